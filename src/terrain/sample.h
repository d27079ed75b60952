/* Sampling the distance field: plain functions of plain data, for the walls, where fluid meets them
 * in the middle of a loop, as well as for the public functions. Invariant: distance and normal are
 * defined for every finite point. */
#ifndef SKV_TERRAIN_SAMPLE_H
#define SKV_TERRAIN_SAMPLE_H

#include "terrain/terrain.h"

#include <math.h>

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

/* Solid at two opposite corners only. First what hardly any cell has. */
static inline bool skv_is_saddle(const skv_corners *c)
{
    return c->d00 * c->d10 < 0 && c->d00 * c->d11 > 0 && c->d10 * c->d01 > 0;
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

/* 1/sqrt(2): the thesis' kernel weighs a neighbour by its distance d_j times the unit vector to
 * it, which in a 3x3 kernel is (1, 0), (0.707, 0.707) and so on. */
#define SKV_DIAGONAL 0.70710678f

/* Written so that a NaN ends at `low`. */
static inline float skv_clamp(float value, float low, float high)
{
    value = value > low ? value : low;
    return value < high ? value : high;
}

/* The cell that holds a coordinate in the sampled range. */
static inline int skv_cell_of(float g, int pixels)
{
    int cell = (int)g;
    return cell < pixels - 3 ? cell : pixels - 3;
}

/* Distance at any point given in grid coordinates; beyond the rim it grows (or, in solid, falls) by
 * the way to the rim. */
static inline float skv_grid_distance(const skv_terrain *terrain, float gx, float gy)
{
    float cx = skv_clamp(gx, SKV_GRID_LOW, skv_grid_high(terrain->columns));
    float cy = skv_clamp(gy, SKV_GRID_LOW, skv_grid_high(terrain->rows));
    int x = skv_cell_of(cx, terrain->columns), y = skv_cell_of(cy, terrain->rows);
    skv_corners corners = skv_corners_at(terrain, x, y);
    float distance = skv_cell_distance(&corners, cx - (float)x, cy - (float)y);
    if (cx != gx || cy != gy) {
        double ox = (double)gx - (double)cx, oy = (double)gy - (double)cy;
        float way = (float)sqrt(ox * ox + oy * oy) * terrain->pixel_size;
        distance += distance < 0 ? -way : way;
    }
    return distance;
}

/* The same at any point given in metres. */
static inline float skv_distance_at(const skv_terrain *terrain, float x, float y)
{
    return skv_grid_distance(terrain, skv_to_grid(terrain, x), skv_to_grid(terrain, y));
}

/* The sums of the 3x3 normal kernel, interpolated to grid coordinates inside the sampled range:
 * along the normal, not normalised, zero in the middle of a channel. */
static inline void skv_grid_slope(const skv_terrain *terrain, float gx, float gy, float *sx,
                                  float *sy)
{
    int x = skv_cell_of(gx, terrain->columns), y = skv_cell_of(gy, terrain->rows);
    float u = gx - (float)x, v = gy - (float)y;
    /* The four pixels' 3x3 kernels overlap in 4x4 pixels; interpolating between them gives each
     * column and row of these a weight as a difference and one as a mean. */
    const float across[4] = {u - 1, -u, 1 - u, u}, up[4] = {v - 1, -v, 1 - v, v};
    const float mean_x[4] = {SKV_DIAGONAL * (1 - u), 1 - u + SKV_DIAGONAL * u,
                             SKV_DIAGONAL * (1 - u) + u, SKV_DIAGONAL * u};
    const float mean_y[4] = {SKV_DIAGONAL * (1 - v), 1 - v + SKV_DIAGONAL * v,
                             SKV_DIAGONAL * (1 - v) + v, SKV_DIAGONAL * v};
    const float *row =
        terrain->field + (size_t)(y - 1) * (size_t)terrain->columns + (size_t)(x - 1);
    float sum_x = 0, sum_y = 0;
    for (int j = 0; j < 4; j++, row += terrain->columns) {
        float difference =
            row[0] * across[0] + row[1] * across[1] + row[2] * across[2] + row[3] * across[3];
        float mean =
            row[0] * mean_x[0] + row[1] * mean_x[1] + row[2] * mean_x[2] + row[3] * mean_x[3];
        sum_x += mean_y[j] * difference;
        sum_y += up[j] * mean;
    }
    *sx = sum_x;
    *sy = sum_y;
}

/* Scales to unit length; (0, 1) if there is no direction. */
static inline void skv_normalise(double x, double y, double least, float *nx, float *ny)
{
    double length = sqrt(x * x + y * y);
    bool known = length > least && length <= 1e300;
    *nx = known ? (float)(x / length) : 0;
    *ny = known ? (float)(y / length) : 1;
}

/* The distance and the unit normal at any point given in metres; (0, 1) if there is no direction.
 */
static inline float skv_normal_at(const skv_terrain *terrain, float x, float y, float *nx,
                                  float *ny)
{
    float gx = skv_to_grid(terrain, x), gy = skv_to_grid(terrain, y);
    float cx = skv_clamp(gx, SKV_GRID_LOW, skv_grid_high(terrain->columns));
    float cy = skv_clamp(gy, SKV_GRID_LOW, skv_grid_high(terrain->rows));
    float distance = skv_grid_distance(terrain, gx, gy);
    float sx, sy;
    skv_grid_slope(terrain, cx, cy, &sx, &sy);
    /* On a straight wall the sums are about 4.8 pixels long; rounding leaves 1e-6 of the distance
     * itself where the true slope is zero. */
    double least = 1e-4 * (double)terrain->pixel_size + 1e-5 * fabs((double)distance);
    skv_normalise((double)sx, (double)sy, least, nx, ny);
    if (cx != gx || cy != gy) {
        /* Along the rim the slope is the rim's, away from it that of the way to the rim. */
        double ox = (double)gx - (double)cx, oy = (double)gy - (double)cy;
        double way = sqrt(ox * ox + oy * oy), sign = distance < 0 ? -1 : 1;
        double tx = cx != gx ? 0 : (double)*nx, ty = cy != gy ? 0 : (double)*ny;
        skv_normalise(tx + sign * ox / way, ty + sign * oy / way, 1e-9, nx, ny);
    }
    return distance;
}

/* True if the straight way between two points in grid coordinates meets solid. The same for (a, b)
 * and (b, a), bit by bit; a wall thinner than a third of a pixel may be missed. The bounds spare
 * looking distances up: lower bounds, in m, of the ends' distances from solid; 0: not known. */
bool skv_grid_occluded(const skv_terrain *terrain, float ax, float ay, float a_clearance, float bx,
                       float by, float b_clearance);

#endif
