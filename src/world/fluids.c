/* Which fluids a world has, and which of its particles are of which. Invariant: the list begins
 * with what the world's fluid is at present, and every particle's number is that of one in the
 * list. */
#include "world/fluids.h"

#include "base/assert.h"
#include "base/exact.h"
#include "world/liquids.h"
#include "world/springs/springs.h"
#include "world/world_internal.h"

#include <string.h>

void skv_liquids_follow(skv_world *world)
{
    world->liquids[0] = (skv_liquid){
        .cookie = skv_liquid_cookie,
        .name = SKV_FIRST_FLUID,
        .color = SKV_NO_COLOR,
#define LIQUID_NUMBER(...)
#define LIQUID_OF_MATERIAL(id, member, ...) .member = world->fluid.member,
#define LIQUID_OF_FIRST(id, member, ...)    .member = world->fluid.member,
#include "world/liquid_rows.h"
    };
    skv_world_weigh(world);
}

/* What a world's fluid is with the viscosity of one of the list. */
static skv_fluid_def fluid_with(const skv_world *world, float viscosity)
{
    skv_fluid_def fluid = world->fluid;
    fluid.viscosity = viscosity;
    return fluid;
}

void skv_world_weigh(skv_world *world)
{
    skv_state *s = &world->state;
    for (int i = 0; i < world->fluid_count; i++) {
        skv_fluid_def fluid = fluid_with(world, world->liquids[i].viscosity);
        world->sigmas[i] = (float)skv_linear_viscosity(&fluid);
    }
    skv_world_share_cohesion(world);
    for (int i = 0; s->several && i < s->count; i++) {
        s->mass[i] = skv_mass_of(world, s->fluid[i]);
        s->drag[i] = skv_drag_of(world, s->fluid[i]);
    }
}

double skv_world_contrast(const skv_world *world)
{
    float least = world->liquids[0].density, most = least;
    for (int i = 1; i < world->fluid_count; i++) {
        least = skv_minf(least, world->liquids[i].density);
        most = skv_maxf(most, world->liquids[i].density);
    }
    return (double)(most / least);
}

/* ... and with the most viscous one's, and the greatest cohesion. */
static skv_fluid_def most_demanding(const skv_world *world)
{
    float most = world->fluid.viscosity;
    for (int i = 1; i < world->fluid_count; i++)
        most = skv_maxf(most, world->liquids[i].viscosity);
    skv_fluid_def fluid = fluid_with(world, most);
    fluid.cohesion = skv_world_most_cohesion(world);
    return fluid;
}

int skv_world_substep_rule(const skv_world *world, double load)
{
    skv_fluid_def fluid = most_demanding(world);
    int needed = skv_substep_rule(&fluid, load), springs = skv_springs_rule(world);
    return needed > springs ? needed : springs;
}

int skv_world_warm_substeps(const skv_world *world, int cold)
{
    skv_fluid_def fluid = most_demanding(world);
    int warm = skv_warm_substeps(&fluid, cold), springs = skv_springs_rule(world);
    return warm > springs ? warm : springs < cold ? springs : cold;
}

const float *skv_world_masses(const skv_world *world)
{
    const skv_state *s = &world->state;
    for (int i = 0; s->several && i < s->count; i++)
        if (s->mass[i] != 1 || s->drag[i] != world->sigmas[0])
            return s->mass;
    return NULL;
}

const float *skv_world_drags(const skv_world *world)
{
    const skv_state *s = &world->state;
    for (int i = 0; s->several && i < s->count; i++)
        if (world->sigmas[s->fluid[i]] != world->sigmas[0])
            return s->drag;
    return NULL;
}

void skv_world_put_liquids(skv_world *world, const skv_world_def *def)
{
    skv_liquids_follow(world);
    for (int i = 0; i < def->liquid_count; i++)
        world->liquids[i + 1] = def->liquids[i];
    world->fluid_count = def->liquid_count + 1;
    skv_world_weigh(world);
}

const skv_liquid *skv_world_liquid(const skv_world *world, int number)
{
    SKV_ASSERT_OR(world, NULL);
    return number >= 0 && number < world->fluid_count ? &world->liquids[number] : NULL;
}

skv_result skv_world_set_fluids(skv_world *world, int first, int count, const uint8_t *fluids,
                                skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (fluids || count <= 0), SKV_ERROR_VALUE);
    skv_result result = skv_state_check_range(&world->state, "fluid", first, count, error);
    for (int i = 0; i < count && result == SKV_OK; i++)
        result = skv_check_fluid(fluids[i], world->fluid_count, error);
    if (result != SKV_OK)
        return result;
    for (int i = first, k = 0; k < count; i++, k++) {
        if (skv_fluid_of(&world->state, i) == fluids[k])
            continue;
        world->state.fluid[i] = fluids[k];
        world->state.mass[i] = skv_mass_of(world, fluids[k]);
        world->state.drag[i] = skv_drag_of(world, fluids[k]);
        skv_springs_renew(world, i);
        skv_sleep_wake(world, i);
    }
    skv_springs_part(world);
    return SKV_OK;
}
