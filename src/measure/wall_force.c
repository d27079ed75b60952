/* Force on walls: the walls' share in the corrections of one substep, times -m/dt^2.
 *
 * A wall acts on a particle through the wall density's push, through contact, and by stopping its
 * moves; what a particle gains by that, the wall loses. A solver like the world's takes the substep
 * on a copy of the fluid near the box, and reports that reaction; air that pushes the fluid pushes
 * the copy, and the walls (wall_air.c). Invariant: the copy reaches so
 * far that no particle whose force counts has a neighbour, or a neighbour's neighbour, missing.
 */
#include "measure/wall_force.h"

#include "base/arrays.h"
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "world/air/air.h"
#include "world/springs/springs.h"

#include <math.h>
#include <string.h>

void skv_force_free(skv_force_meter *m)
{
    if (m->solver)
        m->solver->type->destroy(m->solver);
    skv_free(m->block);
    skv_free(m->pushes.block);
    memset(m, 0, sizeof *m);
}

static skv_result reserve(skv_force_meter *m, int count, skv_error *error)
{
    if (count <= m->capacity)
        return SKV_OK;
    int capacity = count > 2 * m->capacity ? count : 2 * m->capacity;
    size_t room = (size_t)capacity;
    const skv_array arrays[] = {
        SKV_ARRAY(m->x, room, 0),           SKV_ARRAY(m->y, room, 0),
        SKV_ARRAY(m->vx, room, 0),          SKV_ARRAY(m->vy, room, 0),
        SKV_ARRAY(m->clearance, room, 0),   SKV_ARRAY(m->pressure, room, 0),
        SKV_ARRAY(m->warm_lambda, room, 0), SKV_ARRAY(m->id, room, 0),
        SKV_ARRAY(m->mass, room, 0),
    };
    if (!skv_arrays_grow(&m->block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a force on walls");
    m->capacity = capacity;
    return SKV_OK;
}

/* A solver for the fluid around the box. With every iteration, a particle's correction depends on
 * neighbours one h further away, twice: by their densities and by their moves. */
static skv_result prepare_solver(skv_force_meter *m, const skv_world *world,
                                 const skv_reaction *box, skv_error *error)
{
    double reach = 2 * (world->fluid.iterations + 1) * (double)world->h;
    const skv_solver_def def = {
        .x0 = (float)(box->x0 - reach),
        .y0 = (float)(box->y0 - reach),
        .x1 = (float)(box->x1 + reach),
        .y1 = (float)(box->y1 + reach),
        .h = world->h,
        .per_square = world->fluid.radius_ratio * world->fluid.radius_ratio,
        .boundary = &world->boundary,
    };
    const skv_solver_def *had = &m->made_for;
    if (m->solver && def.x0 == had->x0 && def.y0 == had->y0 && def.x1 == had->x1 &&
        def.y1 == had->y1 && def.h == had->h && def.boundary == had->boundary)
        return SKV_OK;
    if (m->solver)
        m->solver->type->destroy(m->solver);
    m->solver = NULL;
    m->made_for = def;
    return world->solver->type->create(&def, &m->solver, error);
}

static bool is_near(const skv_force_meter *m, float x, float y)
{
    const skv_solver_def *around = &m->made_for;
    return x > around->x0 && x < around->x1 && y > around->y0 && y < around->y1;
}

/* Puts a copy of the particles near the box in the place of the world's. */
static skv_result copy_fluid(skv_force_meter *m, const skv_world *world, const skv_pushed *pushed,
                             skv_solver_step *step, skv_error *error)
{
    const skv_solver_particles from = step->particles;
    int count = 0;
    for (int i = 0; i < from.count; i++)
        count += is_near(m, from.x[i], from.y[i]);
    skv_result result = reserve(m, count, error);
    if (result != SKV_OK)
        return result;
    int k = 0;
    for (int i = 0; i < from.count; i++) {
        if (!is_near(m, from.x[i], from.y[i]))
            continue;
        m->x[k] = from.x[i];
        m->y[k] = from.y[i];
        m->vx[k] = from.vx[i] + (pushed ? pushed->dvx[i] : 0);
        m->vy[k] = from.vy[i] + (pushed ? pushed->dvy[i] : 0);
        if (world->air)
            skv_air_push_one(world, i, step->constants->dt, &m->vx[k], &m->vy[k]);
        m->warm_lambda[k] = from.warm_lambda[i];
        m->mass[k] = from.mass ? from.mass[i] : 1;
        m->id[k] = from.id[i];
        m->clearance[k++] = 0;
    }
    step->particles = (skv_solver_particles){
        .count = count,
        .x = m->x,
        .y = m->y,
        .vx = m->vx,
        .vy = m->vy,
        .clearance = m->clearance,
        .pressure = m->pressure,
        .warm_lambda = m->warm_lambda,
        .mass = from.mass ? m->mass : NULL,
        .id = m->id,
    };
    return SKV_OK;
}

skv_result skv_force_measure(skv_force_meter *m, const skv_world *world, double x0, double y0,
                             double x1, double y1, skv_wall_force *force, skv_error *error)
{
    SKV_ASSERT_OR(m && world && force, SKV_ERROR_VALUE);
    *force = (skv_wall_force){0};
    skv_reaction reaction = {
        skv_min(x0, x1), skv_min(y0, y1), skv_max(x0, x1), skv_max(y0, y1), 0, 0, 0};
    const skv_constants constants = skv_world_make_constants(world);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    skv_solver_step step = skv_world_describe_step(world, &constants, forces);
    skv_result result = prepare_solver(m, world, &reaction, error);
    const skv_pushed *pushed = NULL;
    if (result == SKV_OK)
        result = skv_springs_ask(&m->pushes, world, constants.dt, &pushed, error);
    if (result == SKV_OK)
        result = copy_fluid(m, world, pushed, &step, error);
    step.reaction = &reaction;
    step.pool = NULL; /* others may read the world meanwhile */
    if (result == SKV_OK)
        result = m->solver->type->reserve(m->solver, &step, error);
    if (result != SKV_OK)
        return result;
    m->solver->type->advance(m->solver, &step);
    double dt = (double)constants.dt, s = (double)world->fluid.spacing;
    double scale = -(double)world->fluid.density * s * s / (dt * dt);
    *force = (skv_wall_force){scale * reaction.dx, scale * reaction.dy, scale * reaction.moment};
    skv_force_add_air(world, &reaction, force);
    return SKV_OK;
}
