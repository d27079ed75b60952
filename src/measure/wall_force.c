/* Force on walls: the walls' share in the corrections of one substep, times -m/dt^2.
 *
 * A wall acts on a particle through the wall density's push, through contact, and by stopping its
 * moves; what a particle gains by that, the wall loses. The substep is taken by the reference
 * solver's passes on a copy of the fluid near the box. Invariant: the copy reaches so far that no
 * particle whose force counts has a neighbour, or a neighbour's neighbour, missing.
 */
#include "measure/wall_force.h"

#include "base/assert.h"
#include "base/memory.h"
#include "world/frame.h"

#include <math.h>
#include <string.h>

enum { ARRAYS = 25 };

static void float_arrays(skv_state *s, float **arrays[ARRAYS])
{
    float **list[ARRAYS] = {
        &s->x,         &s->y,          &s->vx,           &s->vy,       &s->wx,
        &s->wy,        &s->dx,         &s->dy,           &s->density,  &s->push,
        &s->near_push, &s->gradient_x, &s->gradient_y,   &s->pressure, &s->near_density,
        &s->clearance, &s->wall_near,  &s->wall_density, &s->f1x,      &s->f1y,
        &s->f2x,       &s->f2y,        &s->normal_x,     &s->normal_y, &s->depth,
    };
    memcpy(arrays, list, sizeof list);
}

void skv_force_free(skv_force_meter *meter)
{
    skv_free(meter->block);
    skv_neighbours_destroy(&meter->neighbours);
    memset(meter, 0, sizeof *meter);
}

static skv_result reserve(skv_force_meter *m, int count, skv_error *error)
{
    if (count <= m->capacity)
        return SKV_OK;
    size_t capacity = (size_t)(count > 2 * m->capacity ? count : 2 * m->capacity);
    float *block = skv_calloc(capacity * (ARRAYS + 1), sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a force on walls");
    float **arrays[ARRAYS];
    float_arrays(&m->state, arrays);
    for (int i = 0; i < ARRAYS; i++)
        *arrays[i] = block + capacity * (size_t)i;
    m->state.id = (uint32_t *)(void *)(block + capacity * ARRAYS);
    skv_free(m->block);
    m->block = block;
    m->capacity = (int)capacity;
    return SKV_OK;
}

/* One measurement. */
typedef struct measurement {
    skv_force_meter *meter;
    const skv_world *world;
    skv_constants constants;
    double box[4];                   /* x0, y0, x1, y1 */
    double reach;                    /* how far around the box fluid is copied, m */
    double sum_x, sum_y, sum_torque; /* of the walls' displacements, m and m^2 */
} measurement;

/* With every iteration, a particle's correction depends on neighbours one h further away, twice:
 * by their densities and by their moves. */
static double reach_for(const skv_world *world)
{
    return 2 * (world->fluid.iterations + 1) * (double)world->h;
}

static bool is_near(const measurement *m, float x, float y)
{
    return (double)x > m->box[0] - m->reach && (double)x < m->box[2] + m->reach &&
           (double)y > m->box[1] - m->reach && (double)y < m->box[3] + m->reach;
}

static skv_result copy_fluid(measurement *m, skv_error *error)
{
    const skv_state *from = &m->world->state;
    skv_state *to = &m->meter->state;
    int count = 0;
    for (int i = 0; i < from->count; i++)
        count += is_near(m, from->x[i], from->y[i]);
    skv_result result = reserve(m->meter, count, error);
    if (result != SKV_OK)
        return result;
    to->count = 0;
    for (int i = 0; i < from->count; i++) {
        if (!is_near(m, from->x[i], from->y[i]))
            continue;
        int k = to->count++;
        to->x[k] = from->x[i];
        to->y[k] = from->y[i];
        to->vx[k] = from->vx[i];
        to->vy[k] = from->vy[i];
        to->id[k] = from->id[i];
        to->clearance[k] = 0;
    }
    return SKV_OK;
}

static skv_result prepare_neighbours(measurement *m, skv_error *error)
{
    skv_force_meter *meter = m->meter;
    double h = (double)m->world->h;
    bool moved = meter->h != h;
    for (int k = 0; k < 4; k++)
        moved = moved || meter->box[k] != m->box[k];
    if (moved) {
        skv_neighbours_destroy(&meter->neighbours);
        meter->h = 0;
        float reach = (float)m->reach;
        skv_result result = skv_neighbours_create(
            &meter->neighbours, (float)m->box[0] - reach, (float)m->box[1] - reach,
            (float)m->box[2] + reach, (float)m->box[3] + reach, m->world->h, error);
        if (result != SKV_OK)
            return result;
        skv_cut_pairs_at_walls(m->world, &meter->neighbours);
        meter->h = h;
        memcpy(meter->box, m->box, sizeof m->box);
    }
    skv_result result = skv_neighbours_reserve(&meter->neighbours, meter->state.count, error);
    if (result != SKV_OK)
        return result;
    skv_neighbours_build(&meter->neighbours, &meter->state, m->world->h, NULL);
    int wanted = meter->neighbours.wanted;
    if (wanted <= meter->neighbours.list_capacity)
        return SKV_OK;
    result = skv_neighbours_reserve(&meter->neighbours, meter->state.count, error);
    skv_neighbours_build(&meter->neighbours, &meter->state, m->world->h, NULL);
    return result;
}

/* Books (dx, dy), which a wall has done to particle i, if that wall lies in the box. */
static void book(measurement *m, int i, double dx, double dy)
{
    const skv_state *s = &m->meter->state;
    float nx, ny;
    double d = (double)skv_terrain_normal(m->world->terrain, s->x[i], s->y[i], &nx, &ny);
    double x = (double)s->x[i] - d * (double)nx, y = (double)s->y[i] - d * (double)ny;
    if (x < m->box[0] || x > m->box[2] || y < m->box[1] || y > m->box[3])
        return;
    double arm_x = x - (m->box[0] + m->box[2]) / 2, arm_y = y - (m->box[1] + m->box[3]) / 2;
    m->sum_x += dx;
    m->sum_y += dy;
    m->sum_torque += arm_x * dy - arm_y * dx;
}

/* Moves every particle by its dx, dy; of that the walls have wanted (wall_x, wall_y), null:
 * nothing, and they stop what would go into them. */
static void move_all(measurement *m, bool walls_push)
{
    skv_state *s = &m->meter->state;
    for (int i = 0; i < s->count; i++) {
        double wall_x = 0, wall_y = 0;
        if (walls_push) {
            wall_x = (double)(s->push[i] * s->f1x[i] + s->near_push[i] * s->f2x[i]);
            wall_y = (double)(s->push[i] * s->f1y[i] + s->near_push[i] * s->f2y[i]);
        }
        float x = s->x[i], y = s->y[i], dx = s->dx[i], dy = s->dy[i];
        float made = skv_move_at_walls(m->world, &x, &y, dx, dy, &s->clearance[i]);
        wall_x += (double)((made - 1) * dx);
        wall_y += (double)((made - 1) * dy);
        if (wall_x != 0 || wall_y != 0)
            book(m, i, wall_x, wall_y);
        s->wx[i] += made * dx;
        s->wy[i] += made * dy;
        s->x[i] = x;
        s->y[i] = y;
    }
}

static void predict(measurement *m)
{
    skv_state *s = &m->meter->state;
    const skv_world *w = m->world;
    const skv_constants *c = &m->constants;
    skv_pull pulls[SKV_MAX_HANDS];
    for (int i = 0; i < w->hand_count; i++)
        pulls[i] = skv_make_pull(&w->hands[i], c->dt);
    skv_pass_external_forces(s, c, w->gravity_x, w->gravity_y, pulls, w->hand_count, 0, s->count);
    if (c->viscosity_linear > 0 || c->viscosity_quadratic > 0) {
        skv_pass_viscosity(s, c, &m->meter->neighbours, 0, s->count);
        skv_pass_apply_viscosity(s, 0, s->count);
    }
    skv_pass_advance(s, c, 0, s->count);
    for (int i = 0; i < s->count; i++) {
        s->wx[i] = -s->dx[i];
        s->wy[i] = -s->dy[i];
    }
    /* Moving adds what was made of the move, so that only what a wall took stays in w. */
    move_all(m, false);
}

static void sample_walls(measurement *m)
{
    skv_state *s = &m->meter->state;
    for (int i = 0; i < s->count; i++) {
        skv_wall_sample wall;
        skv_walls_at(m->world, s->x[i], s->y[i], &wall);
        s->wall_density[i] = wall.r;
        s->wall_near[i] = wall.rn;
        s->f1x[i] = wall.f1x;
        s->f1y[i] = wall.f1y;
        s->f2x[i] = wall.f2x;
        s->f2y[i] = wall.f2y;
    }
}

static void relax(measurement *m)
{
    skv_state *s = &m->meter->state;
    const skv_constants *c = &m->constants;
    bool clavet = m->world->fluid.law == SKV_LAW_CLAVET;
    skv_pressure_law *law = clavet ? skv_pass_pressure_clavet : skv_pass_pressure_calibrated;
    for (int iteration = 0; iteration < m->world->fluid.iterations; iteration++) {
        sample_walls(m);
        bool has_gradient = iteration == 0 && !clavet;
        skv_pass_density(s, c, &m->meter->neighbours, has_gradient, 0, s->count);
        law(s, c, 0, s->count);
        skv_pass_displacement(s, c, &m->meter->neighbours, 0, s->count);
        if (has_gradient)
            skv_pass_tension(s, c, &m->meter->neighbours, 0, s->count);
        move_all(m, true);
    }
}

static void touch_walls(measurement *m)
{
    skv_state *s = &m->meter->state;
    for (int i = 0; i < s->count; i++)
        s->depth[i] = skv_contact_depth(m->world, s->x[i], s->y[i], &s->normal_x[i],
                                        &s->normal_y[i], &s->clearance[i]);
    skv_pass_contact(s, &m->constants, 0, s->count);
    for (int i = 0; i < s->count; i++) {
        if (s->depth[i] > 0)
            book(m, i, (double)s->dx[i], (double)s->dy[i]);
    }
}

skv_result skv_force_measure(skv_force_meter *meter, const skv_world *world, double x0, double y0,
                             double x1, double y1, skv_wall_force *force, skv_error *error)
{
    SKV_ASSERT_OR(meter && world && force, SKV_ERROR_VALUE);
    *force = (skv_wall_force){0};
    measurement m = {
        .meter = meter,
        .world = world,
        .constants = skv_make_constants(&world->fluid, 1.0f / 60 / (float)world->substeps),
        .box = {fmin(x0, x1), fmin(y0, y1), fmax(x0, x1), fmax(y0, y1)},
        .reach = reach_for(world),
    };
    skv_result result = copy_fluid(&m, error);
    /* The lists of the present positions serve viscosity, and size the memory. */
    if (result == SKV_OK)
        result = prepare_neighbours(&m, error);
    if (result != SKV_OK)
        return result;
    predict(&m);
    skv_neighbours_build(&meter->neighbours, &meter->state, world->h, NULL);
    relax(&m);
    touch_walls(&m);
    double dt = (double)m.constants.dt, s = (double)world->fluid.spacing;
    double scale = -(double)world->fluid.density * s * s / (dt * dt);
    *force = (skv_wall_force){scale * m.sum_x, scale * m.sum_y, scale * m.sum_torque};
    return SKV_OK;
}
