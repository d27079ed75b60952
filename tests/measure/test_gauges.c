/* Gauges: what they take for a surface. */
#include "rest.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static skv_instrument add(skv_lab *lab, skv_instrument_kind kind, double x0, double y0, double x1,
                          double y1)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    skv_instrument id;
    assert_int_equal(skv_lab_add(lab, &def, &id, NULL), SKV_OK);
    return id;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spray_is_no_surface),
        cmocka_unit_test(gauges_end_with_the_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
