/* The reference solver's substep: one pass after the other over all particles, for reading, and for
 * measuring the production solver against. The passes and their order are those of step.c.
 *
 * Invariant: a pass writes a particle's own elements only, and none that the same pass reads from
 * others; so the result does not depend on the number of threads.
 */
#include "base/platform.h"
#include "world/frame.h"

#include <math.h>

/* What the passes of one substep share. */
typedef struct substep {
    skv_world *world;
    skv_state *state;
    const skv_constants *constants;
    skv_pull pulls[SKV_MAX_HANDS];
    bool with_gradient; /* the density pass of the first iteration */
} substep;

/* Moves particle i by (dx, dy) as far as the walls allow; returns the share it could move.
 * `clearance` is a lower bound of the distance to the nearest wall: only moves that exceed it look
 * at the terrain, which in a pool are one in ten. */
static float move_particle(const substep *sub, int i, float dx, float dy)
{
    skv_state *s = sub->state;
    /* The distance is bilinear: along a diagonal it can fall by the square root of two. */
    s->clearance[i] -= 1.4143f * sqrtf(dx * dx + dy * dy);
    if (s->clearance[i] <= sub->world->wall_clearance)
        return skv_move_at_walls(sub->world, &s->x[i], &s->y[i], dx, dy, &s->clearance[i]);
    s->x[i] += dx;
    s->y[i] += dy;
    return 1;
}

static void external_forces(int begin, int end, void *context)
{
    const substep *sub = context;
    const skv_world *world = sub->world;
    skv_pass_external_forces(sub->state, sub->constants, world->gravity_x, world->gravity_y,
                             sub->pulls, world->hand_count, begin, end);
}

static void viscosity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_viscosity(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

static void apply_viscosity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_apply_viscosity(sub->state, begin, end);
}

/* What a wall stops of the advance is a correction: it leaves the velocity. */
static void advance(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    skv_pass_advance(s, sub->constants, begin, end);
    for (int i = begin; i < end; i++) {
        float lost = move_particle(sub, i, s->dx[i], s->dy[i]) - 1;
        s->wx[i] = lost * s->dx[i];
        s->wy[i] = lost * s->dy[i];
    }
}

static void walls(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    for (int i = begin; i < end; i++) {
        skv_wall_sample wall;
        skv_walls_at(sub->world, s->x[i], s->y[i], &wall);
        s->wall_density[i] = wall.r;
        s->wall_near[i] = wall.rn;
        s->f1x[i] = wall.f1x;
        s->f1y[i] = wall.f1y;
        s->f2x[i] = wall.f2x;
        s->f2y[i] = wall.f2y;
    }
}

static void density(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_density(sub->state, sub->constants, &sub->world->neighbours, sub->with_gradient, begin,
                     end);
}

static void pressure(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pressure_law *law = sub->world->fluid.law == SKV_LAW_CLAVET ? skv_pass_pressure_clavet
                                                                    : skv_pass_pressure_calibrated;
    law(sub->state, sub->constants, begin, end);
}

static void displacement(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_displacement(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

static void tension(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_tension(sub->state, sub->constants, &sub->world->neighbours, begin, end);
}

/* Carries out the collected corrections and keeps what was carried out in w. */
static void correct(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    for (int i = begin; i < end; i++) {
        float made = move_particle(sub, i, s->dx[i], s->dy[i]);
        s->wx[i] += made * s->dx[i];
        s->wy[i] += made * s->dy[i];
    }
}

/* Finds out how deep particles are inside the contact distance. */
static void find_contacts(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_state *s = sub->state;
    for (int i = begin; i < end; i++) {
        s->depth[i] = 0;
        if (s->clearance[i] < sub->constants->contact_distance)
            s->depth[i] = skv_contact_depth(sub->world, s->x[i], s->y[i], &s->normal_x[i],
                                            &s->normal_y[i], &s->clearance[i]);
    }
}

static void contact(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_contact(sub->state, sub->constants, begin, end);
}

static void update_velocity(int begin, int end, void *context)
{
    const substep *sub = context;
    skv_pass_update_velocity(sub->state, sub->constants, begin, end);
}

/* Runs one pass over all particles and books its time. */
static void run(substep *sub, skv_pass pass, skv_task *task)
{
    double start = skv_clock();
    skv_pool_run(sub->world->pool, sub->state->count, task, sub);
    sub->world->pass_seconds[pass] += skv_clock() - start;
}

static void update_neighbours(substep *sub)
{
    skv_world *world = sub->world;
    double start = skv_clock();
    skv_neighbours_build(&world->neighbours, &world->state, world->h, world->pool);
    world->lists_current = true;
    world->pass_seconds[SKV_PASS_NEIGHBOURS] += skv_clock() - start;
}

void skv_reference_substep(skv_world *world)
{
    const skv_fluid_def *fluid = &world->fluid;
    substep passes = {.world = world, .state = &world->state, .constants = &world->constants};
    substep *sub = &passes;
    for (int i = 0; i < world->hand_count; i++)
        sub->pulls[i] = skv_make_pull(&world->hands[i], world->constants.dt);
    run(sub, SKV_PASS_FORCES, external_forces);
    if (world->constants.viscosity_linear > 0 || world->constants.viscosity_quadratic > 0) {
        /* The lists of the last substep serve, unless particles came or went. */
        if (!sub->world->lists_current)
            update_neighbours(sub);
        run(sub, SKV_PASS_VISCOSITY, viscosity);
        run(sub, SKV_PASS_VISCOSITY, apply_viscosity);
    }
    run(sub, SKV_PASS_ADVANCE, advance);
    update_neighbours(sub);
    for (int i = 0; i < fluid->iterations; i++) {
        run(sub, SKV_PASS_WALLS, walls);
        sub->with_gradient = i == 0 && fluid->law == SKV_LAW_CALIBRATED;
        run(sub, SKV_PASS_DENSITY, density);
        run(sub, SKV_PASS_PRESSURE, pressure);
        run(sub, SKV_PASS_DISPLACEMENT, displacement);
        if (sub->with_gradient)
            run(sub, SKV_PASS_DISPLACEMENT, tension);
        run(sub, SKV_PASS_DISPLACEMENT, correct);
    }
    run(sub, SKV_PASS_CONTACT, find_contacts);
    run(sub, SKV_PASS_CONTACT, contact);
    run(sub, SKV_PASS_CONTACT, correct);
    run(sub, SKV_PASS_VELOCITY, update_velocity);
}
