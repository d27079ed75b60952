/* What may change while a world runs: gravity, forces and the fluid, and with them the number of
 * substeps. Invariant: after each call a world of the substep rule takes as many as the rule asks
 * for, or a few more.
 */
#include "base/assert.h"
#include "base/fields.h"
#include "world/air/air.h"
#include "world/emitters.h"
#include "world/fluids.h"
#include "world/forces.h"
#include "world/names.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

float skv_extent_along_gravity(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y, lowest, highest;
    float size = sqrtf(gx * gx + gy * gy);
    skv_terrain_free_range(world->terrain, &lowest, &highest);
    if (!(size > 0))
        return highest - lowest;
    return (fabsf(gx) * skv_terrain_width(world->terrain) + fabsf(gy) * (highest - lowest)) / size;
}

/* The heaviest fluid may press on the lightest, and air on all of it. */
double skv_expected_load(const skv_world *world)
{
    float gx = world->gravity_x, gy = world->gravity_y;
    float head = skv_acting_head(&world->acting, skv_terrain_width(world->terrain),
                                 skv_terrain_height(world->terrain));
    double pressed = world->air ? (double)(world->air->pressure / world->fluid.density) : 0;
    return skv_world_contrast(world) *
           (skv_load_of_depth(sqrtf(gx * gx + gy * gy),
                              world->filled * skv_extent_along_gravity(world), head) +
            pressed);
}

int skv_substeps_needed(const skv_world *world)
{
    return skv_world_substep_rule(world, skv_expected_load(world));
}

/* Follows the gravity and the forces that have been set. */
void skv_world_adapt_substeps(skv_world *world)
{
    if (!world->substeps_fixed)
        skv_load_expect(world, skv_substeps_needed(world));
}

skv_result skv_world_set_gravity(skv_world *world, float gx, float gy, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    if (!skv_within((double)gx, -1000, 1000) || !skv_within((double)gy, -1000, 1000)) {
        char x[32], y[32];
        skv_format_float((double)gx, x);
        skv_format_float((double)gy, y);
        return skv_fail(error, SKV_ERROR_VALUE,
                        "gravity: (%s, %s) is out of range; allowed is -1000..1000 m/s^2", x, y);
    }
    if (gx != world->gravity_x || gy != world->gravity_y)
        skv_sleep_wake_all(world);
    world->gravity_x = gx;
    world->gravity_y = gy;
    skv_world_adapt_substeps(world);
    return SKV_OK;
}

skv_result skv_world_set_forces(skv_world *world, const skv_force *forces, int count,
                                skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (forces || count == 0), SKV_ERROR_VALUE);
    skv_result result = skv_check_forces(forces, count, error);
    if (result == SKV_OK)
        result = skv_acting_name(&world->acting, SKV_ACTING_FORCE, count, error);
    if (result != SKV_OK)
        return result;
    if (count)
        memmove(world->acting.forces, forces, (size_t)count * sizeof *forces);
    world->acting.force_count = count;
    skv_sleep_wake_all(world);
    skv_world_adapt_substeps(world);
    return SKV_OK;
}

const skv_force *skv_world_forces(const skv_world *world, int *count)
{
    SKV_ASSERT_OR(world && count, NULL);
    *count = world->acting.force_count;
    return world->acting.forces;
}

bool skv_emitter_goes_on(const skv_emitter *a, const skv_emitter *b)
{
    return a->x == b->x && a->y == b->y && a->vx == b->vx && a->vy == b->vy && a->width == b->width;
}

skv_result skv_world_check_emitters(const skv_world *world, const skv_emitter *emitters, int count,
                                    skv_error *error)
{
    skv_result result = skv_check_emitters(emitters, count, world->fluid_count, error);
    if (result != SKV_OK)
        return result;
    for (int i = 0; i < count; i++) {
        char wide[160];
        if (skv_emitter_is_wide(&emitters[i], world->fluid.spacing, wide, sizeof wide))
            return skv_fail(error, SKV_ERROR_VALUE, "emitter %d: its mouth %s", i, wide);
    }
    return SKV_OK;
}

skv_result skv_world_set_emitters(skv_world *world, const skv_emitter *emitters, int count,
                                  skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (emitters || count == 0), SKV_ERROR_VALUE);
    skv_result result = skv_world_check_emitters(world, emitters, count, error);
    if (result == SKV_OK)
        result = skv_acting_name(&world->acting, SKV_ACTING_EMITTER, count, error);
    if (result != SKV_OK)
        return result;
    skv_acting *acting = &world->acting;
    for (int i = 0; i < count; i++) {
        if (i >= acting->emitter_count || !skv_emitter_goes_on(&acting->emitters[i], &emitters[i]))
            acting->streams[i] = skv_new_stream(world->next_id);
        acting->emitters[i] = emitters[i];
    }
    acting->emitter_count = count;
    skv_world_adapt_substeps(world);
    return SKV_OK;
}

const skv_emitter *skv_world_emitters(const skv_world *world, int *count)
{
    SKV_ASSERT_OR(world && count, NULL);
    *count = world->acting.emitter_count;
    return world->acting.emitters;
}

skv_result skv_world_set_drains(skv_world *world, const skv_drain *drains, int count,
                                skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (drains || count == 0), SKV_ERROR_VALUE);
    skv_result result = skv_check_drains(drains, count, error);
    if (result == SKV_OK)
        result = skv_acting_name(&world->acting, SKV_ACTING_DRAIN, count, error);
    if (result != SKV_OK)
        return result;
    if (count)
        memmove(world->acting.drains, drains, (size_t)count * sizeof *drains);
    world->acting.drain_count = count;
    return SKV_OK;
}

const skv_drain *skv_world_drains(const skv_world *world, int *count)
{
    SKV_ASSERT_OR(world && count, NULL);
    *count = world->acting.drain_count;
    return world->acting.drains;
}

void skv_world_put_emission(skv_world *world, const skv_world_def *def)
{
    world->emission_limit = def->emission_limit;
    world->emission_replaces = def->emission_replaces;
}

void skv_world_change_fluid(skv_world *world, const skv_fluid_def *fluid)
{
    skv_world_put_fluid(world, fluid, skv_ramp_begin(world, fluid));
    skv_world_adapt_substeps(world);
    skv_sleep_wake_all(world);
}
