/* The task pool: every index once, for any number of threads, thousands of short runs in a row. */
#include "base/pool.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 5000 };

static atomic_int touched[MOST];

static void touch(int begin, int end, void *context)
{
    for (int i = begin; i < end; i++)
        atomic_fetch_add(&touched[i], *(int *)context);
}

static void check_pool(int threads)
{
    skv_pool *pool;
    assert_int_equal(skv_pool_create(threads, &pool, NULL), SKV_OK);
    assert_true(threads == 0 || skv_pool_threads(pool) == threads);
    const int counts[] = {0, 1, 127, 128, 129, 1000, MOST};
    for (int c = 0; c < 7; c++) {
        memset(touched, 0, sizeof touched);
        int one = 1, rounds = 300;
        for (int round = 0; round < rounds; round++)
            skv_pool_run(pool, counts[c], touch, &one);
        for (int i = 0; i < MOST; i++)
            assert_int_equal(touched[i], i < counts[c] ? rounds : 0);
    }
    skv_pool_destroy(pool);
}

static void every_index_runs_exactly_once(void **unused)
{
    (void)unused;
    const int threads[] = {0, 1, 2, 3, 7};
    for (int t = 0; t < 5; t++)
        check_pool(threads[t]);
}

static void no_pool_means_the_calling_thread(void **unused)
{
    (void)unused;
    memset(touched, 0, sizeof touched);
    int two = 2;
    skv_pool_run(NULL, 1000, touch, &two);
    assert_int_equal(touched[999], 2);
    assert_int_equal(touched[1000], 0);
}

static void bad_thread_numbers_are_refused(void **unused)
{
    (void)unused;
    skv_pool *pool;
    skv_error error;
    assert_int_equal(skv_pool_create(-1, &pool, &error), SKV_ERROR_VALUE);
    assert_null(pool);
    assert_non_null(strstr(error.text, "0..64"));
    assert_int_equal(skv_pool_create(65, &pool, NULL), SKV_ERROR_VALUE);
    skv_pool_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_index_runs_exactly_once),
        cmocka_unit_test(no_pool_means_the_calling_thread),
        cmocka_unit_test(bad_thread_numbers_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
