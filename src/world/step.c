/* Time: a step in equal substeps, which the solver takes, and who sleeps or leaves between them.
 * How a substep moves the fluid is in src/solver/reference/reference.c. */
#include "base/assert.h"
#include "base/fields.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/emitters.h"
#include "world/flow.h"
#include "world/fluids.h"
#include "world/liquids.h"
#include "world/remove.h"
#include "world/springs/springs.h"

#include <math.h>
#include <string.h>

/* s; of skv_world_step, as floats like its argument. */
#define LEAST_STEP   1e-6f
#define LONGEST_STEP 0.1f
#define DT_ROUNDING  1e-6 /* how far off, relatively, a sum of float dt may be */

skv_constants skv_world_make_constants(const skv_world *world)
{
    skv_fluid_def fluid = skv_ramp_fluid(&world->fluid, &world->ramp);
    fluid.cohesion = skv_world_most_cohesion(world);
    skv_constants constants =
        skv_make_constants(&fluid, world->compression, 1.0f / 60 / (float)world->substeps);
    skv_set_stiffness(&constants, skv_load_stiffness(world));
    return constants;
}

skv_solver_step skv_world_describe_step(const skv_world *world, const skv_constants *constants,
                                        skv_external_force forces[SKV_SOLVER_MOST_FORCES])
{
    const skv_state *s = &world->state;
    skv_solver_step step = {
        .particles = {.count = s->count,
                      .x = s->x,
                      .y = s->y,
                      .vx = s->vx,
                      .vy = s->vy,
                      .clearance = s->clearance,
                      .pressure = s->pressure,
                      .warm_lambda = s->warm_lambda,
                      .mass = skv_world_masses(world),
                      .drag = skv_world_drags(world),
                      .id = s->id},
        .constants = constants,
        .gravity_x = world->gravity_x,
        .gravity_y = world->gravity_y,
        .forces = forces,
        .force_count = skv_make_external_forces(&world->acting, world->h, constants->dt, forces),
        .substeps = 1,
        .pool = world->pool,
    };
    skv_world_tell_fluids(world, &step.particles);
    return step;
}

/* What moves of the fluid: springs and air change velocities, the solver does all else. */
static void move_fluid(skv_world *world, const skv_solver_step *step)
{
    const bool partial = step->particles.part != NULL;
    skv_springs_push(world, world->constants.dt, partial);
    skv_air_push(world, world->constants.dt, partial);
    skv_impulse given = world->solver->type->advance(world->solver, step);
    if (!step->ungauged)
        skv_air_gauge(world, partial);
    double s = (double)world->fluid.spacing, mass = (double)world->fluid.density * s * s;
    double scale = mass / (double)world->constants.dt;
    world->wall_impulse.x += scale * given.x;
    world->wall_impulse.y += scale * given.y;
    world->wall_impulse.moment += scale * given.moment;
}

/* Takes some substeps, `time` seconds in all; what sleeps stays. `ungauged`: others follow before
 * anybody asks for pressures, unless films between bodies and walls do. */
static skv_result take_substeps(skv_world *world, int substeps, float time, bool ungauged,
                                skv_error *error)
{
    const double dt = (double)world->constants.dt;
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = skv_world_describe_step(world, &world->constants, forces);
    step.substeps = substeps;
    skv_result result = world->solver->type->reserve(world->solver, &step, error);
    if (result == SKV_OK)
        result = skv_springs_prepare(world, error);
    if (result != SKV_OK)
        return result;
    skv_bodies_move(world, dt);
    step.ungauged = ungauged && !skv_bodies_may_have_films(world);
    step.solid_given = skv_world_has_bodies(world) ? world->bodies->given : NULL;
    bool partial, moves = skv_sleep_plan(world, time, &partial) > 0;
    step.particles.part = partial ? world->state.part : NULL;
    if (moves)
        move_fluid(world, &step);
    skv_bodies_feel(world, dt, moves);
    if (moves && skv_pool_is_stopped(world->pool))
        return skv_fail(error, SKV_STOPPED, "the step was stopped");
    skv_sleep_watch(world, time);
    return SKV_OK;
}

/* Adds dt to the time that is owed and takes the whole substeps out of it. What is whole but for
 * the rounding of a float dt is whole, so 1/60 s is a frame, always. */
static int take_due(skv_world *world, double dt)
{
    double due = world->due + dt * 60 * world->substeps;
    double whole = floor(due + 0.5);
    if (fabs(due - whole) > DT_ROUNDING * whole)
        whole = floor(due);
    else
        due = whole;
    world->due = due - whole;
    return (int)whole;
}

/* Whether particles may come or go between substeps: a closed emitter does nothing. */
static bool has_flow(const skv_acting *acting)
{
    bool flows = acting->drain_count > 0;
    for (int i = 0; i < acting->emitter_count; i++)
        flows |= skv_emitter_speed(&acting->emitters[i]) > 0;
    return flows;
}

static void call_host(skv_world *world)
{
    if (!world->before_substep)
        return;
    world->busy = SKV_IN_SUBSTEPS;
    world->before_substep(world, world->constants_dt, world->before_substep_user);
    world->busy = SKV_AT_WORK;
}

/* Takes `count` substeps, with what happens between them; writes how many are done. Many at once,
 * unless somebody may come or go between them. */
static skv_result advance(skv_world *world, int count, int *done, skv_error *error)
{
    bool open = skv_terrain_open_sides(world->terrain) != 0;
    bool flows = has_flow(&world->acting);
    bool asks = flows || world->before_substep; /* for pressures */
    bool one_by_one = open || asks || skv_world_has_bodies(world) || skv_world_is_springy(world) ||
                      world->air || world->solver->type->most_substeps < count;
    int at_once = one_by_one ? 1 : count;
    double time = at_once / (60.0 * world->substeps); /* gravity may change them on the way */
    skv_pool_go(world->pool);
    for (; *done < count; *done += at_once) {
        if (skv_pool_asks_to_stop(world->pool))
            return skv_fail(error, SKV_STOPPED, "the step was stopped");
        call_host(world);
        skv_result result = SKV_OK;
        if (flows)
            result = skv_world_let_flow(world, world->constants_dt, error);
        if (open && result == SKV_OK)
            result = skv_events_reserve(&world->events, world->state.count, error);
        if (result == SKV_OK)
            result =
                take_substeps(world, at_once, (float)time, !asks && *done + at_once < count, error);
        if (result != SKV_OK)
            return result;
        if (open) {
            skv_world_remove_leavers(world);
            skv_bodies_remove_leavers(world);
        }
        world->time += time;
        world->steps += at_once;
    }
    return SKV_OK;
}

skv_result skv_world_step(skv_world *world, float dt, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world), SKV_ERROR_VALUE);
    if (!skv_within((double)dt, (double)LEAST_STEP, (double)LONGEST_STEP)) {
        char text[32];
        skv_format_float((double)dt, text);
        return skv_fail(error, SKV_ERROR_VALUE,
                        "step: dt %s s is out of range; allowed is %g..%g s", text,
                        (double)LEAST_STEP, (double)LONGEST_STEP);
    }
    double owed = world->due, began = world->time;
    world->wall_impulse = (skv_wall_impulse){0};
    int count = take_due(world, (double)dt);
    float part = 1.0f / 60 / (float)world->substeps, stiffness = skv_load_stiffness(world);
    if (world->constants_stale || part != world->constants_dt ||
        stiffness != world->constants_stiffness) {
        world->constants = skv_world_make_constants(world);
        world->constants_dt = part;
        world->constants_stiffness = stiffness;
        world->constants_stale = false;
    }
    world->busy = SKV_AT_WORK;
    skv_events_begin(&world->events);
    skv_bodies_begin_step(world);
    int done = 0;
    skv_result result = advance(world, count, &done, error);
    if (result != SKV_OK)
        world->due = done == 0 ? owed : world->due + count - done;
    skv_events_end(&world->events);
    world->busy = SKV_IDLE;
    skv_load_follow(world, began);
    skv_ramp_follow(world, began);
    return result;
}

skv_profile skv_world_profile(skv_world *world, bool reset)
{
    skv_profile profile = {0};
    SKV_ASSERT_OR(world, profile);
    const skv_solver_type *solver = world->solver->type;
    profile.count = solver->pass_count;
    memcpy(profile.name, solver->pass_names, sizeof profile.name);
    solver->profile(world->solver, reset, profile.seconds);
    return profile;
}
