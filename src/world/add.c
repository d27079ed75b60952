/* Adding single particles, and many at once.
 *
 * Invariant: what is added lies in the free region, or at most a smoothing radius beyond an open
 * side: there the world ends, and what has gone farther is taken out.
 */
#include "world/add.h"

#include "base/assert.h"

skv_result skv_world_make_room(skv_world *world, int more, skv_error *error)
{
    if ((uint32_t)more > SKV_NO_PARTICLE - world->next_id)
        return skv_fail(
            error, SKV_ERROR_LIMIT,
            "this world has named 4294967295 particles and has no id left; make another");
    return skv_world_reserve(world, world->state.count + more, error);
}

/* True if a place is beyond a closed side, round a corner, or too far beyond an open side. */
static bool is_outside(const skv_world *world, float x, float y)
{
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    bool beside = x < 0 || x > width, beyond = y < 0 || y > height;
    if (!beside && !beyond)
        return false;
    if (beside && beyond)
        return true;
    float h = world->h;
    unsigned side = x < 0       ? SKV_SIDE_LEFT
                    : x > width ? SKV_SIDE_RIGHT
                    : y < 0     ? SKV_SIDE_BOTTOM
                                : SKV_SIDE_TOP;
    return !(skv_terrain_open_sides(world->terrain) & side) || x < -h || x > width + h || y < -h ||
           y > height + h;
}

static bool is_blocked(const skv_world *world, float x, float y)
{
    return is_outside(world, x, y) || skv_terrain_distance(world->terrain, x, y) <= 0;
}

static bool is_sane(float x, float y, float vx, float vy)
{
    return skv_within((double)x, -100, 100) && skv_within((double)y, -100, 100) &&
           skv_within((double)vx, -1000, 1000) && skv_within((double)vy, -1000, 1000);
}

skv_result skv_world_add_particle(skv_world *world, float x, float y, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!is_sane(x, y, vx, vy))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: position or velocity is not finite or beyond 100 m, 1000 m/s");
    if (is_blocked(world, x, y))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: (%g, %g) is in solid or outside the world; choose a free place",
                        (double)x, (double)y);
    skv_result result = skv_world_make_room(world, 1, error);
    if (result == SKV_OK)
        skv_world_append(world, x, y, vx, vy);
    return result;
}
