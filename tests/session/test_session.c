/* The stage below every toolkit: opening and failing to, time, gravity, camera, pictures. Told
 * twice: once with all work done within the calls, once on a thread of its own. */
#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "session/stage.h"
#include "session/support.h"
#include "support/failing_memory.h"

static void open_scene(skv_stage *stage, const char *name)
{
    skv_stage_open(stage, name, NULL);
    skv_stage_wait(stage);
}

static void test_starts_empty(void **state)
{
    (void)state;
    for (int threaded = 0; threaded < 2; threaded++) {
        skv_stage_def def = skv_default_stage_def();
        def.own_thread = threaded;
        def.threads = 1;
        skv_stage *stage;
        skv_error error;
        skv_picture picture;
        skv_outcome report;
        assert_int_equal(skv_stage_create(&def, &stage, &error), SKV_OK);
        skv_stage_advance(stage, 1, 0);
        skv_stage_step_once(stage);
        skv_stage_seek(stage, 0);
        skv_stage_undo(stage);
        skv_stage_redo(stage);
        skv_stage_set_gravity(stage, 0, 1, 0);
        skv_stage_push(stage, 0, 1, 0);
        skv_stage_set(stage, 0, "fluid.viscosity", "1");
        skv_stage_wait(stage);
        stage_copy(stage, &picture);
        assert_int_equal(picture.opened, 0);
        assert_null(picture.scene);
        assert_string_equal(picture.title, "");
        assert_int_equal(picture.frame.particles.count, 0);
        assert_false(skv_stage_is_active(stage));
        assert_false(skv_stage_next_outcome(stage, &report));
        assert_true(skv_stage_camera(stage, 0).scale > 0);
        skv_stage_destroy(stage);

        def.threads = SKV_MAX_THREADS + 1;
        assert_int_equal(skv_stage_create(&def, &stage, &error), SKV_ERROR_VALUE);
        assert_null(stage);
    }
    skv_stage_destroy(NULL);
}

static void test_failed_open_changes_nothing(void **state)
{
    skv_stage *stage = *state;
    stage_advance(stage, 2.0 / 60);
    uint64_t hash = stage_hash(stage, 0);
    skv_outcome report;
    open_scene(stage, "no-such-scene.json");
    assert_true(skv_stage_next_outcome(stage, &report));
    assert_int_equal(report.kind, SKV_OUTCOME_OPEN);
    assert_int_not_equal(report.error.code, SKV_OK);
    assert_non_null(strstr(report.error.text, "no-such-scene.json"));
    assert_int_equal(stage_hash(stage, 0), hash);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
}

static void test_open_takes_over(void **state)
{
    skv_stage *stage = *state;
    skv_picture picture;
    skv_outcome report;
    skv_stage_set_speed(stage, 0.5);
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, 10, 10, 0);
    /* A picture that is held outlives what it shows. */
    const skv_picture *held = skv_session_acquire(stage->worlds[0]);
    open_scene(stage, "dam-break");
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    stage_copy(stage, &picture);
    assert_string_equal(picture.name, "dam-break");
    assert_string_equal(picture.title, "Dam break");
    assert_int_equal(picture.opened, 2);
    assert_int_equal(picture.moment, 0);
    assert_int_equal(picture.mark_count, 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
    assert_true(skv_stage_speed(stage) == 0.5);
    for (int i = 0; i < 6; i++)
        stage_advance(stage, 2.0 / 60);
    assert_string_equal(held->title, "Pool");
    assert_true(held->frame.particles.x[0] > 0);
    assert_non_null(skv_scene_description(held->scene));
    skv_session_release(stage->worlds[0], held);
}

static void test_options_and_memory(void **state)
{
    skv_stage *stage = *state;
    const skv_setting settings[] = {{"fluid.viscosity", "0.002"}, {"world.pixel", "0.02"}};
    skv_scene_options options = skv_default_scene_options();
    skv_outcome report;
    skv_picture picture;
    options.settings = settings;
    options.setting_count = 2;
    options.particles = 150;
    skv_stage_open(stage, "dam-break", &options);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    stage_copy(stage, &picture);
    assert_true(picture.frame.particles.count > 100 && picture.frame.particles.count < 200);

    char json[] = "{\"title\": \"Mine\", \"water\": [{\"shape\": \"box\", \"x1\": 0.2}]}";
    skv_stage_open_memory(stage, json, sizeof json - 1, "json", "mine.json", NULL);
    memset(json, 0, sizeof json); /* it was copied */
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    stage_copy(stage, &picture);
    assert_string_equal(picture.title, "Mine");
    skv_stage_open_memory(stage, "{", 1, "json", "broken.json", NULL);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_ERROR_FORMAT);
    assert_non_null(strstr(report.error.text, "broken.json"));
}

static void test_reset_goes_back(void **state)
{
    skv_stage *stage = *state;
    uint64_t start = stage_hash(stage, 0);
    skv_picture picture;
    skv_stage_set_gravity(stage, 0, 1, 0);
    skv_stage_set_speed(stage, 2);
    stage_advance(stage, 2.0 / 60);
    assert_int_not_equal(stage_hash(stage, 0), start);
    skv_stage_set_paused(stage, true);
    skv_stage_seek(stage, 0);
    skv_stage_wait(stage);
    assert_int_equal(stage_hash(stage, 0), start);
    stage_copy(stage, &picture);
    assert_true(picture.tilt_x == 0 && fabs(picture.tilt_y + 1) < 1e-6);
    assert_true(skv_stage_paused(stage) && picture.paused);
    assert_true(skv_stage_speed(stage) == 2 && picture.speed == 2);
}

static void test_clock_steps_whole_frames(void **state)
{
    skv_stage *stage = *state;
    for (int i = 1; i <= 30; i++) {
        assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
        assert_int_equal(stage_moment(stage), i);
    }
    skv_picture picture;
    stage_copy(stage, &picture);
    assert_true(fabs(picture.frame.time - 0.5) < 1e-6);
    assert_int_equal(stage_advance(stage, 0), 0);
    assert_int_equal(stage_advance(stage, -1), 0);
    assert_int_equal(stage_advance(stage, (double)NAN), 0);
}

static void test_clock_accumulates(void **state)
{
    skv_stage *stage = *state;
    int frames = 0;
    for (int i = 0; i < 10; i++)
        frames += stage_advance(stage, 0.1 / 60);
    assert_int_equal(frames, 1);

    /* A 144 Hz display: 60 frames in a second all the same. */
    frames = 0;
    for (int i = 0; i < 144; i++)
        frames += stage_advance(stage, 1.0 / 144);
    assert_int_equal(frames, 60);
}

static void test_clock_follows_a_display_near_60_hz(void **state)
{
    skv_stage *stage = *state;
    /* A pool that sleeps steps no frames. */
    const skv_setting awake = {"sleep", "false"};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    options.settings = &awake;
    options.setting_count = 1;
    skv_stage_open(stage, "pool", &options);
    skv_stage_wait(stage);
    for (int i = 0; i < 200; i++) /* 59.94 Hz, with a jitter of 0.1 ms */
        assert_int_equal(stage_advance(stage, 1 / 59.94 + (i % 3 - 1) * 1e-4), 1);
}

static void test_clock_drops_what_is_too_much(void **state)
{
    skv_stage *stage = *state;
    assert_int_equal(stage_advance(stage, 10), 12);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
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
        skv_stage *stage;
        skv_stage_def def = skv_default_stage_def();
        def.threads = 1;
        def.own_thread = own_thread;
        def.clock = hundredths;
        assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
        skv_stage_open(stage, "pool", NULL);
        skv_stage_wait(stage);
        stage_advance(stage, 0.1); /* and now it knows what a step takes */
        assert_int_equal(stage_advance(stage, 0.1), own_thread ? 6 : 3);
        /* Told how long it draws, it steps for half as long: fewer pictures, but water that flows.
         */
        int64_t before = stage_moment(stage);
        skv_stage_advance(stage, 0.15, 0.11);
        skv_stage_wait(stage);
        assert_int_equal(stage_moment(stage) - before, own_thread ? 9 : 5);
        skv_stage_destroy(stage);
    }
}

static void test_speed(void **state)
{
    skv_stage *stage = *state;
    skv_stage_set_speed(stage, 0.25);
    int frames = 0;
    for (int i = 0; i < 40; i++)
        frames += stage_advance(stage, 1.0 / 60);
    assert_int_equal(frames, 10);
    skv_stage_set_speed(stage, 2);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 2);
    skv_stage_set_speed(stage, 0);
    assert_true(skv_stage_speed(stage) == 0.05);
    skv_stage_set_speed(stage, 1e9);
    assert_true(skv_stage_speed(stage) == 2);
}

static void test_pause_and_single_steps(void **state)
{
    skv_stage *stage = *state;
    assert_true(skv_stage_is_active(stage));
    skv_stage_set_paused(stage, true);
    assert_true(skv_stage_paused(stage));
    assert_int_equal(stage_advance(stage, 1), 0);
    assert_false(skv_stage_is_active(stage));
    skv_stage_step_once(stage);
    skv_stage_step_once(stage);
    skv_stage_wait(stage);
    assert_int_equal(stage_moment(stage), 2);
    skv_stage_set_paused(stage, false);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1); /* the pause left no debt */
    assert_true(skv_stage_is_active(stage));
}

/* A step that fails is told, pauses, and leaves the world as it was, so that playing on can try
 * again. */
static void test_failing_step_pauses(void **state)
{
    skv_stage *stage = *state;
    skv_scene_options options = skv_default_scene_options();
    const skv_setting unsettled = {"settle", "false"}; /* settling makes the room for steps */
    options.settings = &unsettled;
    options.setting_count = 1;
    options.particles = 200;
    skv_outcome opened;
    skv_stage_open(stage, "pool", &options);
    skv_stage_wait(stage);
    while (skv_stage_next_outcome(stage, &opened))
        assert_int_equal(opened.error.code, SKV_OK);
    uint64_t start = stage_hash(stage, 0);
    failing_memory memory;
    skv_outcome report;
    failing_memory_start(&memory, 1); /* the first step of a world makes room for its solver */
    stage_advance(stage, 2.0 / 60);
    failing_memory_stop();
    assert_true(skv_stage_next_outcome(stage, &report));
    assert_int_equal(report.error.code, SKV_ERROR_MEMORY);
    assert_int_equal(stage_moment(stage), 0);
    assert_non_null(strstr(report.error.text, "memory"));
    assert_int_equal(stage_hash(stage, 0), start);
    skv_stage_set_paused(stage, false);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
}

static void test_gravity_turns(void **state)
{
    skv_stage *stage = *state;
    skv_picture picture;
    const double wanted[][2] = {{1, 0}, {0, 0}, {0, 0.5}, {-2, 0}, {-1e6, 0}};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        double length = fmax(hypot(wanted[i][0], wanted[i][1]), 1e-9), cut = fmin(1, 2 / length);
        skv_stage_set_gravity(stage, 0, wanted[i][0], wanted[i][1]);
        stage_advance(stage, 1.0 / 60);
        stage_copy(stage, &picture);
        assert_true(fabs((double)picture.frame.gravity_x - 9.81 * cut * wanted[i][0]) < 1e-4);
        assert_true(fabs((double)picture.frame.gravity_y - 9.81 * cut * wanted[i][1]) < 1e-4);
        assert_true(fabs(picture.tilt_x - cut * wanted[i][0]) < 1e-9);
    }
}

static void test_camera_shows_the_whole_world(void **state)
{
    skv_stage *stage = *state;
    const double width = 1.6, height = 0.9;
    const int views[][2] = {{1280, 720}, {300, 900}, {900, 300}, {1, 1}, {0, -5}, {7681, 33}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        skv_stage_set_view(stage, 0, views[i][0], views[i][1]);
        skv_camera camera = skv_stage_camera(stage, 0);
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
    skv_stage_set_view(stage, 0, 1600, 900);
    skv_stage_zoom(stage, 0, 4, 800, 450);
    skv_stage_set_view(stage, 0, 800, 450);
    assert_true(fabs(skv_stage_camera(stage, 0).scale - 2000) < 0.01);
    open_scene(stage, "dam-break");
    assert_true(skv_stage_camera(stage, 0).zoom == 1);
}

/* Whatever row of a window comes and goes. */
static void test_margin_stays_free(void **state)
{
    (void)state;
    skv_stage *stage;
    skv_stage_def def = skv_default_stage_def();
    def.margin = 6;
    def.own_thread = false;
    assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
    const int heights[] = {900, 860, 700, 1000};
    for (int i = 0; i < 8; i++) {
        if (i == 4)
            open_scene(stage, "dam-break");
        skv_stage_zoom(stage, 0, 3, 800, 450);
        skv_stage_show_all(stage);
        skv_stage_set_view(stage, 0, 1600, heights[i % 4]);
        skv_camera camera = skv_stage_camera(stage, 0);
        double left, top, right, bottom;
        skv_camera_to_view(&camera, 0, camera.world_height, &left, &top);
        skv_camera_to_view(&camera, camera.world_width, 0, &right, &bottom);
        assert_true(fabs(fmin(left, top) - 6) < 1e-6);
        assert_true(fabs(fmin(1600 - right, heights[i % 4] - bottom) - 6) < 1e-6);
    }
    skv_stage_destroy(stage);
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
    skv_stage *stage;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    def.own_thread = false;
    def.threads = 1;
    def.wake = count_news;
    assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
    skv_stage_set_view(stage, 0, 1600, 900);
    skv_stage_open(stage, "pool", &options);
    for (int i = 0; i < 6000 && skv_stage_is_active(stage); i++)
        skv_stage_advance(stage, 1.0 / 60, 0);
    assert_false(skv_stage_is_active(stage));
    skv_picture before, after;
    stage_copy(stage, &before);
    assert_true(before.at_rest);
    news = 0;
    for (int i = 0; i < 100; i++)
        skv_stage_advance(stage, 1.0 / 60, 0);
    stage_copy(stage, &after);
    assert_int_equal(news, 0);
    assert_true(after.number == before.number && after.moment == before.moment);
    /* A touch wakes it. */
    stage_touch(stage, SKV_PHASE_DOWN, SKV_DEVICE_MOUSE, 0, 800, 800, 0);
    assert_true(news > 0);
    assert_true(skv_stage_is_active(stage));
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    stage_copy(stage, &after);
    assert_false(after.at_rest);
    assert_int_equal(after.hand_count, 1);
    skv_stage_destroy(stage);
}

/* Instruments read with every frame; a watched one shows its history. */
static void test_probes(void **state)
{
    skv_stage *stage = *state;
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    skv_picture picture;
    skv_outcome report;
    def.x0 = 0.8;
    def.y0 = 0.1;
    uint32_t probe = skv_stage_add_probe(stage, &def);
    uint32_t other = skv_stage_add_probe(stage, &def);
    assert_true(probe != 0 && other != probe);
    skv_stage_watch_probe(stage, probe, true);
    for (int i = 0; i < 30; i++)
        stage_advance(stage, 1.0 / 60);
    stage_copy(stage, &picture);
    assert_int_equal(picture.probe_count, 2);
    assert_int_equal(picture.probes[0].id, probe);
    assert_true(picture.probes[0].value[0] > 100);
    assert_true(picture.probes[0].value[0] == picture.probes[1].value[0]);
    skv_stage_look(stage);
    const skv_picture *held = skv_stage_picture(stage, 0);
    assert_int_equal(held->probes[0].samples, 31); /* the start, and 30 frames */
    assert_true(held->probes[0].history[0][30] == held->probes[0].value[0]);
    assert_true(fabs(held->probes[0].times[30] - held->frame.time) < 1e-9);
    assert_int_equal(held->probes[1].samples, 0);

    skv_stage_move_probe(stage, other, 0.8, 0.8, 0.8, 0.8);
    skv_stage_remove_probe(stage, probe);
    stage_advance(stage, 1.0 / 60);
    stage_copy(stage, &picture);
    assert_int_equal(picture.probe_count, 1);
    assert_true(isnan(picture.probes[0].value[0])); /* in the dry */
    assert_false(skv_stage_next_outcome(stage, &report) && report.error.code != SKV_OK);
    def.x0 = (double)NAN;
    skv_stage_add_probe(stage, &def);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_ERROR_VALUE);
    assert_int_equal(report.kind, SKV_OUTCOME_EDIT);
}

/* A file is there when it is complete, or not at all; what was saved can be opened. */
static void test_saving(void **state)
{
    skv_stage *stage = *state;
    const char *const names[] = {"session-test.skv", "session-test.skvr"};
    skv_outcome report;
    skv_picture picture;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 20; k++)
            stage_advance(stage, 1.0 / 60);
        uint64_t there = stage_hash(stage, 0);
        skv_stage_save(stage, names[i]);
        skv_stage_wait(stage);
        assert_int_equal(stage_report(stage, &report), SKV_OK);
        assert_int_equal(report.kind, SKV_OUTCOME_SAVE);
        skv_stage_open(stage, names[i], NULL);
        skv_stage_wait(stage);
        assert_int_equal(stage_report(stage, &report), SKV_OK);
        stage_copy(stage, &picture);
        assert_string_equal(picture.title, names[i]);
        /* The replay plays to where it was saved, by itself. */
        for (int k = 0; i == 1 && k < 20; k++)
            stage_advance(stage, 1.0 / 60);
        assert_int_equal(stage_hash(stage, 0), there);
        remove(names[i]);
    }
    stage_copy(stage, &picture);
    assert_false(picture.mismatch);
    /* The cause alone. */
    const char *const bad[][2] = {{"no/such/folder/a.skv", strerror(ENOENT)}, {"a.txt", ".skvr"}};
    for (int i = 0; i < 2; i++) {
        skv_stage_save(stage, bad[i][0]);
        skv_stage_wait(stage);
        assert_true(stage_report(stage, &report) > 0);
        assert_non_null(strstr(report.error.text, bad[i][1]));
        assert_null(strstr(report.error.text, bad[i][0]));
    }
    skv_stage_open(stage, "missing.skv", NULL);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_ERROR_FILE);
}

#define BOTH(test)                                                                                 \
    cmocka_unit_test_setup_teardown(test, stage_setup, stage_teardown),                            \
        cmocka_unit_test_setup_teardown(test, stage_setup_thread, stage_teardown)

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
        cmocka_unit_test_setup_teardown(test_failing_step_pauses, stage_setup, stage_teardown),
        BOTH(test_gravity_turns),
        cmocka_unit_test(test_margin_stays_free),
        BOTH(test_camera_shows_the_whole_world),
        BOTH(test_probes),
        BOTH(test_saving),
        cmocka_unit_test(test_rest_costs_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
