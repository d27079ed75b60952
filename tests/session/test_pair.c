/* Two worlds side by side: one of them another liquid or finer, both at the same moment, whatever
 * is done in time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/pair.h>

#include "session/support.h"
#include "support/kept.h"
#include "terrain/terrain.h"

typedef struct worlds {
    skv_session *a, *b;
    skv_pair *pair;
} worlds;

static void settle(worlds *w)
{
    skv_session_wait(w->a);
    skv_session_wait(w->b);
}

/* Both are at one moment; which. */
static int64_t moment(worlds *w)
{
    settle(w);
    int64_t at = session_moment(w->a);
    assert_int_equal(session_moment(w->b), at);
    return at;
}

static void pass(worlds *w, double seconds)
{
    skv_pair_advance(w->pair, seconds, 0);
    settle(w);
}

static void pass_frames(worlds *w, int frames)
{
    for (int i = 0; i < frames; i++)
        pass(w, 1.0 / 60);
}

/* The second world: as the first, but for some settings; not paired yet. */
static worlds open_beside(skv_session *a, bool own_thread, int particles, const char *path,
                          const char *value)
{
    kept shared = {0};
    worlds w = {.a = a, .b = session_open_pool(100, own_thread)};
    skv_outcome outcome;
    skv_setting setting = {path, value};
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    options.settings = &setting;
    options.setting_count = path ? 1 : 0;
    skv_session_share(a);
    skv_session_wait(a);
    while (skv_session_next_outcome(a, &outcome))
        assert_string_equal(outcome.error.text, "");
    assert_true(skv_session_read_shared(a, kept_add, &shared));
    skv_session_open_memory(w.b, shared.bytes, shared.size, "skvr", "other", &options);
    kept_clear(&shared);
    skv_session_wait(w.b);
    while (skv_session_next_outcome(w.b, &outcome))
        assert_string_equal(outcome.error.text, "");
    return w;
}

static worlds pair_with(skv_session *a, bool own_thread, int particles, const char *path,
                        const char *value)
{
    worlds w = open_beside(a, own_thread, particles, path, value);
    assert_int_equal(skv_pair_create(w.a, w.b, &w.pair, NULL), SKV_OK);
    settle(&w);
    return w;
}

static void part(worlds *w)
{
    skv_pair_destroy(w->pair);
    skv_session_destroy(w->a);
    skv_session_destroy(w->b);
}

static void draw_wall(skv_session *session, double px)
{
    skv_session_set_tool(session, 1);
    session_point(session, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, px, 300, 0);
    session_point(session, SKV_PHASE_MOVE, SKV_DEVICE_MOUSE, 0, px + 100, 350, 0.1);
    session_point(session, SKV_PHASE_UP, SKV_DEVICE_MOUSE, 0, px + 100, 350, 0.2);
}

/* Alone, too: what was done is done again, and goes on. */
static void test_played_again(void **state)
{
    (void)state;
    skv_session *session = session_open_pool(200, false);
    skv_picture picture;
    draw_wall(session, 400);
    for (int i = 0; i < 20; i++)
        session_advance(session, 1.0 / 60);
    uint64_t played = session_hash(session);
    skv_session_replay(session);
    skv_session_wait(session);
    assert_int_equal(session_moment(session), 0);
    for (int i = 0; i < 20; i++)
        session_advance(session, 1.0 / 60);
    assert_true(session_hash(session) == played);
    session_advance(session, 1.0 / 60);
    session_look(session, &picture);
    assert_true(picture.moment == 21 && picture.end == 21 && !picture.as_recorded);
    skv_session_destroy(session);
}

static void test_lockstep(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        worlds w = pair_with(session_open_pool(200, own_thread), own_thread, 800, NULL, NULL);
        skv_picture a, b;
        session_look(w.a, &a);
        session_look(w.b, &b);
        assert_int_equal(a.frame.particles.count, 200);
        assert_int_equal(b.frame.particles.count, 800);
        assert_int_equal(moment(&w), 0);
        static const double ticks[] = {1.0 / 60, 0.04, 0.003, 1.0 / 30, 0.011, 0.5};
        int64_t before = 0;
        for (int i = 0; i < 24; i++) {
            pass(&w, ticks[i % 6]);
            assert_true(moment(&w) >= before);
            before = moment(&w);
        }
        assert_true(before > 24);
        assert_true(skv_pair_is_active(w.pair));
        part(&w);
    }
}

/* No thread is waited for here: apart by what was granted at most. */
static void test_the_slower_paces_both(void **state)
{
    (void)state;
    worlds w = pair_with(session_open_pool(100, true), true, 8000, NULL, NULL);
    for (int i = 0; i < 200; i++) {
        skv_pair_advance(w.pair, 1.0 / 60, 0);
        int64_t b = session_moment(w.b), a = session_moment(w.a);
        assert_true(a - b <= 5 && b - a <= 5); /* a grant of four, and one owed */
    }
    pass(&w, 0.001);
    moment(&w);
    part(&w);
}

/* A clock by which every step takes 10 ms. */
static double hundredths(void)
{
    static double now;
    return now += 0.01;
}

static skv_session *make_slow(void)
{
    skv_session *session;
    skv_stage_def def = skv_default_stage_def();
    def.threads = 1;
    def.own_thread = false;
    def.clock = hundredths;
    assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
    skv_session_open(session, "pool", NULL);
    return session;
}

/* Who calls steps both, and is not kept for longer than two frames, however late it comes. */
static void test_within_the_calls_steps_add_up(void **state)
{
    (void)state;
    worlds w = {.a = make_slow(), .b = make_slow()};
    skv_session_share(w.a);
    assert_int_equal(skv_pair_create(w.a, w.b, &w.pair, NULL), SKV_OK);
    pass(&w, 0.001);
    pass(&w, 0.1); /* and now it knows what a step takes */
    for (int i = 0; i < 3; i++) {
        int64_t before = moment(&w);
        pass(&w, 0.2);
        assert_int_equal(moment(&w) - before, 1);
    }
    part(&w);
}

/* What was done before is done to both; then each has its own hand. */
static void test_another_liquid(void **state)
{
    (void)state;
    skv_session *a = session_open_pool(300, false);
    skv_picture one, other;
    draw_wall(a, 400);
    for (int i = 0; i < 20; i++)
        session_advance(a, 1.0 / 60);
    uint64_t played = session_hash(a);
    worlds w = pair_with(a, false, 0, "fluid.material", "honey");
    session_look(w.b, &other);
    assert_true(other.following && other.end == 20);
    pass_frames(&w, 20);
    assert_int_equal(moment(&w), 20);
    assert_true(session_hash(w.a) == played); /* it went as it had gone */
    assert_true(session_hash(w.b) != played);
    session_look(w.a, &one);
    session_look(w.b, &other);
    assert_true(!other.mismatch && !other.as_recorded && !one.as_recorded);
    assert_int_equal(one.frame.terrain->hash, other.frame.terrain->hash);
    draw_wall(w.b, 900);
    pass_frames(&w, 5);
    session_look(w.a, &one);
    session_look(w.b, &other);
    assert_int_not_equal(one.frame.terrain->hash, other.frame.terrain->hash);
    part(&w);
}

static void test_time_is_both_s(void **state)
{
    (void)state;
    worlds w = pair_with(session_open_pool(200, false), false, 0, "fluid.law", "clavet");
    pass_frames(&w, 30);
    assert_int_equal(moment(&w), 30);
    skv_pair_set_paused(w.pair, true);
    pass_frames(&w, 5);
    assert_int_equal(moment(&w), 30);
    assert_false(skv_pair_is_active(w.pair));
    skv_pair_step_once(w.pair);
    assert_int_equal(moment(&w), 31);
    skv_pair_seek(w.pair, 10);
    assert_int_equal(moment(&w), 10);
    skv_pair_set_paused(w.pair, false);
    skv_pair_set_speed(w.pair, 0.5);
    pass_frames(&w, 10);
    assert_int_equal(moment(&w), 15);
    /* One stands still, so both do. */
    skv_session_set_paused(w.b, true);
    pass_frames(&w, 5);
    assert_true(skv_session_paused(w.a));
    moment(&w);
    part(&w);
}

static void test_undo_is_both_s(void **state)
{
    (void)state;
    worlds w = pair_with(session_open_pool(200, false), false, 0, NULL, NULL);
    skv_picture picture;
    pass_frames(&w, 10);
    draw_wall(w.a, 400);
    pass_frames(&w, 10);
    draw_wall(w.b, 900);
    pass_frames(&w, 10);
    uint64_t a = session_hash(w.a), b = session_hash(w.b);
    skv_pair_undo(w.pair);
    assert_int_equal(moment(&w), 20);
    skv_pair_undo(w.pair);
    assert_int_equal(moment(&w), 10);
    session_look(w.a, &picture);
    assert_false(picture.can_undo);
    skv_pair_redo(w.pair);
    assert_int_equal(moment(&w), 20);
    skv_pair_redo(w.pair);
    assert_int_equal(moment(&w), 30);
    assert_true(session_hash(w.a) == a && session_hash(w.b) == b);
    /* An edit in both, taken back from both. */
    draw_wall(w.a, 200);
    draw_wall(w.b, 200);
    pass_frames(&w, 4);
    skv_pair_undo(w.pair);
    assert_int_equal(moment(&w), 30);
    assert_true(session_hash(w.a) == a && session_hash(w.b) == b);
    part(&w);
}

static void test_apart_again(void **state)
{
    (void)state;
    worlds w = pair_with(session_open_pool(200, false), false, 0, NULL, NULL);
    pass_frames(&w, 3);
    /* Led apart by hand: they come together again. */
    skv_session_step_once(w.a);
    pass(&w, 1.0 / 60);
    pass(&w, 1.0 / 60);
    moment(&w);
    skv_pair_destroy(w.pair);
    int64_t b = session_moment(w.b);
    assert_int_equal(session_advance(w.a, 1.0 / 60), 1);
    assert_int_equal(session_moment(w.b), b);
    w.pair = NULL;
    part(&w);
}

/* What was done after it was shared, by a finger that is still down, is in neither world. */
static void test_both_begin_with_what_was_shared(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_session *a = session_open_pool(200, own_thread);
        skv_picture one, other;
        for (int i = 0; i < 12; i++)
            session_advance(a, 1.0 / 60);
        worlds w = open_beside(a, own_thread, 0, NULL, NULL);
        draw_wall(a, 400);
        skv_session_set_tool(a, 0);
        session_point(a, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, 500, 700, 1);
        for (int i = 0; i < 9; i++)
            session_advance(a, 1.0 / 60);
        assert_int_equal(skv_pair_create(w.a, w.b, &w.pair, NULL), SKV_OK);
        settle(&w);
        session_look(w.a, &one);
        session_look(w.b, &other);
        assert_true(one.end == 12 && other.end == 12 && one.following && other.following);
        pass_frames(&w, 20);
        assert_int_equal(moment(&w), 20);
        assert_true(session_hash(w.a) == session_hash(w.b));
        session_look(w.a, &one);
        assert_int_equal(one.hand_count, 0);
        part(&w);
    }
}

/* Looking at the past, too, a session shares what was up to there. */
static void test_shared_in_the_past(void **state)
{
    (void)state;
    skv_session *a = session_open_pool(200, false);
    for (int i = 0; i < 20; i++)
        session_advance(a, 1.0 / 60);
    draw_wall(a, 400);
    for (int i = 0; i < 20; i++)
        session_advance(a, 1.0 / 60);
    skv_session_seek(a, 10);
    worlds w = pair_with(a, false, 0, NULL, NULL);
    pass_frames(&w, 30);
    assert_int_equal(moment(&w), 30);
    assert_true(session_hash(w.a) == session_hash(w.b));
    part(&w);
}

static skv_instrument_def probe_at(double x)
{
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = x;
    def.y0 = 0.2;
    return def;
}

static void expect_same_probes(worlds *w, int count)
{
    skv_picture a, b;
    session_look(w->a, &a);
    session_look(w->b, &b);
    assert_int_equal(a.probe_count, count);
    assert_int_equal(b.probe_count, count);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++)
            if (a.probes[i].id == b.probes[k].id)
                assert_true(a.probes[i].def.x0 == b.probes[k].def.x0);
    for (int i = 0, same = 0; i < count; i++, same = 0) {
        for (int k = 0; k < count; k++)
            same += a.probes[i].id == b.probes[k].id;
        assert_int_equal(same, 1);
    }
}

/* Whenever it was asked for: before, while nothing waits for it, or at once. */
static void test_instruments_are_both_s(void **state)
{
    (void)state;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_session *a = session_open_pool(4000, own_thread);
        skv_instrument_def first = probe_at(0.2), last = probe_at(0.4), own = probe_at(0.9);
        skv_instrument_def next = probe_at(0.6);
        uint32_t gone = skv_session_add_probe(a, &own), old = skv_session_add_probe(a, &first);
        skv_session_remove_probe(a, gone);
        worlds w = open_beside(a, own_thread, 0, NULL, NULL);
        skv_session_add_probe(w.b, &own);
        skv_session_watch_probe(a, old, true);
        session_advance(a, 0.02);
        skv_session_advance(a, 0.1, 0); /* it is busy stepping */
        skv_session_add_probe(a, &last);
        assert_int_equal(skv_pair_create(w.a, w.b, &w.pair, NULL), SKV_OK);
        uint32_t both = skv_session_add_probe(w.a, &next);
        assert_int_equal(skv_session_add_probe(w.b, &next), both);
        skv_pair_set_paused(w.pair, true);
        for (int i = 0; skv_pair_is_active(w.pair); i++) {
            assert_true(i < 100);
            pass(&w, 1.0 / 60);
        }
        expect_same_probes(&w, 3);
        skv_pair_set_paused(w.pair, false);
        pass_frames(&w, 4);
        const skv_picture *picture = skv_session_acquire(w.b);
        for (int i = 0; i < 3; i++)
            assert_int_equal(picture->probes[i].samples > 0, picture->probes[i].id == old);
        skv_session_release(w.b, picture);
        part(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_played_again),
        cmocka_unit_test(test_lockstep),
        cmocka_unit_test(test_the_slower_paces_both),
        cmocka_unit_test(test_within_the_calls_steps_add_up),
        cmocka_unit_test(test_another_liquid),
        cmocka_unit_test(test_time_is_both_s),
        cmocka_unit_test(test_undo_is_both_s),
        cmocka_unit_test(test_apart_again),
        cmocka_unit_test(test_both_begin_with_what_was_shared),
        cmocka_unit_test(test_shared_in_the_past),
        cmocka_unit_test(test_instruments_are_both_s),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
