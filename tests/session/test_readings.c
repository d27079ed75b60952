/* Readings are alive: whatever is changed shows in the next picture, stepped or not, and says what
 * it is called. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/controls.h>
#include <skvalp/parameters.h>

#include "support.h"

static uint32_t add(skv_stage *stage, skv_instrument_kind kind, double x0, double y0, double x1,
                    double y1)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x0, def.y0 = y0, def.x1 = x1, def.y1 = y1;
    return skv_stage_add_probe(stage, &def);
}

static double reading(skv_stage *stage, uint32_t probe, int channel)
{
    stage_look(stage, 0);
    const skv_probe *read = skv_stage_probe(stage, 0, probe);
    assert_non_null(read);
    return read->value[channel];
}

static void settle_down(skv_stage *stage)
{
    for (int i = 0; i < 600 && !stage_look(stage, 0)->at_rest; i++)
        stage_pass_frames(stage, 10);
    assert_true(stage_look(stage, 0)->at_rest);
}

/* Before the first step, while nothing but messages passes; a paused stage, and one at rest. */
static void test_still(void **state)
{
    skv_stage *stage = *state;
    for (int rest = 0; rest < 2; rest++) {
        skv_stage_set_paused(stage, !rest);
        if (rest)
            settle_down(stage);
        int64_t moment = stage_moment(stage);
        uint32_t ruler = add(stage, SKV_INSTRUMENT_RULER, 0.2, 0.1, 0.5, 0.5);
        assert_true(fabs(reading(stage, ruler, 0) - 0.5) < 1e-9);
        uint32_t pressure = add(stage, SKV_INSTRUMENT_PRESSURE, 0.8, 0.1, 0, 0);
        double shallow = reading(stage, pressure, 0);
        assert_true(shallow > 500);
        skv_stage_move_probe(stage, pressure, 0.8, 0.05, 0, 0);
        assert_true(reading(stage, pressure, 0) > shallow + 200);
        skv_stage_move_probe(stage, pressure, 0.8, 0.85, 0, 0);
        assert_true(isnan(reading(stage, pressure, 0)));
        skv_stage_watch_probe(stage, pressure, true);
        stage_look(stage, 0);
        assert_int_equal(skv_stage_probe(stage, 0, pressure)->samples, 1);
        assert_int_equal(stage_moment(stage), moment);
        skv_stage_remove_probe(stage, ruler);
        skv_stage_remove_probe(stage, pressure);
    }
}

static double greatest_pressure(skv_stage *stage)
{
    const skv_particles *p = &stage_look(stage, 0)->frame.particles;
    double most = 0;
    for (int i = 0; i < p->count; i++)
        most = fmax(most, (double)p->pressure[i]);
    return most;
}

/* While nothing is stepped pressures are those to which things lead: at the start, where nothing
 * was pressed yet, and with another liquid. None of it changes the way that the water goes. */
static void test_forecast(void **state)
{
    (void)state;
    skv_stage *stage = stage_make(false, stage_still), *other = stage_make(false, stage_still);
    skv_stage *both[] = {stage, other};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 1000;
    for (int i = 0; i < 2; i++) {
        skv_stage_open(both[i], "dam-break", &options);
        stage_pass_frames(both[i], 30);
    }
    uint32_t probe = add(stage, SKV_INSTRUMENT_PRESSURE, 0.1, 0.1, 0, 0);
    skv_stage_set_paused(stage, true);
    skv_stage_seek(stage, 0);
    assert_true(greatest_pressure(stage) > 1000);
    double water = reading(stage, probe, 0);
    assert_true(water > 300);
    for (int moment = 0; moment < 30; moment += 20) {
        skv_stage_seek(stage, moment);
        water = reading(stage, probe, 0);
        skv_stage_set(stage, 0, "fluid.density", "2000");
        double heavy = reading(stage, probe, 0);
        assert_true(heavy > 1.3 * water);
        skv_stage_set(stage, 0, "gravity.y", "-19.62");
        assert_true(reading(stage, probe, 0) != heavy);
        skv_stage_undo(stage);
        assert_true(reading(stage, probe, 0) == heavy);
        skv_stage_undo(stage);
        assert_true(reading(stage, probe, 0) == water);
        skv_stage_set_paused(stage, false);
        stage_pass_frames(stage, 30 - moment);
        skv_stage_set_paused(stage, true);
    }
    assert_true(stage_hash(stage, 0) == stage_hash(other, 0));
    skv_stage_destroy(stage);
    skv_stage_destroy(other);
}

/* A reading at rest is that of what is there: what changes it wakes the water. */
static void test_rest(void **state)
{
    static const struct {
        const char *path, *value;
        double times; /* of the pressure before */
    } changes[] = {
        {"fluid.material", "honey", 1.42},
        {"fluid.density", "500", 500 / 1420.0},
        {"gravity.y", "-19.62", 2},
        {"fluid.material", "water", 2},
    };
    skv_stage *stage = *state;
    settle_down(stage);
    uint32_t pressure = add(stage, SKV_INSTRUMENT_PRESSURE, 0.8, 0.1, 0, 0);
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        double before = reading(stage, pressure, 0);
        skv_stage_set(stage, 0, changes[i].path, changes[i].value);
        assert_false(stage_look(stage, 0)->at_rest);
        assert_true(skv_stage_is_active(stage));
        settle_down(stage);
        double after = reading(stage, pressure, 0), theory = reading(stage, pressure, 1);
        assert_true(fabs(after / before / changes[i].times - 1) < 0.1);
        assert_true(fabs(after / theory - 1) < 0.1);
    }
}

/* So does every parameter of the balance, whether a reading shows it or not. */
static void test_every_parameter(void **state)
{
    skv_stage *stage = *state;
    settle_down(stage);
    const skv_field *field;
    int changed = 0;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        bool acts =
            strncmp(field->path, "fluid.", 6) == 0 || strncmp(field->path, "gravity", 7) == 0;
        if (!acts || !skv_world_can_change(field->path) || field->type == SKV_FIELD_CHOICE)
            continue;
        const skv_world_def *def = &skv_stage_picture(stage, 0)->parameters;
        double now = skv_world_def_number(def, skv_world_parameter(field->path));
        char text[32];
        snprintf(text, sizeof text, "%.6g",
                 now == field->minimum ? now + 1 : (now + field->minimum) / 2);
        if (field->type == SKV_FIELD_INTEGER)
            snprintf(text, sizeof text, "%d", (int)now + 1);
        skv_stage_set(stage, 0, field->path, text);
        if (stage_look(stage, 0)->at_rest)
            fail_msg("%s = %s leaves the water asleep", field->path, text);
        skv_stage_undo(stage);
        assert_true(stage_look(stage, 0)->at_rest);
        changed++;
    }
    assert_true(changed > 10);
}

/* A moment that was gone back to reads as it did then; one that was jumped to has no history. */
static void test_moments(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set(stage, 0, "gravity.x", "3");
    uint32_t pressure = add(stage, SKV_INSTRUMENT_PRESSURE, 0.8, 0.1, 0, 0);
    skv_stage_watch_probe(stage, pressure, true);
    stage_pass_frames(stage, 20);
    double then = reading(stage, pressure, 0);
    stage_pass_frames(stage, 40);
    assert_true(reading(stage, pressure, 0) != then);
    assert_int_equal(skv_stage_probe(stage, 0, pressure)->samples, 61);
    skv_stage_set_paused(stage, true);
    skv_stage_seek(stage, 20);
    assert_true(reading(stage, pressure, 0) == then);
    assert_int_equal(skv_stage_probe(stage, 0, pressure)->samples, 1);
    skv_stage_seek(stage, 21); /* no jump */
    stage_look(stage, 0);
    assert_int_equal(skv_stage_probe(stage, 0, pressure)->samples, 2);
    skv_stage_seek(stage, 40);
    stage_look(stage, 0);
    assert_int_equal(skv_stage_probe(stage, 0, pressure)->samples, 1);
}

/* A level is where rulers and walls have it, wherever the gauge begins; a force is a force on
 * whichever wall; and what can't be read says why. */
static void test_names(void **state)
{
    skv_stage *stage = *state;
    settle_down(stage);
    double levels[2];
    for (int i = 0; i < 2; i++) {
        uint32_t id = add(stage, SKV_INSTRUMENT_LEVEL, 0.8, i ? 0.05 : 0.15, 0.8, 0.8);
        int channel = skv_gauge_of(SKV_INSTRUMENT_LEVEL)->channel;
        levels[i] = reading(stage, id, channel);
        assert_string_equal(skv_instrument_channel(SKV_INSTRUMENT_LEVEL, channel)->name, "level");
    }
    const skv_picture *picture = stage_look(stage, 0);
    const skv_particles *p = &picture->frame.particles;
    double top = 0;
    for (int i = 0; i < p->count; i++)
        top = fmax(top, (double)p->y[i]);
    assert_true(fabs(levels[0] - levels[1]) < 1e-6);
    assert_true(fabs(levels[0] - top) < (double)picture->frame.spacing);
    int channel = skv_gauge_of(SKV_INSTRUMENT_FORCE)->channel;
    uint32_t side = add(stage, SKV_INSTRUMENT_FORCE, -0.1, -0.1, 0.05, 0.9);
    double force = reading(stage, side, channel), fx = reading(stage, side, 0);
    assert_true(force > 50 && force >= fabs(fx));
    uint32_t dry = add(stage, SKV_INSTRUMENT_PRESSURE, 0.8, 0.8, 0, 0);
    stage_look(stage, 0);
    assert_string_equal(skv_stage_probe(stage, 0, dry)->lack, "no water here");
    assert_string_equal(skv_stage_probe(stage, 0, side)->lack, "");
}

/* A stopwatch that runs at rest is not kept waiting, of one world or two. */
static void test_timed(void **state)
{
    skv_stage *stage = *state;
    settle_down(stage);
    for (int sides = 1; sides <= 2; sides++) {
        skv_stage_set_timed(stage, sides == 2);
        if (sides == 2)
            stage_compare(stage, 0, NULL, NULL);
        for (int i = 0;
             i < 600 && !(stage_look(stage, 0)->at_rest && stage_look(stage, 1)->at_rest); i++)
            stage_pass_frames(stage, 10);
        skv_stage_set_timed(stage, true);
        stage_pass_frames(stage, 5);
        int64_t moment = stage_moment(stage);
        assert_true(skv_stage_is_active(stage));
        stage_pass_frames(stage, 30);
        assert_in_range(stage_moment(stage), moment + 29, moment + 31);
        assert_true(skv_stage_now(stage).at_rest);
        skv_stage_set_paused(stage, true);
        stage_pass_frames(stage, 5);
        moment = stage_moment(stage);
        stage_pass_frames(stage, 5);
        assert_int_equal(stage_moment(stage), moment);
        skv_stage_set_paused(stage, false);
        skv_stage_set_timed(stage, false);
        stage_pass_frames(stage, 5);
        moment = stage_moment(stage);
        stage_pass_frames(stage, 30);
        assert_int_equal(stage_moment(stage), moment);
        assert_false(skv_stage_is_active(stage));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_timed, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_names, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_still, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_moments, stage_setup, stage_teardown),
        cmocka_unit_test(test_forecast),
        cmocka_unit_test_setup_teardown(test_rest, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_every_parameter, stage_setup, stage_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
