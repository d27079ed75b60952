/* The tool that drops bodies: where there is room, as they were drawn to fly; undone, erased,
 * played again, in two worlds. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "skvalp/bodies.h"
#include "skvalp/controls.h"
#include "support/fixture.h"

/* 1000 pixels of the view are a metre, and the pool is 0.3 m deep or so. */
static int setup(void **state)
{
    skv_stage *stage = stage_open_pool(400, false);
    int tool = 0;
    while (!skv_tool_info(tool)->drops)
        tool++;
    skv_stage_set_tool(stage, tool);
    *state = stage;
    return 0;
}

static int count_of(skv_stage *stage, int side)
{
    return stage_look(stage, side)->frame.body_count;
}

static skv_body body_of(skv_stage *stage, int side, int number)
{
    const skv_picture *picture = stage_look(stage, side);
    assert_true(number < picture->frame.body_count);
    return picture->frame.bodies[number];
}

/* Draws a way, in pixels. */
static void drop(skv_stage *stage, double px, double py, double way_x, double way_y)
{
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, px, py, 0);
    stage_touch(stage, SKV_PHASE_MOVE, SKV_DEVICE_MOUSE, 0, px + way_x, py + way_y, 0.1);
    stage_touch(stage, SKV_PHASE_UP, SKV_DEVICE_MOUSE, 0, px + way_x, py + way_y, 0.2);
    skv_stage_wait(stage);
}

static void expect_report(skv_stage *stage, const char *text)
{
    skv_outcome report;
    assert_true(skv_stage_next_outcome(stage, &report));
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
    assert_non_null(strstr(report.error.text, text));
    assert_false(skv_stage_next_outcome(stage, &report));
}

static void bodies_come_as_they_are_drawn(void **state)
{
    skv_stage *stage = *state;
    drop(stage, 400, 300, 0, 0);
    drop(stage, 800, 300, 100, -200);
    skv_stage_set_shape(stage, 1);
    drop(stage, 1200, 300, 0, 0);
    assert_int_equal(count_of(stage, 0), 3);
    skv_body duck = body_of(stage, 0, 0), flying = body_of(stage, 0, 1),
             ball = body_of(stage, 0, 2);
    assert_true(duck.vx == 0 && duck.vy == 0 && duck.density == 500 && !duck.fixed);
    assert_near((double)duck.x, 0.4, 0.02);
    assert_near((double)duck.y, 0.6, 0.02);
    assert_near((double)flying.vx, 1, 0.01);
    assert_near((double)flying.vy, 2, 0.01);
    /* A twentieth of the world's width. */
    assert_near((double)ball.area, 3.14159 * 0.08 * 0.08, 1e-4);
    assert_true(duck.corners > 10 && duck.area < ball.area);
    stage_pass_frames(stage, 240);
    assert_true((double)body_of(stage, 0, 0).y > 0.2 && (double)body_of(stage, 0, 0).y < 0.5);
}

static void each_is_one_step_of_undo(void **state)
{
    skv_stage *stage = *state;
    for (int i = 0; i < 3; i++)
        drop(stage, 400 + 300 * i, 300, 0, 0);
    for (int left = 2; left >= 0; left--) {
        skv_stage_undo(stage);
        assert_int_equal(count_of(stage, 0), left);
    }
    for (int there = 1; there <= 3; there++) {
        skv_stage_redo(stage);
        assert_int_equal(count_of(stage, 0), there);
    }

    /* The eraser takes what it comes over, by whatever part. */
    skv_stage_set_tool(stage, 3);
    drop(stage, 400 - 50, 300 - 30, 0, 0);
    assert_int_equal(count_of(stage, 0), 2);
    drop(stage, 550, 150, 0, 0);
    assert_int_equal(count_of(stage, 0), 2);
    skv_stage_undo(stage);
    skv_stage_undo(stage);
    assert_int_equal(count_of(stage, 0), 3);
}

static void none_comes_without_room(void **state)
{
    skv_stage *stage = *state;
    drop(stage, 400, 300, 0, 0);
    drop(stage, 420, 320, 0, 0); /* on the first */
    expect_report(stage, "a wall or another body leaves no room");
    drop(stage, 30, 300, 0, 0); /* in the wall */
    expect_report(stage, "a wall or another body leaves no room");
    assert_int_equal(count_of(stage, 0), 1);
    skv_stage_undo(stage);
    assert_false(stage_look(stage, 0)->can_undo);

    /* So small that as many find room as there may be. */
    skv_stage_set_shape(stage, 2);
    skv_stage_set_brush(stage, 0.03);
    for (int i = 0; i <= SKV_MAX_BODIES; i++)
        drop(stage, 100 + 80.0 * (double)(i % 16), 100 + 80.0 * (double)(i >> 4), 0, 0);
    expect_report(stage, "that is all there may be");
    assert_int_equal(count_of(stage, 0), SKV_MAX_BODIES);
    skv_stage_set_brush(stage, 0.001);
    drop(stage, 1500, 100, 0, 0);
    skv_outcome report;
    assert_true(skv_stage_next_outcome(stage, &report));
}

static void replays_and_links_drop_them_too(void **state)
{
    skv_stage *stage = *state;
    for (int shape = 0; shape < 3; shape++) {
        skv_stage_set_shape(stage, shape);
        drop(stage, 400 + 300 * shape, 300, 50, 20 * shape);
        stage_pass_frames(stage, 10);
    }
    stage_pass_frames(stage, 30);
    uint64_t hash = stage_hash(stage, 0);
    int64_t moment = stage_moment(stage);
    skv_body body = body_of(stage, 0, 2);
    skv_stage_seek(stage, 5);
    assert_int_equal(count_of(stage, 0), 1);
    skv_stage_seek(stage, moment);
    assert_true(stage_hash(stage, 0) == hash);
    assert_true(body_of(stage, 0, 2).x == body.x && body_of(stage, 0, 2).angle == body.angle);

    skv_stage *other = stage_open_shared(stage);
    assert_true(body_of(other, 0, 2).x == body.x);
    skv_stage_destroy(other);
}

static void both_worlds_get_theirs(void **state)
{
    skv_stage *stage = *state;
    stage_compare(stage, 0, "gravity.y", "-3");
    drop(stage, 400, 300, 0, 0);
    assert_int_equal(count_of(stage, 0), 1);
    assert_int_equal(count_of(stage, 1), 1);
}

/* The tool again: the next shape, and after the last the first. */
static void shapes_are_chosen(void **state)
{
    skv_stage *stage = *state;
    int tool = skv_stage_tool(stage), count = 0;
    assert_int_equal(skv_stage_shape(stage), 0);
    while (skv_drop_shape(count))
        count++;
    skv_stage_set_shape(stage, count);
    skv_stage_set_shape(stage, -1);
    assert_int_equal(skv_stage_shape(stage), 0);
    for (int next = 1; next <= count; next++) {
        skv_control_tool(stage, tool);
        assert_int_equal(skv_stage_shape(stage), next % count);
    }
    skv_control_tool(stage, 0);
    skv_control_tool(stage, tool);
    assert_int_equal(skv_stage_shape(stage), 0);

    /* A command with another one is refused. */
    skv_command command = {
        .kind = SKV_COMMAND_DROP,
        .drop = {.shape = count, .x = 0.8f, .y = 0.6f, .radius = 0.05f, .density = 500}};
    skv_stage_edit(stage, 0, &command);
    skv_stage_wait(stage);
    expect_report(stage, "there is no shape 3");
    command.drop.shape = 0;
    command.drop.x = NAN;
    skv_stage_edit(stage, 0, &command);
    skv_stage_wait(stage);
    expect_report(stage, "leaves no room");
    command.drop.x = 0.8f;
    command.drop.density = NAN;
    skv_stage_edit(stage, 0, &command);
    skv_stage_wait(stage);
    expect_report(stage, "density");

    /* A brush that is nowhere takes none. */
    command.drop.density = 500;
    skv_stage_edit(stage, 0, &command);
    skv_command nowhere = {.kind = SKV_COMMAND_CLOSE,
                           .water = {NAN, 0.6f, 3e38f, 0.6f, 0.1f, 0, 0, 0, 0}};
    skv_stage_edit(stage, 0, &nowhere);
    assert_int_equal(count_of(stage, 0), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(bodies_come_as_they_are_drawn, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(each_is_one_step_of_undo, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(none_comes_without_room, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(replays_and_links_drop_them_too, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(both_worlds_get_theirs, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(shapes_are_chosen, setup, stage_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
