/* Shapes: boxes, circles, polygons and thick lines, in metres. Exact arithmetic only (+, -, *, /
 * and sqrt), because particles are placed by them. */
#ifndef SKV_SCENE_SHAPE_H
#define SKV_SCENE_SHAPE_H

#include <stdbool.h>

/* In the order of the registry's choices. */
typedef enum skv_shape_kind {
    SKV_SHAPE_BOX,
    SKV_SHAPE_CIRCLE,
    SKV_SHAPE_POLYGON, /* even-odd where it crosses itself */
    SKV_SHAPE_LINE     /* everything within `radius` of the points' connection */
} skv_shape_kind;

typedef struct skv_shape {
    skv_shape_kind kind;
    double x0, y0, x1, y1; /* the box; for the other kinds the box around it */
    double x, y;           /* circle */
    double radius;         /* circle, line */
    const double *points;  /* polygon, line: x, y, x, y... */
    int point_count;
    bool carve;    /* solid: cuts out instead of adding */
    double vx, vy; /* water: m/s */
    int dye;       /* water */
    int fluid;     /* water: its number */
} skv_shape;

/* Fills in x0..y1 of a circle, polygon or line. */
void skv_shape_set_bounds(skv_shape *shape);

/* Makes a shape at least so thick everywhere, so that no part of a wall is lost between pixels;
 * whether it had to be. A polygon is taken as a whole: a sliver becomes its outline. */
bool skv_shape_thicken(skv_shape *shape, double least);

bool skv_shape_contains(const skv_shape *shape, double x, double y);

/* Where the edge from a to b crosses height y; false if it does not. Half-open, so that a corner
 * counts once. */
bool skv_edge_crossing(const double *a, const double *b, double y, double *x);

#endif
