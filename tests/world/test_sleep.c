/* Sleep: still fluid is not stepped, whatever disturbs it wakes it, nothing that moves is stopped,
 * and none of it depends on threads. */
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static skv_world *make_world(float x1, float y1, bool sleep, int threads)
{
    /* A little viscosity, to be at rest sooner. */
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 2, 0.02f, threads);
    def.sleep = sleep;
    skv_world *world;
    skv_error error;
    if (skv_world_create(&def, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    fixture_fill(world, 0, 0, x1, y1);
    return world;
}

static void a_pool_falls_asleep_and_stays_as_it_is(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    uint64_t hash = skv_world_hash(world);
    double time = skv_world_time(world);
    fixture_run(world, 600);
    assert_int_equal(skv_world_hash(world), hash);
    assert_true(fabs(skv_world_time(world) - time - 10) < 1e-6);
    skv_stats stats = skv_world_stats(world);
    assert_true(stats.kinetic_energy == 0);
    /* It lies where the same pool lies that never sleeps. */
    skv_world *awake = make_world(1.6f, 0.3f, false, 1);
    fixture_run(awake, (int)(time * 60));
    skv_stats other = skv_world_stats(awake);
    float s = skv_world_spacing(world);
    assert_true(fabs(stats.centre_y - other.centre_y) < 0.02 * (double)s);
    assert_int_equal(skv_world_awake_count(awake), other.particles);
    skv_world_destroy(awake);
    skv_world_destroy(world);
}

static void fluid_in_motion_is_never_left_out(void **unused)
{
    (void)unused;
    /* While it moves, sleep changes no bit. */
    skv_world *worlds[2];
    for (int k = 0; k < 2; k++) {
        worlds[k] = make_world(0.4f, 0.6f, k == 1, 1);
        fixture_run(worlds[k], 120);
    }
    assert_int_equal(skv_world_hash(worlds[0]), skv_world_hash(worlds[1]));
    skv_world_destroy(worlds[0]);
    skv_world_destroy(worlds[1]);
}

static void tilting_wakes_everything(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    double x = skv_world_stats(world).centre_x;
    assert_int_equal(skv_world_set_gravity(world, 0, -9.81f, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0); /* it was so before */
    assert_int_equal(skv_world_set_gravity(world, 2, -9.6f, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), skv_world_particle_count(world));
    fixture_run(world, 40);
    assert_true(skv_world_stats(world).centre_x > x + 0.03);
    skv_world_destroy(world);
}

static void a_hand_wakes_what_it_reaches_and_waves_wake_the_rest(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    skv_hand hand = skv_default_hand();
    hand.x = 0.3f;
    hand.y = 0.25f;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 1);
    int all = skv_world_particle_count(world), first = skv_world_awake_count(world);
    assert_in_range(first, 50, all * 2 / 3);
    fixture_run(world, 30);
    assert_int_equal(skv_world_set_hands(world, NULL, 0, NULL), SKV_OK);
    int most = 0;
    for (int f = 0; f < 120; f++) {
        fixture_run(world, 1);
        most = skv_world_awake_count(world) > most ? skv_world_awake_count(world) : most;
    }
    assert_int_equal(most, all);
    skv_world_destroy(world);
}

static float highest(const skv_world *world, float *x)
{
    skv_particles p = skv_world_particles(world);
    float y = 0;
    for (int i = 0; i < p.count; i++) {
        if (p.y[i] > y) {
            y = p.y[i];
            *x = p.x[i];
        }
    }
    return y;
}

/* A hand wakes what lies within its radius, and nothing that lies a millimetre beyond. */
static void a_hand_reaches_as_far_as_its_radius(void **unused)
{
    (void)unused;
    for (int reaches = 0; reaches < 2; reaches++) {
        skv_world *world = fixture_sleeping_pool(0.02f, 1);
        skv_hand hand = skv_default_hand();
        hand.radius = 0.2f;
        hand.y = highest(world, &hand.x) + hand.radius + (reaches ? -0.001f : 0.001f);
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
        fixture_run(world, 1);
        assert_int_equal(skv_world_awake_count(world) > 0, reaches);
        skv_world_destroy(world);
    }
}

/* An emitter that may not emit leaves the water around its mouth asleep, until it may. */
static void an_emitter_that_pauses_wakes_nobody(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    char limit[16];
    skv_format(limit, sizeof limit, "%d", skv_world_particle_count(world));
    assert_int_equal(skv_world_set(world, "emission.replaces", "false", NULL), SKV_OK);
    assert_int_equal(skv_world_set(world, "emission.limit", limit, NULL), SKV_OK);
    skv_emitter emitter = {.x = 0.8f, .y = 0.15f, .vx = 0.2f, .width = 0.1f};
    assert_int_equal(skv_world_set_emitters(world, &emitter, 1, NULL), SKV_OK);
    fixture_run(world, 30);
    assert_int_equal(skv_world_awake_count(world), 0);
    assert_int_equal(skv_world_set(world, "emission.limit", "20000", NULL), SKV_OK);
    fixture_run(world, 2);
    assert_true(skv_world_awake_count(world) > 0);
    skv_world_destroy(world);
}

/* A drop falls on a sleeping pool: freely, until it lands, and then it wakes the pool. */
static void a_falling_drop_is_not_held_and_wakes_the_pool(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    int drop = skv_world_particle_count(world);
    const float height = 0.8f;
    fixture_fill(world, 0.75f, 0.72f, 0.85f, height);
    fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), skv_world_particle_count(world) - drop);
    fixture_run(world, 11); /* 0.2 s: a way of 0.196 m */
    skv_particles p = skv_world_particles(world);
    double speed = 0;
    for (int i = drop; i < p.count; i++)
        speed -= (double)p.vy[i] / (p.count - drop);
    assert_true(fabs(speed - 9.81 * 0.2) < 0.01);
    assert_int_equal(skv_world_awake_count(world), p.count - drop);
    fixture_run(world, 40);
    assert_true(skv_world_awake_count(world) > p.count / 2);
    skv_world_destroy(world);
}

/* So fast that it is through half of the pool within one call: the fluid on its way is awake. */
static void a_fast_drop_does_not_pass_through_sleeping_fluid(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    int pool = skv_world_particle_count(world);
    skv_fill_def fill = skv_default_fill_def();
    fill.x0 = 0.75f;
    fill.x1 = 0.85f;
    fill.y0 = 0.6f;
    fill.y1 = 0.65f;
    fill.vy = -8;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    int drop = skv_world_particle_count(world) - pool;
    assert_int_equal(skv_world_step(world, 0.1f, NULL), SKV_OK); /* a way of 0.8 m, if it is free */
    assert_true(skv_world_awake_count(world) > 3 * drop);
    skv_particles p = skv_world_particles(world);
    double depth = 0;
    for (int i = pool; i < p.count; i++)
        depth += (double)p.y[i] / drop;
    assert_true(depth > 0.1);
    skv_world_destroy(world);
}

/* A drop may get half as fast again within a call: the pool wakes where it would be then. */
static void what_gets_faster_still_finds_fluid_awake(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    const float dt = 0.1f, tile = 2 * skv_world_smoothing_radius(world);
    float x = 0, top = floorf(highest(world, &x) / tile);
    /* Half of its way is a tile. At its own speed it ends a little more than two tiles above the
     * pool's highest; beside the tile that it is in, one is awake. */
    float speed = 2 * tile / dt, way = speed * dt + 9.81f * dt * dt;
    float y = (top + 2.3f) * tile + way;
    assert_int_equal(skv_world_add_particle(world, 0.8f, y, 0, -speed, NULL), SKV_OK);
    assert_int_equal(skv_world_step(world, dt, NULL), SKV_OK);
    assert_true(skv_world_awake_count(world) > 1);
    skv_world_destroy(world);
}

static void a_push_in_velocity_wakes(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.02f, 1);
    assert_int_equal(skv_world_add_velocity(world, 0, 50, 0.5f, 0, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_true(skv_world_awake_count(world) >= 50);
    assert_true(skv_world_stats(world).kinetic_energy > 0);
    skv_world_destroy(world);
}

/* A lasting disturbance in one corner: the far end sleeps, and the result is the same for any
 * number of threads. */
static void a_partly_sleeping_world_does_not_depend_on_threads(void **unused)
{
    (void)unused;
    const int threads[] = {1, 3, 2, 7};
    uint64_t hash[4];
    for (int t = 0; t < (long_tests() ? 4 : 2); t++) {
        skv_world *world = fixture_sleeping_pool(0.02f, threads[t]);
        skv_hand hand = skv_default_hand();
        hand.x = 0.1f;
        hand.y = 0.1f;
        hand.radius = 0.1f;
        hand.attraction = 2;
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
        fixture_run(world, 20);
        assert_in_range(skv_world_awake_count(world), 1, skv_world_particle_count(world) - 1);
        hash[t] = skv_world_hash(world);
        skv_world_destroy(world);
        assert_int_equal(hash[t], hash[0]);
    }
}

/* The mean of what pressures change by in a frame. */
static double pressure_step(skv_world *world, float *before)
{
    fixture_run(world, 1);
    skv_particles p = skv_world_particles(world);
    double sum = 0;
    for (int i = 0; i < p.count; i++) {
        sum += fabs((double)(p.pressure[i] - before[p.id[i]]));
        before[p.id[i]] = p.pressure[i];
    }
    return sum / p.count;
}

/* What is held lies where it would if it moved, so the rest hardly feels it. Where it lay as high
 * as substeps end, above what moves, pressures changed by three times as much as awake, and with
 * images by seven times; it is 1.9 now. */
static void falling_asleep_does_not_shake_the_pool(void **unused)
{
    (void)unused;
    for (int images = 0; images < 2; images++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.0155f, 1);
        def.sleep = true;
        def.depth = 0.45f;
        def.fluid.wall_images = images;
        skv_world *world;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        int count = fixture_fill(world, 0, 0, 1.6f, 0.45f);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        float *before = calloc((size_t)count, sizeof *before);
        pressure_step(world, before);
        double awake = 0, partly = 0;
        int frames = 0;
        for (; skv_world_awake_count(world) == count; frames++) {
            assert_true(frames < 3600);
            awake += pressure_step(world, before);
        }
        for (int f = 0; f < 120; f++)
            partly = fmax(partly, pressure_step(world, before));
        if (!(partly < 2.5 * awake / frames))
            fail_msg("pressures change by %g a frame, and by %g awake", partly, awake / frames);
        free(before);
        skv_world_destroy(world);
    }
}

static void only_the_fast_solver_sleeps(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_REFERENCE, 2, 0.04f, 1);
    def.sleep = true;
    skv_world *world = fixture_dam_of(&def);
    fixture_run(world, 120);
    assert_int_equal(skv_world_awake_count(world), skv_world_particle_count(world));
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pool_falls_asleep_and_stays_as_it_is),
        cmocka_unit_test(fluid_in_motion_is_never_left_out),
        cmocka_unit_test(tilting_wakes_everything),
        cmocka_unit_test(a_hand_wakes_what_it_reaches_and_waves_wake_the_rest),
        cmocka_unit_test(a_hand_reaches_as_far_as_its_radius),
        cmocka_unit_test(an_emitter_that_pauses_wakes_nobody),
        cmocka_unit_test(a_falling_drop_is_not_held_and_wakes_the_pool),
        cmocka_unit_test(a_fast_drop_does_not_pass_through_sleeping_fluid),
        cmocka_unit_test(what_gets_faster_still_finds_fluid_awake),
        cmocka_unit_test(a_push_in_velocity_wakes),
        cmocka_unit_test(a_partly_sleeping_world_does_not_depend_on_threads),
        cmocka_unit_test(falling_asleep_does_not_shake_the_pool),
        cmocka_unit_test(only_the_fast_solver_sleeps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
