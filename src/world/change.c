/* What may change while a world runs: gravity and the fluid, and with them the number of substeps.
 * Invariant: after each call a world of the substep rule takes as many as the rule asks for, or a
 * few more.
 */
#include "base/assert.h"
#include "world/world_internal.h"

#include <math.h>

/* Substeps are given back when less than this share of them is needed. */
#define SPARE_SUBSTEPS (2.0f / 3)

float skv_extent_along_gravity(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y, lowest, highest;
    float size = sqrtf(gx * gx + gy * gy);
    skv_terrain_free_range(world->terrain, &lowest, &highest);
    if (!(size > 0))
        return highest - lowest;
    return (fabsf(gx) * skv_terrain_width(world->terrain) + fabsf(gy) * (highest - lowest)) / size;
}

int skv_substeps_needed(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y;
    return skv_substep_rule(&world->fluid, sqrtf(gx * gx + gy * gy),
                            world->filled * skv_extent_along_gravity(world));
}

/* Follows the gravity that has been set. The pressure of a fluid at rest is its excess of density
 * over dt^2: where g dt^2 stays, so does the fluid. Fewer substeps only if a good part can be
 * spared, so that a gravity that trembles does not change them to and fro. */
static void adapt_substeps(skv_world *world)
{
    if (world->substeps_fixed)
        return;
    int needed = skv_substeps_needed(world);
    if (needed <= world->substeps && (float)needed > SPARE_SUBSTEPS * (float)world->substeps)
        return;
    world->due *= (double)needed / world->substeps;
    world->substeps = needed;
}

skv_result skv_world_set_gravity(skv_world *world, float gx, float gy, skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)gx, -1000, 1000) || !skv_within((double)gy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "gravity: (%g, %g) is out of range; allowed is -1000..1000 m/s^2",
                        (double)gx, (double)gy);
    if (gx != world->gravity_x || gy != world->gravity_y)
        skv_sleep_wake_all(world);
    world->gravity_x = gx;
    world->gravity_y = gy;
    adapt_substeps(world);
    return SKV_OK;
}

void skv_world_put_fluid(skv_world *world, const skv_fluid_def *fluid)
{
    world->fluid = *fluid;
    world->constants_dt = 0; /* they are made anew */
    world->boundary.contact_distance = fluid->contact_distance * fluid->spacing;
}

void skv_world_change_fluid(skv_world *world, const skv_fluid_def *fluid)
{
    skv_world_put_fluid(world, fluid);
    adapt_substeps(world);
    skv_sleep_wake_all(world);
}
