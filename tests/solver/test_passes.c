/* Every pass of the solver against the oracle, on random states; momentum of the pair passes;
 * coincident particles. Tolerances are float rounding: some 1e-6 of the largest value at hand. */
#include "support/oracle.h"

#include "solver/direction.h"
#include "solver/reference/passes.h"
#include "solver/wall_image.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { N = 400, ROUNDS = 8, ARRAYS = 31 };

static uint32_t random_state;

static double uniform(double lo, double hi)
{
    random_state = random_state * 1664525u + 1013904223u;
    return lo + (hi - lo) * (double)(random_state >> 8) / 16777216.0;
}

/* A solver's state and the oracle's, equal in float. */
typedef struct twin {
    float memory[ARRAYS][N];
    uint32_t id[N];
    skv_substep substep;
    skv_constants constants;
    skv_shared_impulse given;
    skv_neighbours lists;
    skv_fluid_def fluid;
    oracle o;
} twin;

static void bind_arrays(twin *t)
{
    skv_pass_data *s = &t->substep.data;
    float **arrays[ARRAYS] = {
        &s->x,           &s->y,          &s->vx,           &s->vy,          &s->wx,
        &s->wy,          &s->dx,         &s->dy,           &s->density,     &s->near_density,
        &s->gradient_x,  &s->gradient_y, &s->lambda,       &s->near_lambda, &s->pressure,
        &s->wall_near,   &s->f1x,        &s->wall_density, &s->f1y,         &s->f2x,
        &s->f2y,         &s->clearance,  &s->normal_x,     &s->normal_y,    &s->depth,
        &s->warm_lambda, &s->image,      &s->facing_x,     &s->facing_y,    &s->behind_x,
        &s->behind_y,
    };
    for (int a = 0; a < ARRAYS; a++)
        *arrays[a] = t->memory[a];
    s->id = t->id;
    s->count = N;
}

static void set(float *array, double *exact, int i, double value)
{
    array[i] = (float)value;
    exact[i] = (double)array[i];
}

/* Particles about a spacing apart, some much closer, with walls and velocities at random. */
static void randomise(twin *t)
{
    skv_pass_data *s = &t->substep.data;
    oracle *o = &t->o;
    double spacing = (double)t->fluid.spacing;
    for (int i = 0; i < N; i++) {
        double close = uniform(0, 1) < 0.1 ? 0.05 : 0.8;
        set(s->x, o->x, i, spacing * (i % 20 + uniform(-close, close)));
        set(s->y, o->y, i, spacing * (i / 20 + uniform(-close, close)));
        set(s->vx, o->vx, i, uniform(-2, 2));
        set(s->vy, o->vy, i, uniform(-2, 2));
        double loose = (double)t->constants.tension_until / (o->dt * o->dt);
        double most = uniform(0, 1) < 0.5 ? 100 : uniform(0, 1) < 0.5 ? 2 * loose : 0;
        set(s->warm_lambda, o->warm, i, uniform(0, most));
        double wall = uniform(0, 1) < 0.3 ? 1 : 0, angle = uniform(0, 6.28);
        set(s->wall_density, o->wall_density, i, wall * uniform(0, 2));
        set(s->wall_near, o->wall_near, i, wall * uniform(0, 1));
        set(s->f1x, o->f1x, i, wall * uniform(-2, 2));
        set(s->f1y, o->f1y, i, wall * uniform(-2, 2));
        set(s->f2x, o->f2x, i, wall * uniform(-1, 1));
        set(s->f2y, o->f2y, i, wall * uniform(-1, 1));
        bool imaged = t->constants.images && wall > 0;
        set(s->image, o->image, i, imaged ? uniform(0.02, 0.9) : (double)SKV_FAR);
        set(s->facing_x, o->facing_x, i, imaged ? cos(angle) : 0);
        set(s->facing_y, o->facing_y, i, imaged ? sin(angle) : 0);
        set(s->normal_x, o->normal_x, i, cos(angle));
        set(s->normal_y, o->normal_y, i, sin(angle));
        set(s->depth, o->depth, i, wall * uniform(0, 0.3) * spacing);
        t->id[i] = (uint32_t)i;
    }
}

/* Takes out of the lists the pairs that the oracle's thin wall parts. */
static void cut_at_wall(twin *t, const float *x)
{
    skv_neighbours *lists = &t->lists;
    double wall = t->o.wall_x;
    int kept = 0;
    for (int i = 0, from = 0; i < N; i++) {
        int end = lists->start[i + 1];
        for (int k = from; k < end; k++)
            if (((double)x[i] < wall) == ((double)x[lists->list[k]] < wall))
                lists->list[kept++] = lists->list[k];
        from = end;
        lists->start[i + 1] = kept;
    }
}

/* The lists of the pairs where they are taken. */
static void list_pairs(twin *t)
{
    const skv_pass_data *s = &t->substep.data;
    float x[N], y[N];
    for (int i = 0; i < N; i++) {
        x[i] = s->x[i] - s->behind_x[i];
        y[i] = s->y[i] - s->behind_y[i];
    }
    for (int round = 0; round < 2; round++) {
        assert_int_equal(skv_neighbours_reserve(&t->lists, N, NULL), SKV_OK);
        skv_neighbours_build(&t->lists, x, y, N, t->constants.h, NULL);
    }
    if (t->o.walled)
        cut_at_wall(t, x);
}

static twin *make_twin(skv_law law, bool images, uint32_t seed)
{
    twin *t = calloc(1, sizeof *t);
    random_state = seed;
    bind_arrays(t);
    skv_fluid_def *f = &t->fluid;
    *f = skv_default_fluid_def(law);
    f->spacing = (float)uniform(0.001, 0.05);
    f->radius_ratio = (float)uniform(2, 4);
    f->viscosity_linear = (float)uniform(0, 20);
    f->viscosity_quadratic = (float)uniform(0, 3);
    f->wall_friction = (float)uniform(0, 0.5);
    f->wall_softness = (float)uniform(0.1, 0.9);
    f->wall_images = images;
    f->adhesion = 0.5f;
    int substeps = skv_substep_rule(f, 9.81 * 0.5);
    t->constants = skv_make_constants(f, 1.0f / 60 / (float)substeps);
    oracle *o = &t->o;
    o->n = N;
    o->s = (double)f->spacing;
    o->eta = (double)f->radius_ratio;
    o->fluid_density = (double)f->density;
    o->dt = (double)t->constants.dt;
    skv_set_stiffness(&t->constants, 1.2f);
    o->warm_start = (double)t->constants.warm_start;
    o->sigma = (double)f->viscosity_linear;
    o->beta = (double)f->viscosity_quadratic;
    o->friction_a_frame = (double)f->wall_friction;
    o->softness_a_frame = (double)f->wall_softness;
    o->omega = fmin((double)f->relaxation, 4 / (o->eta * o->eta));
    o->k_near = (double)f->near_stiffness;
    o->k_coh = (double)f->cohesion;
    o->iterations = f->iterations;
    o->clavet = law == SKV_LAW_CLAVET;
    o->images = images;
    o->adhesion = (double)f->adhesion;
    o->k = (double)f->clavet_stiffness;
    o->k_near_clavet = (double)f->clavet_near_stiffness;
    o->rest_density_clavet = (double)f->clavet_rest_density;
    randomise(t);
    float size = 30 * f->spacing;
    assert_int_equal(
        skv_neighbours_create(&t->lists, -size, -size, size, size, t->constants.h, NULL, NULL),
        SKV_OK);
    o->walled = seed % 2 == 0;
    o->wall_x = 10 * (double)f->spacing;
    list_pairs(t);
    t->substep.constants = &t->constants;
    t->substep.given = &t->given;
    t->substep.neighbours = &t->lists;
    t->substep.first = true;
    t->substep.last = seed % 3 > 0;
    return t;
}

static void free_twin(twin *t)
{
    skv_neighbours_destroy(&t->lists);
    free(t);
}

/* Largest difference relative to the largest exact value. */
static double difference(const float *array, const double *exact)
{
    double worst = 0, largest = 1e-30;
    for (int i = 0; i < N; i++) {
        worst = fmax(worst, fabs((double)array[i] - exact[i]));
        largest = fmax(largest, fabs(exact[i]));
    }
    return worst / largest;
}

#define assert_close(array, exact, tolerance)                                                      \
    do {                                                                                           \
        double found = difference(array, exact);                                                   \
        if (!(found <= (tolerance)))                                                               \
            fail_msg("%s differs by %g, more than %g", #array, found, (double)(tolerance));        \
    } while (0)

/* By itself: beside the displacement of such a state it is small. */
static void check_tension(twin *t)
{
    skv_pass_data *s = &t->substep.data;
    oracle *o = &t->o, *alone = malloc(sizeof *alone);
    if (o->clavet) {
        free(alone);
        return;
    }
    *alone = *o;
    skv_pass_data kept = *s;
    float dx[N] = {0}, dy[N] = {0}, pressure[N] = {0};
    s->dx = dx;
    s->dy = dy;
    s->pressure = pressure;
    for (int i = 0; i < N; i++)
        alone->dx[i] = alone->dy[i] = alone->pressure[i] = 0;
    skv_pass_tension(&t->substep, 0, N);
    oracle_tension(alone);
    assert_close(s->dx, alone->dx, 1e-5);
    assert_close(s->dy, alone->dy, 1e-5);
    assert_close(s->pressure, alone->pressure, 1e-5);
    *s = kept;
    skv_pass_tension(&t->substep, 0, N);
    oracle_tension(o);
    free(alone);
}

static void check_twin(twin *t)
{
    skv_pass_data *s = &t->substep.data;
    const skv_constants *c = &t->constants;
    oracle *o = &t->o;
    double spacing = (double)t->fluid.spacing;

    oracle_hand hand = {5 * spacing, 7 * spacing, 1.5, -0.5, 8 * spacing, 60, 6, 9};
    skv_external_force force = {.x = (float)hand.x,
                                .y = (float)hand.y,
                                .vx = 1.5f,
                                .vy = -0.5f,
                                .inv_radius = (float)(1 / hand.radius),
                                .attraction = (float)(60 * o->dt),
                                .friction = (float)fmin(0.5, 6 * o->dt),
                                .follow = (float)fmin(0.5, 9 * o->dt)};
    o->g_y = -9.81;
    t->substep.gravity_y = -9.81f;
    t->substep.forces = &force;
    t->substep.force_count = 1;
    skv_pass_external_forces(&t->substep, 0, N);
    oracle_external_forces(o, &hand);
    assert_close(s->vx, o->vx, 2e-6);
    assert_close(s->vy, o->vy, 2e-6);

    skv_pass_viscosity(&t->substep, 0, N);
    oracle_take_pairs(o, 0);
    oracle_viscosity(o);
    assert_close(s->dx, o->dx, 1e-5);
    assert_close(s->dy, o->dy, 1e-5);
    skv_pass_apply_viscosity(&t->substep, 0, N);
    for (int i = 0; i < N; i++) {
        o->vx[i] += o->dx[i];
        o->vy[i] += o->dy[i];
    }
    assert_close(s->vx, o->vx, 1e-5);

    skv_pass_predict(&t->substep, 0, N);
    oracle_advance(o, (double)c->max_speed);
    assert_close(s->dx, o->dx, 1e-5);
    assert_close(s->vy, o->vy, 1e-5);

    skv_pass_lag(&t->substep, 0, N);
    oracle_take_pairs(o, o->clavet ? 0 : ORACLE_LAG);
    list_pairs(t);
    skv_pass_density(&t->substep, 0, N);
    oracle_density(o, !o->clavet);
    assert_close(s->density, o->density, 2e-6);
    assert_close(s->near_density, o->near_density, 2e-6);
    if (!o->clavet) {
        assert_close(s->gradient_x, o->gx, 5e-6);
        assert_close(s->gradient_y, o->gy, 5e-6);
    }

    (o->clavet ? skv_pass_pressure_clavet : skv_pass_pressure_calibrated)(&t->substep, 0, N);
    oracle_pressure(o, t->substep.first);
    assert_close(s->lambda, o->lambda, 5e-6);
    assert_close(s->near_lambda, o->near_lambda, 5e-6);
    assert_close(s->warm_lambda, o->warm, 5e-6);
    /* A later iteration remembers what it adds. */
    t->substep.first = false;
    (o->clavet ? skv_pass_pressure_clavet : skv_pass_pressure_calibrated)(&t->substep, 0, N);
    oracle_pressure(o, t->substep.first);
    assert_close(s->lambda, o->lambda, 5e-6);
    assert_close(s->warm_lambda, o->warm, 5e-6);

    skv_pass_displacement(&t->substep, 0, N);
    oracle_displacement(o, t->substep.last);
    assert_close(s->dx, o->dx, 1e-5);
    assert_close(s->dy, o->dy, 1e-5);
    assert_close(s->pressure, o->pressure, 1e-5);
    check_tension(t);
    for (int i = 0; i < N; i++) {
        s->wx[i] += s->dx[i];
        s->wy[i] += s->dy[i];
        o->wx[i] += o->dx[i];
        o->wy[i] += o->dy[i];
    }

    skv_pass_contact(&t->substep, 0, N);
    oracle_contact(o);
    assert_close(s->dx, o->dx, 1e-5);
    assert_close(s->dy, o->dy, 1e-5);

    skv_pass_update_velocity(&t->substep, 0, N);
    oracle_velocity(o);
    assert_close(s->vx, o->vx, 1e-5);
    assert_close(s->vy, o->vy, 1e-5);
}

static void passes_match_the_oracle(void **unused)
{
    (void)unused;
    for (uint32_t round = 0; round < ROUNDS; round++) {
        /* The calibrated law, with images and without, and the clavet law. */
        for (int kind = 0; kind < 3; kind++) {
            skv_law law = kind == 2 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
            twin *t = make_twin(law, kind == 1, 7 * round + 1);
            check_twin(t);
            free_twin(t);
        }
    }
}

/* The constants themselves, against the formulas of docs/model.md in the oracle. */
static void constants_match_the_oracle(void **unused)
{
    (void)unused;
    for (uint32_t seed = 1; seed < 20; seed++) {
        twin *t = make_twin(SKV_LAW_CALIBRATED, false, seed);
        double rest = oracle_rest_density(&t->o);
        assert_true(fabs((double)t->constants.rest_density / rest - 1) < 1e-6);
        free_twin(t);
    }
}

/* Without walls, the pair passes must not create momentum: each pair's parts are opposite to the
 * last bit, so what is left is the rounding of the sums. */
static void pair_passes_keep_momentum(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        twin *t = make_twin((skv_law)law, false, 99);
        skv_pass_data *s = &t->substep.data;
        size_t bytes = N * sizeof(float);
        memset(s->f1x, 0, bytes);
        memset(s->f1y, 0, bytes);
        memset(s->f2x, 0, bytes);
        memset(s->f2y, 0, bytes);
        for (int pass = 0; pass < 2; pass++) {
            if (pass == 0) {
                skv_pass_viscosity(&t->substep, 0, N);
            } else {
                skv_pass_lag(&t->substep, 0, N);
                list_pairs(t);
                skv_pass_density(&t->substep, 0, N);
                (law == SKV_LAW_CLAVET ? skv_pass_pressure_clavet
                                       : skv_pass_pressure_calibrated)(&t->substep, 0, N);
                skv_pass_displacement(&t->substep, 0, N);
                if (law == SKV_LAW_CALIBRATED)
                    skv_pass_tension(&t->substep, 0, N);
            }
            double sum_x = 0, sum_y = 0, size = 0;
            for (int i = 0; i < N; i++) {
                sum_x += (double)s->dx[i];
                sum_y += (double)s->dy[i];
                size += fabs((double)s->dx[i]) + fabs((double)s->dy[i]);
            }
            assert_true(size > 0);
            assert_true(fabs(sum_x) < 1e-7 * size && fabs(sum_y) < 1e-7 * size);
        }
        free_twin(t);
    }
}

/* Two particles in one place part in opposite directions, whatever their numbers. */
static void coincident_particles_part(void **unused)
{
    (void)unused;
    for (uint32_t a = 0; a < 200; a++) {
        float ux, uy, wx, wy;
        skv_fallback_direction(a, 3 * a + 1, &ux, &uy);
        skv_fallback_direction(3 * a + 1, a, &wx, &wy);
        assert_true(fabsf(ux * ux + uy * uy - 1) < 1e-5f);
        assert_true(ux == -wx && uy == -wy);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_match_the_oracle),
        cmocka_unit_test(constants_match_the_oracle),
        cmocka_unit_test(pair_passes_keep_momentum),
        cmocka_unit_test(coincident_particles_part),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
