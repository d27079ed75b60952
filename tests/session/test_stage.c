/* A stage: what is opened on it and beside it, and what is done on either side. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "session/stage.h"
#include "session/support.h"
#include "support/kept.h"
#include "terrain/terrain.h"

/* What was done before is done to both; then each has its own hand. */
static void test_another_liquid(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(300, false);
    stage_draw_wall(stage, 0, 400);
    stage_pass_frames(stage, 20);
    uint64_t played = stage_hash(stage, 0);
    stage_compare(stage, 0, "fluid.material", "honey");
    skv_stage_set_linked(stage, false);
    const skv_picture *other = stage_look(stage, 1);
    assert_true(other->following && other->end == 20);
    stage_pass_frames(stage, 20);
    assert_int_equal(stage_moment(stage), 20);
    assert_true(stage_hash(stage, 0) == played); /* it went as it had gone */
    assert_true(stage_hash(stage, 1) != played);
    const skv_picture *one = skv_stage_picture(stage, 0);
    other = skv_stage_picture(stage, 1);
    assert_true(!other->mismatch && !other->as_recorded && !one->as_recorded);
    assert_int_equal(one->frame.terrain->hash, other->frame.terrain->hash);
    stage_draw_wall(stage, 1, 900);
    stage_pass_frames(stage, 5);
    assert_int_not_equal(stage_look(stage, 0)->frame.terrain->hash,
                         stage_look(stage, 1)->frame.terrain->hash);
    skv_stage_destroy(stage);
}

static void test_apart_again(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    stage_compare(stage, 0, NULL, NULL);
    stage_pass_frames(stage, 3);
    /* Led apart by hand: they come together again. */
    skv_session_post(stage->worlds[0], &(skv_message){.kind = SKV_MESSAGE_STEP});
    stage_pass(stage, 1.0 / 60);
    stage_pass(stage, 1.0 / 60);
    int64_t before = stage_moment(stage);
    skv_stage_end_compare(stage);
    assert_int_equal(skv_stage_sides(stage), 1);
    assert_ptr_equal(skv_stage_picture(stage, 1), skv_stage_picture(stage, 0));
    stage_pass_frames(stage, 1);
    assert_int_equal(stage_moment(stage), before + 1);
    /* Something else is open: nothing to compare with. */
    stage_compare(stage, 0, NULL, NULL);
    skv_outcome outcome;
    skv_stage_open(stage, "no-such-scene", NULL);
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.error.code != SKV_OK);
    assert_int_equal(skv_stage_sides(stage), 2);
    skv_stage_open(stage, "dam-break", NULL);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_int_equal(skv_stage_sides(stage), 1);
    stage_pass_frames(stage, 1);
    assert_int_equal(stage_moment(stage), 1);
    skv_stage_destroy(stage);
}

/* The last wish counts, and what cannot be leaves the first alone. */
static void test_what_is_asked_for_beside(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = stage_make(own_thread, stage_still);
        skv_outcome outcome;
        skv_stage_compare(stage, NULL);
        assert_string_equal(stage_compared(stage).error.text, "nothing is open");
        skv_stage_destroy(stage);
        stage = stage_open_pool(200, own_thread);
        stage_ask_compare(stage, 0, "fluid.material", "glue");
        assert_non_null(strstr(stage_compared(stage).error.text, "glue"));
        assert_int_equal(skv_stage_sides(stage), 1);
        stage_pass_frames(stage, 2);
        assert_int_equal(stage_moment(stage), 2);
        stage_ask_compare(stage, 0, "fluid.material", "glue");
        stage_ask_compare(stage, 800, NULL, NULL);
        assert_string_equal(stage_compared(stage).error.text, "");
        assert_int_equal(stage_look(stage, 1)->frame.particles.count, 800);
        /* The second stays until the next is there. */
        stage_ask_compare(stage, 0, "fluid.material", "glue");
        assert_non_null(strstr(stage_compared(stage).error.text, "glue"));
        stage_ask_compare(stage, 400, NULL, NULL);
        assert_int_equal(skv_stage_sides(stage), 2);
        assert_int_equal(stage_look(stage, 1)->frame.particles.count, 800);
        assert_string_equal(stage_compared(stage).error.text, "");
        assert_int_equal(stage_look(stage, 1)->frame.particles.count, 400);
        stage_ask_compare(stage, 300, NULL, NULL);
        skv_stage_end_compare(stage);
        skv_stage_wait(stage);
        assert_false(skv_stage_next_outcome(stage, &outcome));
        assert_int_equal(skv_stage_sides(stage), 1);
        skv_stage_destroy(stage);
    }
}

/* What was done after it was asked for, by a finger that is still down, is in neither world. */
static void test_both_begin_with_what_was_shared(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = stage_open_pool(200, own_thread);
        kept link = {0};
        stage_pass_frames(stage, 12);
        stage_ask_compare(stage, 0, NULL, NULL);
        stage_draw_wall(stage, 0, 400);
        skv_stage_set_tool(stage, 0);
        stage_point(stage, 0, SKV_PHASE_DOWN, 500, 700, 1);
        assert_int_equal(skv_stage_pointer_count(stage, 0), 1);
        stage_pass_frames(stage, 9);
        assert_string_equal(stage_compared(stage).error.text, "");
        const skv_picture *one = stage_look(stage, 0), *other = skv_stage_picture(stage, 1);
        assert_true(one->end == 12 && other->end == 12 && one->following && other->following);
        stage_pass_frames(stage, 20);
        assert_int_equal(stage_moment(stage), 20);
        assert_true(stage_hash(stage, 0) == stage_hash(stage, 1));
        assert_int_equal(stage_look(stage, 0)->hand_count, 0);
        assert_false(skv_stage_read_shared(stage, kept_add, &link)); /* nobody asked for a link */
        skv_stage_destroy(stage);
    }
}

static uint32_t add_probe(skv_stage *stage, double x)
{
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = x;
    def.y0 = 0.2;
    return skv_stage_add_probe(stage, &def);
}

static void expect_same_probes(skv_stage *stage, int count)
{
    const skv_picture *a = stage_look(stage, 0), *b = skv_stage_picture(stage, 1);
    assert_int_equal(a->probe_count, count);
    assert_int_equal(b->probe_count, count);
    for (int i = 0; i < count; i++) {
        const skv_probe *other = skv_stage_probe(stage, 1, a->probes[i].id);
        assert_non_null(other);
        assert_true(other->def.x0 == a->probes[i].def.x0);
    }
}

/* A link that is made while a second world opens moves nothing. */
static void test_a_link_meanwhile(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, true);
    kept link = {0};
    skv_outcome outcome;
    stage_pass_frames(stage, 12);
    stage_ask_compare(stage, 0, NULL, NULL);
    stage_pass_frames(stage, 9);
    skv_stage_share(stage);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.kind == SKV_OUTCOME_SHARE);
    assert_string_equal(stage_compared(stage).error.text, "");
    assert_true(stage_look(stage, 0)->end == 12 && skv_stage_picture(stage, 1)->end == 12);
    assert_true(skv_stage_read_shared(stage, kept_add, &link) && link.size > 0);
    kept_clear(&link);
    skv_stage_destroy(stage);
}

/* Whenever it was asked for: before, while nothing waits for it, or at once. */
static void test_instruments_are_both_s(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = stage_open_pool(4000, own_thread);
        uint32_t gone = add_probe(stage, 0.9), old = add_probe(stage, 0.2);
        skv_stage_remove_probe(stage, gone);
        stage_ask_compare(stage, 0, NULL, NULL);
        skv_stage_watch_probe(stage, old, true);
        stage_pass(stage, 0.02);
        skv_stage_advance(stage, 0.1, 0); /* it is busy stepping */
        add_probe(stage, 0.4);
        assert_string_equal(stage_compared(stage).error.text, "");
        uint32_t both = add_probe(stage, 0.6);
        skv_stage_set_paused(stage, true);
        for (int i = 0; skv_stage_is_active(stage); i++) {
            assert_true(i < 100);
            stage_pass(stage, 1.0 / 60);
        }
        expect_same_probes(stage, 3);
        skv_stage_move_probe(stage, both, 0.7, 0.1, 0.7, 0.1);
        expect_same_probes(stage, 3);
        assert_true(skv_stage_probe(stage, 1, both)->def.x0 == (double)0.7F ||
                    skv_stage_probe(stage, 1, both)->def.x0 == 0.7);
        assert_null(skv_stage_probe(stage, 0, gone));
        skv_stage_shift_probe(stage, both, -0.1, 0.1);
        expect_same_probes(stage, 3);
        assert_true(fabs(skv_stage_probe(stage, 1, both)->def.y1 - 0.2) < 1e-6);
        skv_stage_set_paused(stage, false);
        stage_pass_frames(stage, 4);
        const skv_picture *picture = stage_look(stage, 1);
        for (int i = 0; i < 3; i++)
            assert_int_equal(picture->probes[i].samples > 0, picture->probes[i].id == old);
        skv_stage_destroy(stage);
    }
}

/* Hands and gravity are for both, until they are told apart; what was chosen before is the
 * second's, too. */
static void test_linked_or_apart(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    skv_stage_set_brush(stage, 0.07);
    skv_stage_set_tool(stage, 0);
    skv_stage_set_dye(stage, 3);
    stage_compare(stage, 0, NULL, NULL);
    assert_true(stage_look(stage, 1)->brush == 0.07 && skv_stage_dye(stage) == 3);
    assert_int_equal(skv_stage_picture(stage, 1)->tool, skv_stage_tool(stage));
    assert_true(skv_stage_linked(stage));
    stage_point(stage, 1, SKV_PHASE_DOWN, 500, 700, 1);
    skv_stage_set_gravity(stage, 1, 0.5, -0.5);
    stage_pass_frames(stage, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(stage_look(stage, i)->hand_count, 1);
        assert_true(fabs(stage_look(stage, i)->tilt_x - 0.5) < 1e-3);
        assert_true(fabs((double)stage_look(stage, i)->hands[0].x - 0.5) < 1e-3);
    }
    skv_stage_set_linked(stage, false);
    assert_false(skv_stage_linked(stage));
    stage_pass_frames(stage, 2);
    assert_int_equal(stage_look(stage, 0)->hand_count + stage_look(stage, 1)->hand_count, 0);
    stage_point(stage, 0, SKV_PHASE_DOWN, 500, 700, 2);
    skv_stage_set_gravity(stage, 0, 0, -1);
    skv_stage_push(stage, 0, 0, 99);
    skv_stage_keyboard(stage, 1, 1, 0, true);
    skv_stage_set(stage, 1, "fluid.viscosity", "0.05");
    skv_stage_edit(stage, 0,
                   &(skv_command){.kind = SKV_COMMAND_SET, .set = {"fluid.viscosity", "0.01"}});
    stage_pass_frames(stage, 2);
    assert_int_equal(stage_look(stage, 0)->hand_count, 1);
    assert_int_equal(stage_look(stage, 1)->hand_count, 1); /* that of the keys */
    assert_true(fabs(stage_look(stage, 0)->tilt_x) < 1e-3 &&
                fabs(stage_look(stage, 1)->tilt_x - 0.5) < 1e-3);
    assert_true(stage_look(stage, 0)->parameters.fluid.viscosity <
                stage_look(stage, 1)->parameters.fluid.viscosity);
    skv_stage_cancel_pointers(stage);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
    skv_stage_destroy(stage);
}

/* What is no number, or too large a one, does no harm. */
static void test_any_numbers(void **state)
{
    skv_stage *stage = stage_open_pool(200, false);
    const double nan = (double)NAN, huge = (double)INFINITY;
    (void)state;
    const double brush = stage_look(stage, 0)->brush;
    skv_stage_set_gravity(stage, 0, nan, 0);
    skv_stage_set_gravity(stage, 0, huge, 0);
    skv_stage_push(stage, 0, nan, huge);
    skv_stage_zoom(stage, 0, nan, 0, 0);
    skv_stage_zoom(stage, 0, -1, 0, 0);
    skv_stage_pan(stage, 0, huge, 0);
    skv_stage_set_speed(stage, nan);
    skv_stage_set_brush(stage, nan);
    skv_stage_set_tool(stage, 99);
    skv_stage_set_dye(stage, -1);
    stage_pass_frames(stage, 1);
    const skv_picture *picture = stage_look(stage, 0);
    assert_true(picture->tilt_x == 0 && picture->brush == brush && picture->tool == 0);
    assert_true(skv_stage_speed(stage) == 1 && skv_stage_dye(stage) == 1);
    assert_true(skv_stage_camera(stage, 0).zoom == 1);
    skv_stage_set_speed(stage, huge);
    skv_stage_set_brush(stage, -1);
    assert_true(skv_stage_speed(stage) == 2 && stage_look(stage, 0)->brush == brush);
    skv_stage_push(stage, 0, 0, 99);
    assert_true(stage_look(stage, 0)->frame.particles.vy[0] < 11);
    skv_stage_destroy(stage);
}

/* Both show the same part of their worlds, in views of any size; a finger is at the same place. */
static void test_cameras_go_together(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    skv_stage_zoom(stage, 0, 4, 400, 450);
    stage_compare(stage, 0, NULL, NULL);
    skv_stage_set_view(stage, 1, 800, 450);
    for (int i = 0; i < 2; i++) {
        skv_camera a = skv_stage_camera(stage, 0), b = skv_stage_camera(stage, 1);
        assert_true(a.zoom == b.zoom && a.centre_x == b.centre_x && a.centre_y == b.centre_y);
        skv_stage_look(stage);
        assert_int_equal(skv_stage_look(stage), 0);
        skv_stage_pan(stage, 1, 30, 20);
        assert_int_equal(skv_stage_look(stage), 3);
    }
    stage_point(stage, 1, SKV_PHASE_DOWN, 400, 225, 0);
    stage_pass_frames(stage, 1);
    assert_true(
        fabs((double)(stage_look(stage, 0)->hands[0].x - stage_look(stage, 1)->hands[0].x)) < 1e-3);
    skv_stage_show_all(stage);
    assert_true(skv_stage_camera(stage, 0).zoom == 1 && skv_stage_camera(stage, 1).zoom == 1);
    assert_int_equal(skv_stage_camera(stage, 1).width, 800);
    skv_stage_destroy(stage);
}

static double touch(skv_stage *stage, skv_phase phase, int finger, double px, double time)
{
    skv_pointer_event event = {.phase = phase, .device = SKV_DEVICE_FINGER};
    event.pointer = (uint64_t)finger;
    event.px = px;
    event.py = 400;
    event.time = time;
    return skv_stage_touch(stage, 0, &event, 12);
}

/* Two fingers zoom, three undo, and one that is alone waits, and is a hand then. */
static void test_fingers(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    assert_true(touch(stage, SKV_PHASE_DOWN, 1, 700, 0) > 0);
    touch(stage, SKV_PHASE_DOWN, 2, 900, 0.05);
    touch(stage, SKV_PHASE_MOVE, 2, 1100, 0.2);
    touch(stage, SKV_PHASE_MOVE, 1, 500, 0.3);
    assert_true(skv_stage_camera(stage, 0).zoom > 2);
    touch(stage, SKV_PHASE_UP, 1, 500, 0.4);
    touch(stage, SKV_PHASE_UP, 2, 1100, 0.4);
    skv_stage_show_all(stage);
    stage_draw_wall(stage, 0, 400);
    stage_pass_frames(stage, 3);
    assert_true(stage_look(stage, 0)->can_undo);
    for (int i = 0; i < 3; i++)
        touch(stage, SKV_PHASE_DOWN, i, 300 + 100 * i, 1 + 0.01 * i);
    for (int i = 0; i < 3; i++)
        touch(stage, SKV_PHASE_UP, i, 300 + 100 * i, 1.2);
    assert_false(stage_look(stage, 0)->can_undo);
    skv_stage_set_tool(stage, 0);
    assert_true(touch(stage, SKV_PHASE_DOWN, 1, 700, 2) > 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
    assert_true(skv_stage_touch_waited(stage, 0) == 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 1);
    skv_stage_cancel_pointers(stage);
    assert_true(touch(stage, SKV_PHASE_DOWN, 1, 700, 3) > 0); /* the first again */
    skv_stage_destroy(stage);
}

/* What was saved is opened again, from a file and from memory. */
static void test_saved(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    skv_outcome outcome;
    kept link = {0};
    stage_pass_frames(stage, 5);
    uint64_t played = stage_hash(stage, 0);
    skv_stage_save(stage, "test_stage.skv");
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.kind == SKV_OUTCOME_SAVE);
    assert_string_equal(outcome.error.text, "");
    skv_stage_share(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.kind == SKV_OUTCOME_SHARE);
    assert_true(skv_stage_read_shared(stage, kept_add, &link));
    skv_stage_open_memory(stage, link.bytes, link.size, "skvr", "link", NULL);
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.error.code == SKV_OK);
    assert_int_equal(stage_look(stage, 0)->end, 5);
    skv_stage_open(stage, "test_stage.skv", NULL);
    assert_true(skv_stage_next_outcome(stage, &outcome) && outcome.error.code == SKV_OK);
    assert_true(stage_hash(stage, 0) == played);
    remove("test_stage.skv");
    kept_clear(&link);
    skv_stage_destroy(stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_another_liquid),
        cmocka_unit_test(test_apart_again),
        cmocka_unit_test(test_what_is_asked_for_beside),
        cmocka_unit_test(test_both_begin_with_what_was_shared),
        cmocka_unit_test(test_a_link_meanwhile),
        cmocka_unit_test(test_instruments_are_both_s),
        cmocka_unit_test(test_linked_or_apart),
        cmocka_unit_test(test_any_numbers),
        cmocka_unit_test(test_cameras_go_together),
        cmocka_unit_test(test_fingers),
        cmocka_unit_test(test_saved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
