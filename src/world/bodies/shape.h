/* A body's shape: its outline, what it weighs per density, and its walls in its own frame. */
#ifndef SKV_WORLD_BODY_SHAPE_H
#define SKV_WORLD_BODY_SHAPE_H

#include "skvalp/area.h"
#include "terrain/boundary.h"
#include "world/world_internal.h"

/* About the centre of mass, m, counter-clockwise. */
typedef struct skv_outline {
    int corners;
    double corner[SKV_MAX_CORNERS][2];
    double area, inertia;      /* m^2, and m^4 about the centre of mass */
    double middle_x, middle_y; /* of the area as it was given: its centre of mass */
    double reach;              /* the farthest corner's distance */
    double around;             /* length, m */
} skv_outline;

/* Points of the outline that are asked whether they touch something. */
enum { SKV_MOST_RIM = 400 };

typedef struct skv_body_shape {
    int owners; /* bodies of one world, and shapes that have its walls */
    skv_outline outline;
    struct skv_body_shape *lender; /* whose the picture and the walls are; null: its own */
    skv_terrain *terrain; /* its picture, with the centre of mass at (middle_x, middle_y) */
    skv_wall_map *walls;
    skv_boundary boundary;
    float middle_x, middle_y;
    int rims;
    float rim[SKV_MOST_RIM][2]; /* about the centre of mass, m */
} skv_body_shape;

/* Finds what follows from the corners. */
void skv_outline_measure(skv_outline *outline);
/* Fails if it is none of a body. */
skv_result skv_outline_check(const skv_outline *outline, float spacing, skv_error *error);
/* The outline of an area. Fails as that does. */
skv_result skv_outline_make(const skv_area *area, float spacing, skv_outline *outline,
                            skv_error *error);

/* Makes the walls of an outline for a world's fluid, or takes those of one of its `others` whose
 * picture is the same. The first owner gives it up by destroying it. */
skv_result skv_body_shape_create(const skv_world *world, const struct skv_bodies *others,
                                 const skv_outline *outline, skv_body_shape **shape,
                                 skv_error *error);
void skv_body_shape_destroy(skv_body_shape *shape);

#endif
