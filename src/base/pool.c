/* A pool of persistent threads for short phases.
 *
 * Invariant: between two calls of skv_pool_run no worker touches anything but the pool. A run is
 * announced by raising `generation`; every worker takes chunks from `next` until none is left and
 * then counts itself in `finished`. Workers and caller spin briefly before they sleep, because a
 * phase takes tens of microseconds and a sleep costs as much, but spinning beside a busy process
 * would cost a whole time slice.
 */
#include "base/pool.h"

#include "base/assert.h"
#include "base/memory.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <unistd.h>

enum { CHUNK = 128, SPINS = 2000, MAX_THREADS = 64 };

struct skv_pool {
    int threads;
    pthread_t worker[MAX_THREADS];
    pthread_mutex_t mutex;
    pthread_cond_t work, done;
    atomic_uint generation;
    atomic_int next;
    atomic_int finished;
    bool quit;
    int count;
    skv_task *task;
    void *context;
};

static void relax_cpu(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

static void take_chunks(skv_pool *pool)
{
    for (;;) {
        int begin = atomic_fetch_add(&pool->next, CHUNK);
        if (begin >= pool->count)
            return;
        int end = begin + CHUNK < pool->count ? begin + CHUNK : pool->count;
        pool->task(begin, end, pool->context);
    }
}

static unsigned wait_for_work(skv_pool *pool, unsigned seen)
{
    for (int i = 0; i < SPINS; i++) {
        if (atomic_load(&pool->generation) != seen)
            return atomic_load(&pool->generation);
        relax_cpu();
    }
    pthread_mutex_lock(&pool->mutex);
    while (atomic_load(&pool->generation) == seen)
        pthread_cond_wait(&pool->work, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
    return atomic_load(&pool->generation);
}

static void *worker_main(void *argument)
{
    skv_pool *pool = argument;
    unsigned seen = 0;
    for (;;) {
        seen = wait_for_work(pool, seen);
        if (pool->quit)
            return NULL;
        take_chunks(pool);
        if (atomic_fetch_add(&pool->finished, 1) == pool->threads - 2) {
            pthread_mutex_lock(&pool->mutex);
            pthread_cond_signal(&pool->done);
            pthread_mutex_unlock(&pool->mutex);
        }
    }
}

static void announce(skv_pool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    atomic_fetch_add(&pool->generation, 1);
    pthread_cond_broadcast(&pool->work);
    pthread_mutex_unlock(&pool->mutex);
}

/* One per physical core: a core's first hardware thread is the one that heads its sibling list. */
static int physical_cores(void)
{
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    int cores = 0;
    for (int cpu = 0; cpu < online; cpu++) {
        char path[96];
        snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu%d/topology/thread_siblings_list",
                 cpu);
        FILE *file = fopen(path, "r");
        int first = cpu;
        if (file) {
            if (fscanf(file, "%d", &first) != 1)
                first = cpu;
            fclose(file);
        }
        cores += first == cpu;
    }
    return cores < 1 ? 1 : cores > MAX_THREADS ? MAX_THREADS : cores;
}

skv_result skv_pool_create(int threads, skv_pool **out, skv_error *error)
{
    *out = NULL;
    if (threads < 0 || threads > MAX_THREADS)
        return skv_fail(error, SKV_ERROR_VALUE, "threads: %d is out of range; allowed is 0..%d",
                        threads, MAX_THREADS);
    skv_pool *pool = skv_calloc(1, sizeof *pool);
    if (!pool)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the task pool");
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_cond_init(&pool->work, NULL);
    pthread_cond_init(&pool->done, NULL);
    int wanted = threads ? threads : physical_cores();
    pool->threads = wanted;
    for (int i = 0; i < wanted - 1; i++) {
        if (pthread_create(&pool->worker[i], NULL, worker_main, pool)) {
            /* Workers compare with pool->threads only after a run was announced. */
            pool->threads = i + 1;
            skv_pool_destroy(pool);
            return skv_fail(error, SKV_ERROR_LIMIT,
                            "the system refused to start thread %d of %d; use fewer threads", i + 2,
                            wanted);
        }
    }
    *out = pool;
    return SKV_OK;
}

void skv_pool_destroy(skv_pool *pool)
{
    if (!pool)
        return;
    pool->quit = true;
    announce(pool);
    for (int i = 0; i < pool->threads - 1; i++)
        pthread_join(pool->worker[i], NULL);
    pthread_cond_destroy(&pool->done);
    pthread_cond_destroy(&pool->work);
    pthread_mutex_destroy(&pool->mutex);
    skv_free(pool);
}

int skv_pool_threads(const skv_pool *pool)
{
    return pool->threads;
}

void skv_pool_run(skv_pool *pool, int count, skv_task *task, void *context)
{
    if (!pool || pool->threads == 1 || count <= CHUNK) {
        if (count > 0)
            task(0, count, context);
        return;
    }
    pool->count = count;
    pool->task = task;
    pool->context = context;
    atomic_store(&pool->next, 0);
    atomic_store(&pool->finished, 0);
    announce(pool);
    take_chunks(pool);
    int others = pool->threads - 1;
    for (int i = 0; i < SPINS; i++) {
        if (atomic_load(&pool->finished) == others)
            return;
        relax_cpu();
    }
    pthread_mutex_lock(&pool->mutex);
    while (atomic_load(&pool->finished) != others)
        pthread_cond_wait(&pool->done, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
}
