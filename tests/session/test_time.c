/* Two worlds side by side are at the same moment, whatever is done in time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "session/stage.h"
#include "session/support.h"
#include <skvalp/query.h>

/* Alone, too: what was done is done again, and goes on. */
static void test_played_again(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    stage_draw_wall(stage, 0, 400);
    stage_pass_frames(stage, 20);
    uint64_t played = stage_hash(stage, 0);
    skv_stage_replay(stage);
    assert_int_equal(stage_moment(stage), 0);
    stage_pass_frames(stage, 20);
    assert_true(stage_hash(stage, 0) == played);
    stage_pass_frames(stage, 1);
    const skv_picture *picture = stage_look(stage, 0);
    assert_true(picture->moment == 21 && picture->end == 21 && !picture->as_recorded);
    skv_stage_destroy(stage);
}

/* A parameter of Clavet's law is on its way for a second: back in the midst of that, and onward. */
static void test_a_way_is_gone_again(void **state)
{
    (void)state;
    enum { SET_AT = 5, END = 80 };
    const skv_setting clavet[] = {{"particles", "200"}, {"fluid.law", "clavet"}};
    skv_scene_options options = skv_default_scene_options();
    options.settings = clavet;
    options.setting_count = 2;
    skv_scene *scene;
    skv_player *player;
    uint64_t hashes[END + 1];
    assert_int_equal(skv_scene_load("pool", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, NULL, &player, NULL), SKV_OK);
    skv_command set = {.kind = SKV_COMMAND_SET, .set = {"fluid.clavet_rest_density", "6"}};
    for (int f = 0; f < END; f++) {
        if (f == SET_AT)
            assert_int_equal(skv_player_apply(player, &set, NULL), SKV_OK);
        hashes[f] = skv_world_hash(skv_player_world(player));
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    }
    for (int back = 50; back > 0; back -= 20) {
        assert_int_equal(skv_player_seek(player, back, NULL), SKV_OK);
        while (skv_player_seeking(player))
            assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        for (int f = back; f < END; f++) {
            assert_true(skv_world_hash(skv_player_world(player)) == hashes[f]);
            assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        }
    }
    skv_player_destroy(player);
}

static void test_lockstep(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_stage *stage = stage_open_pool(200, own_thread);
        stage_compare(stage, 800, NULL, NULL);
        assert_int_equal(stage_look(stage, 0)->frame.particles.count, 200);
        assert_int_equal(stage_look(stage, 1)->frame.particles.count, 800);
        assert_int_equal(stage_moment(stage), 0);
        static const double ticks[] = {1.0 / 60, 0.04, 0.003, 1.0 / 30, 0.011, 0.5};
        int64_t before = 0;
        for (int i = 0; i < 24; i++) {
            stage_pass(stage, ticks[i % 6]);
            assert_true(stage_moment(stage) >= before);
            before = stage_moment(stage);
        }
        assert_true(before > 24);
        assert_true(skv_stage_is_active(stage));
        skv_stage_destroy(stage);
    }
}

/* No thread is waited for here: apart by what was granted at most. */
static void test_the_slower_paces_both(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(100, true);
    stage_compare(stage, 8000, NULL, NULL);
    for (int i = 0; i < 200; i++) {
        skv_stage_advance(stage, 1.0 / 60, 0);
        skv_stage_look(stage);
        int64_t a = skv_stage_picture(stage, 0)->moment, b = skv_stage_picture(stage, 1)->moment;
        assert_true(a - b <= 5 && b - a <= 5); /* a grant of four, and one owed */
    }
    stage_pass(stage, 0.001);
    stage_moment(stage);
    skv_stage_destroy(stage);
}

/* A clock by which every step takes 10 ms. */
static double hundredths(void)
{
    static double now;
    return now += 0.01;
}

/* Who calls steps both, and is not kept for longer than two frames, however late it comes. */
static void test_within_the_calls_steps_add_up(void **state)
{
    (void)state;
    skv_stage *stage = stage_make(false, hundredths);
    skv_outcome outcome;
    skv_stage_open(stage, "pool", NULL);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    stage_compare(stage, 0, NULL, NULL);
    stage_pass(stage, 0.001);
    stage_pass(stage, 0.1); /* and now it knows what a step takes */
    for (int i = 0; i < 3; i++) {
        int64_t before = stage_moment(stage);
        stage_pass(stage, 0.2);
        assert_int_equal(stage_moment(stage) - before, 1);
    }
    skv_stage_state now = skv_stage_now(stage);
    assert_true(now.step_ms > 15 && now.pace < 1 && !now.at_rest);
    skv_stage_destroy(stage);
}

static void test_time_is_both_s(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    skv_stage_set_paused(stage, true);
    stage_compare(stage, 0, "fluid.law", "clavet");
    assert_false(skv_stage_paused(stage)); /* there is something to be seen now */
    stage_pass_frames(stage, 30);
    assert_int_equal(stage_moment(stage), 30);
    skv_stage_set_paused(stage, true);
    stage_pass_frames(stage, 5);
    assert_int_equal(stage_moment(stage), 30);
    assert_false(skv_stage_is_active(stage));
    skv_stage_step_once(stage);
    assert_int_equal(stage_moment(stage), 31);
    skv_stage_seek(stage, 10);
    assert_int_equal(stage_moment(stage), 10);
    skv_stage_set_paused(stage, false);
    skv_stage_set_speed(stage, 0.5);
    assert_true(skv_stage_speed(stage) == 0.5);
    stage_pass_frames(stage, 10);
    assert_int_equal(stage_moment(stage), 15);
    /* One stands stage_still, so both do. */
    skv_session_set_paused(stage->worlds[1], true);
    stage_pass_frames(stage, 5);
    assert_true(skv_stage_paused(stage));
    stage_moment(stage);
    skv_stage_destroy(stage);
}

/* Steps that come faster than pictures add up, within what can be reached. */
static void test_back_and_forth(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    stage_pass_frames(stage, 30);
    stage_moment(stage);
    skv_stage_go(stage, -10, 25);
    assert_true(skv_stage_paused(stage));
    skv_stage_go(stage, -3, 25);
    assert_int_equal(stage_moment(stage), 17);
    skv_stage_go(stage, 1, 25);
    assert_int_equal(stage_moment(stage), 18);
    skv_stage_go(stage, -100, 25);
    assert_int_equal(stage_moment(stage), 5);
    skv_stage_go(stage, 100, 25);
    assert_int_equal(stage_moment(stage), 30);
    skv_stage_destroy(stage);
}

static void test_undo_is_both_s(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    stage_compare(stage, 0, NULL, NULL);
    skv_stage_set_linked(stage, false);
    stage_pass_frames(stage, 10);
    stage_draw_wall(stage, 0, 400);
    stage_pass_frames(stage, 10);
    stage_draw_wall(stage, 1, 900);
    stage_pass_frames(stage, 10);
    uint64_t a = stage_hash(stage, 0), b = stage_hash(stage, 1);
    skv_stage_undo(stage);
    assert_int_equal(stage_moment(stage), 20);
    skv_stage_undo(stage);
    assert_int_equal(stage_moment(stage), 10);
    skv_stage_state now = skv_stage_now(stage);
    assert_true(!now.can_undo && now.can_redo);
    skv_stage_redo(stage);
    assert_int_equal(stage_moment(stage), 20);
    skv_stage_redo(stage);
    assert_int_equal(stage_moment(stage), 30);
    assert_true(stage_hash(stage, 0) == a && stage_hash(stage, 1) == b);
    /* An edit in both, taken back from both. */
    skv_stage_set_linked(stage, true);
    stage_draw_wall(stage, 1, 200);
    assert_int_equal(stage_look(stage, 0)->can_undo, true);
    stage_pass_frames(stage, 4);
    skv_stage_undo(stage);
    assert_int_equal(stage_moment(stage), 30);
    assert_true(stage_hash(stage, 0) == a && stage_hash(stage, 1) == b);
    skv_stage_destroy(stage);
}

/* Looking at the past, too, a stage compares what was up to there. */
static void test_shared_in_the_past(void **state)
{
    (void)state;
    skv_stage *stage = stage_open_pool(200, false);
    stage_pass_frames(stage, 20);
    stage_draw_wall(stage, 0, 400);
    stage_pass_frames(stage, 20);
    skv_stage_seek(stage, 10);
    stage_compare(stage, 0, NULL, NULL);
    stage_pass_frames(stage, 30);
    assert_int_equal(stage_moment(stage), 30);
    assert_true(stage_hash(stage, 0) == stage_hash(stage, 1));
    skv_stage_destroy(stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_played_again),
        cmocka_unit_test(test_a_way_is_gone_again),
        cmocka_unit_test(test_lockstep),
        cmocka_unit_test(test_the_slower_paces_both),
        cmocka_unit_test(test_within_the_calls_steps_add_up),
        cmocka_unit_test(test_time_is_both_s),
        cmocka_unit_test(test_back_and_forth),
        cmocka_unit_test(test_undo_is_both_s),
        cmocka_unit_test(test_shared_in_the_past),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
