/* Two threads at once: the face asks for everything, as fast as it can, while the other one steps,
 * opens, seeks and publishes. Run under ThreadSanitizer by test_tsan.sh; here it also measures what
 * the face's thread waited, with SKV_LONG_TESTS=1 beside 200 000 particles. */
#define _GNU_SOURCE
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

#include <cmocka.h>

#include "support/long.h"

#include <skvalp/session.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void rest(double seconds)
{
    struct timespec t = {.tv_nsec = (long)(1e9 * seconds)};
    nanosleep(&t, NULL);
}

static double longest;

/* Makes a call of the face's, and notes how long it took. */
#define TIMED(call)                                                                                \
    do {                                                                                           \
        double before_ = now();                                                                    \
        call;                                                                                      \
        longest = fmax(longest, now() - before_);                                                  \
    } while (0)

static skv_session *make(bool wide)
{
    skv_session *session;
    skv_stage_def def = skv_default_stage_def();
    def.threads = wide ? 0 : 2;
    assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
    skv_session_set_view(session, 1600, 900);
    return session;
}

static void open_pool(skv_session *session, int particles)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    TIMED(skv_session_open(session, "pool", &options));
}

/* Looks at a picture as a renderer does: at all of it. */
static double look(skv_session *session, uint64_t *last)
{
    const skv_picture *picture = NULL;
    TIMED(picture = skv_session_acquire(session));
    assert_true(picture->number >= *last);
    *last = picture->number;
    double sum = picture->frame.time;
    for (int i = 0; i < picture->frame.particles.count; i++)
        sum += (double)picture->frame.particles.x[i] + (double)picture->frame.particles.pressure[i];
    assert_true(isfinite(sum));
    TIMED(skv_session_release(session, picture));
    return sum;
}

static void point(skv_session *session, skv_phase phase, int turn)
{
    skv_pointer_event event = {.phase = phase,
                               .device = SKV_DEVICE_FINGER,
                               .pointer = 1 + (uint64_t)turn % 3,
                               .px = 100 + 37 * turn % 1400,
                               .py = 500 + 13 * turn % 400,
                               .time = turn / 500.0};
    TIMED(skv_session_pointer(session, &event));
}

/* Something else that a face asks for now and then. */
static void ask(skv_session *session, int turn, uint32_t *probe)
{
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = 0.8;
    def.y0 = 0.1;
    switch (turn % 11) {
    case 0:
        TIMED(skv_session_seek(session, turn / 3));
        break;
    case 1:
        TIMED(skv_session_undo(session));
        break;
    case 2:
        TIMED(skv_session_redo(session));
        break;
    case 3:
        TIMED(skv_session_set(session, "fluid.viscosity", "0.0001"));
        break;
    case 4:
        TIMED(skv_session_set_gravity(session, 0.2, -1));
        break;
    case 5:
        TIMED(*probe = skv_session_add_probe(session, &def));
        TIMED(skv_session_watch_probe(session, *probe, true));
        break;
    case 6:
        TIMED(skv_session_remove_probe(session, *probe));
        break;
    case 7:
        TIMED(skv_session_set_tool(session, turn / 11 % 3));
        break;
    case 8:
        TIMED(skv_session_set_paused(session, false));
        break;
    case 9:
        TIMED(skv_session_push(session, 0, 0.5));
        break;
    default:
        TIMED(skv_session_step_once(session));
        break;
    }
}

static void test_everything_at_once(void **state)
{
    (void)state;
    skv_session *session = make(false);
    uint64_t last = 0;
    uint32_t probe = 0;
    skv_outcome outcome;
    open_pool(session, 400);
    for (int turn = 0; turn < 400; turn++) {
        TIMED(skv_session_advance(session, 1.0 / 60, 0.001));
        point(session, SKV_PHASE_DOWN, turn);
        point(session, SKV_PHASE_MOVE, turn);
        if (turn % 4 == 3)
            point(session, SKV_PHASE_UP, turn);
        if (turn % 5 == 0)
            ask(session, turn / 5, &probe);
        if (turn % 250 == 249)
            open_pool(session, 300 + turn);
        look(session, &last);
        skv_session_camera(session);
        skv_session_is_active(session);
        while (skv_session_next_outcome(session, &outcome))
            if (outcome.error.code != SKV_OK && outcome.kind != SKV_OUTCOME_EDIT)
                fail_msg("%d: %s", (int)outcome.kind, outcome.error.text);
        rest(0.0005);
    }
    skv_session_wait(session);
    look(session, &last);
    assert_true(last > 1);
    skv_session_destroy(session);
}

/* A flood of events while nobody reads them: the newest place counts, and no finger stays down. */
static void test_a_flood(void **state)
{
    (void)state;
    skv_session *session = make(false);
    uint64_t last = 0;
    open_pool(session, 3000);
    for (int i = 0; i < 3000; i++) {
        point(session, SKV_PHASE_DOWN, 3 * i);
        point(session, SKV_PHASE_MOVE, 3 * i);
        point(session, SKV_PHASE_UP, 3 * i);
    }
    skv_session_wait(session);
    skv_session_advance(session, 1.0 / 60, 0);
    skv_session_wait(session);
    look(session, &last);
    const skv_picture *picture = skv_session_acquire(session);
    assert_int_equal(picture->hand_count, 0);
    skv_session_release(session, picture);
    assert_int_equal(skv_session_pointer_count(session), 0);
    skv_session_destroy(session);
}

/* A step of many particles takes long; the face's thread must not notice. */
static void test_the_face_never_waits(void **state)
{
    (void)state;
    int particles = long_tests() ? 200000 : 20000;
    skv_session *session = make(true);
    uint64_t last = 0;
    open_pool(session, particles);
    skv_session_wait(session);
    longest = 0;
    double step = 0;
    int64_t steps = 0;
    for (int turn = 0; turn < 300 || steps < 3; turn++) {
        TIMED(skv_session_advance(session, 1.0 / 60, 0.004));
        point(session, turn == 0 ? SKV_PHASE_DOWN : SKV_PHASE_MOVE, 3 * turn);
        const skv_picture *picture;
        TIMED(picture = skv_session_acquire(session));
        assert_true(picture->number >= last);
        assert_in_range(picture->frame.particles.count, particles / 2, 2 * particles);
        last = picture->number;
        step = picture->step_ms;
        steps = picture->moment;
        TIMED(skv_session_release(session, picture));
        rest(0.004);
    }
    assert_true(step > 0);
    print_message("%d particles: a step takes %.1f ms, the longest call of the face's thread %.3f "
                  "ms\n",
                  particles, step, 1000 * longest);
    skv_session_destroy(session);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_everything_at_once),
        cmocka_unit_test(test_a_flood),
        cmocka_unit_test(test_the_face_never_waits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
