/* Sampling the distance field inside one cell, shared by distance, normal and sweep. */
#ifndef SKV_TERRAIN_SAMPLE_H
#define SKV_TERRAIN_SAMPLE_H

#include "terrain/terrain.h"

/* Distances at a cell's corners: first number x, second y. */
typedef struct skv_corners {
    float d00, d10, d01, d11;
} skv_corners;

/* Grid coordinates that can be sampled: a cell and the ring of pixels that normals need. */
#define SKV_GRID_LOW 1.0f
static inline float skv_grid_high(int pixels)
{
    return (float)(pixels - 2);
}

static inline float skv_to_grid(const skv_terrain *terrain, float metres)
{
    return metres * terrain->per_metre + ((float)SKV_TERRAIN_RIM - 0.5f);
}

static inline skv_corners skv_corners_at(const skv_terrain *terrain, int x, int y)
{
    const float *low = terrain->field + (size_t)y * (size_t)terrain->columns + (size_t)x;
    const float *high = low + terrain->columns;
    return (skv_corners){low[0], low[1], high[0], high[1]};
}

/* Solid at two opposite corners only. */
static inline bool skv_is_saddle(const skv_corners *c)
{
    return c->d00 * c->d11 > 0 && c->d10 * c->d01 > 0 && c->d00 * c->d10 < 0;
}

/* Distance at (u, v) in 0..1 of a cell: bilinear, but a saddle is two planes that meet in the
 * diagonal between the solid corners. There the bilinear surface is highest in the middle and
 * would leave a hole in a diagonal line one pixel wide. */
static inline float skv_cell_distance(const skv_corners *c, float u, float v)
{
    if (skv_is_saddle(c)) {
        if (c->d00 < 0)
            return u > v ? c->d00 + u * (c->d10 - c->d00) + v * (c->d11 - c->d10)
                         : c->d00 + v * (c->d01 - c->d00) + u * (c->d11 - c->d01);
        return u + v < 1 ? c->d00 + u * (c->d10 - c->d00) + v * (c->d01 - c->d00)
                         : c->d11 + (1 - u) * (c->d01 - c->d11) + (1 - v) * (c->d10 - c->d11);
    }
    float low = c->d00 + u * (c->d10 - c->d00);
    float high = c->d01 + u * (c->d11 - c->d01);
    return low + v * (high - low);
}

/* Distance at any point given in grid coordinates. */
float skv_grid_distance(const skv_terrain *terrain, float gx, float gy);

/* True if the straight way between two points in grid coordinates meets solid. The same for (a, b)
 * and (b, a), bit by bit; a wall thinner than a third of a pixel may be missed. The bounds spare
 * looking distances up: lower bounds, in m, of the ends' distances from solid; 0: not known. */
bool skv_grid_occluded(const skv_terrain *terrain, float ax, float ay, float a_clearance, float bx,
                       float by, float b_clearance);

/* The sums of the 3x3 normal kernel, interpolated to grid coordinates inside the sampled range:
 * along the normal, not normalised, zero in the middle of a channel. */
void skv_grid_slope(const skv_terrain *terrain, float gx, float gy, float *sx, float *sy);

#endif
