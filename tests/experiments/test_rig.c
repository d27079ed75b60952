/* The rig of an experiment: a world that is built anew keeps what was in it. */
#include "experiments/experiment.h"
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* As a gate is opened: the same vessel, of which a wall is missing. */
static void a_rebuilt_world_keeps_its_fluids(void **unused)
{
    (void)unused;
    skv_error error;
    findings found = {0};
    skv_lab_options options = skv_default_lab_options();
    options.threads = 1;
    rig s;
    skv_rig_open(&s, &skv_exp_layers, &options, &found, &error);
    rig_plan plan = {.width = 0.8,
                     .height = 0.6,
                     .solids = 1,
                     .solid = {skv_shape_box(0.38, 0, 0.42, 0.6)},
                     .waters = 2,
                     .water = {skv_shape_box(0, 0, 0.38, 0.2), skv_shape_box(0, 0.2, 0.38, 0.4)},
                     .depth = 0.4,
                     .gravity_y = -9.81,
                     .fluids = 1,
                     .fluid = {{"oil", 900, 0}}};
    plan.fluid_of[1] = 1;
    skv_rig_build(&s, &plan);
    assert_true(skv_rig_ok(&s));
    skv_stats before[2] = {skv_world_fluid_stats(s.world, 0), skv_world_fluid_stats(s.world, 1)};
    assert_true(before[0].particles > 100 && before[1].particles > 100);
    plan.solids = 0;
    skv_rig_rebuild(&s, &plan);
    assert_true(skv_rig_ok(&s));
    for (int k = 0; k < 2; k++) {
        skv_stats after = skv_world_fluid_stats(s.world, k);
        assert_int_equal(after.particles, before[k].particles);
        assert_near(after.centre_y, before[k].centre_y, 1e-6);
    }
    assert_int_equal(skv_rig_close(&s), SKV_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_rebuilt_world_keeps_its_fluids)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
