/* Stages for tests, by a clock that stands still, so that nothing depends on the machine. */
#include "support.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support/fixture.h"
#include "support/kept.h"

double stage_still(void)
{
    return 0;
}

skv_stage *stage_make(bool own_thread, double (*clock)(void))
{
    skv_stage *stage;
    skv_stage_def def = skv_default_stage_def();
    def.threads = 1;
    def.own_thread = own_thread;
    def.clock = clock;
    assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
    skv_stage_set_view(stage, 0, 1600, 900);
    return stage;
}

skv_stage *stage_open_pool(int particles, bool own_thread)
{
    skv_stage *stage = stage_make(own_thread, stage_still);
    skv_outcome outcome;
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_stage_open(stage, "pool", &options);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &outcome));
    assert_string_equal(outcome.error.text, "");
    return stage;
}

const skv_picture *stage_look(skv_stage *stage, int side)
{
    skv_stage_wait(stage);
    skv_stage_look(stage);
    return skv_stage_picture(stage, side);
}

uint64_t stage_hash(skv_stage *stage, int side)
{
    return fixture_hash(&stage_look(stage, side)->frame.particles);
}

int64_t stage_moment(skv_stage *stage)
{
    int64_t at = stage_look(stage, 0)->moment;
    assert_int_equal(skv_stage_picture(stage, 1)->moment, at);
    return at;
}

void stage_pass(skv_stage *stage, double seconds)
{
    skv_stage_advance(stage, seconds, 0);
    skv_stage_wait(stage);
}

void stage_pass_frames(skv_stage *stage, int frames)
{
    for (int i = 0; i < frames; i++)
        stage_pass(stage, 1.0 / 60);
}

skv_outcome stage_compared(skv_stage *stage)
{
    skv_outcome outcome;
    do
        skv_stage_wait(stage);
    while (!skv_stage_next_outcome(stage, &outcome));
    assert_int_equal(outcome.kind, SKV_OUTCOME_COMPARE);
    if (skv_stage_sides(stage) == 2)
        skv_stage_set_view(stage, 1, 1600, 900);
    return outcome;
}

void stage_ask_compare(skv_stage *stage, int particles, const char *path, const char *value)
{
    skv_setting setting = {path, value};
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    options.settings = &setting;
    options.setting_count = path ? 1 : 0;
    skv_stage_compare(stage, &options);
    skv_stage_wait(stage);
}

void stage_compare(skv_stage *stage, int particles, const char *path, const char *value)
{
    stage_ask_compare(stage, particles, path, value);
    assert_string_equal(stage_compared(stage).error.text, "");
    assert_int_equal(skv_stage_sides(stage), 2);
}

void stage_point(skv_stage *stage, int side, skv_phase phase, double px, double py, double time)
{
    skv_stage_pointer(stage, side,
                      &(skv_pointer_event){.phase = phase, .px = px, .py = py, .time = time});
    skv_stage_wait(stage);
}

void stage_draw_wall(skv_stage *stage, int side, double px)
{
    skv_stage_set_tool(stage, 1);
    stage_point(stage, side, SKV_PHASE_DOWN, px, 300, 0);
    stage_point(stage, side, SKV_PHASE_MOVE, px + 100, 350, 0.1);
    stage_point(stage, side, SKV_PHASE_UP, px + 100, 350, 0.2);
}

skv_player *open_player(size_t history)
{
    const skv_setting oil = {"fluids[0].name", "oil"};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 300;
    options.settings = &oil;
    options.setting_count = 1;
    skv_scene *scene;
    skv_player *player;
    skv_player_def def = skv_default_player_def();
    def.threads = 1;
    if (history)
        def.history = history;
    assert_int_equal(skv_scene_load("pool", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, &def, &player, NULL), SKV_OK);
    return player;
}

int stage_setup(void **state)
{
    *state = stage_open_pool(200, false);
    return 0;
}

int stage_setup_thread(void **state)
{
    *state = stage_open_pool(200, true);
    return 0;
}

int stage_teardown(void **state)
{
    skv_stage_destroy(*state);
    return 0;
}

void stage_copy(skv_stage *stage, skv_picture *picture)
{
    skv_stage_look(stage);
    *picture = *skv_stage_picture(stage, 0);
}

int stage_advance(skv_stage *stage, double seconds)
{
    int64_t before = stage_moment(stage);
    skv_stage_advance(stage, seconds, 0);
    skv_stage_wait(stage);
    return (int)(stage_moment(stage) - before);
}

void stage_touch(skv_stage *stage, skv_phase phase, skv_device device, uint64_t pointer, double px,
                 double py, double time)
{
    skv_stage_pointer(stage, 0,
                      &(skv_pointer_event){.phase = phase,
                                           .device = device,
                                           .pointer = pointer,
                                           .px = px,
                                           .py = py,
                                           .time = time});
    skv_stage_wait(stage);
}

skv_stage *stage_open_shared(skv_stage *stage)
{
    skv_outcome outcome;
    kept shared = {0};
    skv_stage_share(stage);
    skv_stage_wait(stage);
    while (skv_stage_next_outcome(stage, &outcome))
        assert_string_equal(outcome.error.text, "");
    assert_true(skv_stage_read_shared(stage, kept_add, &shared));
    skv_stage *other = stage_make(false, stage_still);
    skv_stage_open_memory(other, shared.bytes, shared.size, "skvr", "link", NULL);
    skv_stage_wait(other);
    kept_clear(&shared);
    skv_stage_seek(other, stage_moment(stage));
    assert_true(stage_hash(other, 0) == stage_hash(stage, 0));
    assert_false(stage_look(other, 0)->mismatch);
    return other;
}

int stage_report(skv_stage *stage, skv_outcome *report)
{
    return skv_stage_next_outcome(stage, report) ? (int)report->error.code : -1;
}
