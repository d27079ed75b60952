/* What instruments read in two layers, oil of half the density over water: each particle weighs as
 * much as its fluid does. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { WATER = 1000, OIL = 500 };
static const double g = 9.81, layer = 0.25;

/* Half a metre deep, at rest. */
static skv_world *make_layers(void)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
    fixture_add_liquids(&def, 1);
    def.liquids[0].density = OIL;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    for (int i = 0; i < 2; i++) {
        skv_fill_def fill = skv_default_fill_def();
        fill.y0 = (float)(i * layer);
        fill.y1 = (float)((i + 1) * layer);
        fill.fluid = i;
        assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    }
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    return world;
}

static skv_instrument add(skv_lab *lab, skv_instrument_kind kind, double x0, double y0, double x1,
                          double y1)
{
    return fixture_instrument(lab, kind, kind == SKV_INSTRUMENT_FORCE ? 0.5 : 0, x0, y0, x1, y1);
}

/* Of all particles above a height, N. */
static double weight_above(const skv_world *world, double height)
{
    skv_particles p = skv_world_particles(world);
    double s = (double)skv_world_spacing(world), weight = 0;
    for (int i = 0; i < p.count; i++)
        if ((double)p.y[i] > height)
            weight += g * s * s * (p.fluid[i] ? OIL : WATER);
    return weight;
}

static void instruments_weigh(void **unused)
{
    (void)unused;
    skv_world *world = make_layers();
    skv_lab *lab;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    skv_instrument deep = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.1, 0, 0);
    skv_instrument high = add(lab, SKV_INSTRUMENT_PRESSURE, 0.8, 0.35, 0, 0);
    skv_instrument energy = add(lab, SKV_INSTRUMENT_ENERGY, 0, 0, 0, 0);
    skv_instrument floor = add(lab, SKV_INSTRUMENT_FORCE, -0.1, -0.1, 1.7, 0.02);
    skv_instrument side = add(lab, SKV_INSTRUMENT_FORCE, -0.1, 0.3, 0.1, 0.8);
    for (int frame = 0; frame < 30; frame++) {
        fixture_run(world, 1);
        assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
    }
    skv_stats stats = skv_world_stats(world);
    assert_near(skv_lab_reading(lab, energy, 0), stats.kinetic_energy, 1e-9 * stats.kinetic_energy);
    assert_near(skv_lab_reading(lab, energy, 1), stats.potential_energy,
                1e-9 * stats.potential_energy);
    double above_deep = weight_above(world, 0.1) / 1.6,
           above_high = weight_above(world, 0.35) / 1.6;
    /* A surface may be a third of a spacing off. */
    assert_near(skv_lab_reading(lab, high, 1) / above_high, 1, 0.05);
    assert_near(skv_lab_reading(lab, deep, 1) / above_deep, 1, 0.02);
    assert_near(skv_lab_reading(lab, high, 0) / above_high, 1, 0.1);
    assert_near(skv_lab_reading(lab, deep, 0) / above_deep, 1, 0.05);
    /* The floor bears all of it. */
    assert_near(skv_lab_reading(lab, floor, 1) / weight_above(world, 0), -1, 0.02);
    /* And the wall beside the oil what its depth there presses. */
    double pressed = weight_above(world, 0.3) / 1.6, depth = pressed / (g * OIL);
    assert_near(skv_lab_reading(lab, side, 0) / (pressed * depth / 2), -1, 0.1);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void densities_are_those_of_the_fluids(void **unused)
{
    (void)unused;
    skv_world *world = make_layers();
    skv_survey *survey;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    skv_local low = skv_survey_at(survey, 0.8, 0.12), high = skv_survey_at(survey, 0.8, 0.38);
    skv_local between = skv_survey_at(survey, 0.8, layer - 0.01);
    assert_near(low.density, low.fill * WATER, 1e-6 * WATER);
    assert_near(high.density, high.fill * OIL, 1e-6 * OIL);
    assert_near(between.density / between.fill, 0.5 * (WATER + OIL), 0.15 * WATER);
    assert_near(low.fill, 1, 0.05);
    assert_near(high.fill, 1, 0.05);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instruments_weigh),
        cmocka_unit_test(densities_are_those_of_the_fluids),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
