/* The task pool: every index once, for any number of threads, thousands of short runs in a row,
 * on its own threads and on those that a host lends; and no thread of its own takes a host's
 * signal. */
#include "base/pool.h"
#include "support/host.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

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

/* Hosts: each calls `member` in its own way. `user` is the number of threads that it has. */

static void run_on_threads(void *user, int count, void (*member)(void *team), void *team)
{
    int threads = *(int *)user < count ? *(int *)user : count;
    host_run(threads, member, team);
}

static void run_one_by_one(void *user, int count, void (*member)(void *team), void *team)
{
    for (int i = 0; i < count && i < *(int *)user; i++)
        member(team);
}

static void check_lent(const skv_task_system *tasks)
{
    skv_pool *pool;
    assert_int_equal(skv_pool_create_lent(tasks, &pool, NULL), SKV_OK);
    assert_int_equal(skv_pool_threads(pool), tasks->threads);
    memset(touched, 0, sizeof touched);
    int one = 1, rounds = 30;
    for (int round = 0; round < rounds; round++)
        skv_pool_run(pool, MOST, touch, &one);
    for (int i = 0; i < MOST; i++)
        assert_int_equal(touched[i], rounds);
    skv_pool_destroy(pool);
}

static void a_host_may_lend_as_many_threads_as_it_has(void **unused)
{
    (void)unused;
    for (int asked = 1; asked <= 4; asked++) {
        for (int has = 0; has <= 4; has++) {
            check_lent(&(skv_task_system){asked, run_on_threads, &has});
            check_lent(&(skv_task_system){asked, run_one_by_one, &has});
        }
    }
}

/* Who comes when a team is complete has no part in it, not even a late one's. */

typedef struct roll {
    int calls;
    int most; /* threads that a member was told of */
} roll;

static void answer(int thread, int threads, void *context)
{
    roll *r = context;
    assert_true(thread >= 0 && thread < threads);
    r->calls++;
    r->most = threads > r->most ? threads : r->most;
}

static void late_threads_find_the_door_closed(void **unused)
{
    (void)unused;
    int has = 4;
    const skv_task_system lent = {4, run_one_by_one, &has};
    skv_pool *pool;
    assert_int_equal(skv_pool_create_lent(&lent, &pool, NULL), SKV_OK);
    for (int team = 0; team < 5; team++) {
        roll r = {0};
        skv_pool_team(pool, answer, &r);
        assert_int_equal(r.calls, 1);
        assert_int_equal(r.most, 1);
    }
    skv_pool_destroy(pool);
}

/* All members of a team meet, as often as they like. */

typedef struct meeting {
    skv_pool *pool;
    atomic_int here;
    int most;
} meeting;

static void meet(int thread, int threads, void *context)
{
    meeting *m = context;
    for (int round = 1; round <= 1000; round++) {
        atomic_fetch_add(&m->here, 1);
        skv_pool_barrier(m->pool);
        if (atomic_load(&m->here) != round * threads)
            m->most = -1000;
        skv_pool_barrier(m->pool);
    }
    if (thread == 0 && m->most >= 0)
        m->most = threads > m->most ? threads : m->most;
}

static void members_meet_at_barriers(void **unused)
{
    (void)unused;
    int has = 3;
    const skv_task_system lent = {3, run_on_threads, &has};
    for (int own = 0; own < 2; own++) {
        meeting m = {0};
        assert_int_equal(own ? skv_pool_create(3, &m.pool, NULL)
                             : skv_pool_create_lent(&lent, &m.pool, NULL),
                         SKV_OK);
        for (int i = 0; i < 20; i++) {
            atomic_store(&m.here, 0);
            skv_pool_team(m.pool, meet, &m);
        }
        assert_in_range(m.most, own ? 3 : 1, 3);
        skv_pool_destroy(m.pool);
    }
}

/* At a gathering one member works, when all have come and before any goes on. */

typedef struct gathering {
    skv_pool *pool;
    atomic_int here;
    int threads, works;
    bool early;
} gathering;

static void work_for_all(void *context)
{
    gathering *g = context;
    g->works++;
    g->early = g->early || atomic_load(&g->here) != g->works * g->threads;
}

static void gather(int thread, int threads, void *context)
{
    gathering *g = context;
    if (thread == 0)
        g->threads = threads;
    skv_pool_barrier(g->pool);
    for (int round = 1; round <= 1000; round++) {
        atomic_fetch_add(&g->here, 1);
        skv_pool_gather(g->pool, work_for_all, g);
        if (g->works != round)
            atomic_store(&g->here, -1000000);
        skv_pool_barrier(g->pool);
    }
}

/* Neighbours keep step with each other without barriers: nobody is ever two rounds ahead. */

enum { MOST_MEMBERS = 4 };

typedef struct march {
    skv_pool *pool;
    skv_progress progress[MOST_MEMBERS];
    int written[MOST_MEMBERS];
    atomic_int wrong;
} march;

static void keep_step(int thread, int threads, void *context)
{
    march *m = context;
    for (int round = 1; round <= 1000; round++) {
        m->written[thread] = round;
        skv_pool_reach(m->pool, &m->progress[thread], 2 * (unsigned)round - 1);
        for (int beside = thread - 1; beside <= thread + 1; beside += 2) {
            if (beside < 0 || beside >= threads)
                continue;
            skv_pool_await(m->pool, &m->progress[beside], 2 * (unsigned)round - 1);
            if (m->written[beside] != round)
                atomic_fetch_add(&m->wrong, 1);
        }
        skv_pool_reach(m->pool, &m->progress[thread], 2 * (unsigned)round);
        for (int beside = thread - 1; beside <= thread + 1; beside += 2)
            if (beside >= 0 && beside < threads)
                skv_pool_await(m->pool, &m->progress[beside], 2 * (unsigned)round);
    }
}

static void members_gather_and_wait_for_each_other(void **unused)
{
    (void)unused;
    for (int threads = 1; threads <= MOST_MEMBERS; threads++) {
        gathering g = {0};
        march m = {0};
        assert_int_equal(skv_pool_create(threads, &g.pool, NULL), SKV_OK);
        skv_pool_team(g.pool, gather, &g);
        assert_int_equal(g.works, 1000);
        assert_int_equal(atomic_load(&g.here), 1000 * threads);
        assert_false(g.early);
        m.pool = g.pool;
        skv_pool_team(m.pool, keep_step, &m);
        assert_int_equal(atomic_load(&m.wrong), 0);
        skv_pool_destroy(g.pool);
    }
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
    const skv_task_system none = {0, run_one_by_one, NULL};
    assert_int_equal(skv_pool_create_lent(&none, &pool, &error), SKV_ERROR_VALUE);
    assert_null(pool);
    assert_non_null(strstr(error.text, "1..64"));
}

static volatile sig_atomic_t handled;

static void note_signal(int unused)
{
    (void)unused;
    handled = 1;
}

/* A signal that the host holds back, as the program does while it starts ffmpeg, waits for the host
 * instead of running its handler on a thread of the pool. */
static void signals_wait_for_the_host(void **unused)
{
    (void)unused;
    skv_pool *pool;
    sigset_t held, before;
    int one = 1;
    struct sigaction noting = {.sa_handler = note_signal}, old;
    assert_int_equal(skv_pool_create(4, &pool, NULL), SKV_OK);
    skv_pool_run(pool, MOST, touch, &one);
    assert_int_equal(sigaction(SIGTERM, &noting, &old), 0);
    sigemptyset(&held);
    sigaddset(&held, SIGTERM);
    assert_int_equal(pthread_sigmask(SIG_BLOCK, &held, &before), 0);
    assert_int_equal(kill(getpid(), SIGTERM), 0);
    for (int round = 0; round < 100; round++)
        skv_pool_run(pool, MOST, touch, &one);
    assert_int_equal(handled, 0);
    assert_int_equal(pthread_sigmask(SIG_SETMASK, &before, NULL), 0);
    assert_int_equal(handled, 1);
    assert_int_equal(sigaction(SIGTERM, &old, NULL), 0);
    skv_pool_destroy(pool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_index_runs_exactly_once),
        cmocka_unit_test(no_pool_means_the_calling_thread),
        cmocka_unit_test(a_host_may_lend_as_many_threads_as_it_has),
        cmocka_unit_test(late_threads_find_the_door_closed),
        cmocka_unit_test(members_meet_at_barriers),
        cmocka_unit_test(members_gather_and_wait_for_each_other),
        cmocka_unit_test(bad_thread_numbers_are_refused),
        cmocka_unit_test(signals_wait_for_the_host),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
