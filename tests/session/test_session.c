/* The session below every toolkit: opening and failing to, time, gravity, camera, pictures. Told
 * twice: once with all work done within the calls, once on a thread of its own. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "support/failing_memory.h"

static void open_scene(skv_session *session, const char *name)
{
    skv_session_open(session, name, NULL);
    skv_session_wait(session);
}

static void test_starts_empty(void **state)
{
    (void)state;
    for (int threaded = 0; threaded < 2; threaded++) {
        skv_stage_def def = skv_default_stage_def();
        def.own_thread = threaded;
        def.threads = 1;
        skv_session *session;
        skv_error error;
        skv_picture picture;
        skv_outcome report;
        char text[64];
        assert_int_equal(skv_session_create(&def, &session, &error), SKV_OK);
        skv_session_advance(session, 1, 0);
        skv_session_step_once(session);
        skv_session_reset(session);
        skv_session_undo(session);
        skv_session_redo(session);
        skv_session_set_gravity(session, 1, 0);
        skv_session_push(session, 1, 0);
        skv_session_set(session, "fluid.viscosity", "1");
        skv_session_wait(session);
        session_look(session, &picture);
        assert_int_equal(picture.opened, 0);
        assert_null(picture.scene);
        assert_string_equal(picture.title, "");
        assert_int_equal(picture.frame.particles.count, 0);
        skv_picture_describe(&picture, text, sizeof text);
        assert_string_equal(text, "");
        assert_false(skv_session_is_active(session));
        assert_false(skv_session_next_outcome(session, &report));
        assert_true(skv_session_camera(session).scale > 0);
        skv_session_destroy(session);

        def.threads = SKV_MAX_THREADS + 1;
        assert_int_equal(skv_session_create(&def, &session, &error), SKV_ERROR_VALUE);
        assert_null(session);
    }
    skv_session_destroy(NULL);
}

static void test_failed_open_changes_nothing(void **state)
{
    skv_session *session = *state;
    session_advance(session, 2.0 / 60);
    uint64_t hash = session_hash(session);
    skv_outcome report;
    open_scene(session, "no-such-scene.json");
    assert_true(skv_session_next_outcome(session, &report));
    assert_int_equal(report.kind, SKV_OUTCOME_OPEN);
    assert_int_not_equal(report.error.code, SKV_OK);
    assert_non_null(strstr(report.error.text, "no-such-scene.json"));
    assert_int_equal(session_hash(session), hash);
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
}

static void test_open_takes_over(void **state)
{
    skv_session *session = *state;
    skv_picture picture;
    skv_outcome report;
    skv_session_set_speed(session, 0.5);
    session_point(session, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, 10, 10, 0);
    /* A picture that is held outlives what it shows. */
    const skv_picture *held = skv_session_acquire(session);
    open_scene(session, "dam-break");
    assert_int_equal(session_report(session, &report), SKV_OK);
    session_look(session, &picture);
    assert_string_equal(picture.name, "dam-break");
    assert_string_equal(picture.title, "Dam break");
    assert_int_equal(picture.opened, 2);
    assert_int_equal(picture.moment, 0);
    assert_int_equal(picture.mark_count, 0);
    assert_int_equal(skv_session_pointer_count(session), 0);
    assert_true(skv_session_speed(session) == 0.5);
    for (int i = 0; i < 6; i++)
        session_advance(session, 2.0 / 60);
    assert_string_equal(held->title, "Pool");
    assert_true(held->frame.particles.x[0] > 0);
    assert_non_null(skv_scene_description(held->scene));
    skv_session_release(session, held);
}

static void test_options_and_memory(void **state)
{
    skv_session *session = *state;
    const skv_setting settings[] = {{"fluid.viscosity", "0.002"}, {"world.pixel", "0.02"}};
    skv_scene_options options = skv_default_scene_options();
    skv_outcome report;
    skv_picture picture;
    options.settings = settings;
    options.setting_count = 2;
    options.particles = 150;
    skv_session_open(session, "dam-break", &options);
    skv_session_wait(session);
    assert_int_equal(session_report(session, &report), SKV_OK);
    session_look(session, &picture);
    assert_true(picture.frame.particles.count > 100 && picture.frame.particles.count < 200);

    char json[] = "{\"title\": \"Mine\", \"water\": [{\"shape\": \"box\", \"x1\": 0.2}]}";
    skv_session_open_memory(session, json, sizeof json - 1, "json", "mine.json", NULL);
    memset(json, 0, sizeof json); /* it was copied */
    skv_session_wait(session);
    assert_int_equal(session_report(session, &report), SKV_OK);
    session_look(session, &picture);
    assert_string_equal(picture.title, "Mine");
    skv_session_open_memory(session, "{", 1, "json", "broken.json", NULL);
    skv_session_wait(session);
    assert_int_equal(session_report(session, &report), SKV_ERROR_FORMAT);
    assert_non_null(strstr(report.error.text, "broken.json"));
}

static void test_reset_goes_back(void **state)
{
    skv_session *session = *state;
    uint64_t start = session_hash(session);
    skv_picture picture;
    skv_session_set_gravity(session, 1, 0);
    skv_session_set_speed(session, 2);
    session_advance(session, 2.0 / 60);
    assert_int_not_equal(session_hash(session), start);
    skv_session_set_paused(session, true);
    skv_session_reset(session);
    skv_session_wait(session);
    assert_int_equal(session_hash(session), start);
    session_look(session, &picture);
    assert_true(picture.tilt_x == 0 && fabs(picture.tilt_y + 1) < 1e-6);
    assert_true(skv_session_paused(session) && picture.paused);
    assert_true(skv_session_speed(session) == 2 && picture.speed == 2);
}

static void test_clock_steps_whole_frames(void **state)
{
    skv_session *session = *state;
    for (int i = 1; i <= 30; i++) {
        assert_int_equal(session_advance(session, 1.0 / 60), 1);
        assert_int_equal(session_moment(session), i);
    }
    skv_picture picture;
    session_look(session, &picture);
    assert_true(fabs(picture.frame.time - 0.5) < 1e-6);
    assert_int_equal(session_advance(session, 0), 0);
    assert_int_equal(session_advance(session, -1), 0);
    assert_int_equal(session_advance(session, (double)NAN), 0);
}

static void test_clock_accumulates(void **state)
{
    skv_session *session = *state;
    int frames = 0;
    for (int i = 0; i < 10; i++)
        frames += session_advance(session, 0.1 / 60);
    assert_int_equal(frames, 1);

    /* A 144 Hz display: 60 frames in a second all the same. */
    frames = 0;
    for (int i = 0; i < 144; i++)
        frames += session_advance(session, 1.0 / 144);
    assert_int_equal(frames, 60);
}

static void test_clock_follows_a_display_near_60_hz(void **state)
{
    skv_session *session = *state;
    /* A pool that sleeps steps no frames. */
    const skv_setting awake = {"sleep", "false"};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    options.settings = &awake;
    options.setting_count = 1;
    skv_session_open(session, "pool", &options);
    skv_session_wait(session);
    for (int i = 0; i < 200; i++) /* 59.94 Hz, with a jitter of 0.1 ms */
        assert_int_equal(session_advance(session, 1 / 59.94 + (i % 3 - 1) * 1e-4), 1);
}

static void test_clock_drops_what_is_too_much(void **state)
{
    skv_session *session = *state;
    assert_int_equal(session_advance(session, 10), 12);
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
}

/* A clock by which every step takes 10 ms. */
static double hundredths(void)
{
    static double now;
    return now += 0.01;
}

/* Where the face takes 0.1 s to draw, a thread of its own steps meanwhile; without one the face
 * would wait for the steps as well. */
static void test_slow_drawing_does_not_slow_time(void **unused)
{
    (void)unused;
    for (int own_thread = 0; own_thread < 2; own_thread++) {
        skv_session *session;
        skv_stage_def def = skv_default_stage_def();
        def.threads = 1;
        def.own_thread = own_thread;
        def.clock = hundredths;
        assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
        skv_session_open(session, "pool", NULL);
        skv_session_wait(session);
        session_advance(session, 0.1); /* and now it knows what a step takes */
        assert_int_equal(session_advance(session, 0.1), own_thread ? 6 : 3);
        /* Told how long it draws, it steps for half as long: fewer pictures, but water that flows.
         */
        int64_t before = session_moment(session);
        skv_session_advance(session, 0.15, 0.11);
        skv_session_wait(session);
        assert_int_equal(session_moment(session) - before, own_thread ? 9 : 5);
        skv_session_destroy(session);
    }
}

static void test_speed(void **state)
{
    skv_session *session = *state;
    skv_session_set_speed(session, 0.25);
    int frames = 0;
    for (int i = 0; i < 40; i++)
        frames += session_advance(session, 1.0 / 60);
    assert_int_equal(frames, 10);
    skv_session_set_speed(session, 2);
    assert_int_equal(session_advance(session, 1.0 / 60), 2);
    skv_session_set_speed(session, 0);
    assert_true(skv_session_speed(session) == 0.05);
    skv_session_set_speed(session, 1e9);
    assert_true(skv_session_speed(session) == 2);
}

static void test_pause_and_single_steps(void **state)
{
    skv_session *session = *state;
    assert_true(skv_session_is_active(session));
    skv_session_set_paused(session, true);
    assert_true(skv_session_paused(session));
    assert_int_equal(session_advance(session, 1), 0);
    assert_false(skv_session_is_active(session));
    skv_session_step_once(session);
    skv_session_step_once(session);
    skv_session_wait(session);
    assert_int_equal(session_moment(session), 2);
    skv_session_set_paused(session, false);
    assert_int_equal(session_advance(session, 1.0 / 60), 1); /* the pause left no debt */
    assert_true(skv_session_is_active(session));
}

/* A step that fails is told, pauses, and leaves the world as it was, so that playing on can try
 * again. */
static void test_failing_step_pauses(void **state)
{
    skv_session *session = *state;
    skv_scene_options options = skv_default_scene_options();
    const skv_setting unsettled = {"settle", "false"}; /* settling makes the room for steps */
    options.settings = &unsettled;
    options.setting_count = 1;
    options.particles = 200;
    skv_outcome opened;
    skv_session_open(session, "pool", &options);
    skv_session_wait(session);
    while (skv_session_next_outcome(session, &opened))
        assert_int_equal(opened.error.code, SKV_OK);
    uint64_t start = session_hash(session);
    failing_memory memory;
    skv_outcome report;
    failing_memory_start(&memory, 1); /* the first step of a world makes room for its solver */
    session_advance(session, 2.0 / 60);
    failing_memory_stop();
    assert_true(skv_session_next_outcome(session, &report));
    assert_int_equal(report.error.code, SKV_ERROR_MEMORY);
    assert_int_equal(session_moment(session), 0);
    assert_non_null(strstr(report.error.text, "memory"));
    assert_int_equal(session_hash(session), start);
    skv_session_set_paused(session, false);
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
}

static void test_gravity_turns(void **state)
{
    skv_session *session = *state;
    skv_picture picture;
    const double wanted[][2] = {{1, 0}, {0, 0}, {0, 0.5}, {-2, 0}, {-1e6, 0}};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        double length = fmax(hypot(wanted[i][0], wanted[i][1]), 1e-9), cut = fmin(1, 2 / length);
        skv_session_set_gravity(session, wanted[i][0], wanted[i][1]);
        session_advance(session, 1.0 / 60);
        session_look(session, &picture);
        assert_true(fabs((double)picture.frame.gravity_x - 9.81 * cut * wanted[i][0]) < 1e-4);
        assert_true(fabs((double)picture.frame.gravity_y - 9.81 * cut * wanted[i][1]) < 1e-4);
        assert_true(fabs(picture.tilt_x - cut * wanted[i][0]) < 1e-9);
    }
}

static void test_camera_shows_the_whole_world(void **state)
{
    skv_session *session = *state;
    const double width = 1.6, height = 0.9;
    const int views[][2] = {{1280, 720}, {300, 900}, {900, 300}, {1, 1}, {0, -5}, {7681, 33}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        skv_session_set_view(session, views[i][0], views[i][1]);
        skv_camera camera = skv_session_camera(session);
        double left, bottom, right, top;
        skv_camera_to_world(&camera, 0, camera.height, &left, &bottom);
        skv_camera_to_world(&camera, camera.width, 0, &right, &top);
        assert_true(left <= 1e-7 && bottom <= 1e-7);
        assert_true(right >= width - 1e-7 && top >= height - 1e-7);
        assert_true(fabs(left + right - width) < 1e-7); /* centred */
        assert_true(fabs(bottom + top - height) < 1e-7);
        assert_true(fmin(-left, -bottom) < 1e-7); /* as large as fits */
    }
    /* Zoomed, it stays so when the view changes its size, and starts afresh with another world. */
    skv_session_set_view(session, 1600, 900);
    skv_camera near = skv_session_camera(session);
    skv_camera_zoom(&near, 4, 800, 450);
    skv_session_set_camera(session, &near);
    skv_session_set_view(session, 800, 450);
    assert_true(fabs(skv_session_camera(session).scale - 2000) < 0.01);
    open_scene(session, "dam-break");
    assert_true(skv_session_camera(session).zoom == 1);
}

static int news;
static void count_news(void *user)
{
    (void)user;
    news++;
}

/* Water that sleeps costs nothing: no step, no picture, and the face need not ask. */
static void test_rest_costs_nothing(void **state)
{
    (void)state;
    skv_stage_def def = skv_default_stage_def();
    skv_session *session;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    def.own_thread = false;
    def.threads = 1;
    def.wake = count_news;
    assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
    skv_session_set_view(session, 1600, 900);
    skv_session_open(session, "pool", &options);
    for (int i = 0; i < 6000 && skv_session_is_active(session); i++)
        skv_session_advance(session, 1.0 / 60, 0);
    assert_false(skv_session_is_active(session));
    skv_picture before, after;
    session_look(session, &before);
    assert_true(before.at_rest);
    char text[128];
    skv_picture_describe(&before, text, sizeof text);
    assert_non_null(strstr(text, "playing"));
    assert_non_null(strstr(text, "at rest"));
    news = 0;
    for (int i = 0; i < 100; i++)
        skv_session_advance(session, 1.0 / 60, 0);
    session_look(session, &after);
    assert_int_equal(news, 0);
    assert_true(after.number == before.number && after.moment == before.moment);
    /* A touch wakes it. */
    session_point(session, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, 800, 800, 0);
    assert_true(news > 0);
    assert_true(skv_session_is_active(session));
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
    session_look(session, &after);
    assert_false(after.at_rest);
    assert_int_equal(after.hand_count, 1);
    skv_session_destroy(session);
}

/* Instruments read with every frame; a watched one shows its history. */
static void test_probes(void **state)
{
    skv_session *session = *state;
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    skv_picture picture;
    skv_outcome report;
    def.x0 = 0.8;
    def.y0 = 0.1;
    uint32_t probe = skv_session_add_probe(session, &def);
    uint32_t other = skv_session_add_probe(session, &def);
    assert_true(probe != 0 && other != probe);
    skv_session_watch_probe(session, probe, true);
    for (int i = 0; i < 30; i++)
        session_advance(session, 1.0 / 60);
    session_look(session, &picture);
    assert_int_equal(picture.probe_count, 2);
    assert_int_equal(picture.probes[0].id, probe);
    assert_true(picture.probes[0].value[0] > 100);
    assert_true(picture.probes[0].value[0] == picture.probes[1].value[0]);
    const skv_picture *held = skv_session_acquire(session);
    assert_int_equal(held->probes[0].samples, 30);
    assert_true(held->probes[0].history[0][29] == held->probes[0].value[0]);
    assert_true(fabs(held->probes[0].times[29] - held->frame.time) < 1e-9);
    assert_int_equal(held->probes[1].samples, 0);
    skv_session_release(session, held);

    skv_session_move_probe(session, other, 0.8, 0.8, 0.8, 0.8);
    skv_session_remove_probe(session, probe);
    session_advance(session, 1.0 / 60);
    session_look(session, &picture);
    assert_int_equal(picture.probe_count, 1);
    assert_true(isnan(picture.probes[0].value[0])); /* in the dry */
    assert_false(skv_session_next_outcome(session, &report) && report.error.code != SKV_OK);
    def.x0 = (double)NAN;
    skv_session_add_probe(session, &def);
    skv_session_wait(session);
    assert_int_equal(session_report(session, &report), SKV_ERROR_VALUE);
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
}

/* A file is there when it is complete, or not at all; what was saved can be opened. */
static void test_saving(void **state)
{
    skv_session *session = *state;
    const char *const names[] = {"session-test.skv", "session-test.skvr"};
    skv_outcome report;
    skv_picture picture;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 20; k++)
            session_advance(session, 1.0 / 60);
        uint64_t there = session_hash(session);
        skv_session_save(session, names[i]);
        skv_session_wait(session);
        assert_int_equal(session_report(session, &report), SKV_OK);
        assert_int_equal(report.kind, SKV_OUTCOME_SAVE);
        skv_session_open(session, names[i], NULL);
        skv_session_wait(session);
        assert_int_equal(session_report(session, &report), SKV_OK);
        session_look(session, &picture);
        assert_string_equal(picture.title, names[i]);
        /* The replay plays to where it was saved, by itself. */
        for (int k = 0; i == 1 && k < 20; k++)
            session_advance(session, 1.0 / 60);
        assert_int_equal(session_hash(session), there);
        remove(names[i]);
    }
    session_look(session, &picture);
    assert_false(picture.mismatch);
    const char *const bad[] = {"no/such/folder/a.skv", "a.txt"};
    for (int i = 0; i < 2; i++) {
        skv_session_save(session, bad[i]);
        skv_session_wait(session);
        assert_true(session_report(session, &report) > 0);
        assert_non_null(strstr(report.error.text, bad[i]));
    }
    skv_session_open(session, "missing.skv", NULL);
    skv_session_wait(session);
    assert_int_equal(session_report(session, &report), SKV_ERROR_FILE);
}

#define BOTH(test)                                                                                 \
    cmocka_unit_test_setup_teardown(test, session_setup, session_teardown),                        \
        cmocka_unit_test_setup_teardown(test, session_setup_thread, session_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_starts_empty),
        BOTH(test_failed_open_changes_nothing),
        BOTH(test_open_takes_over),
        BOTH(test_options_and_memory),
        BOTH(test_reset_goes_back),
        BOTH(test_clock_steps_whole_frames),
        BOTH(test_clock_accumulates),
        BOTH(test_clock_follows_a_display_near_60_hz),
        BOTH(test_clock_drops_what_is_too_much),
        cmocka_unit_test(test_slow_drawing_does_not_slow_time),
        BOTH(test_speed),
        BOTH(test_pause_and_single_steps),
        cmocka_unit_test_setup_teardown(test_failing_step_pauses, session_setup, session_teardown),
        BOTH(test_gravity_turns),
        BOTH(test_camera_shows_the_whole_world),
        BOTH(test_probes),
        BOTH(test_saving),
        cmocka_unit_test(test_rest_costs_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
