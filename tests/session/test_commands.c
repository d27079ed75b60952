/* Commands of a face: one step of undo each; what is refused leaves no trace; parameters follow
 * time. A stage with all work done within the calls, and one on a thread of its own. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include <skvalp/parameters.h>
#include <skvalp/query.h>

/* An edit is one step of undo; one that is refused leaves nothing behind. */
static void test_edits_bring_their_mark(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    for (int i = 0; i < 4; i++)
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    uint64_t before = skv_world_hash(skv_player_world(player));
    skv_command set = {.kind = SKV_COMMAND_SET, .set = {"fluid.viscosity", "much"}};
    assert_int_equal(skv_player_edit(player, &set, NULL), SKV_ERROR_VALUE);
    assert_false(skv_player_can_undo(player));
    skv_command push = {.kind = SKV_COMMAND_PUSH, .vector = {1, 0}};
    assert_int_equal(skv_player_edit(player, &push, NULL), SKV_OK);
    assert_int_equal(skv_player_edit(player, &set, NULL), SKV_ERROR_VALUE);
    assert_int_not_equal(skv_world_hash(skv_player_world(player)), before);
    assert_int_equal(skv_player_undo(player, NULL), SKV_OK);
    while (skv_player_seeking(player))
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    assert_int_equal(skv_world_hash(skv_player_world(player)), before);
    assert_int_equal(skv_player_frame(player), 4);
    assert_false(skv_player_can_undo(player));
    skv_player_destroy(player);
}

/* What is poured is of the fluid that the command names. */
static void test_pouring_names_a_fluid(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    const skv_world *world = skv_player_world(player);
    skv_command command = {.kind = SKV_COMMAND_POUR};
    command.water =
        (skv_dab){.x0 = 0.8f, .y0 = 0.7f, .x1 = 0.8f, .y1 = 0.7f, .radius = 0.1f, .fluid = 1};
    assert_int_equal(skv_player_edit(player, &command, NULL), SKV_OK);
    assert_in_range(skv_world_fluid_stats(world, 1).particles, 5, 100);
    command.water.fluid = 2;
    assert_int_equal(skv_player_edit(player, &command, NULL), SKV_ERROR_VALUE);
    skv_player_destroy(player);
}

static void expect_parameter(skv_stage *stage, const char *path, const char *wanted)
{
    skv_picture picture;
    char text[64];
    stage_copy(stage, &picture);
    assert_int_equal(skv_world_def_get(&picture.parameters, path, text, sizeof text, NULL), SKV_OK);
    assert_string_equal(text, wanted);
}

/* An edit that is refused leaves nothing to undo; those before it can be. */
static void test_edits(void **state)
{
    skv_stage *stage = *state;
    skv_outcome report;
    skv_picture picture;
    skv_command tap = {.kind = SKV_COMMAND_EMIT};
    tap.source = (skv_emitter){.x = 0.4f, .y = 0.8f, .vy = -1, .width = 0.02f};
    for (int i = 0; i <= SKV_MAX_EMITTERS; i++)
        skv_stage_edit(stage, 0, &tap);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_ERROR_LIMIT);
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
    stage_copy(stage, &picture);
    assert_int_equal(picture.mark_count, SKV_MAX_EMITTERS);
    for (int left = SKV_MAX_EMITTERS - 1; left >= 0; left--) {
        skv_stage_undo(stage);
        skv_stage_wait(stage);
        stage_copy(stage, &picture);
        assert_int_equal(picture.mark_count, left);
        assert_int_equal(picture.can_undo, left > 0);
    }
}

static const skv_force *forces(skv_player *player, int wanted)
{
    int count;
    const skv_force *list = skv_world_forces(skv_player_world(player), &count);
    assert_int_equal(count, wanted);
    return list;
}

/* One more, another, one less; the others stay in their order. What has no such place is refused.
 */
static void test_forces(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    skv_command change = {.kind = SKV_COMMAND_FORCE, .force.place = -1};
    for (int i = 0; i < 3; i++) {
        change.force.force = (skv_force){.area = skv_circle(0.3f, 0.2f, 0.1f), .ax = (float)i};
        assert_int_equal(skv_player_edit(player, &change, NULL), SKV_OK);
    }
    change.force.place = 1;
    change.force.force.ax = 7;
    assert_int_equal(skv_player_edit(player, &change, NULL), SKV_OK);
    assert_true(forces(player, 3)[1].ax == 7 && forces(player, 3)[2].ax == 2);
    change.force.remove = true;
    change.force.place = 0;
    assert_int_equal(skv_player_edit(player, &change, NULL), SKV_OK);
    assert_true(forces(player, 2)[0].ax == 7 && forces(player, 2)[1].ax == 2);
    skv_error error;
    const int none[] = {-1, 2, -2, 1000};
    for (int i = 0; i < 4; i++) {
        change.force.place = none[i];
        assert_int_equal(skv_player_edit(player, &change, &error), SKV_ERROR_VALUE);
        assert_non_null(strstr(error.text, "no force has the place"));
    }
    change.force = (skv_force_change){.place = 0, .force.drag = -1};
    assert_int_equal(skv_player_edit(player, &change, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_player_undo(player, NULL), SKV_OK);
    while (skv_player_seeking(player))
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    assert_true(forces(player, 3)[0].ax == 0);
    /* What closes takes fans, and no other force. */
    skv_command fan = {.kind = SKV_COMMAND_FORCE, .force.place = -1};
    fan.force.force.area = skv_swept_circle(0.2f, 0.2f, 0.4f, 0.2f, 0.1f);
    assert_int_equal(skv_player_edit(player, &fan, NULL), SKV_OK);
    forces(player, 4);
    skv_command close = {.kind = SKV_COMMAND_CLOSE};
    close.water = (skv_dab){.x0 = 0.3f, .y0 = 0.2f, .x1 = 0.3f, .y1 = 0.2f, .radius = 0.05f};
    assert_int_equal(skv_player_edit(player, &close, NULL), SKV_OK);
    assert_true(forces(player, 3)[0].ax == 0 && forces(player, 3)[2].ax == 2);
    skv_player_destroy(player);
}

static void test_parameters_and_pushes(void **state)
{
    skv_stage *stage = *state;
    skv_outcome report;
    skv_picture picture;
    uint64_t start = stage_hash(stage, 0);
    skv_stage_set(stage, 0, "fluid.density", "900");
    skv_stage_wait(stage);
    stage_copy(stage, &picture);
    assert_true(picture.frame.density == 900 && picture.can_undo && !picture.can_redo);
    skv_stage_set(stage, 0, "fluid.density", "heavy");
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &report));
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
    assert_non_null(strstr(report.error.text, "fluid.density"));
    expect_parameter(stage, "fluid.density", "900");
    skv_stage_undo(stage); /* the one that was refused left no mark */
    skv_stage_wait(stage);
    stage_copy(stage, &picture);
    assert_true(picture.frame.density == 1000 && !picture.can_undo && picture.can_redo);
    expect_parameter(stage, "fluid.density", "1000");
    skv_stage_redo(stage);
    skv_stage_wait(stage);
    expect_parameter(stage, "fluid.density", "900");
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    /* Gravity is a parameter, and the ball follows; what was asked for before is not forgotten. */
    skv_stage_set_gravity(stage, 0, 1, 0);
    skv_stage_set(stage, 0, "gravity.y", "-4.905");
    skv_stage_wait(stage);
    stage_copy(stage, &picture);
    assert_true(fabs(picture.tilt_x - 1) < 1e-6 && fabs(picture.tilt_y + 0.5) < 1e-6);
    skv_stage_undo(stage);
    skv_stage_wait(stage);
    stage_copy(stage, &picture);
    assert_true(fabs(picture.tilt_x - 1) < 1e-6 && picture.tilt_y == 0 && !picture.can_undo);
    /* What is too long to be a parameter is refused, too. */
    char path[100];
    memset(path, 'a', sizeof path - 1);
    path[sizeof path - 1] = '\0';
    skv_stage_set(stage, 0, path, "1");
    assert_int_equal(stage_report(stage, &report), SKV_ERROR_VALUE);
    skv_stage_push(stage, 0, 0, 2);
    skv_stage_wait(stage);
    assert_int_not_equal(stage_hash(stage, 0), start);
}

/* Another text for a field, which a world takes: between its bounds, another choice. */
static void other_value(const skv_field *field, const char *now, char text[64])
{
    double value = strtod(now, NULL), step = field->type == SKV_FIELD_INTEGER ? 1 : 0.5;
    if (field->type == SKV_FIELD_BOOLEAN) {
        skv_format(text, 64, "%s", strcmp(now, "true") == 0 ? "false" : "true");
    } else if (field->type == SKV_FIELD_CHOICE) {
        const char *rest = strchr(field->choices, '|') + 1;
        bool first = strncmp(now, field->choices, (size_t)(rest - 1 - field->choices)) == 0;
        skv_format(text, 64, "%s", first ? rest : field->choices);
        text[strcspn(text, "|")] = '\0';
    } else {
        double up = fmin(field->maximum, value + step);
        skv_format(text, 64, "%.7g", up > value ? up : fmax(field->minimum, value - step));
    }
}

/* What a panel of properties shows is the picture's parameters: each of them follows undo and redo,
 * one step an edit. */
static void test_every_parameter_follows_undo(void **state)
{
    skv_stage *stage = *state;
    const skv_field *field;
    int count = 0;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        char before[64], wanted[64];
        skv_picture picture;
        skv_outcome report;
        if (!skv_world_can_change(field->path))
            continue;
        stage_advance(stage, 1.0 / 60);
        stage_copy(stage, &picture);
        skv_world_def_get(&picture.parameters, field->path, before, sizeof before, NULL);
        other_value(field, before, wanted);
        skv_stage_set(stage, 0, field->path, wanted);
        skv_stage_wait(stage);
        if (skv_stage_next_outcome(stage, &report))
            fail_msg("%s", report.error.text);
        expect_parameter(stage, field->path, wanted);
        stage_advance(stage, 1.0 / 60);
        skv_stage_undo(stage);
        skv_stage_wait(stage);
        expect_parameter(stage, field->path, before);
        stage_copy(stage, &picture);
        assert_true(!picture.can_undo && picture.can_redo);
        skv_stage_redo(stage);
        skv_stage_wait(stage);
        expect_parameter(stage, field->path, wanted);
        skv_stage_undo(stage);
        skv_stage_wait(stage);
        count++;
    }
    assert_true(count > 15);
}

#define BOTH(test)                                                                                 \
    cmocka_unit_test_setup_teardown(test, stage_setup, stage_teardown),                            \
        cmocka_unit_test_setup_teardown(test, stage_setup_thread, stage_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_edits_bring_their_mark),
        cmocka_unit_test(test_pouring_names_a_fluid),
        cmocka_unit_test(test_forces),
        BOTH(test_parameters_and_pushes),
        BOTH(test_edits),
        BOTH(test_every_parameter_follows_undo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
