/* Meeting walls: swept moves, contact, and what the solid adds to the sums. Invariant: a move ends
 * where the terrain's sweep lets it, so nothing passes a wall, however fast it is. */
#include "terrain/boundary.h"

#include "base/exact.h"

float skv_boundary_move(const skv_boundary *b, float *x, float *y, float dx, float dy,
                        float *distance)
{
    float share = skv_terrain_sweep(b->terrain, *x, *y, *x + dx, *y + dy, b->clearance);
    if (share < 1) {
        *x += share * dx;
        *y += share * dy;
    } else {
        *x += dx;
        *y += dy;
    }
    *distance = skv_terrain_distance(b->terrain, *x, *y);
    return share;
}

float skv_boundary_contact(const skv_boundary *b, float contact_distance, float x, float y,
                           float *nx, float *ny, float *distance)
{
    *distance = skv_terrain_normal(b->terrain, x, y, nx, ny);
    float depth = contact_distance - *distance;
    if (!(depth > 0))
        return 0;
    float beyond = skv_terrain_distance(b->terrain, x + depth * *nx, y + depth * *ny);
    float gain = skv_maxf(-depth, skv_minf(depth, beyond - *distance));
    return 0.5f * (depth + gain);
}

float skv_boundary_sample(const skv_boundary *b, float x, float y, skv_wall_sample *wall)
{
    if (!skv_wall_map_near_thin(b->walls, x, y)) {
        skv_wall_map_sample(b->walls, x, y, wall);
        return skv_terrain_distance(b->terrain, x, y);
    }
    float nx, ny, distance = skv_terrain_normal(b->terrain, x, y, &nx, &ny);
    skv_wall_map_sample_beside(b->walls, x, y, distance, nx, ny, wall);
    return distance;
}

bool skv_boundary_has_thin(const skv_boundary *b)
{
    return skv_wall_map_has_thin(b->walls);
}

bool skv_boundary_near_thin(const skv_boundary *b, float x, float y)
{
    return skv_wall_map_near_thin(b->walls, x, y);
}

bool skv_boundary_occluded(const skv_boundary *b, float ax, float ay, float a_clearance, float bx,
                           float by, float b_clearance)
{
    return skv_wall_map_occluded(b->walls, b->terrain, ax, ay, a_clearance, bx, by, b_clearance);
}
