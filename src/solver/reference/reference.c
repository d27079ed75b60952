/* How a fluid moves: a substep as a list of passes, `take_substep`.
 *
 * A substep predicts every particle's position from its velocity, relaxes the positions until the
 * density is right, and takes the velocity from where the particles have ended (prediction and
 * relaxation, thesis section 3.1.1). The order of the passes is the method; "Algorithm" is the
 * thesis' number. The production solver does the same for one row of space after the other.
 *
 * Invariant: a step begins and ends in the caller's arrays, which are in single precision; what is
 * kept between steps is memory only.
 */
#include "solver/reference/reference.h"

#include "base/arrays.h"
#include "base/memory.h"
#include "base/platform.h"

#include <math.h>
#include <string.h>

/* How far the lists reach, in h: what comes within h until the last iteration is in them, too. With
 * 1 pressures are 2e-6 off. */
#define LIST_REACH 1.02f

/* What the passes are booked under, for the profile. */
enum {
    FORCES,
    VISCOSITY,
    ADVANCE,
    NEIGHBOURS,
    WALLS,
    DENSITY,
    PRESSURE,
    DISPLACEMENT,
    CONTACT,
    VELOCITY,
    PASSES
};

static void run(skv_reference *f, int booked, skv_pass *pass);
static void list_neighbours(skv_reference *f);

/* The method. */
static void take_substep(skv_reference *f)
{
    const skv_constants *c = f->constants;
    run(f, FORCES, skv_pass_external_forces); /* v += dt (g + a_hand): Algorithm 2 */
    run(f, ADVANCE, skv_pass_predict);        /* x += dt v, stopped at walls: 4 */
    f->advances = true;
    run(f, ADVANCE, skv_pass_move);
    f->advances = false;
    run(f, ADVANCE, skv_pass_lag);            /* pairs are taken behind that */
    run(f, NEIGHBOURS, list_neighbours);      /* lists of pairs within h: 5 */
    for (int i = 0; i < c->iterations; i++) { /* until the density is right: 6 */
        f->first = i == 0;
        f->last = i == c->iterations - 1;
        run(f, WALLS, skv_pass_walls);               /* what the solid adds, and images */
        run(f, DENSITY, skv_pass_density);           /* rho, near density and gradient */
        run(f, PRESSURE, skv_pass_pressure);         /* P and N */
        run(f, DISPLACEMENT, skv_pass_displacement); /* along the pressure differences */
        if (f->first && !c->clavet)
            run(f, DISPLACEMENT, skv_pass_tension);
        if (f->first && (skv_is_viscous(c) || f->various))
            run(f, VISCOSITY, skv_pass_viscosity); /* approaching pairs exchange impulses: 3 */
        if (f->first && f->massive)
            run(f, DISPLACEMENT, skv_pass_turn); /* what is light from below what is heavy */
        if (f->first && f->liquids)
            run(f, DISPLACEMENT, skv_pass_push); /* fluids from each other */
        run(f, DISPLACEMENT, skv_pass_divide);   /* what is heavy gives way less */
        if (f->last && (skv_resists_slip(c) || f->various))
            run(f, DISPLACEMENT, skv_pass_slip); /* what a wall holds of the slip along it */
        run(f, DISPLACEMENT, skv_pass_move);     /* x += dx, stopped at walls */
        run(f, DISPLACEMENT, skv_pass_lag);
    }
    run(f, CONTACT, skv_pass_contact);   /* friction and push at walls: 7 */
    run(f, VELOCITY, skv_pass_velocity); /* v = what was moved / dt: 8 */
}

/* Runs one pass over all particles and books its time. */
static void run(skv_reference *f, int booked, skv_pass *pass)
{
    double start = skv_clock();
    pass(f);
    f->seconds[booked] += skv_clock() - start;
}

static void list_neighbours(skv_reference *f)
{
    for (int i = 0; i < f->count; i++) {
        f->listed_x[i] = (float)(f->x[i] - f->behind_x[i]);
        f->listed_y[i] = (float)(f->y[i] - f->behind_y[i]);
    }
    skv_neighbours_build(&f->neighbours, f->listed_x, f->listed_y, f->count,
                         LIST_REACH * f->constants->h);
}

static void load(skv_reference *f, const skv_solver_particles *p)
{
    const double dt = (double)f->constants->dt;
    f->count = p->count;
    f->id = p->id;
    f->massive = p->mass != NULL;
    f->fluid = p->fluid;
    f->liquids = p->liquids;
    f->cohesion = p->cohesion;
    f->various = p->mass && p->drag;
    for (int i = 0; i < p->count; i++) {
        f->x[i] = (double)p->x[i];
        f->y[i] = (double)p->y[i];
        f->vx[i] = (double)p->vx[i];
        f->vy[i] = (double)p->vy[i];
        f->clearance[i] = (double)p->clearance[i];
        f->warm_lambda[i] = dt * dt * (double)p->warm_lambda[i];
        f->mass[i] = p->mass ? (double)p->mass[i] : 1;
        f->drag[i] = dt * (f->various ? (double)p->drag[i]
                                      : f->mass[i] * (double)f->constants->viscosity_linear);
    }
}

static void store(const skv_reference *f, const skv_solver_particles *p)
{
    const double dt = (double)f->constants->dt;
    for (int i = 0; i < p->count; i++) {
        p->x[i] = (float)f->x[i];
        p->y[i] = (float)f->y[i];
        p->vx[i] = (float)f->vx[i];
        p->vy[i] = (float)f->vy[i];
        p->clearance[i] = (float)f->clearance[i];
        p->pressure[i] = (float)f->pressure[i];
        if (!f->constants->clavet)
            p->warm_lambda[i] = (float)(f->warm_lambda[i] / (dt * dt));
    }
}

static skv_impulse advance(skv_solver *solver, const skv_solver_step *step)
{
    skv_reference *f = (skv_reference *)solver;
    f->constants = step->constants;
    f->gravity_x = (double)step->gravity_x;
    f->gravity_y = (double)step->gravity_y;
    f->forces = step->forces;
    f->force_count = step->force_count;
    f->reaction = step->reaction;
    f->solid_given = f->boundary->solids ? step->solid_given : NULL;
    for (int k = 0; f->solid_given && k < f->boundary->solids->count; k++)
        f->solid_given[k] = (skv_impulse){0};
    f->given = (skv_impulse){0};
    load(f, &step->particles);
    for (int i = 0; i < step->substeps; i++)
        take_substep(f);
    store(f, &step->particles);
    return f->given;
}

static skv_result reserve_arrays(skv_reference *f, int count, skv_error *error)
{
    if (count <= f->capacity)
        return SKV_OK;
    int capacity = count > 2 * f->capacity ? count : 2 * f->capacity;
    size_t room = (size_t)capacity;
    const skv_array arrays[] = {
        SKV_ARRAY(f->x, room, 0),
        SKV_ARRAY(f->y, room, 0),
        SKV_ARRAY(f->vx, room, 0),
        SKV_ARRAY(f->vy, room, 0),
        SKV_ARRAY(f->clearance, room, 0),
        SKV_ARRAY(f->pressure, room, 0),
        SKV_ARRAY(f->warm_lambda, room, 0),
        SKV_ARRAY(f->mass, room, 0),
        SKV_ARRAY(f->drag, room, 0),
        SKV_ARRAY(f->moved_x, room, 0),
        SKV_ARRAY(f->moved_y, room, 0),
        SKV_ARRAY(f->behind_x, room, 0),
        SKV_ARRAY(f->behind_y, room, 0),
        SKV_ARRAY(f->dx, room, 0),
        SKV_ARRAY(f->dy, room, 0),
        SKV_ARRAY(f->density, room, 0),
        SKV_ARRAY(f->near_density, room, 0),
        SKV_ARRAY(f->mean_mass, room, 0),
        SKV_ARRAY(f->gradient_x, room, 0),
        SKV_ARRAY(f->gradient_y, room, 0),
        SKV_ARRAY(f->hanging, room, 0),
        SKV_ARRAY(f->lambda, room, 0),
        SKV_ARRAY(f->near_lambda, room, 0),
        SKV_ARRAY(f->wall_density, room, 0),
        SKV_ARRAY(f->wall_near, room, 0),
        SKV_ARRAY(f->f1x, room, 0),
        SKV_ARRAY(f->f1y, room, 0),
        SKV_ARRAY(f->f2x, room, 0),
        SKV_ARRAY(f->f2y, room, 0),
        SKV_ARRAY(f->image, room, 0),
        SKV_ARRAY(f->facing_x, room, 0),
        SKV_ARRAY(f->facing_y, room, 0),
        SKV_ARRAY(f->listed_x, room, 0),
        SKV_ARRAY(f->listed_y, room, 0),
    };
    if (!skv_arrays_grow(&f->block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    f->capacity = capacity;
    f->bytes = skv_arrays_bytes(arrays, sizeof arrays / sizeof *arrays);
    return SKV_OK;
}

/* How much memory lists take the present positions tell: in a substep nothing is allocated. */
static skv_result reserve(skv_solver *solver, const skv_solver_step *step, skv_error *error)
{
    skv_reference *f = (skv_reference *)solver;
    const skv_solver_particles *p = &step->particles;
    skv_result result = reserve_arrays(f, p->count, error);
    if (result == SKV_OK)
        result = skv_neighbours_reserve(&f->neighbours, p->count, error);
    if (result != SKV_OK)
        return result;
    skv_neighbours_build(&f->neighbours, p->x, p->y, p->count, LIST_REACH * step->constants->h);
    return skv_neighbours_reserve(&f->neighbours, p->count, error);
}

static void destroy(skv_solver *solver)
{
    skv_reference *f = (skv_reference *)solver;
    skv_neighbours_destroy(&f->neighbours);
    skv_free(f->block);
    skv_free(f);
}

static skv_result create(const skv_solver_def *def, skv_solver **solver, skv_error *error)
{
    skv_reference *f = skv_calloc(1, sizeof *f);
    if (!f)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver");
    f->solver.type = &skv_reference_solver;
    f->boundary = def->boundary;
    /* Cells lie at multiples of their size, so that sums have the same order in any region. */
    float cell = LIST_REACH * def->h, margin = 2 * def->h;
    float x0 = floorf((def->x0 - margin) / cell) * cell;
    float y0 = floorf((def->y0 - margin) / cell) * cell;
    skv_result result = skv_neighbours_create(&f->neighbours, x0, y0, def->x1 + margin,
                                              def->y1 + margin, cell, def->boundary, error);
    if (result != SKV_OK) {
        destroy(&f->solver);
        return result;
    }
    *solver = &f->solver;
    return SKV_OK;
}

static void profile(skv_solver *solver, bool reset, double *seconds)
{
    skv_reference *f = (skv_reference *)solver;
    memcpy(seconds, f->seconds, PASSES * sizeof *seconds);
    if (reset)
        memset(f->seconds, 0, PASSES * sizeof *seconds);
}

static skv_solver_memory memory(const skv_solver *solver)
{
    const skv_reference *f = (const skv_reference *)solver;
    const skv_neighbours *n = &f->neighbours;
    size_t cells = (size_t)n->columns * (size_t)n->rows + 1;
    return (skv_solver_memory){
        .particles = f->bytes + (size_t)n->particle_capacity *
                                    (sizeof *n->sorted + sizeof *n->cell + sizeof *n->start),
        .kept = (size_t)n->list_capacity * sizeof *n->list,
        .grid = cells * sizeof *n->cell_start,
    };
}

const skv_solver_type skv_reference_solver = {
    .most_substeps = 1,
    .pass_count = PASSES,
    .pass_names = {"external forces", "viscosity", "advance", "neighbours", "walls", "density",
                   "pressure", "displacement", "contact", "velocity"},
    .create = create,
    .destroy = destroy,
    .reserve = reserve,
    .advance = advance,
    .profile = profile,
    .memory = memory,
};
