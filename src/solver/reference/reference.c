/* How a fluid moves: a substep as a list of passes, `take_substep`.
 *
 * A substep predicts every particle's position from its velocity, relaxes the positions until the
 * density is right, and takes the velocity from where the particles have ended (prediction and
 * relaxation, thesis section 3.1.1). The order of the passes is the method; "Algorithm" is the
 * thesis' number. The production solver does the same for one row of space after the other.
 *
 * Invariant: a pass writes a particle's own elements only, and none that the same pass reads from
 * others; so the result does not depend on the number of threads.
 */
#include "base/arrays.h"
#include "base/memory.h"
#include "base/platform.h"
#include "solver/reference/passes.h"

#include <math.h>
#include <string.h>

/* How far the lists reach, in h: what comes within h until the last iteration is in them, too. With
 * 1 pressures are 2e-6 off, with this 1e-6. */
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

typedef struct reference {
    skv_solver solver;
    const skv_boundary *boundary;
    float reach;        /* of the lists, m */
    skv_pass_data data; /* its own arrays; the caller's are those of the last step */
    int capacity;
    void *block;
    size_t bytes;
    skv_neighbours neighbours;
    /* Where the particles were when the lists were made, and their revision; 0: there are none.
     */
    float *listed_x, *listed_y;
    uint32_t listed;
    bool current; /* the lists have been made from there */
    double seconds[PASSES];

    /* Of the step under way. */
    skv_substep substep;
    skv_pass *pass;
    skv_pool *pool;
} reference;

static void run(reference *r, int booked, skv_pass *pass);
static void update_neighbours(reference *r);

/* The method. */
static void take_substep(reference *r)
{
    const skv_constants *c = r->substep.constants;
    run(r, FORCES, skv_pass_external_forces); /* v += dt (g + a_hand): Algorithm 2 */
    if (skv_is_viscous(c)) {                  /* pairs that approach exchange impulses: 3 */
        run(r, VISCOSITY, skv_pass_viscosity);
        run(r, VISCOSITY, skv_pass_apply_viscosity);
    }
    run(r, ADVANCE, skv_pass_predict); /* x += dt v, stopped at walls: 4 */
    run(r, ADVANCE, skv_pass_advance);
    run(r, ADVANCE, skv_pass_lag);            /* pairs are taken behind that */
    update_neighbours(r);                     /* lists of pairs within h: 5 */
    for (int i = 0; i < c->iterations; i++) { /* until the density is right: 6 */
        r->substep.first = i == 0;
        r->substep.last = i == c->iterations - 1;
        if (i > 0)
            run(r, DISPLACEMENT, skv_pass_lag);
        run(r, WALLS, skv_pass_walls);     /* what the solid adds to the sums, and images */
        run(r, DENSITY, skv_pass_density); /* rho, near density and gradient */
        run(r, PRESSURE, c->clavet ? skv_pass_pressure_clavet : skv_pass_pressure_calibrated);
        run(r, DISPLACEMENT, skv_pass_displacement); /* along the pressure differences */
        if (i == 0 && !c->clavet)
            run(r, DISPLACEMENT, skv_pass_tension);
        if (i == c->iterations - 1 && skv_resists_slip(c))
            run(r, DISPLACEMENT, skv_pass_slip); /* what a wall holds of the slip along it */
        run(r, DISPLACEMENT, skv_pass_correct);  /* x += dx, stopped at walls */
    }
    run(r, CONTACT, skv_pass_find_contacts); /* friction and push at walls: 7 */
    run(r, CONTACT, skv_pass_contact);
    run(r, CONTACT, skv_pass_correct);
    run(r, VELOCITY, skv_pass_update_velocity); /* v += (sum of corrections) / dt: 8 */
}

static void task(int begin, int end, void *context)
{
    const reference *r = context;
    r->pass(&r->substep, begin, end);
}

/* Runs one pass over all particles and books its time. */
static void run(reference *r, int booked, skv_pass *pass)
{
    double start = skv_clock();
    r->pass = pass;
    skv_pool_run(r->pool, r->substep.data.count, task, r);
    r->seconds[booked] += skv_clock() - start;
}

static void list_from(reference *r, const float *x, const float *y, int count)
{
    if (count == 0)
        return;
    memcpy(r->listed_x, x, (size_t)count * sizeof *x);
    memcpy(r->listed_y, y, (size_t)count * sizeof *y);
}

static void update_neighbours(reference *r)
{
    double start = skv_clock();
    const skv_pass_data *s = &r->substep.data;
    for (int i = 0; i < s->count; i++) {
        r->listed_x[i] = s->x[i] - s->behind_x[i];
        r->listed_y[i] = s->y[i] - s->behind_y[i];
    }
    skv_neighbours_build(&r->neighbours, r->listed_x, r->listed_y, s->count, r->reach, r->pool);
    r->seconds[NEIGHBOURS] += skv_clock() - start;
}

static skv_impulse advance(skv_solver *solver, const skv_solver_step *step)
{
    reference *r = (reference *)solver;
    const skv_solver_particles *p = &step->particles;
    skv_pass_data *s = &r->data;
    s->count = p->count;
    s->x = p->x;
    s->y = p->y;
    s->vx = p->vx;
    s->vy = p->vy;
    s->clearance = p->clearance;
    s->pressure = p->pressure;
    s->warm_lambda = p->warm_lambda;
    s->id = p->id;
    skv_shared_impulse given = {0};
    r->substep = (skv_substep){
        .data = *s,
        .constants = step->constants,
        .gravity_x = step->gravity_x,
        .gravity_y = step->gravity_y,
        .forces = step->forces,
        .force_count = step->force_count,
        .neighbours = &r->neighbours,
        .boundary = r->boundary,
        .given = &given,
        .reaction = step->reaction,
    };
    r->pool = step->reaction ? NULL : step->pool;
    for (int i = 0; i < step->substeps; i++)
        take_substep(r);
    const skv_impulse_sum sum = {given.x, given.y, given.moment};
    skv_impulse in_h = skv_impulse_value(&sum);
    double h = (double)step->constants->h;
    return (skv_impulse){in_h.x * h, in_h.y * h, in_h.moment * h * h};
}

static skv_result reserve_arrays(reference *r, int count, skv_error *error)
{
    if (count <= r->capacity)
        return SKV_OK;
    int capacity = count > 2 * r->capacity ? count : 2 * r->capacity;
    size_t room = (size_t)capacity, kept = (size_t)r->capacity;
    skv_pass_data *s = &r->data;
    const skv_array arrays[] = {
        SKV_ARRAY(s->wx, room, 0),           SKV_ARRAY(s->wy, room, 0),
        SKV_ARRAY(s->behind_x, room, 0),     SKV_ARRAY(s->behind_y, room, 0),
        SKV_ARRAY(s->dx, room, 0),           SKV_ARRAY(s->dy, room, 0),
        SKV_ARRAY(s->density, room, 0),      SKV_ARRAY(s->near_density, room, 0),
        SKV_ARRAY(s->gradient_x, room, 0),   SKV_ARRAY(s->gradient_y, room, 0),
        SKV_ARRAY(s->lambda, room, 0),       SKV_ARRAY(s->near_lambda, room, 0),
        SKV_ARRAY(s->wall_density, room, 0), SKV_ARRAY(s->wall_near, room, 0),
        SKV_ARRAY(s->f1x, room, 0),          SKV_ARRAY(s->f1y, room, 0),
        SKV_ARRAY(s->f2x, room, 0),          SKV_ARRAY(s->f2y, room, 0),
        SKV_ARRAY(s->image, room, 0),        SKV_ARRAY(s->facing_x, room, 0),
        SKV_ARRAY(s->facing_y, room, 0),     SKV_ARRAY(s->depth, room, 0),
        SKV_ARRAY(s->normal_x, room, 0),     SKV_ARRAY(s->normal_y, room, 0),
        SKV_ARRAY(r->listed_x, room, kept),  SKV_ARRAY(r->listed_y, room, kept),
    };
    if (!skv_arrays_grow(&r->block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    r->capacity = capacity;
    r->bytes = skv_arrays_bytes(arrays, sizeof arrays / sizeof *arrays);
    return SKV_OK;
}

/* The lists of a substep are those that it finds after its advance; before, the viscosity reads the
 * last substep's. Where there are none, for particles came or went, the present positions give
 * them, and say how much memory lists take. */
static skv_result reserve(skv_solver *solver, const skv_solver_step *step, skv_error *error)
{
    reference *r = (reference *)solver;
    const skv_solver_particles *p = &step->particles;
    skv_result result = reserve_arrays(r, p->count, error);
    if (result == SKV_OK)
        result = skv_neighbours_reserve(&r->neighbours, p->count, error);
    if (result == SKV_OK && r->listed != p->revision) {
        list_from(r, p->x, p->y, p->count);
        r->listed = p->revision;
        r->current = false;
    }
    while (result == SKV_OK && !r->current) {
        skv_neighbours_build(&r->neighbours, r->listed_x, r->listed_y, p->count, r->reach,
                             step->pool);
        r->current = r->neighbours.wanted <= r->neighbours.list_capacity;
        result = skv_neighbours_reserve(&r->neighbours, p->count, error);
    }
    return result;
}

static int recall(const skv_solver *solver, uint32_t revision,
                  const float *memories[SKV_SOLVER_MOST_MEMORIES])
{
    const reference *r = (const reference *)solver;
    memories[0] = r->listed_x;
    memories[1] = r->listed_y;
    return r->listed == revision ? 2 : 0;
}

static skv_result make_memories(skv_solver *solver, int count,
                                float *memories[SKV_SOLVER_MOST_MEMORIES], skv_error *error)
{
    reference *r = (reference *)solver;
    skv_result result = reserve_arrays(r, count, error);
    memories[0] = r->listed_x;
    memories[1] = r->listed_y;
    return result;
}

static void remember(skv_solver *solver, uint32_t revision)
{
    reference *r = (reference *)solver;
    r->listed = revision;
    r->current = false;
}

static void destroy(skv_solver *solver)
{
    reference *r = (reference *)solver;
    skv_neighbours_destroy(&r->neighbours);
    skv_free(r->block);
    skv_free(r);
}

static skv_result create(const skv_solver_def *def, skv_solver **solver, skv_error *error)
{
    reference *r = skv_calloc(1, sizeof *r);
    if (!r)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver");
    r->solver.type = &skv_reference_solver;
    r->boundary = def->boundary;
    r->reach = LIST_REACH * def->h;
    /* Cells lie at multiples of their size, so that sums have the same order in any region. */
    float margin = 2 * def->h, x0 = floorf((def->x0 - margin) / r->reach) * r->reach;
    float y0 = floorf((def->y0 - margin) / r->reach) * r->reach;
    skv_result result = skv_neighbours_create(&r->neighbours, x0, y0, def->x1 + margin,
                                              def->y1 + margin, r->reach, def->boundary, error);
    if (result != SKV_OK) {
        destroy(&r->solver);
        return result;
    }
    *solver = &r->solver;
    return SKV_OK;
}

static void profile(skv_solver *solver, bool reset, double *seconds)
{
    reference *r = (reference *)solver;
    memcpy(seconds, r->seconds, sizeof r->seconds);
    if (reset)
        memset(r->seconds, 0, sizeof r->seconds);
}

static skv_solver_memory memory(const skv_solver *solver)
{
    const reference *r = (const reference *)solver;
    const skv_neighbours *n = &r->neighbours;
    size_t cells = (size_t)n->columns * (size_t)n->rows + 1;
    return (skv_solver_memory){
        .particles = r->bytes + (size_t)n->particle_capacity *
                                    (sizeof *n->sorted + sizeof *n->cell + sizeof *n->start),
        .kept = (size_t)n->list_capacity * sizeof *n->list,
        .grid = cells * sizeof *n->cell_start,
    };
}

const skv_solver_type skv_reference_solver = {
    .reacts = true,
    .most_substeps = 1,
    .pass_count = PASSES,
    .pass_names = {"external forces", "viscosity", "advance", "neighbours", "walls", "density",
                   "pressure", "displacement", "contact", "velocity"},
    .create = create,
    .destroy = destroy,
    .reserve = reserve,
    .advance = advance,
    .recall = recall,
    .make_memories = make_memories,
    .remember = remember,
    .profile = profile,
    .memory = memory,
};
