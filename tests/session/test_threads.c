/* The threads of a stage: all of its worlds share one pool. A new world is made while the old one
 * is still there, so on a system that grants only so many threads one pool a world would leave the
 * second scene without. */
#define _GNU_SOURCE /* RTLD_NEXT */
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include <skvalp/query.h>

static int granted; /* threads that the system still has */

/* Stands before the system's own. */
int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                   void *argument)
{
    int (*create)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    *(void **)&create = dlsym(RTLD_NEXT, "pthread_create");
    return granted-- > 0 ? create(thread, attributes, run, argument) : EAGAIN;
}

static void open_scene(skv_stage *stage, const char *name)
{
    skv_outcome report;
    skv_stage_open(stage, name, NULL);
    skv_stage_wait(stage);
    assert_true(skv_stage_next_outcome(stage, &report));
    assert_int_equal(report.error.code, SKV_OK);
}

static skv_stage_def three_threads(bool own_thread)
{
    skv_stage_def def = skv_default_stage_def();
    def.threads = 3;
    def.own_thread = own_thread;
    return def;
}

static void test_scenes_follow_each_other_on_the_same_threads(void **state)
{
    (void)state;
    skv_stage *stage;
    skv_error error = {0};
    skv_stage_def def = three_threads(true);
    granted = 3;
    assert_int_equal(skv_stage_create(&def, &stage, &error), SKV_OK);
    assert_int_equal(granted, 0);
    open_scene(stage, "pool");
    open_scene(stage, "dam-break");
    skv_stage_seek(stage, 0);
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    skv_stage_destroy(stage);
}

static void test_too_few_threads_are_told(void **state)
{
    (void)state;
    skv_stage *stage;
    skv_error error = {0};
    skv_stage_def def = three_threads(false);
    granted = 1;
    assert_int_equal(skv_stage_create(&def, &stage, &error), SKV_ERROR_LIMIT);
    assert_null(stage);
    assert_non_null(strstr(error.text, "thread 3 of 3"));
}

/* Without a thread of its own a stage does all within its calls. */
static void test_a_session_without_its_thread(void **state)
{
    (void)state;
    skv_stage *stage;
    skv_stage_def def = three_threads(true);
    granted = 2;
    assert_int_equal(skv_stage_create(&def, &stage, NULL), SKV_OK);
    open_scene(stage, "pool");
    assert_int_equal(stage_advance(stage, 1.0 / 60), 1);
    skv_stage_destroy(stage);
}

/* Worlds of one pool give the bits that each gives alone, and outlive each other in any order. */
static void test_worlds_of_one_pool(void **state)
{
    (void)state;
    granted = 8;
    skv_pool *pool;
    skv_scene *scene;
    skv_world *worlds[3];
    assert_int_equal(skv_pool_create(3, &pool, NULL), SKV_OK);
    assert_int_equal(skv_scene_load("dam-break", NULL, &scene, NULL), SKV_OK);
    for (int i = 0; i < 3; i++) {
        skv_world_def def = skv_scene_world_def(scene);
        def.pool = i < 2 ? pool : NULL;
        def.threads = 1;
        assert_int_equal(skv_world_create(&def, &worlds[i], NULL), SKV_OK);
        assert_int_equal(skv_world_threads(worlds[i]), i < 2 ? 3 : 1);
        assert_int_equal(skv_scene_fill(scene, worlds[i], NULL), SKV_OK);
    }
    for (int frame = 0; frame < 5; frame++)
        for (int i = 0; i < 3; i++)
            assert_int_equal(skv_world_step(worlds[i], 1.0f / 60, NULL), SKV_OK);
    assert_true(skv_world_hash(worlds[0]) == skv_world_hash(worlds[2]));
    skv_world_destroy(worlds[0]);
    assert_int_equal(skv_world_step(worlds[1], 1.0f / 60, NULL), SKV_OK);
    assert_int_equal(skv_world_step(worlds[2], 1.0f / 60, NULL), SKV_OK);
    assert_true(skv_world_hash(worlds[1]) == skv_world_hash(worlds[2]));
    skv_world_destroy(worlds[1]);
    skv_world_destroy(worlds[2]);
    skv_scene_destroy(scene);
    skv_pool_destroy(pool);
    skv_pool_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_follow_each_other_on_the_same_threads),
        cmocka_unit_test(test_too_few_threads_are_told),
        cmocka_unit_test(test_a_session_without_its_thread),
        cmocka_unit_test(test_worlds_of_one_pool),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
