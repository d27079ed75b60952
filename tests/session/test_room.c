/* Room for more water: what people add keeps to the limit of emitters, and they are told why. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support.h"

static void draw(skv_stage *stage, const char *tool, double px, double to)
{
    int i = 0;
    while (strcmp(skv_tool_info(i)->name, tool) != 0)
        i++;
    skv_stage_set_tool(stage, i);
    stage_point(stage, 0, SKV_PHASE_DOWN, px, 100, 1);
    for (double time = 1; px <= to; px += 20, time += 0.1)
        stage_point(stage, 0, SKV_PHASE_MOVE, px, 100, time);
    stage_point(stage, 0, SKV_PHASE_UP, to, 100, 9);
}

/* The last report of a refusal. */
static skv_outcome refused(skv_stage *stage)
{
    skv_outcome report, last = {.kind = SKV_OUTCOME_OPEN};
    stage_look(stage, 0);
    while (skv_stage_next_outcome(stage, &report))
        last = report.error.code != SKV_OK ? report : last;
    return last;
}

static void set_limit(skv_stage *stage, int limit)
{
    char text[16];
    snprintf(text, sizeof text, "%d", limit);
    skv_stage_set(stage, 0, "emission.limit", text);
    assert_int_equal(refused(stage).error.code, SKV_OK);
}

static int particles(skv_stage *stage)
{
    return stage_look(stage, 0)->frame.particles.count;
}

static bool has_tap(skv_stage *stage)
{
    const skv_picture *picture = stage_look(stage, 0);
    for (int i = 0; i < picture->mark_count; i++)
        if (picture->marks[i].role == SKV_MARK_SOURCE)
            return true;
    return false;
}

static void test_limit(void **state)
{
    skv_stage *stage = *state;
    int before = particles(stage);
    skv_stage_set_paused(stage, true);
    set_limit(stage, before + 10);
    draw(stage, "water", 400, 1200);
    assert_in_range(particles(stage) - before, 10, 40); /* its last dab is whole */
    skv_outcome report = refused(stage);
    assert_int_equal(report.error.code, SKV_ERROR_LIMIT);
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
    assert_non_null(strstr(report.error.text, "emission.limit"));
    draw(stage, "tap", 800, 900);
    assert_false(has_tap(stage));
    assert_int_equal(refused(stage).error.code, SKV_ERROR_LIMIT);
    set_limit(stage, 20000);
    draw(stage, "tap", 800, 900);
    assert_true(has_tap(stage));
    assert_int_equal(refused(stage).error.code, SKV_OK);
}

static int count_refusals(skv_stage *stage)
{
    skv_outcome report;
    int count = 0;
    stage_look(stage, 0);
    while (skv_stage_next_outcome(stage, &report))
        count += report.kind == SKV_OUTCOME_EDIT && report.error.code == SKV_ERROR_LIMIT;
    return count;
}

/* A tap that reaches the limit while it runs says so, once each time. */
static void test_dry(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_paused(stage, true);
    draw(stage, "tap", 800, 900);
    assert_true(has_tap(stage));
    for (int turn = 0; turn < 2; turn++) {
        set_limit(stage, particles(stage) + 10);
        skv_stage_set_paused(stage, false);
        int told = 0;
        for (int frames = 0; frames < 3000 && !told; frames += 10) {
            stage_pass_frames(stage, 10);
            told = count_refusals(stage);
        }
        assert_int_equal(told, 1);
        stage_pass_frames(stage, 30);
        assert_int_equal(count_refusals(stage), 0);
        set_limit(stage, 20000);
        stage_pass_frames(stage, 2);
        skv_stage_set_paused(stage, true);
    }
}

/* Taps that replace the oldest water need no room. */
static void test_replaced(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_paused(stage, true);
    set_limit(stage, 1);
    skv_stage_set(stage, 0, "emission.replaces", "true");
    draw(stage, "tap", 800, 900);
    assert_true(has_tap(stage));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_limit, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_dry, stage_setup, stage_teardown),
        cmocka_unit_test_setup_teardown(test_replaced, stage_setup, stage_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
