/* Every allocation failing once, from a scene to its readings: the call says so, whatever it was
 * called on goes on as if nothing had been asked of it, and asked again it gives the same bits.
 *
 * The whole story is told again and again, each time with another allocation failing, until it has
 * been told with none. Invariant: each telling ends with the same numbers and with every block
 * released. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "support/failing_memory.h"
#include "support/long.h"

#include <skvalp/experiments.h>
#include <skvalp/measure.h>
#include <skvalp/query.h>
#include <skvalp/stage.h>

/* Makes the call; if memory failed it must say so, and a second call must succeed. */
#define TWICE(call)                                                                                \
    do {                                                                                           \
        skv_error error_ = {0}, *error = &error_;                                                  \
        skv_result result_ = (call);                                                               \
        if (result_ != SKV_OK) {                                                                   \
            assert_int_equal(result_, SKV_ERROR_MEMORY);                                           \
            assert_int_equal(error_.code, SKV_ERROR_MEMORY);                                       \
            assert_non_null(strstr(error_.text, "memory"));                                        \
            assert_int_equal((call), SKV_OK);                                                      \
        }                                                                                          \
    } while (0)

/* What a telling ends with. */
typedef struct outcome {
    uint64_t hash;
    int particles;
    double pressure, level, force;
} outcome;

static const char json[] =
    "{\"world\": {\"pixel\": 0.01, \"width\": 0.4, \"height\": 0.3, \"open\": {\"right\": true}},"
    " \"solid\": [{\"shape\": \"box\", \"x0\": 0.3, \"y1\": 0.1}],"
    " \"water\": [{\"shape\": \"box\", \"x1\": 0.2, \"y1\": 0.15, \"vx\": 0.5}],"
    " \"fluid\": {\"viscosity\": 0.001}, \"particles\": 150}";

static void measure(skv_world *world, outcome *end)
{
    skv_lab *lab = NULL;
    skv_instrument level = 0, probe = 0, force = 0;
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_LEVEL);
    def.x0 = def.x1 = 0.1;
    def.y0 = 0.01;
    def.y1 = 0.29;
    TWICE(skv_lab_create(&lab, error));
    TWICE(skv_lab_add(lab, &def, &level, error));
    def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = 0.1;
    def.y0 = 0.05;
    TWICE(skv_lab_add(lab, &def, &probe, error));
    def = skv_default_instrument_def(SKV_INSTRUMENT_FORCE);
    def.x1 = 0.3;
    def.y1 = 0.02;
    TWICE(skv_lab_add(lab, &def, &force, error));
    for (int i = 0; i < 5; i++) {
        TWICE(skv_world_step(world, 1.0f / 60, error));
        TWICE(skv_lab_sample(lab, world, error));
    }
    end->level = skv_lab_reading(lab, level, 0);
    end->pressure = skv_lab_reading(lab, probe, 0);
    end->force = skv_lab_reading(lab, force, 1);
    skv_lab_destroy(lab);
}

static void tell(outcome *end)
{
    skv_scene *scene = NULL;
    skv_world *world = NULL;
    TWICE(skv_scene_load_memory(json, sizeof json - 1, "json", "memory.json", NULL, &scene, error));
    TWICE(skv_scene_create_world(scene, 2, &world, error));
    TWICE(skv_world_step(world, 1.0f / 60, error));
    /* Growing in the midst of it. */
    for (int i = 0; i < 200; i++)
        TWICE(skv_world_add_particle(world, 0.05f + 0.001f * (float)i, 0.25f, 0, 0, error));
    measure(world, end);
    end->hash = skv_world_hash(world);
    end->particles = skv_world_particle_count(world);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

static void test_every_allocation_fails_once(void **state)
{
    (void)state;
    outcome first = {0};
    failing_memory memory;
    failing_memory_start(&memory, -1);
    tell(&first);
    int calls = memory.calls;
    assert_true(calls > 20);
    assert_int_equal(memory.live, 0);
    failing_memory_stop();
    /* Every third allocation, or each of them. */
    for (int fail_at = 0; fail_at < calls; fail_at += long_tests() ? 1 : 3) {
        outcome again = {0};
        failing_memory_start(&memory, fail_at);
        tell(&again);
        assert_true(memory.calls > fail_at);
        assert_int_equal(memory.live, 0);
        failing_memory_stop();
        assert_memory_equal(&again, &first, sizeof first);
    }
}

/* The same for what the faces hold. What fails is reported, and asked for again. */
static void open_surely(skv_stage *stage, const char *name, const skv_scene_options *options)
{
    for (int i = 0; i < 2; i++) {
        skv_outcome report = {0};
        skv_stage_open(stage, name, options);
        skv_stage_wait(stage);
        while (skv_stage_next_outcome(stage, &report))
            assert_int_equal(report.kind, SKV_OUTCOME_OPEN);
        if (report.error.code == SKV_OK)
            return;
        assert_int_equal(report.error.code, SKV_ERROR_MEMORY);
    }
    fail_msg("%s could not be opened", name);
}

/* Some frames, an edit, and back. */
static void play_surely(skv_stage *stage)
{
    skv_outcome report;
    skv_stage_set_paused(stage, false);
    for (int i = 0; i < 6; i++) {
        skv_stage_advance(stage, 4.0 / 60, 0);
        if (i == 3)
            skv_stage_set(stage, 0, "fluid.density", "900");
    }
    skv_stage_undo(stage);
    skv_stage_redo(stage);
    skv_stage_wait(stage);
    while (skv_stage_next_outcome(stage, &report))
        assert_int_equal(report.error.code, SKV_ERROR_MEMORY);
}

static uint64_t play(void)
{
    skv_stage *stage = NULL;
    skv_scene_options options = skv_default_scene_options();
    skv_stage_def def = skv_default_stage_def();
    /* Coarse walls are made in no time. */
    const skv_setting coarse = {"world.pixel", "0.02"};
    options.particles = 100;
    options.settings = &coarse;
    options.setting_count = 1;
    def.own_thread = false;
    def.threads = 1;
    TWICE(skv_stage_create(&def, &stage, error));
    open_surely(stage, "dam-break", &options);
    play_surely(stage);
    open_surely(stage, "pool", &options);
    play_surely(stage);
    open_surely(stage, "pool", &options);
    while (stage_moment(stage) < 2) {
        skv_stage_set_paused(stage, false);
        skv_stage_advance(stage, 1.0 / 60, 0);
    }
    uint64_t hash = stage_hash(stage, 0);
    skv_stage_destroy(stage);
    return hash;
}

static void test_session_survives(void **state)
{
    (void)state;
    failing_memory memory;
    failing_memory_start(&memory, -1);
    uint64_t hash = play();
    int calls = memory.calls;
    assert_int_equal(memory.live, 0);
    failing_memory_stop();
    /* Some 500 plays take their time: every eighth allocation, or each of them. */
    for (int fail_at = 0; fail_at < calls; fail_at += long_tests() ? 1 : 8) {
        failing_memory_start(&memory, fail_at);
        assert_true(play() == hash);
        assert_int_equal(memory.live, 0);
        failing_memory_stop();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_allocation_fails_once),
        cmocka_unit_test(test_session_survives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
