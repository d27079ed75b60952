/* Steps and settling that nobody waits for: they stop between two substeps, and nothing else shows
 * that they might have been. */
#include <skvalp/skvalp.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "session/stage.h"
#include "session/support.h"
#include "skvalp/scene.h"

/* ---- Worlds ---------------------------------------------------------------------------------- */

typedef struct patience {
    int asked, left; /* says yes when it was asked more often than that */
} patience;

static bool runs_out(void *user)
{
    patience *p = user;
    p->asked++;
    return p->asked > p->left;
}

static skv_world *make_world(skv_pool *pool, skv_result wanted)
{
    skv_scene *scene;
    skv_world *world;
    assert_int_equal(skv_scene_load("pool", NULL, &scene, NULL), SKV_OK);
    skv_world_def def = skv_scene_world_def(scene);
    def.pool = pool;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    assert_int_equal(skv_scene_fill(scene, world, NULL), wanted);
    skv_scene_destroy(scene);
    return world;
}

static void a_step_stops_between_substeps(void **state)
{
    (void)state;
    skv_pool *pool;
    patience p = {.left = 1 << 30};
    assert_int_equal(skv_pool_create(2, &pool, NULL), SKV_OK);
    skv_world *plain = make_world(pool, SKV_OK);
    skv_world_set_gravity(plain, 3, -9, NULL);
    skv_world *world;
    size_t size = skv_world_snapshot_size(plain, false);
    void *before = malloc(size);
    assert_int_equal(skv_world_save(plain, false, before, size, NULL), SKV_OK);
    skv_world_def host = skv_default_world_def();
    host.pool = pool;
    assert_int_equal(skv_world_copy(plain, &host, &world, NULL), SKV_OK);
    assert_int_equal(skv_world_step(plain, 1.0f / 60, NULL), SKV_OK);

    skv_pool_set_stop(pool, runs_out, &p);
    assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    assert_true(skv_world_hash(world) == skv_world_hash(plain)); /* asked, and not stopped */
    int all = p.asked;
    assert_true(all >= skv_world_substeps_per_frame(world));

    assert_int_equal(skv_world_restore(world, before, size, NULL), SKV_OK);
    p = (patience){.left = all / 2};
    assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_STOPPED);
    assert_int_equal(p.asked, all / 2 + 1); /* no other substep after it */
    skv_pool_set_stop(pool, NULL, NULL);
    assert_int_equal(skv_world_restore(world, before, size, NULL), SKV_OK);
    assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    assert_true(skv_world_hash(world) == skv_world_hash(plain));
    skv_world_destroy(world);
    skv_world_destroy(plain);
    skv_pool_destroy(pool);
    free(before);
}

static void settling_stops_between_rounds(void **state)
{
    (void)state;
    skv_pool *pool;
    patience p = {.left = 10};
    assert_int_equal(skv_pool_create(1, &pool, NULL), SKV_OK);
    skv_pool_set_stop(pool, runs_out, &p);
    skv_world_destroy(make_world(pool, SKV_STOPPED));
    assert_int_equal(p.asked, 11);
    skv_pool_destroy(pool);
}

/* ---- A stage --------------------------------------------------------------------------------- */

static atomic_bool armed, reached, go_on;
static atomic_int times_asked;
static _Atomic(const skv_worker *) watched; /* null: none ends */

static bool is_ending(const skv_worker *worker)
{
    return worker && atomic_load(&worker->quit);
}

/* Asked before a step, and after one that was not stopped. Once armed it holds the step up until
 * what is asked of the stage meanwhile has been asked. */
static double hold_up(void)
{
    atomic_fetch_add(&times_asked, 1);
    if (atomic_exchange(&armed, false)) {
        atomic_store(&reached, true);
        while (!atomic_load(&go_on) && !is_ending(atomic_load(&watched)))
            continue;
    }
    return 0;
}

static skv_stage *open_moving(void)
{
    skv_stage *stage = stage_make(true, hold_up);
    skv_outcome report;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    skv_stage_open(stage, "dam-break", &options);
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    stage_pass_frames(stage, 20);
    assert_int_equal(stage_moment(stage), 20);
    return stage;
}

/* Begins a frame, which waits for release(). */
static void begin_frame(skv_stage *stage)
{
    atomic_store(&go_on, false);
    atomic_store(&reached, false);
    atomic_store(&armed, true);
    skv_stage_advance(stage, 1.0 / 60, 0);
    while (!atomic_load(&reached))
        continue;
}

static void release(void)
{
    atomic_store(&go_on, true);
}

static void a_scene_that_opens_does_not_wait_for_a_frame(void **state)
{
    (void)state;
    skv_stage *stage = open_moving();
    skv_outcome report;
    uint64_t before = stage_hash(stage, 0);
    begin_frame(stage);
    skv_stage_push(stage, 0, 1, 0); /* of a world that is to go */
    skv_stage_open(stage, "no-such-scene", NULL);
    release();
    skv_stage_wait(stage);
    assert_true(stage_report(stage, &report) > 0);
    assert_int_equal(report.kind, SKV_OUTCOME_OPEN);
    assert_int_equal(stage_moment(stage), 20); /* the frame was broken off, and is not missing */
    assert_true(stage_hash(stage, 0) == before);
    stage_pass_frames(stage, 5);
    assert_int_equal(stage_moment(stage), 25);
    assert_int_equal(stage_report(stage, &report), -1);

    begin_frame(stage);
    skv_stage_open(stage, "pool", NULL);
    release();
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    assert_string_equal(stage_look(stage, 0)->name, "pool");
    assert_int_equal(stage_moment(stage), 0);
    skv_stage_destroy(stage);
}

static void what_is_saved_before_is_whole(void **state)
{
    (void)state;
    skv_stage *stage = open_moving();
    skv_outcome report;
    begin_frame(stage);
    skv_stage_save(stage, "stopping-test.skv");
    skv_stage_open(stage, "no-such-scene", NULL);
    release();
    skv_stage_wait(stage);
    assert_int_equal(stage_report(stage, &report), SKV_OK);
    assert_int_equal(report.kind, SKV_OUTCOME_SAVE);
    assert_true(stage_report(stage, &report) > 0);
    assert_int_equal(stage_moment(stage), 21);
    remove("stopping-test.skv");
    skv_stage_destroy(stage);
}

static void the_end_does_not_wait_for_a_frame(void **state)
{
    (void)state;
    skv_stage *stage = open_moving();
    begin_frame(stage);
    int before = atomic_load(&times_asked);
    atomic_store(&watched, &stage->worlds[0]->worker);
    skv_stage_destroy(stage);
    atomic_store(&watched, NULL);
    assert_int_equal(atomic_load(&times_asked), before); /* the step did not come to its end */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_stops_between_substeps),
        cmocka_unit_test(settling_stops_between_rounds),
        cmocka_unit_test(a_scene_that_opens_does_not_wait_for_a_frame),
        cmocka_unit_test(what_is_saved_before_is_whole),
        cmocka_unit_test(the_end_does_not_wait_for_a_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
