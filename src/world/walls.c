/* Meeting walls: swept moves and contact. Invariant: a move ends where the terrain's sweep lets it,
 * so nothing passes a wall, however fast it is. */
#include "base/exact.h"
#include "world/frame.h"

float skv_move_at_walls(const skv_world *world, float *x, float *y, float dx, float dy,
                        float *distance)
{
    const skv_terrain *terrain = world->terrain;
    float share = skv_terrain_sweep(terrain, *x, *y, *x + dx, *y + dy, world->wall_clearance);
    if (share < 1) {
        *x += share * dx;
        *y += share * dy;
    } else {
        *x += dx;
        *y += dy;
    }
    *distance = skv_terrain_distance(terrain, *x, *y);
    return share;
}

float skv_contact_depth(const skv_world *world, float x, float y, float *nx, float *ny,
                        float *distance)
{
    const skv_terrain *terrain = world->terrain;
    *distance = skv_terrain_normal(terrain, x, y, nx, ny);
    float depth = world->constants.contact_distance - *distance;
    if (!(depth > 0))
        return 0;
    float beyond = skv_terrain_distance(terrain, x + depth * *nx, y + depth * *ny);
    float gain = skv_maxf(-depth, skv_minf(depth, beyond - *distance));
    return 0.5f * (depth + gain);
}

float skv_walls_at(const skv_world *world, float x, float y, skv_wall_sample *wall)
{
    if (!skv_wall_map_near_thin(world->walls, x, y)) {
        skv_wall_map_sample(world->walls, x, y, wall);
        return skv_terrain_distance(world->terrain, x, y);
    }
    float nx, ny, distance = skv_terrain_normal(world->terrain, x, y, &nx, &ny);
    skv_wall_map_sample_beside(world->walls, x, y, distance, nx, ny, wall);
    return distance;
}

bool skv_wall_between(const void *context, float ax, float ay, float bx, float by)
{
    const skv_world *world = context;
    return skv_wall_map_occluded(world->walls, world->terrain, ax, ay, 0, bx, by, 0);
}

void skv_cut_pairs_at_walls(const skv_world *world, skv_neighbours *neighbours)
{
    if (!skv_wall_map_has_thin(world->walls))
        return;
    neighbours->occluded = skv_wall_between;
    neighbours->occluded_context = world;
}
