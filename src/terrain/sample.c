/* Distance and normal at a point, and whether a straight way is free. */
#include "terrain/sample.h"

#include "base/assert.h"
#include "base/exact.h"

#include <math.h>

/* What a sampled distance may be other than the true one at two places, and a little more. */
#define SAMPLED 3.0f

/* Whether solid lies between two points so far apart, whose distances from it are known; all in
 * pixels. What both distances cover is free: a sampled distance falls by at most sqrt(2) a pixel,
 * and on a long way by little more than the way. The half that lies nearer to solid is looked at
 * first: there a way that meets it mostly ends. */
static bool is_occluded(const skv_terrain *terrain, float ax, float ay, float a, float bx, float by,
                        float b, float length)
{
    if (a <= 0 || b <= 0)
        return true;
    if (length < 0.3f || a + b >= skv_minf(1.4143f * length, length + SAMPLED))
        return false;
    float x = 0.5f * (ax + bx), y = 0.5f * (ay + by), half = 0.5f * length;
    float middle = skv_grid_distance(terrain, x, y) * terrain->per_metre;
    if (a < b)
        return is_occluded(terrain, ax, ay, a, x, y, middle, half) ||
               is_occluded(terrain, x, y, middle, bx, by, b, half);
    return is_occluded(terrain, x, y, middle, bx, by, b, half) ||
           is_occluded(terrain, ax, ay, a, x, y, middle, half);
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
    return skv_distance_at(terrain, x, y);
}

float skv_terrain_normal(const skv_terrain *terrain, float x, float y, float *nx, float *ny)
{
    SKV_ASSERT_OR(terrain && nx && ny, 0);
    return skv_normal_at(terrain, x, y, nx, ny);
}
