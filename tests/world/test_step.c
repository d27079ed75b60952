/* Conservation laws of the whole substep, and a pool that comes to rest. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

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
        cmocka_unit_test(coincident_particles_part), cmocka_unit_test(momentum_and_mass_are_kept),
        cmocka_unit_test(a_pool_comes_to_rest),      cmocka_unit_test(gravity_is_gravity),
        cmocka_unit_test(a_hand_carries_fluid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
