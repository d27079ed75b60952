/* The session below every toolkit: opening and failing to, the playback clock, gravity, camera. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/failing_memory.h"

#include <skvalp/session.h>

static int setup(void **state)
{
    skv_session *session;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    if (skv_session_create(1, &session, NULL) != SKV_OK)
        return -1;
    *state = session;
    return skv_session_open(session, "pool", &options, NULL) == SKV_OK ? 0 : -1;
}

static int teardown(void **state)
{
    skv_session_destroy(*state);
    return 0;
}

/* Advances, which must not fail; returns the frames stepped. */
static int advance(skv_session *session, double seconds)
{
    int frames = -1;
    skv_error error;
    assert_int_equal(skv_session_advance(session, seconds, &frames, &error), SKV_OK);
    return frames;
}

static int64_t frames_of(skv_session *session)
{
    const skv_world *world = skv_session_world(session);
    return skv_world_substep_count(world) / skv_world_substeps_per_frame(world);
}

static void test_starts_empty(void **state)
{
    (void)state;
    skv_session *session;
    skv_error error;
    assert_int_equal(skv_session_create(1, &session, &error), SKV_OK);
    assert_null(skv_session_world(session));
    assert_null(skv_session_scene(session));
    assert_int_equal(advance(session, 1), 0);
    assert_int_equal(skv_session_step_once(session, NULL), SKV_OK);
    assert_int_equal(skv_session_reset(session, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "open"));
    assert_true(skv_session_camera(session).scale > 0);
    skv_session_destroy(session);
    skv_session_destroy(NULL);

    assert_int_equal(skv_session_create(SKV_MAX_THREADS + 1, &session, &error), SKV_ERROR_VALUE);
    assert_null(session);
}

static void test_failed_open_changes_nothing(void **state)
{
    skv_session *session = *state;
    advance(session, 2.0 / 60);
    skv_session_pointer_down(session, 7, 10, 10, 0);
    const skv_world *world = skv_session_world(session);
    const skv_scene *scene = skv_session_scene(session);
    uint64_t hash = skv_world_hash(world);

    skv_error error = {0};
    assert_int_not_equal(skv_session_open(session, "no-such-scene.json", NULL, &error), SKV_OK);
    assert_non_null(strstr(error.text, "no-such-scene.json"));
    assert_ptr_equal(skv_session_world(session), world);
    assert_ptr_equal(skv_session_scene(session), scene);
    assert_int_equal(skv_world_hash(world), hash);
    assert_int_equal(skv_session_pointer_count(session), 1);
    assert_int_equal(advance(session, 1.0 / 60), 1);
}

static void test_open_takes_over(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 7, 10, 10, 0);
    skv_session_set_speed(session, 0.5);
    skv_scene *scene;
    assert_int_equal(skv_scene_load("dam-break", NULL, &scene, NULL), SKV_OK);
    assert_int_equal(skv_session_open_scene(session, scene, NULL), SKV_OK);
    assert_ptr_equal(skv_session_scene(session), scene);
    assert_string_equal(skv_scene_name(skv_session_scene(session)), "dam-break");
    assert_int_equal(skv_world_substep_count(skv_session_world(session)), 0);
    assert_int_equal(skv_session_pointer_count(session), 0);
    assert_true(skv_session_speed(session) == 0.5);

    /* The same scene once more is a reset. */
    assert_int_equal(skv_session_open_scene(session, scene, NULL), SKV_OK);
    assert_ptr_equal(skv_session_scene(session), scene);
}

static void test_reset_goes_back(void **state)
{
    skv_session *session = *state;
    uint64_t start = skv_world_hash(skv_session_world(session));
    skv_session_set_gravity_direction(session, 1, 0);
    skv_session_set_speed(session, 2);
    advance(session, 2.0 / 60);
    assert_int_not_equal(skv_world_hash(skv_session_world(session)), start);
    skv_session_set_paused(session, true);

    assert_int_equal(skv_session_reset(session, NULL), SKV_OK);
    assert_int_equal(skv_world_hash(skv_session_world(session)), start);
    double x, y;
    skv_session_gravity_direction(session, &x, &y);
    assert_true(x == 0 && fabs(y + 1) < 1e-6);
    assert_true(skv_session_paused(session));
    assert_true(skv_session_speed(session) == 2);
}

static void test_clock_steps_whole_frames(void **state)
{
    skv_session *session = *state;
    for (int i = 1; i <= 30; i++) {
        assert_int_equal(advance(session, 1.0 / 60), 1);
        assert_int_equal(frames_of(session), i);
    }
    assert_true(fabs(skv_world_time(skv_session_world(session)) - 0.5) < 1e-6);
    assert_int_equal(advance(session, 0), 0);
    assert_int_equal(advance(session, -1), 0);
    assert_int_equal(advance(session, NAN), 0);
}

static void test_clock_accumulates(void **state)
{
    skv_session *session = *state;
    int frames = 0;
    for (int i = 0; i < 10; i++)
        frames += advance(session, 0.1 / 60);
    assert_int_equal(frames, 1);

    /* A 144 Hz display: 60 frames in a second all the same. */
    frames = 0;
    for (int i = 0; i < 144; i++)
        frames += advance(session, 1.0 / 144);
    assert_int_equal(frames, 60);
}

static void test_clock_follows_a_display_near_60_hz(void **state)
{
    skv_session *session = *state;
    for (int i = 0; i < 200; i++) /* 59.94 Hz, with a jitter of 0.1 ms */
        assert_int_equal(advance(session, 1 / 59.94 + (i % 3 - 1) * 1e-4), 1);
}

static void test_clock_drops_what_is_too_much(void **state)
{
    skv_session *session = *state;
    assert_int_equal(advance(session, 10), 4);
    assert_int_equal(advance(session, 1.0 / 60), 1);
}

static void test_speed(void **state)
{
    skv_session *session = *state;
    skv_session_set_speed(session, 0.25);
    int frames = 0;
    for (int i = 0; i < 40; i++)
        frames += advance(session, 1.0 / 60);
    assert_int_equal(frames, 10);
    skv_session_set_speed(session, 2);
    assert_int_equal(advance(session, 1.0 / 60), 2);
    skv_session_set_speed(session, 0);
    assert_true(skv_session_speed(session) == 0.05);
    skv_session_set_speed(session, 1e9);
    assert_true(skv_session_speed(session) == 2);
}

static void test_pause_and_single_steps(void **state)
{
    skv_session *session = *state;
    skv_session_set_paused(session, true);
    assert_true(skv_session_paused(session));
    assert_int_equal(advance(session, 1), 0);
    assert_int_equal(frames_of(session), 0);
    assert_int_equal(skv_session_step_once(session, NULL), SKV_OK);
    assert_int_equal(skv_session_step_once(session, NULL), SKV_OK);
    assert_int_equal(frames_of(session), 2);
    skv_session_set_paused(session, false);
    assert_int_equal(advance(session, 1.0 / 60), 1); /* the pause left no debt */
}

/* A step that fails is told, pauses, and leaves the world as it was, so that playing on can try
 * again. */
static void test_failing_step_pauses(void **state)
{
    skv_session *session = *state;
    uint64_t start = skv_world_hash(skv_session_world(session));
    failing_memory memory;
    skv_error error = {0};
    int frames = -1;
    failing_memory_start(&memory, 0); /* the first step of a world makes room for its solver */
    assert_int_equal(skv_session_advance(session, 2.0 / 60, &frames, &error), SKV_ERROR_MEMORY);
    failing_memory_stop();
    assert_int_equal(frames, 0);
    assert_non_null(strstr(error.text, "memory"));
    assert_true(skv_session_paused(session));
    assert_int_equal(skv_world_hash(skv_session_world(session)), start);

    failing_memory_start(&memory, 0);
    assert_int_equal(skv_session_step_once(session, &error), SKV_ERROR_MEMORY);
    failing_memory_stop();

    skv_session_set_paused(session, false);
    assert_int_equal(advance(session, 1.0 / 60), 1);
}

static void test_gravity_turns(void **state)
{
    skv_session *session = *state;
    float x, y;
    skv_session_set_gravity_direction(session, 1, 0);
    skv_world_gravity(skv_session_world(session), &x, &y);
    assert_true(fabs(x - 9.81) < 1e-5 && y == 0);
    skv_session_set_gravity_direction(session, 0, 0);
    skv_world_gravity(skv_session_world(session), &x, &y);
    assert_true(x == 0 && y == 0);
    skv_session_set_gravity_direction(session, 0, 0.5); /* a tilted device: half of it */
    skv_world_gravity(skv_session_world(session), &x, &y);
    assert_true(x == 0 && fabs(y - 0.5 * 9.81) < 1e-5);
    double dx, dy;
    skv_session_gravity_direction(session, &dx, &dy);
    assert_true(dx == 0 && dy == 0.5);
    skv_session_set_gravity_direction(session, -1e6, 0);
    skv_world_gravity(skv_session_world(session), &x, &y);
    assert_true(x == -1000);
}

static void test_camera_shows_the_whole_world(void **state)
{
    skv_session *session = *state;
    const skv_terrain *terrain = skv_world_terrain(skv_session_world(session));
    double width = skv_terrain_width(terrain), height = skv_terrain_height(terrain);
    const int views[][2] = {{1280, 720}, {300, 900}, {900, 300}, {1, 1}, {0, -5}, {7681, 33}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        skv_session_set_view(session, views[i][0], views[i][1]);
        skv_camera camera = skv_session_camera(session);
        double left, bottom, right, top;
        skv_camera_to_world(&camera, 0, camera.height, &left, &bottom);
        skv_camera_to_world(&camera, camera.width, 0, &right, &top);
        assert_true(left <= 1e-9 && bottom <= 1e-9);
        assert_true(right >= width - 1e-9 && top >= height - 1e-9);
        assert_true(fabs(left + right - width) < 1e-9); /* centred */
        assert_true(fabs(bottom + top - height) < 1e-9);
        assert_true(fmin(-left, -bottom) < 1e-9); /* as large as fits */
    }
}

static void test_camera_round_trip(void **state)
{
    skv_session *session = *state;
    skv_session_set_view(session, 777, 555);
    skv_camera camera = skv_session_camera(session);
    double x, y;
    skv_camera_to_world(&camera, camera.origin_x, camera.origin_y, &x, &y);
    assert_true(fabs(x) < 1e-12 && fabs(y) < 1e-12);
    skv_camera_to_world(&camera, 123.25, 45.5, &x, &y);
    assert_true(fabs(camera.origin_x + x * camera.scale - 123.25) < 1e-9);
    assert_true(fabs(camera.origin_y - y * camera.scale - 45.5) < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_starts_empty),
        cmocka_unit_test_setup_teardown(test_failed_open_changes_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(test_open_takes_over, setup, teardown),
        cmocka_unit_test_setup_teardown(test_reset_goes_back, setup, teardown),
        cmocka_unit_test_setup_teardown(test_clock_steps_whole_frames, setup, teardown),
        cmocka_unit_test_setup_teardown(test_clock_accumulates, setup, teardown),
        cmocka_unit_test_setup_teardown(test_clock_follows_a_display_near_60_hz, setup, teardown),
        cmocka_unit_test_setup_teardown(test_clock_drops_what_is_too_much, setup, teardown),
        cmocka_unit_test_setup_teardown(test_speed, setup, teardown),
        cmocka_unit_test_setup_teardown(test_pause_and_single_steps, setup, teardown),
        cmocka_unit_test_setup_teardown(test_failing_step_pauses, setup, teardown),
        cmocka_unit_test_setup_teardown(test_gravity_turns, setup, teardown),
        cmocka_unit_test_setup_teardown(test_camera_shows_the_whole_world, setup, teardown),
        cmocka_unit_test_setup_teardown(test_camera_round_trip, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
