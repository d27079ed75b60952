/* Distance and normal at a point. Invariant: both are defined for every finite point: beyond the
 * rim the distance grows (or, in solid, falls) by the way to the rim. */
#include "terrain/sample.h"

#include "base/assert.h"

#include <math.h>

/* 1/sqrt(2): the thesis' kernel weighs a neighbour by its distance d_j times the unit vector to
 * it, which in a 3x3 kernel is (1, 0), (0.707, 0.707) and so on. */
#define DIAGONAL 0.70710678f

/* Written so that a NaN ends at `low`. */
static inline float clamp(float value, float low, float high)
{
    value = value > low ? value : low;
    return value < high ? value : high;
}

/* The cell that holds a coordinate in the sampled range. */
static inline int cell_of(float g, int pixels)
{
    int cell = (int)g;
    return cell < pixels - 3 ? cell : pixels - 3;
}

float skv_grid_distance(const skv_terrain *terrain, float gx, float gy)
{
    float cx = clamp(gx, SKV_GRID_LOW, skv_grid_high(terrain->columns));
    float cy = clamp(gy, SKV_GRID_LOW, skv_grid_high(terrain->rows));
    int x = cell_of(cx, terrain->columns), y = cell_of(cy, terrain->rows);
    skv_corners corners = skv_corners_at(terrain, x, y);
    float distance = skv_cell_distance(&corners, cx - (float)x, cy - (float)y);
    if (cx != gx || cy != gy) {
        double ox = (double)gx - (double)cx, oy = (double)gy - (double)cy;
        float way = (float)sqrt(ox * ox + oy * oy) * terrain->pixel_size;
        distance += distance < 0 ? -way : way;
    }
    return distance;
}

/* Whether solid lies between two points so far apart, whose distances from it are known; all in
 * pixels. What both distances cover is free: a distance falls by at most sqrt(2) a pixel. */
static bool is_occluded(const skv_terrain *terrain, float ax, float ay, float a, float bx, float by,
                        float b, float length)
{
    if (a <= 0 || b <= 0)
        return true;
    if (length < 0.3f || a + b >= 1.4143f * length)
        return false;
    float x = 0.5f * (ax + bx), y = 0.5f * (ay + by), half = 0.5f * length;
    float middle = skv_grid_distance(terrain, x, y) * terrain->per_metre;
    return is_occluded(terrain, ax, ay, a, x, y, middle, half) ||
           is_occluded(terrain, x, y, middle, bx, by, b, half);
}

/* The distance of an end from solid in pixels, or the bound of it that is known. Ends are
 * particles: one that a wall holds counts as beside it. */
static float at_end(const skv_terrain *terrain, float gx, float gy, float clear)
{
    const float beside = 1e-3f;
    if (!(clear > 0))
        clear = skv_grid_distance(terrain, gx, gy);
    clear *= terrain->per_metre;
    return clear > beside ? clear : beside;
}

bool skv_grid_occluded(const skv_terrain *terrain, float ax, float ay, float a_clearance, float bx,
                       float by, float b_clearance)
{
    float dx = bx - ax, dy = by - ay;
    return is_occluded(terrain, ax, ay, at_end(terrain, ax, ay, a_clearance), bx, by,
                       at_end(terrain, bx, by, b_clearance), sqrtf(dx * dx + dy * dy));
}

float skv_terrain_distance(const skv_terrain *terrain, float x, float y)
{
    SKV_ASSERT_OR(terrain, 0);
    return skv_grid_distance(terrain, skv_to_grid(terrain, x), skv_to_grid(terrain, y));
}

void skv_grid_slope(const skv_terrain *terrain, float gx, float gy, float *sx, float *sy)
{
    int x = cell_of(gx, terrain->columns), y = cell_of(gy, terrain->rows);
    float u = gx - (float)x, v = gy - (float)y;
    /* The four pixels' 3x3 kernels overlap in 4x4 pixels; interpolating between them gives each
     * column and row of these a weight as a difference and one as a mean. */
    const float across[4] = {u - 1, -u, 1 - u, u}, up[4] = {v - 1, -v, 1 - v, v};
    const float mean_x[4] = {DIAGONAL * (1 - u), 1 - u + DIAGONAL * u, DIAGONAL * (1 - u) + u,
                             DIAGONAL * u};
    const float mean_y[4] = {DIAGONAL * (1 - v), 1 - v + DIAGONAL * v, DIAGONAL * (1 - v) + v,
                             DIAGONAL * v};
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
static void normalise(double x, double y, double least, float *nx, float *ny)
{
    double length = sqrt(x * x + y * y);
    bool known = length > least && length <= 1e300;
    *nx = known ? (float)(x / length) : 0;
    *ny = known ? (float)(y / length) : 1;
}

float skv_terrain_normal(const skv_terrain *terrain, float x, float y, float *nx, float *ny)
{
    SKV_ASSERT_OR(terrain && nx && ny, 0);
    float gx = skv_to_grid(terrain, x), gy = skv_to_grid(terrain, y);
    float cx = clamp(gx, SKV_GRID_LOW, skv_grid_high(terrain->columns));
    float cy = clamp(gy, SKV_GRID_LOW, skv_grid_high(terrain->rows));
    float distance = skv_grid_distance(terrain, gx, gy);
    float sx, sy;
    skv_grid_slope(terrain, cx, cy, &sx, &sy);
    /* On a straight wall the sums are about 4.8 pixels long; rounding leaves 1e-6 of the distance
     * itself where the true slope is zero. */
    double least = 1e-4 * (double)terrain->pixel_size + 1e-5 * fabs((double)distance);
    normalise((double)sx, (double)sy, least, nx, ny);
    if (cx != gx || cy != gy) {
        /* Along the rim the slope is the rim's, away from it that of the way to the rim. */
        double ox = (double)gx - (double)cx, oy = (double)gy - (double)cy;
        double way = sqrt(ox * ox + oy * oy), sign = distance < 0 ? -1 : 1;
        double tx = cx != gx ? 0 : (double)*nx, ty = cy != gy ? 0 : (double)*ny;
        normalise(tx + sign * ox / way, ty + sign * oy / way, 1e-9, nx, ny);
    }
    return distance;
}
