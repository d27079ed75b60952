/* What tools pour: the fluid that was chosen, whoever pours it, and none that a world lacks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "skvalp/controls.h"

static const char layers[] =
    "{\"particles\": 400, \"world\": {\"width\": 1.6, \"height\": 0.9}, \"fluids\": [{\"name\": "
    "\"oil\", \"material\": \"oil\"}, {\"name\": \"brine\", \"density\": 1200}], \"water\": "
    "[{\"shape\": \"box\", \"y1\": 0.2}]}";

static void open_layers(skv_stage *stage)
{
    skv_outcome outcome;
    skv_stage_open_memory(stage, layers, sizeof layers - 1, "json", "layers.json", NULL);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_string_equal(outcome.error.text, "");
    skv_stage_look(stage);
}

static int setup(void **state)
{
    skv_stage *stage = stage_make(false, stage_still);
    open_layers(stage);
    *state = stage;
    return 0;
}

static int tool_named(const char *name)
{
    int tool = 0;
    while (strcmp(skv_tool_info(tool)->name, name) != 0)
        tool++;
    return tool;
}

/* Particles of a fluid on a side. */
static int number_of(skv_stage *stage, int side, int fluid)
{
    const skv_particles particles = stage_look(stage, side)->frame.particles;
    int count = 0;
    for (int i = 0; i < particles.count; i++)
        count += (particles.fluid ? particles.fluid[i] : 0) == fluid;
    return count;
}

/* Presses at a place in the air and lets go. */
static void pour(skv_stage *stage, skv_device device, double px)
{
    stage_touch(stage, SKV_PHASE_DOWN, device, 3, px, 300, 0);
    stage_touch(stage, SKV_PHASE_UP, device, 3, px, 300, 0.1);
}

static void every_pointer_pours_it(void **state)
{
    skv_stage *stage = *state;
    static const skv_device devices[] = {SKV_DEVICE_MOUSE, SKV_DEVICE_FINGER, SKV_DEVICE_PEN};
    int water = number_of(stage, 0, 0), before = 0;
    skv_stage_set_paused(stage, true);
    skv_stage_set_tool(stage, tool_named("water"));
    skv_stage_set_fluid(stage, 1);
    for (int i = 0; i < 3; i++) {
        pour(stage, devices[i], 300 + 200 * i);
        assert_true(number_of(stage, 0, 1) > before);
        before = number_of(stage, 0, 1);
    }
    skv_stage_keyboard(stage, 0, 0, 1, false);
    skv_stage_keyboard(stage, 0, 0, 0, true);
    skv_stage_wait(stage);
    skv_stage_keyboard(stage, 0, 0, 0, false);
    assert_true(number_of(stage, 0, 1) > before);
    skv_stage_set_fluid(stage, 2);
    pour(stage, SKV_DEVICE_MOUSE, 1300);
    assert_true(number_of(stage, 0, 2) > 0);
    assert_int_equal(number_of(stage, 0, 0), water);

    /* What erases takes all. */
    skv_stage_set_tool(stage, tool_named("eraser"));
    pour(stage, SKV_DEVICE_MOUSE, 1300);
    assert_int_equal(number_of(stage, 0, 2), 0);
}

/* Played again, and as a link: of the same fluid. */
static void replays_and_links_keep_it(void **state)
{
    skv_stage *stage = *state;
    int water = number_of(stage, 0, 0);
    skv_stage_set_fluid(stage, 1);
    skv_stage_set_tool(stage, tool_named("tap"));
    pour(stage, SKV_DEVICE_MOUSE, 500);
    skv_stage_set_tool(stage, tool_named("water"));
    pour(stage, SKV_DEVICE_MOUSE, 900);
    int poured = number_of(stage, 0, 1);
    for (int i = 0; i < 40; i++)
        stage_advance(stage, 1.0 / 60);
    assert_true(poured > 0 && number_of(stage, 0, 1) > poured + 3); /* from the tap */
    assert_int_equal(number_of(stage, 0, 0), water);
    uint64_t hash = stage_hash(stage, 0);
    int64_t moment = stage_look(stage, 0)->moment;
    skv_stage_seek(stage, 0);
    skv_stage_wait(stage);
    skv_stage_seek(stage, moment);
    assert_true(stage_hash(stage, 0) == hash);

    skv_stage_destroy(stage_open_shared(stage));
}

/* A second world pours it, too; another scene what it has. */
static void other_worlds_pour_what_they_have(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_tool(stage, tool_named("water"));
    skv_stage_set_fluid(stage, 2);
    stage_compare(stage, 0, "gravity.y", "-3");
    pour(stage, SKV_DEVICE_MOUSE, 700);
    assert_true(number_of(stage, 0, 2) > 0 && number_of(stage, 1, 2) > 0);
    skv_stage_end_compare(stage);

    skv_outcome outcome;
    skv_stage_open(stage, "pool", NULL);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    int before = number_of(stage, 0, 0);
    assert_int_equal(skv_stage_fluid(stage), 0);
    pour(stage, SKV_DEVICE_MOUSE, 700);
    assert_true(number_of(stage, 0, 0) > before);
    assert_false(skv_stage_next_outcome(stage, &outcome));
}

static void controls_choose_it(void **state)
{
    skv_stage *stage = *state;
    assert_int_equal(skv_stage_fluid(stage), 0);
    skv_stage_set_fluid(stage, -1);
    skv_stage_set_fluid(stage, SKV_MAX_FLUIDS);
    assert_int_equal(skv_stage_fluid(stage), 0);
    skv_control_fluid(stage, 1); /* and the tool that pours */
    assert_int_equal(skv_stage_fluid(stage), 1);
    assert_int_equal(skv_stage_tool(stage), tool_named("water"));
    skv_control_tool(stage, tool_named("tap"));
    for (int next = 2; next < 6; next++) {
        skv_control_next_fluid(stage);
        assert_int_equal(skv_stage_fluid(stage), next % 3);
        assert_int_equal(skv_stage_tool(stage), tool_named("tap"));
    }
}

/* Where there is but one fluid a key for the next changes nothing. */
static void one_fluid_is_no_choice(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    skv_stage_look(stage);
    skv_control_next_fluid(stage);
    assert_int_equal(skv_stage_fluid(stage), 0);
    assert_int_equal(skv_stage_tool(stage), 0);
    skv_stage_destroy(stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_pointer_pours_it, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(replays_and_links_keep_it, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(other_worlds_pour_what_they_have, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(controls_choose_it, setup, stage_teardown),
        cmocka_unit_test(one_fluid_is_no_choice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
