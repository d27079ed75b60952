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

#include <skvalp/stage.h>

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

static skv_stage *make(bool wide)
{
    skv_stage *stage;
    skv_stage_def def = skv_default_stage_def();
    def.threads = wide ? 0 : 2;
    assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
    skv_stage_set_view(stage, 0, 1600, 900);
    return stage;
}

static void open_pool(skv_stage *stage, int particles)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    TIMED(skv_stage_open(stage, "pool", &options));
}

/* Looks at a picture as a renderer does: at all of it. */
static double look(skv_stage *stage, uint64_t *last)
{
    const skv_picture *picture = NULL;
    TIMED(skv_stage_look(stage));
    picture = skv_stage_picture(stage, 0);
    assert_true(picture->number >= *last);
    *last = picture->number;
    double sum = picture->frame.time;
    for (int i = 0; i < picture->frame.particles.count; i++)
        sum += (double)picture->frame.particles.x[i] + (double)picture->frame.particles.pressure[i];
    assert_true(isfinite(sum));
    return sum;
}

static void point(skv_stage *stage, skv_phase phase, int turn)
{
    skv_pointer_event event = {.phase = phase,
                               .device = SKV_DEVICE_FINGER,
                               .pointer = 1 + (uint64_t)turn % 3,
                               .px = 100 + 37 * turn % 1400,
                               .py = 500 + 13 * turn % 400,
                               .time = turn / 500.0};
    TIMED(skv_stage_pointer(stage, 0, &event));
}

/* Something else that a face asks for now and then. */
static void ask(skv_stage *stage, int turn, uint32_t *probe)
{
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = 0.8;
    def.y0 = 0.1;
    switch (turn % 11) {
    case 0:
        TIMED(skv_stage_seek(stage, turn / 3));
        break;
    case 1:
        TIMED(skv_stage_undo(stage));
        break;
    case 2:
        TIMED(skv_stage_redo(stage));
        break;
    case 3:
        TIMED(skv_stage_set(stage, 0, "fluid.viscosity", "0.0001"));
        break;
    case 4:
        TIMED(skv_stage_set_gravity(stage, 0, 0.2, -1));
        break;
    case 5:
        TIMED(*probe = skv_stage_add_probe(stage, &def));
        TIMED(skv_stage_watch_probe(stage, *probe, true));
        break;
    case 6:
        TIMED(skv_stage_remove_probe(stage, *probe));
        break;
    case 7:
        TIMED(skv_stage_set_tool(stage, turn / 11 % 3));
        break;
    case 8:
        TIMED(skv_stage_set_paused(stage, false));
        break;
    case 9:
        TIMED(skv_stage_push(stage, 0, 0, 0.5));
        break;
    default:
        TIMED(skv_stage_step_once(stage));
        break;
    }
}

static void test_everything_at_once(void **state)
{
    (void)state;
    skv_stage *stage = make(false);
    uint64_t last = 0;
    uint32_t probe = 0;
    skv_outcome outcome;
    open_pool(stage, 400);
    skv_stage_wait(stage); /* or the next one that opens takes its place */
    for (int turn = 0; turn < 400; turn++) {
        TIMED(skv_stage_advance(stage, 1.0 / 60, 0.001));
        point(stage, SKV_PHASE_DOWN, turn);
        point(stage, SKV_PHASE_MOVE, turn);
        if (turn % 4 == 3)
            point(stage, SKV_PHASE_UP, turn);
        if (turn % 5 == 0)
            ask(stage, turn / 5, &probe);
        if (turn % 250 == 249)
            open_pool(stage, 300 + turn);
        look(stage, &last);
        skv_stage_camera(stage, 0);
        skv_stage_is_active(stage);
        while (skv_stage_next_outcome(stage, &outcome))
            if (outcome.error.code != SKV_OK && outcome.kind != SKV_OUTCOME_EDIT)
                fail_msg("%d: %s", (int)outcome.kind, outcome.error.text);
        rest(0.0005);
    }
    skv_stage_wait(stage);
    look(stage, &last);
    assert_true(last > 1);
    skv_stage_destroy(stage);
}

/* A flood of events while nobody reads them: the newest place counts, and no finger stays down. */
static void test_a_flood(void **state)
{
    (void)state;
    skv_stage *stage = make(false);
    uint64_t last = 0;
    open_pool(stage, 3000);
    for (int i = 0; i < 3000; i++) {
        point(stage, SKV_PHASE_DOWN, 3 * i);
        point(stage, SKV_PHASE_MOVE, 3 * i);
        point(stage, SKV_PHASE_UP, 3 * i);
    }
    skv_stage_wait(stage);
    skv_stage_advance(stage, 1.0 / 60, 0);
    skv_stage_wait(stage);
    look(stage, &last);
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    assert_int_equal(picture->hand_count, 0);
    assert_int_equal(skv_stage_pointer_count(stage, 0), 0);
    skv_stage_destroy(stage);
}

/* A step of many particles takes long; the face's thread must not notice. */
static void test_the_face_never_waits(void **state)
{
    (void)state;
    int particles = long_tests() ? 200000 : 20000;
    skv_stage *stage = make(true);
    uint64_t last = 0;
    open_pool(stage, particles);
    skv_stage_wait(stage);
    longest = 0;
    double step = 0;
    int64_t steps = 0;
    for (int turn = 0; turn < 300 || steps < 3; turn++) {
        TIMED(skv_stage_advance(stage, 1.0 / 60, 0.004));
        point(stage, turn == 0 ? SKV_PHASE_DOWN : SKV_PHASE_MOVE, 3 * turn);
        const skv_picture *picture;
        TIMED(skv_stage_look(stage));
        picture = skv_stage_picture(stage, 0);
        assert_true(picture->number >= last);
        assert_in_range(picture->frame.particles.count, particles / 2, 2 * particles);
        last = picture->number;
        step = picture->step_ms;
        steps = picture->moment;
        rest(0.004);
    }
    assert_true(step > 0);
    print_message("%d particles: a step takes %.1f ms, the longest call of the face's thread %.3f "
                  "ms\n",
                  particles, step, 1000 * longest);
    skv_stage_destroy(stage);
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
