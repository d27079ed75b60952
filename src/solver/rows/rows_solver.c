/* The production solver behind the interface: its units and axes.
 *
 * The rows work in h and substeps, and lie across the longer side of where fluid is expected: where
 * that is wider than high, their x is the world's y. Invariant: the caller's arrays hold the whole
 * state; what the solver keeps between steps is memory only.
 */
#include "base/memory.h"
#include "solver/rows/rows.h"
#include "solver/solver.h"

typedef struct rows_solver {
    skv_solver solver;
    skv_rows *rows;
    const skv_boundary *boundary;
    bool swapped; /* the rows' x is the world's y */
} rows_solver;

/* The same constants where h and dt are 1. */
static skv_constants in_own_units(const skv_constants *c)
{
    float inv_h = c->inv_h, per_step = c->dt * c->inv_h;
    skv_constants r = *c;
    r.h = r.inv_h = r.dt = 1;
    r.max_speed *= per_step;
    r.lag_rise /= per_step * per_step;
    r.viscosity_linear *= c->dt;
    r.viscosity_quadratic *= c->h; /* beta u: u is in h a substep here */
    float *const lengths[] = {&r.lambda_scale,  &r.near_lambda_scale, &r.lambda_limit,
                              &r.loose_lambda,  &r.warm_limit,        &r.cohesion_scale,
                              &r.tension_scale, &r.tension_until};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
        *lengths[i] *= inv_h;
    r.pressure_scale = r.pressure_scale * c->h * c->h;
    return r;
}

static skv_row_acting acting_on(const skv_solver_step *step, const skv_boundary *boundary,
                                const skv_external_force *forces)
{
    const skv_constants *c = step->constants;
    float per_step = c->dt * c->inv_h;
    skv_row_acting acting = {
        .gravity_x = step->gravity_x * c->dt * per_step,
        .gravity_y = step->gravity_y * c->dt * per_step,
        .forces = forces,
        .force_count = step->force_count,
        .wall_margin = boundary->margin * c->inv_h,
        .contact_distance = boundary->contact_distance * c->inv_h,
    };
    if (boundary->swapped)
        skv_swap(&acting.gravity_x, &acting.gravity_y);
    acting.turn_sense = boundary->swapped ? -1.0f : 1.0f;
    return acting;
}

/* Whether there is a viscosity by particle. */
static bool has_drags(const skv_solver_step *step)
{
    const skv_solver_particles *p = &step->particles;
    return p->mass && (p->drag || skv_is_viscous(step->constants));
}

static skv_impulse advance(skv_solver *solver, const skv_solver_step *step)
{
    const rows_solver *r = (const rows_solver *)solver;
    const skv_constants *c = step->constants;
    const skv_solver_particles *p = &step->particles;
    const skv_boundary boundary = skv_boundary_seen(r->boundary, c->h, c->inv_h, r->swapped);
    skv_external_force forces[SKV_SOLVER_MOST_FORCES];
    for (int i = 0; i < step->force_count; i++)
        forces[i] = skv_external_force_seen(&step->forces[i], c->h, c->inv_h, c->dt, r->swapped);
    const skv_constants constants = in_own_units(c);
    const skv_row_acting acting = acting_on(step, &boundary, forces);
    /* If each iteration lifts what has fallen by as much as any other. */
    float sunk = (float)(c->iterations + 1) / (float)(2 * c->iterations);
    skv_row_frame frame = {
        .count = p->count,
        .part = p->part,
        .x = r->swapped ? p->y : p->x,
        .y = r->swapped ? p->x : p->y,
        .vx = r->swapped ? p->vy : p->vx,
        .vy = r->swapped ? p->vx : p->vy,
        .clearance = p->clearance,
        .pressure = step->ungauged ? NULL : p->pressure,
        .warm_lambda = p->warm_lambda,
        .mass = p->mass,
        .drag = p->drag,
        .viscous = has_drags(step),
        .particles = p,
        .dt = c->dt,
        .length = c->inv_h,
        .speed = c->dt * c->inv_h,
        .lambda = c->dt * c->dt * c->inv_h,
        .sunk_x = sunk * acting.gravity_x,
        .sunk_y = sunk * acting.gravity_y,
    };
    skv_impulse given = skv_rows_step(r->rows, &frame, step->substeps, &constants, &acting,
                                      &boundary, step->pool, step->reaction, step->solid_given);
    double h = (double)c->h, x = given.x * h, y = given.y * h, moment = given.moment * h * h;
    return r->swapped ? (skv_impulse){y, x, -moment} : (skv_impulse){x, y, moment};
}

static skv_result reserve(skv_solver *solver, const skv_solver_step *step, skv_error *error)
{
    return skv_rows_reserve(((rows_solver *)solver)->rows, step->particles.count,
                            skv_pool_threads(step->pool), step->particles.mass != NULL,
                            has_drags(step), error);
}

static void destroy(skv_solver *solver)
{
    rows_solver *r = (rows_solver *)solver;
    skv_rows_destroy(r->rows);
    skv_free(r);
}

static skv_result create(const skv_solver_def *def, skv_solver **solver, skv_error *error)
{
    rows_solver *r = skv_calloc(1, sizeof *r);
    if (!r)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver");
    float width = def->x1 - def->x0, height = def->y1 - def->y0;
    r->solver.type = &skv_rows_solver;
    r->boundary = def->boundary;
    /* The more rows, the more evenly threads share them. */
    r->swapped = width > height;
    float along = r->swapped ? height : width, across = r->swapped ? width : height;
    skv_result result = skv_rows_create(along / def->h, across / def->h, def->per_square,
                                        def->instruction_set, &r->rows, error);
    if (result != SKV_OK) {
        skv_free(r);
        return result;
    }
    *solver = &r->solver;
    return SKV_OK;
}

static void profile(skv_solver *solver, bool reset, double *seconds)
{
    skv_rows_profile(((rows_solver *)solver)->rows, reset, seconds);
}

static skv_solver_memory memory(const skv_solver *solver)
{
    return skv_rows_memory(((const rows_solver *)solver)->rows);
}

const skv_solver_type skv_rows_solver = {
    .holds = true,
    .most_substeps = INT_MAX,
    .pass_count = 4,
    .pass_names = {"advance", "sort", "relaxation", "transfer"},
    .create = create,
    .destroy = destroy,
    .reserve = reserve,
    .advance = advance,
    .profile = profile,
    .memory = memory,
};
