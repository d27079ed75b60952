/* Where the fluid is at the start: shapes, painted pixels, or everything up to a level. */
#ifndef SKV_SCENE_WATER_H
#define SKV_SCENE_WATER_H

#include "scene/shape.h"
#include "skvalp/acting.h"
#include "skvalp/particles.h"

typedef struct skv_water {
    skv_shape *shapes;
    int shape_count;
    const uint8_t *paint; /* width * height skv_paint, row 0 at the bottom; null: not painted */
    int width, height;
    double pixel_size;
    skv_shape *covers; /* bodies that lie where fluid is drawn: none is laid there */
    int cover_count;
    double level;         /* fluid up to here, whatever the rest says; below the world: none */
    float x0, y0, x1, y1; /* a box around all of it, within the world */
    double area;     /* m^2: the drawn fluid that no wall or body covers; from skv_lay_measure */
    float low, high; /* m: where that begins and ends */
} skv_water;

/* Sets the box from everything else. Empty (x0 > x1) if nothing lies within the world. */
void skv_water_set_bounds(skv_water *water);

/* An skv_inside; `user` is a const skv_water. */
bool skv_water_inside(float x, float y, void *user);

/* Whether a body covers a point. */
bool skv_water_is_covered(const skv_water *water, float x, float y);

/* Whether a point lies in a pixel that is painted as oil. */
bool skv_water_is_oil(const skv_water *water, float x, float y);

/* The last shape that holds a point, whose speed its particle takes; null for painted fluid. */
const skv_shape *skv_water_shape_at(const skv_water *water, float x, float y);

#endif
