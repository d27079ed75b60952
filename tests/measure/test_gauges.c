/* Gauges: what they take for a surface, the depth below it, and moments read again. */
#include "rest.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static skv_instrument add(skv_lab *lab, skv_instrument_kind kind, double x0, double y0, double x1,
                          double y1)
{
    return fixture_instrument(lab, kind, skv_default_instrument_def(kind).window, x0, y0, x1, y1);
}

static skv_lab *new_lab(void)
{
    skv_lab *lab;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    return lab;
}

static void sample(skv_lab *lab, const skv_world *world)
{
    assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
}

/* A moment that is read again has one sample, and a gate counts from the moment before; after a
 * jump in time nobody is counted, and histories begin anew. */
static void a_moment_is_read_again(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument gate = add(lab, SKV_INSTRUMENT_GATE, 0.8, 0, 0.8, 0.3);
    skv_instrument region = add(lab, SKV_INSTRUMENT_REGION, 0, 0, 2, 2);
    sample(lab, world);
    rest_shift(world, 0.05f, 0, 0.1);
    sample(lab, world);
    double passed = skv_lab_reading(lab, gate, 3), count = skv_lab_reading(lab, region, 0);
    assert_true(passed > 0);
    for (int again = 0; again < 2; again++) {
        rest_remove(world, 0); /* at the left wall: nobody who has passed */
        sample(lab, world);
    }
    assert_near(skv_lab_reading(lab, gate, 3), passed, 1e-9);
    assert_near(skv_lab_reading(lab, region, 0), count - 2, 1e-9);
    assert_int_equal(skv_lab_history(lab, region, 0, NULL, NULL, 0), 2);
    rest_shift(world, 0.05f, 0, 0.1);
    skv_lab_restart(lab);
    assert_int_equal(skv_lab_history(lab, region, 0, NULL, NULL, 0), 0);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, gate, 3)));
    assert_int_equal(skv_lab_history(lab, region, 0, NULL, NULL, 0), 1);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* A drop of seven particles above the pool is dense enough for fluid, but has no depth. */
static void spray_is_no_surface(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    for (int row = -1; row <= 1; row++) {
        for (int column = 0; column < 3 - (row != 0); column++) {
            float x = 0.8f + 0.0215f * ((float)column - (row ? 0.5f : 1.0f));
            float y = 0.75f + 0.0186f * (float)row;
            assert_int_equal(skv_world_add_particle(world, x, y, 0, 0, NULL), SKV_OK);
        }
    }
    skv_lab *lab = new_lab();
    skv_instrument level = add(lab, SKV_INSTRUMENT_LEVEL, 0.8, 0.1, 0.8, 0.9);
    sample(lab, world);
    assert_true(skv_survey_at(skv_lab_survey(lab), 0.8, 0.75).wet);
    assert_near(skv_lab_reading(lab, level, 2), 0.5, 0.01);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* A shaft four times as high as wide: the level is where the water was filled to. */
static void a_shaft_has_its_level(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
    skv_terrain_def shaft = skv_default_terrain_def();
    shaft.width = 40;
    shaft.height = 160;
    shaft.pixel_size = 0.01f;
    skv_world *world;
    assert_int_equal(skv_terrain_create(&shaft, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 0.4f, 1.2f);
    skv_lab *lab = new_lab();
    skv_instrument level = add(lab, SKV_INSTRUMENT_LEVEL, 0.2, 0.1, 0.2, 1.5);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, level, 2), 1.2, 0.02);
    assert_true(skv_survey_at(skv_lab_survey(lab), 0.2, 1.1).wet);
    assert_false(skv_survey_at(skv_lab_survey(lab), 0.2, 1.3).wet);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Gauges that reach far beyond the world, or begin there, read as short ones do. */
static void gauges_end_with_the_world(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument near = add(lab, SKV_INSTRUMENT_LEVEL, 0.8, 0.1, 0.8, 0.9);
    skv_instrument high = add(lab, SKV_INSTRUMENT_LEVEL, 0.8, 0.1, 0.8, 1e6);
    skv_instrument deep = add(lab, SKV_INSTRUMENT_LEVEL, 0.8, -1e6, 0.8, 1e6);
    skv_instrument beside = add(lab, SKV_INSTRUMENT_LEVEL, 7, 0.1, 7, 1e6);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, near, 2), 0.5, 0.01);
    assert_near(skv_lab_reading(lab, high, 2), skv_lab_reading(lab, near, 2), 1e-6);
    assert_near(skv_lab_reading(lab, deep, 2), skv_lab_reading(lab, near, 2), 1e-3);
    assert_true(isnan(skv_lab_reading(lab, beside, 2)));
    double distance;
    assert_true(skv_survey_surface(skv_lab_survey(lab), 0.8, 0.1, 0.8, 1e12, &distance));
    assert_near(distance, skv_lab_reading(lab, near, 0), 1e-4);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

#define PI 3.14159265358979323846

/* A wave of 1.2 m and 0.06 m passes, once in 0.8 s. */
static void a_wave_of_known_form_is_read(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    int count = skv_world_particle_count(world);
    float *still = malloc((size_t)count * sizeof *still);
    assert_non_null(still);
    memcpy(still, skv_world_particles(world).y, (size_t)count * sizeof *still);
    skv_lab *lab = new_lab();
    skv_instrument up = add(lab, SKV_INSTRUMENT_WAVES, 0.8, 0.1, 0, 0.9);
    skv_instrument down = add(lab, SKV_INSTRUMENT_WAVES, 0.8, 0.1, 5, 0.9);
    double k = 2 * PI / 1.2, omega = 2 * PI / 0.8;
    for (int frame = 0; frame < 300; frame++) {
        double t = frame / 60.0;
        rest_set_wave(world, still, 0.5, 0.03, k, omega * t);
        sample(lab, world);
        assert_near(skv_lab_reading(lab, up, 0), 0.5 + 0.03 * sin(k * 0.8 - omega * t), 0.008);
        assert_near(skv_lab_reading(lab, up, 1), 0.03 * k * cos(k * 0.8 - omega * t), 0.05);
        /* The first rise comes within a period, the second one later. */
        if (t < 0.8)
            assert_true(isnan(skv_lab_reading(lab, up, 2)));
        if (t > 1.7)
            assert_near(skv_lab_reading(lab, up, 3), 0.8, 0.03);
        rest_shift(world, 0, 0, 1 / 60.0);
    }
    assert_near(skv_lab_reading(lab, up, 2), 0.06, 0.004);
    assert_near(skv_lab_reading(lab, up, 3), 0.8, 0.005);
    assert_near(skv_lab_reading(lab, up, 4), 0.06 / 1.2, 0.004);
    assert_near(skv_lab_reading(lab, down, 4), skv_lab_reading(lab, up, 4), 1e-12);
    free(still);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Water at rest has no waves, whatever its particles do within a quarter of their spacing. */
static void still_water_has_no_waves(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument gauge = add(lab, SKV_INSTRUMENT_WAVES, 0.8, 0.1, 0.8, 0.9);
    skv_instrument dry = add(lab, SKV_INSTRUMENT_WAVES, 0.8, 0.7, 0.8, 0.9);
    for (int frame = 0; frame < 60; frame++) {
        sample(lab, world);
        rest_shift(world, 0, frame % 10 < 5 ? 0.001f : -0.001f, 1 / 60.0);
    }
    assert_near(skv_lab_reading(lab, gauge, 0), 0.5, 0.015);
    assert_true(isnan(skv_lab_reading(lab, gauge, 2)));
    assert_true(isnan(skv_lab_reading(lab, gauge, 4)));
    assert_true(isnan(skv_lab_reading(lab, dry, 0)));
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* A hand at the end of a tank of 4 m drives waves of 0.9 s over 0.2 m of water. Their length is
 * that of omega^2 = g k tanh(k d): 1.05 m. Nothing has come back from the far end within eight
 * seconds.
 */
static void a_running_wave_has_its_length(void **unused)
{
    (void)unused;
    enum { MAKER = 480, WATCH = 180 };
    const double period = 0.9;
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 800;
    terrain.height = 100;
    terrain.pixel_size = 0.005f;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
    def.depth = 0.25f;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_fill_def fill = skv_default_fill_def();
    fill.y1 = 0.2f;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    fixture_run(world, 60);
    skv_lab *lab = new_lab();
    skv_instrument gauge = add(lab, SKV_INSTRUMENT_WAVES, 1.5, 0.05, 1.5, 0.45);
    skv_hand maker = skv_default_hand();
    maker.x = 0.1f;
    maker.y = 0.1f;
    maker.radius = 0.3f;
    maker.attraction = 0;
    maker.friction = 0;
    maker.follow = 20;
    for (int frame = 0; frame < MAKER; frame++) {
        maker.vx = (float)(0.6 * cos(2 * PI * frame / 60.0 / period));
        assert_int_equal(skv_world_set_hands(world, &maker, 1, NULL), SKV_OK);
        fixture_run(world, 1);
        if (frame >= WATCH)
            sample(lab, world);
    }
    double height = skv_lab_reading(lab, gauge, 2);
    printf("waves of %.3f m, %.3f s, steepness %.4f\n", height, skv_lab_reading(lab, gauge, 3),
           skv_lab_reading(lab, gauge, 4));
    assert_true(height > 0.02 && height < 0.1);
    assert_near(skv_lab_reading(lab, gauge, 3) / period, 1, 0.03);
    double k = 5;
    for (int i = 0; i < 50; i++)
        k = 4 * PI * PI / (period * period) / (9.81 * tanh(k * 0.2));
    assert_near(height / skv_lab_reading(lab, gauge, 4) * k / (2 * PI), 1, 0.12);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void pull(skv_world *world, double gx, double gy)
{
    assert_int_equal(skv_world_set_gravity(world, (float)gx, (float)gy, NULL), SKV_OK);
}

/* What theory says of a pressure is the weight of the water straight above, wherever up is. */
static void pressure_has_its_theory(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument low = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.1, 0, 0);
    skv_instrument high = add(lab, SKV_INSTRUMENT_PRESSURE, 0.3, 0.4, 0, 0);
    skv_instrument dry = add(lab, SKV_INSTRUMENT_PRESSURE, 0.3, 0.8, 0, 0);
    pull(world, 0, -9.81);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, low, 1), 9810 * 0.4, 9810 * 0.005);
    assert_near(skv_lab_reading(lab, high, 1), 9810 * 0.1, 9810 * 0.005);
    assert_true(isnan(skv_lab_reading(lab, dry, 1)));
    pull(world, 3, -4);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, low, 1), 5000 * 0.4 * 5 / 4, 5000 * 0.005);
    /* Up is where the wall is, or the floor, or nowhere. */
    pull(world, 9.81, 0);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, low, 1)));
    pull(world, 0, 9.81);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, low, 1)));
    pull(world, 0, 0);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, low, 1)) && !isnan(skv_lab_reading(lab, low, 0)));
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* A lid between, thinner than the particles are apart. */
static void a_lid_carries_the_water_above_it(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_terrain *terrain;
    const skv_brush_stroke lid = {.x0 = 0.7f, .y0 = 0.3f, .x1 = 0.9f, .y1 = 0.3f, .radius = 0.008f};
    skv_instrument below = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.2, 0, 0);
    skv_instrument above = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.4, 0, 0);
    skv_instrument within = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.3, 0, 0);
    pull(world, 0, -9.81);
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &lid, 1, &terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, terrain, NULL, NULL), SKV_OK);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, below, 1)));
    assert_string_equal(skv_lab_lack(lab, below), "wall above");
    assert_null(skv_lab_lack(lab, above));
    assert_string_equal(skv_lab_lack(lab, within), "in the wall");
    assert_near(skv_lab_reading(lab, above, 1), 9810 * 0.1, 9810 * 0.005);
    pull(world, 0, 0);
    sample(lab, world);
    assert_string_equal(skv_lab_lack(lab, above), "weightless");
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void expect_lack(skv_instrument_kind kind, double x, double y, const char *wanted)
{
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument id = add(lab, kind, x, y, x, 0.95);
    assert_string_equal(skv_lab_lack(lab, id), "not yet");
    sample(lab, world);
    const char *lack = skv_lab_lack(lab, id);
    assert_string_equal(lack ? lack : "", wanted);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* What can't be read says why, by one of the words that translators know. */
static void what_lacks_says_why(void **unused)
{
    (void)unused;
    static const skv_instrument_kind kinds[] = {SKV_INSTRUMENT_PRESSURE, SKV_INSTRUMENT_VELOCITY,
                                                SKV_INSTRUMENT_LEVEL};
    for (int i = 0; i < 3; i++) {
        expect_lack(kinds[i], 0.8, 0.2, "");
        expect_lack(kinds[i], 0.8, 0.8, "no water here");
        expect_lack(kinds[i], -0.1, 0.2, "outside");
        expect_lack(kinds[i], 0.8, 1.9, "outside");
    }
    expect_lack(SKV_INSTRUMENT_RULER, -1, -1, "");
    expect_lack(SKV_INSTRUMENT_GATE, 0.8, 0.2, "not yet");
    expect_lack(SKV_INSTRUMENT_REGION, 0.8, 0.8, "no water here");
    expect_lack(SKV_INSTRUMENT_WAVES, 0.8, 0.2, "no wave yet");
    expect_lack(SKV_INSTRUMENT_WAVES, 0.8, 0.8, "no water here");
    int words = 0;
    for (; skv_lack_words(words); words++)
        assert_in_range(strlen(skv_lack_words(words)), 3, 16);
    assert_int_equal(words, 7);
    assert_null(skv_lack_words(-1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_moment_is_read_again),
        cmocka_unit_test(spray_is_no_surface),
        cmocka_unit_test(a_shaft_has_its_level),
        cmocka_unit_test(gauges_end_with_the_world),
        cmocka_unit_test(a_wave_of_known_form_is_read),
        cmocka_unit_test(still_water_has_no_waves),
        cmocka_unit_test(a_running_wave_has_its_length),
        cmocka_unit_test(pressure_has_its_theory),
        cmocka_unit_test(a_lid_carries_the_water_above_it),
        cmocka_unit_test(what_lacks_says_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
