/* Pointers that pick bodies up: they follow and fly on; replays, links and a second world go the
 * same way. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "session/support.h"
#include "support/fixture.h"

/* 1000 pixels of the view are a metre. */
static const char crates[] =
    "{\"particles\": 400, \"world\": {\"width\": 1.6, \"height\": 0.9}, \"water\": [{\"shape\": "
    "\"box\", \"y1\": 0.2}], \"bodies\": [{\"shape\": \"box\", \"x0\": 0.25, \"x1\": 0.35, \"y0\": "
    "0.4, \"y1\": 0.5, \"density\": 700}, {\"shape\": \"box\", \"x0\": 1.2, \"x1\": 1.3, \"y0\": "
    "0.4, \"y1\": 0.5, \"density\": 700}]}";

static int setup(void **state)
{
    skv_stage *stage = stage_make(false, stage_still);
    skv_outcome outcome;
    skv_stage_open_memory(stage, crates, sizeof crates - 1, "json", "crates.json", NULL);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_string_equal(outcome.error.text, "");
    *state = stage;
    return 0;
}

static skv_body body_of(skv_stage *stage, int side, int number)
{
    const skv_picture *picture = stage_look(stage, side);
    assert_int_equal(picture->frame.body_count, 2);
    return picture->frame.bodies[number];
}

static void mouse(skv_stage *stage, skv_phase phase, double px, double py, double time)
{
    stage_touch(stage, phase, SKV_DEVICE_MOUSE, 0, px, py, time);
}

/* Picks the first crate up and carries it to the right, at 1.2 m/s in the end, for 30 frames. */
static void carry(skv_stage *stage)
{
    mouse(stage, SKV_PHASE_DOWN, 300, 450, 0);
    for (int i = 1; i <= 30; i++) {
        double px = 300 + (i > 10 ? 20 * (i - 10) : 0);
        mouse(stage, SKV_PHASE_MOVE, px, 450, i / 60.0);
        stage_advance(stage, 1.0 / 60);
    }
}

static void let_go(skv_stage *stage)
{
    mouse(stage, SKV_PHASE_UP, 700, 450, 30 / 60.0);
    stage_advance(stage, 1.0 / 60);
}

static void bodies_are_carried_and_thrown(void **state)
{
    skv_stage *stage = *state;
    carry(stage);
    const skv_picture *picture = stage_look(stage, 0);
    assert_int_equal(picture->hand_count, 1);
    assert_int_equal(picture->hands[0].body, picture->frame.bodies[0].id);
    assert_true(picture->mark_count >= 1);
    /* No larger than what it feels for. */
    assert_near((double)picture->marks[0].radius, 0.016, 1e-6);
    skv_body body = body_of(stage, 0, 0);
    assert_near((double)body.x, 0.7, 0.05);
    assert_near((double)body.y, 0.45, 0.02);
    assert_true(fabs((double)body_of(stage, 0, 1).x - 1.25) < 0.1);
    let_go(stage);
    assert_int_equal(stage_look(stage, 0)->hand_count, 0);
    body = body_of(stage, 0, 0);
    assert_near((double)body.vx, 1.2, 0.15);
    stage_pass_frames(stage, 6);
    assert_near((double)body_of(stage, 0, 0).x, (double)body.x + 0.1 * (double)body.vx, 0.01);
}

/* Beside a body a finger still takes it; where there is none it holds water. */
static void fingers_feel_for_bodies(void **state)
{
    skv_stage *stage = *state;
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 1, 358, 450, 0);
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_FINGER, 2, 800, 800, 0);
    stage_advance(stage, 1.0 / 60);
    const skv_picture *picture = stage_look(stage, 0);
    assert_int_equal(picture->hand_count, 2);
    assert_int_equal(picture->hands[0].body, picture->frame.bodies[0].id);
    assert_int_equal(picture->hands[1].body, 0);
    /* Who lets go takes nothing from the other. */
    stage_touch(stage, SKV_PHASE_UP, SKV_DEVICE_FINGER, 2, 800, 800, 0.1);
    stage_pass_frames(stage, 60);
    assert_near((double)body_of(stage, 0, 0).y, 0.45 - 0.058, 0.01); /* it hangs */
    assert_true((double)body_of(stage, 0, 1).y < 0.3);
}

/* Played again, and as a link. */
static void replays_and_links_carry_it_too(void **state)
{
    skv_stage *stage = *state;
    carry(stage);
    let_go(stage);
    stage_pass_frames(stage, 10);
    uint64_t hash = stage_hash(stage, 0);
    int64_t moment = stage_moment(stage);
    skv_body body = body_of(stage, 0, 0);
    for (int to = 0; to < 30;
         to += 20) { /* the second from a key frame on the way, if there is one */
        skv_stage_seek(stage, to);
        skv_stage_wait(stage);
        skv_stage_seek(stage, moment);
        assert_true(stage_hash(stage, 0) == hash);
        assert_true(body_of(stage, 0, 0).x == body.x);
    }
    skv_stage *other = stage_open_shared(stage);
    assert_true(body_of(other, 0, 0).x == body.x);
    skv_stage_destroy(other);
}

/* Hands are for both worlds: each picks up its own. */
static void both_worlds_carry_theirs(void **state)
{
    skv_stage *stage = *state;
    stage_compare(stage, 0, "gravity.y", "-3");
    carry(stage);
    for (int side = 0; side < 2; side++)
        assert_near((double)body_of(stage, side, 0).x, 0.7, 0.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(bodies_are_carried_and_thrown, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(fingers_feel_for_bodies, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(replays_and_links_carry_it_too, setup, stage_teardown),
        cmocka_unit_test_setup_teardown(both_worlds_carry_theirs, setup, stage_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
