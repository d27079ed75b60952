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
    double level;         /* fluid up to here, whatever the rest says; below the world: none */
    double thinning;      /* share of the surface's particles that is left out */
    float surface_step;   /* a point is at a surface if there is no fluid this much above it */
    float x0, y0, x1, y1; /* a box around all of it, within the world */
} skv_water;

/* Sets the box from everything else. Empty (x0 > x1) if nothing lies within the world. */
void skv_water_set_bounds(skv_water *water);

/* An skv_inside; `user` is a const skv_water. */
bool skv_water_inside(float x, float y, void *user);

/* Whether a point lies in a pixel that is painted as oil. */
bool skv_water_is_oil(const skv_water *water, float x, float y);

/* The last shape that holds a point, whose speed its particle takes; null for painted fluid. */
const skv_shape *skv_water_shape_at(const skv_water *water, float x, float y);

/* The widest spacing at which the water holds `wanted` particles. A surplus of at most about a row
 * is thinned out of the surface; what is left of it after that is for a limit to cut. `least` is a
 * lower limit: if fewer fit at it, *spacing is `least` and *count says how many. SKV_ERROR_VALUE,
 * with *count set, if even the largest spacing allowed holds more. */
skv_result skv_water_choose_spacing(skv_water *water, const skv_terrain *terrain, int wanted,
                                    float least, float *spacing, int *count);

/* The fill that asks this water, which must outlive it. */
skv_fill_def skv_water_fill_def(skv_water *water);

/* skv_fill_count over the water, which ends at `most`. */
int skv_water_count_to(const skv_water *water, const skv_terrain *terrain, float spacing, int most);

/* How many particles the water can be made of: those at the widest and at the finest spacing. From
 * coarse to fine, so that a large world is not counted far beyond what fits into it. */
void skv_water_count_range(const skv_water *water, const skv_terrain *terrain, int *fewest,
                           int *most);

#endif
