/* The threads of a session: all of its worlds share one pool. A new world is made while the old one
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

static void open_scene(skv_session *session, const char *name)
{
    skv_outcome report;
    skv_session_open(session, name, NULL);
    skv_session_wait(session);
    assert_true(skv_session_next_outcome(session, &report));
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
    skv_session *session;
    skv_error error = {0};
    skv_stage_def def = three_threads(true);
    granted = 3;
    assert_int_equal(skv_session_create(&def, &session, &error), SKV_OK);
    assert_int_equal(granted, 0);
    open_scene(session, "pool");
    open_scene(session, "dam-break");
    skv_session_reset(session);
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
    skv_session_destroy(session);
}

static void test_too_few_threads_are_told(void **state)
{
    (void)state;
    skv_session *session;
    skv_error error = {0};
    skv_stage_def def = three_threads(false);
    granted = 1;
    assert_int_equal(skv_session_create(&def, &session, &error), SKV_ERROR_LIMIT);
    assert_null(session);
    assert_non_null(strstr(error.text, "thread 3 of 3"));
}

/* Without a thread of its own a session does all within its calls. */
static void test_a_session_without_its_thread(void **state)
{
    (void)state;
    skv_session *session;
    skv_stage_def def = three_threads(true);
    granted = 2;
    assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
    open_scene(session, "pool");
    assert_int_equal(session_advance(session, 1.0 / 60), 1);
    skv_session_destroy(session);
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
