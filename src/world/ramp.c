/* Changed numbers of Clavet's law go to their new values while the world runs.
 *
 * Fluid that is packed for one set of these numbers is far too dense, or too thin, for another, and
 * flies apart if they jump (docs/notebook/2026-11-27-changes-while-it-runs.md). How the calibrated
 * law packs its fluid does not follow from its numbers, and they jump. Invariant: what people read
 * is what they set, world->fluid; what acts follows from that and from the way alone.
 */
#include "world/ramp.h"

#include "world/fluids.h"
#include "world/world_internal.h"

static float *number(skv_fluid_def *fluid, int i)
{
    float *const numbers[SKV_RAMP_NUMBERS] = {
        &fluid->clavet_stiffness, &fluid->clavet_near_stiffness, &fluid->clavet_rest_density,
        &fluid->contact_distance};
    return numbers[i];
}

skv_fluid_def skv_ramp_fluid(const skv_fluid_def *fluid, const skv_ramp *ramp)
{
    skv_fluid_def present = *fluid;
    for (int i = 0; ramp->left > 0 && i < SKV_RAMP_NUMBERS; i++)
        *number(&present, i) = ramp->now[i];
    return present;
}

skv_ramp skv_ramp_begin(const skv_world *world, const skv_fluid_def *fluid)
{
    skv_fluid_def old = world->fluid, set = *fluid;
    skv_fluid_def present = skv_ramp_fluid(&old, &world->ramp);
    skv_ramp ramp = {.left = world->ramp.left};
    for (int i = 0; i < SKV_RAMP_NUMBERS; i++) {
        ramp.now[i] = *number(&present, i);
        if (*number(&set, i) != *number(&old, i))
            ramp.left = SKV_RAMP_TIME;
    }
    bool packed = fluid->law == SKV_LAW_CLAVET && world->state.count > 0;
    return packed ? ramp : (skv_ramp){0};
}

void skv_world_put_fluid(skv_world *world, const skv_fluid_def *fluid, skv_ramp ramp)
{
    world->fluid = *fluid;
    world->ramp = ramp;
    world->constants_stale = true;
    skv_liquids_follow(world);
    skv_fluid_def present = skv_ramp_fluid(fluid, &ramp);
    world->boundary.contact_distance = skv_contact_distance(&present);
}

void skv_ramp_follow(skv_world *world, double before)
{
    skv_ramp ramp = world->ramp;
    double passed = world->time - before;
    if (!(ramp.left > 0) || !(passed > 0))
        return;
    float share = passed < ramp.left ? (float)(passed / ramp.left) : 1;
    for (int i = 0; i < SKV_RAMP_NUMBERS; i++)
        ramp.now[i] += share * (*number(&world->fluid, i) - ramp.now[i]);
    ramp.left = passed < ramp.left ? ramp.left - passed : 0;
    skv_world_put_fluid(world, &world->fluid, ramp);
}
