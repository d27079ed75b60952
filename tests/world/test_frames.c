/* Time and substeps: frames of any length take the same substeps, and gravity that is set later
 * gets the substeps that it needs. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void step(skv_world *world, float dt, int times)
{
    for (int i = 0; i < times; i++)
        assert_int_equal(skv_world_step(world, dt, NULL), SKV_OK);
}

static skv_world *make_dam(skv_law law, skv_solver_kind solver)
{
    skv_world_def def = fixture_def(law, solver, 0, 0.03f, 1);
    def.substeps = 7;
    return fixture_dam_of(&def);
}

/* A third of a second, cut in pieces of many lengths. */
static void pieces_make_the_same_water(void **unused)
{
    (void)unused;
    const struct {
        float dt;
        int times;
    } cuts[] = {{1.0f / 120, 40}, {1.0f / 144, 48},    {1.0f / 30, 10},
                {1.0f / 90, 30},  {1.0f / 4200, 1400}, {1.0f / 15, 5}};
    for (int k = 0; k < 4; k++) {
        skv_law law = k & 1 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
        skv_solver_kind solver = k & 2 ? SKV_SOLVER_REFERENCE : SKV_SOLVER_FAST;
        skv_world *frames = make_dam(law, solver);
        fixture_run(frames, 20);
        assert_int_equal(skv_world_substep_count(frames), 140);
        int count = solver == SKV_SOLVER_FAST ? 6 : 2;
        for (int c = 0; c < count; c++) {
            skv_world *pieces = make_dam(law, solver);
            step(pieces, cuts[c].dt, cuts[c].times);
            assert_int_equal(skv_world_substep_count(pieces), 140);
            assert_near(skv_world_time(pieces), skv_world_time(frames), 1e-9);
            /* Taking the particles in and out once a frame rounds them: not the same bits. */
            skv_stats a = skv_world_stats(frames), b = skv_world_stats(pieces);
            assert_near(b.centre_x, a.centre_x, 1e-3 * a.centre_x);
            assert_near(b.rms_speed, a.rms_speed, 0.02 * a.rms_speed);
            skv_world_destroy(pieces);
        }
        skv_world_destroy(frames);
    }
}

/* The shortest step allowed is far below a substep: many of them make one. */
static void short_steps_add_up(void **unused)
{
    (void)unused;
    skv_world *world = make_dam(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST);
    const uint64_t before = skv_world_hash(world);
    const double substep = 1.0 / 420;
    const int calls = (int)(substep * 1e6) + 1;
    step(world, 1e-6f, calls - 1);
    assert_int_equal(skv_world_hash(world), before);
    assert_true(skv_world_time(world) == 0);
    step(world, 1e-6f, 1);
    assert_int_equal(skv_world_substep_count(world), 1);
    assert_near(skv_world_time(world), substep, 1e-12);
    step(world, 0.1f, 1);
    assert_int_equal(skv_world_substep_count(world), 43);
    skv_world_destroy(world);
}

/* The worst of five seconds' rms speeds, with a frame of `odd` seconds now and then. */
static double unrest_with(skv_law law, float odd)
{
    skv_world *world = fixture_tank(law, 0.03f, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.4f);
    fixture_run(world, 300);
    double most = 0;
    for (int f = 0; f < 300; f++) {
        if (odd > 0 && f % 30 == 0)
            step(world, odd, 1);
        fixture_run(world, 1);
        most = fmax(most, skv_world_stats(world).rms_speed);
    }
    skv_world_destroy(world);
    return most;
}

static void odd_frames_do_not_heat(void **unused)
{
    (void)unused;
    for (int law = 0; law < 2; law++) {
        double still = unrest_with((skv_law)law, 0);
        const float odd[] = {1e-5f, 1e-4f, 0.0151f};
        for (int k = 0; k < 3; k++)
            assert_true(unrest_with((skv_law)law, odd[k]) < 1.5 * still + 0.002);
    }
}

static skv_world *make_pool(float gx, float gy, float depth, int substeps)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.03f, 1);
    def.gravity_x = gx;
    def.gravity_y = gy;
    def.depth = depth;
    def.substeps = substeps;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, 0.45f);
    return world;
}

static int substeps_for(float gx, float gy)
{
    skv_world *world = make_pool(gx, gy, 0, 0);
    int substeps = skv_world_substeps_per_frame(world);
    skv_world_destroy(world);
    return substeps;
}

static void set_gravity(skv_world *world, float gx, float gy)
{
    assert_int_equal(skv_world_set_gravity(world, gx, gy, NULL), SKV_OK);
}

/* Gravity that is set later is as good as one of the definition, in every direction. */
static void later_gravity_gets_its_substeps(void **unused)
{
    (void)unused;
    const float gravities[][2] = {{0, -40}, {0, -100}, {0, 1000}, {40, 0}, {-40, 0}, {100, -100}};
    int down = substeps_for(0, -9.81f);
    for (int k = 0; k < 6; k++) {
        float gx = gravities[k][0], gy = gravities[k][1];
        skv_world *world = make_pool(0, -9.81f, 0, 0);
        set_gravity(world, gx, gy);
        int now = skv_world_substeps_per_frame(world);
        assert_true(now > down);
        assert_int_equal(now, substeps_for(gx, gy));
        /* Back again; less than g counts as g. */
        set_gravity(world, 0, 0);
        assert_int_equal(skv_world_substeps_per_frame(world), down);
        skv_world_destroy(world);
    }
    /* Sideways the tank is deeper, whatever depth was expected downwards. */
    assert_true(substeps_for(9.81f, 0) > down);
    skv_world *shallow = make_pool(0, -40, 0.45f, 0);
    int before = skv_world_substeps_per_frame(shallow);
    set_gravity(shallow, 40, 0);
    assert_true(skv_world_substeps_per_frame(shallow) > before);
    skv_world_destroy(shallow);
    /* Given substeps stay. */
    skv_world *given = make_pool(0, -9.81f, 0, 9);
    set_gravity(given, 0, -100);
    assert_int_equal(skv_world_substeps_per_frame(given), 9);
    skv_world_destroy(given);
}

/* A gravity that trembles about a value does not change the substeps to and fro. */
static void trembling_gravity_keeps_the_substeps(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(0, -9.81f, 0, 0);
    for (float g = 20; g < 80; g += 0.5f) {
        set_gravity(world, 0, -g);
        int substeps = skv_world_substeps_per_frame(world);
        set_gravity(world, 0, -0.98f * g);
        assert_int_equal(skv_world_substeps_per_frame(world), substeps);
    }
    skv_world_destroy(world);
}

/* Where g dt^2 stays, the fluid stays as it is: twice the gravity does not shake a pool, and ten
 * times the gravity does not squeeze it. */
static void a_pool_bears_more_gravity(void **unused)
{
    (void)unused;
    const struct {
        float gravity;
        double after_a_frame, after_a_second;
    } cases[] = {{20, 0.06, 0.03}, {100, 0.3, 0.1}, {1000, 0.6, 0.2}};
    for (int k = 0; k < 3; k++) {
        skv_world *world = make_pool(0, -9.81f, 0.45f, 0);
        fixture_run(world, 180);
        double volume = fixture_packing(world).volume_ratio;
        set_gravity(world, 0, -cases[k].gravity);
        fixture_run(world, 1);
        assert_true(skv_world_stats(world).rms_speed < cases[k].after_a_frame);
        fixture_run(world, 59);
        skv_stats stats = skv_world_stats(world);
        assert_true(stats.rms_speed < cases[k].after_a_second);
        assert_near(fixture_packing(world).volume_ratio, volume, 0.01);
        skv_world_destroy(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_make_the_same_water),
        cmocka_unit_test(short_steps_add_up),
        cmocka_unit_test(odd_frames_do_not_heat),
        cmocka_unit_test(later_gravity_gets_its_substeps),
        cmocka_unit_test(trembling_gravity_keeps_the_substeps),
        cmocka_unit_test(a_pool_bears_more_gravity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
