/* The whole substep against the oracle, conservation laws, and a pool that comes to rest. */
#include "support/fixture.h"
#include "support/oracle.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void read_state(const skv_world *world, oracle *o)
{
    skv_particles p = skv_world_particles(world);
    const skv_fluid_def *f = skv_world_fluid(world);
    assert_true(p.count <= ORACLE_MAX);
    memset(o, 0, sizeof *o);
    o->n = p.count;
    for (int i = 0; i < p.count; i++) {
        o->x[i] = (double)p.x[i];
        o->y[i] = (double)p.y[i];
        o->vx[i] = (double)p.vx[i];
        o->vy[i] = (double)p.vy[i];
        o->warm[i] = (double)world->state.warm_lambda[i];
    }
    o->warm_start = (double)skv_world_make_constants(world).warm_start;
    o->s = (double)f->spacing;
    o->sigma = (double)f->viscosity_linear;
    o->beta = (double)f->viscosity_quadratic;
    o->eta = (double)f->radius_ratio;
    o->fluid_density = (double)f->density;
    o->dt = 1.0 / 60 / skv_world_substeps_per_frame(world);
    o->omega = (double)f->relaxation;
    o->k_near = (double)f->near_stiffness;
    o->k_coh = (double)f->cohesion;
    o->iterations = f->iterations;
    o->clavet = f->law == SKV_LAW_CLAVET;
    o->k = (double)f->clavet_stiffness;
    o->k_near_clavet = (double)f->clavet_near_stiffness;
    o->rest_density_clavet = (double)f->clavet_rest_density;
    float gx, gy;
    skv_world_gravity(world, &gx, &gy);
    o->g_x = (double)gx;
    o->g_y = (double)gy;
}

static void add_moves(oracle *o)
{
    for (int i = 0; i < o->n; i++) {
        o->x[i] += o->dx[i];
        o->y[i] += o->dy[i];
    }
}

/* The step in the oracle's words: the order of the passes is what is tested. The reference solver
 * reads viscosity before the advance, as the thesis does; the fast one after it, with the first
 * density pass. */
static void oracle_substep(oracle *o, skv_solver_kind solver)
{
    double h = o->s * o->eta;
    bool early = solver == SKV_SOLVER_REFERENCE;
    oracle_external_forces(o, NULL);
    if (early) {
        oracle_take_pairs(o, 0);
        oracle_viscosity(o);
        for (int i = 0; i < o->n; i++) {
            o->vx[i] += o->dx[i];
            o->vy[i] += o->dy[i];
        }
    }
    oracle_advance(o, 0.9 * h / o->dt);
    add_moves(o);
    const double lag = o->clavet ? 0 : ORACLE_LAG;
    oracle_take_pairs(o, lag);
    static double late_x[ORACLE_MAX], late_y[ORACLE_MAX];
    oracle_viscosity(o);
    for (int i = 0; i < o->n; i++) {
        late_x[i] = early ? 0 : o->dx[i] * o->dt;
        late_y[i] = early ? 0 : o->dy[i] * o->dt;
    }
    for (int iteration = 0; iteration < o->iterations; iteration++) {
        oracle_take_pairs(o, lag);
        oracle_density(o, iteration == 0);
        oracle_pressure(o, iteration == 0);
        oracle_displacement(o, iteration == o->iterations - 1);
        if (iteration == 0 && !o->clavet)
            oracle_tension(o);
        for (int i = 0; i < o->n && iteration == 0; i++) {
            o->dx[i] += late_x[i];
            o->dy[i] += late_y[i];
        }
        oracle_correct(o);
    }
    oracle_velocity(o);
}

static void check_substeps(skv_law law, skv_solver_kind solver)
{
    skv_world *world = fixture_blob(law, solver, 3);
    assert_int_equal(skv_world_set_gravity(world, 2, -5, NULL), SKV_OK);
    int n = skv_world_particle_count(world);
    assert_int_equal(skv_world_add_velocity(world, 0, n / 2, 0.5f, 1, NULL), SKV_OK);
    static oracle o;
    for (int step = 0; step < 20; step++) {
        read_state(world, &o);
        oracle_substep(&o, solver);
        assert_int_equal(skv_world_step(world, (float)o.dt, NULL), SKV_OK);
        skv_particles p = skv_world_particles(world);
        double h = (double)skv_world_smoothing_radius(world);
        double modulus = o.fluid_density * (h / o.dt) * (h / o.dt);
        for (int i = 0; i < o.n; i++) {
            assert_true(hypot((double)p.x[i] - o.x[i], (double)p.y[i] - o.y[i]) < 1e-5 * h);
            assert_true(hypot((double)p.vx[i] - o.vx[i], (double)p.vy[i] - o.vy[i]) <
                        1e-5 * h / o.dt);
            /* The error of the pressure is that of a density, some 1e-6, times the modulus. */
            assert_true(fabs((double)p.pressure[i] - o.pressure[i]) < 2e-6 * modulus);
        }
    }
    skv_world_destroy(world);
}

static void a_substep_matches_the_oracle(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++)
        for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++)
            check_substeps((skv_law)law, (skv_solver_kind)solver);
}

/* One substep at a time beside walls, both solvers from the same state: the same to rounding. */
static void both_solvers_agree_at_walls(void **unused)
{
    (void)unused;
    /* The calibrated law, with walls by images and without, and the clavet law. */
    for (int kind = 0; kind < 3; kind++) {
        skv_law law = kind == 2 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
        skv_world_def def = fixture_def(law, SKV_SOLVER_REFERENCE, 0, 0.014f, 1);
        def.fluid.wall_images = kind == 1;
        def.fluid.adhesion = 0.5f;
        skv_world *slow, *fast;
        assert_int_equal(skv_world_create(&def, &slow, NULL), SKV_OK);
        def.solver = SKV_SOLVER_FAST;
        fast = fixture_dam_of(&def);
        fixture_run(fast, 20);
        fixture_expect_same_substep(fast, slow);
    }
}

/* Particles in one place, in the middle of others, part. */
static void coincident_particles_part(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world *world = fixture_blob(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 0);
        int n = skv_world_particle_count(world);
        skv_particles p = skv_world_particles(world);
        float x = p.x[n / 2], y = p.y[n / 2];
        for (int i = 0; i < 3; i++)
            assert_int_equal(skv_world_add_particle(world, x, y, 0, 0, NULL), SKV_OK);
        /* They part at once, and swing for a while. */
        fixture_run(world, 60);
        p = skv_world_particles(world);
        for (int i = n; i < n + 3; i++)
            for (int j = n; j < i; j++)
                assert_true(hypotf(p.x[i] - p.x[j], p.y[i] - p.y[j]) > 0.004f);
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        skv_world_destroy(world);
    }
}

static void momentum_and_mass_are_kept(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
            skv_world *world = fixture_blob((skv_law)law, (skv_solver_kind)solver, 1);
            int n = skv_world_particle_count(world);
            /* One half moves up into the other: they collide, the sum is known. */
            assert_int_equal(skv_world_add_velocity(world, 0, n / 2, 0.02f, 0.05f, NULL), SKV_OK);
            skv_stats before = skv_world_stats(world);
            fixture_run(world, 180);
            skv_stats after = skv_world_stats(world);
            double size = hypot(before.momentum_x, before.momentum_y);
            assert_true(fabs(after.momentum_x - before.momentum_x) < 2e-5 * size);
            assert_true(fabs(after.momentum_y - before.momentum_y) < 2e-5 * size);
            assert_int_equal(after.particles, n);
            assert_int_equal(after.escaped + after.not_finite, 0);
            skv_world_destroy(world);
        }
    }
}

/* A tank half full: level, calm, at its volume, with the pressure of its depth inside. */
static void a_pool_comes_to_rest(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.0155f, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.45f);
    fixture_run(world, 5 * 60);
    skv_stats stats = skv_world_stats(world);
    assert_true(stats.rms_speed < 0.02);
    assert_true(fabs(fixture_packing(world).volume_ratio - 1) < 0.05);
    double area = stats.particles * 0.0155 * 0.0155, level = area / 1.6;
    assert_true(fabs(2 * stats.centre_y / level - 1) < 0.05);
    skv_particles p = skv_world_particles(world);
    double deep_pressure = 0, expected = 0;
    double high[4] = {0};
    for (int i = 0; i < p.count; i++) {
        if (p.y[i] > 0.15f * (float)level && p.y[i] < 0.6f * (float)level) {
            deep_pressure += (double)p.pressure[i];
            expected += 1000 * 9.81 * (2 * stats.centre_y - (double)p.y[i]);
        }
        int quarter = (int)(p.x[i] / 0.4f);
        high[quarter < 4 ? quarter : 3] = fmax(high[quarter < 4 ? quarter : 3], (double)p.y[i]);
    }
    assert_true(fabs(deep_pressure / expected - 1) < 0.06);
    for (int q = 1; q < 4; q++)
        assert_true(fabs(high[q] - high[0]) < 0.0155);
    skv_world_destroy(world);
}

/* Falling freely, the blob's centre follows the parabola. */
static void gravity_is_gravity(void **unused)
{
    (void)unused;
    skv_world *world = fixture_blob(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0);
    skv_stats before = skv_world_stats(world);
    assert_int_equal(skv_world_set_gravity(world, 0.5f, -1, NULL), SKV_OK);
    fixture_run(world, 30);
    skv_stats after = skv_world_stats(world);
    /* The substep rule integrates x += dt v after v += dt g: n (n + 1) / 2 instead of n^2 / 2. */
    double n = 30.0 * skv_world_substeps_per_frame(world), dt = 0.5 / n,
           fall = 0.5 * n * (n + 1) * dt * dt;
    assert_true(fabs(before.centre_y - after.centre_y - fall) < 1e-4 * fall);
    assert_true(fabs(after.centre_x - before.centre_x - 0.5 * fall) < 1e-4 * fall);
    assert_true(fabs(skv_world_time(world) - 0.5) < 1e-6);
    assert_int_equal(skv_world_substep_count(world), 30 * skv_world_substeps_per_frame(world));
    skv_world_destroy(world);
}

/* A hand lifts a piece of a pool and carries it along; let go, it falls. */
static void a_hand_carries_fluid(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.0155f, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.3f);
    fixture_run(world, 60);
    int found[3000];
    skv_area around = skv_circle(0.8f, 0.6f, 0.1f);
    assert_int_equal(skv_world_query(world, &around, found, 3000), 0);
    skv_hand hand = skv_default_hand();
    for (int f = 0; f < 90; f++) {
        hand.x = 0.8f;
        hand.y = 0.25f + 0.35f * fminf(1, (float)f / 60);
        hand.vy = f < 60 ? 0.35f : 0;
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
        fixture_run(world, 1);
    }
    int held = skv_world_query(world, &around, found, 3000);
    assert_true(held > 40);
    for (int i = 1; i < held; i++)
        assert_true(found[i] > found[i - 1]);
    assert_int_equal(skv_world_set_hands(world, NULL, 0, NULL), SKV_OK);
    fixture_run(world, 120);
    assert_int_equal(skv_world_query(world, &around, found, 3000), 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_substep_matches_the_oracle),
        cmocka_unit_test(both_solvers_agree_at_walls),
        cmocka_unit_test(coincident_particles_part),
        cmocka_unit_test(momentum_and_mass_are_kept),
        cmocka_unit_test(a_pool_comes_to_rest),
        cmocka_unit_test(gravity_is_gravity),
        cmocka_unit_test(a_hand_carries_fluid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
