/* A pool of persistent threads, or of threads that a host lends, for short phases.
 *
 * Invariant: a team's members run at the same time, each on a thread of its own, and between two
 * teams no worker touches anything but the pool. A team is announced by raising `generation`;
 * members meet by raising `phase`, or wait for each other's progress. Whoever waits for one of
 * these counters spins before it sleeps: a phase takes tens of microseconds and a sleep costs as
 * much, but spinning or yielding beside a busy process costs whole time slices. So a member spins
 * the longer the more often that has helped, and briefly again once it has not
 * (docs/notebook/2026-11-21-the-shape-of-the-solver.md).
 */
#include "base/pool.h"

#include "base/assert.h"
#include "base/memory.h"
#include "base/platform.h"

/* Turns of spinning, about 40 ns each: the fewest, the most, and how many more after a success. */
enum { SPINS = 400, MOST_SPINS = 4000, MORE_SPINS = 64 };
/* How long the first of the lent threads waits for the others, in turns. */
enum { GATHERING = 2500 };
/* The state of `joined`: the number of threads that have come in, and this once the team is
 * complete. */
#define CLOSED 0x80000000u

enum { CHUNK = 128, MAX_THREADS = 64 };

/* What a worker is started with. */
typedef struct start {
    skv_pool *pool;
    int thread;
} start;

struct skv_pool {
    int threads;          /* the most of a team */
    int size;             /* of the running team */
    skv_task_system lent; /* run null: own threads */
    atomic_uint joined;   /* of lent threads' teams */
    skv_threads *workers;
    start starts[MAX_THREADS];
    atomic_uint generation; /* raised to start a team */
    atomic_uint phase;      /* raised when all members have reached a barrier */
    atomic_int arrived;
    atomic_int patience; /* turns to spin at a barrier; a hint, so races do no harm */
    bool quit;
    skv_stop *stop; /* null: nobody is asked */
    void *stop_user;
    bool stopped; /* the work that runs */
    skv_member *member;
    void *context;
};

/* A turn of spinning: what the numbers above count. */
static void relax_cpu(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    /* "yield" does nothing on most processors; this lets the pipeline run dry. */
    __asm__ volatile("isb" ::: "memory");
#elif defined(__wasm__)
    /* There is no such instruction, and a turn without one lasts a nanosecond. */
    for (int i = 0; i < 256; i++)
        __asm__ volatile("");
#endif
}

static void pause_or_yield(int *turns)
{
    if (++*turns < SPINS)
        relax_cpu();
    else
        skv_platform_yield();
}

/* Spins until a counter has left `old`; false if it has not after so many turns. */
static bool spin(atomic_uint *counter, unsigned old, int most)
{
    for (int turns = 0; turns < most; turns++) {
        if (atomic_load_explicit(counter, memory_order_acquire) != old)
            return true;
        relax_cpu();
    }
    return false;
}

static void count_on(skv_pool *pool, atomic_uint *counter)
{
    atomic_fetch_add(counter, 1);
    skv_threads_wake(pool->workers);
}

/* Waits until a counter has left `old`, spinning for as long as that is likely to help. */
static void wait_for_change(skv_pool *pool, atomic_uint *counter, unsigned old)
{
    int patience = atomic_load_explicit(&pool->patience, memory_order_relaxed);
    int next = SPINS;
    if (spin(counter, old, patience))
        next = patience + MORE_SPINS < MOST_SPINS ? patience + MORE_SPINS : MOST_SPINS;
    else
        skv_threads_sleep(pool->workers, counter, old);
    if (next != patience)
        atomic_store_explicit(&pool->patience, next, memory_order_relaxed);
}

void skv_pool_set_stop(skv_pool *pool, skv_stop *stop, void *user)
{
    SKV_ASSERT(pool);
    pool->stop = stop;
    pool->stop_user = user;
}

void skv_pool_go(skv_pool *pool)
{
    if (pool)
        pool->stopped = false;
}

bool skv_pool_asks_to_stop(skv_pool *pool)
{
    if (pool && pool->stop && !pool->stopped)
        pool->stopped = pool->stop(pool->stop_user);
    return skv_pool_is_stopped(pool);
}

bool skv_pool_is_stopped(const skv_pool *pool)
{
    return pool && pool->stopped;
}

void skv_pool_gather(skv_pool *pool, void (*work)(void *context), void *context)
{
    bool alone = !pool || pool->size == 1;
    unsigned phase = alone ? 0 : atomic_load(&pool->phase);
    if (!alone && atomic_fetch_add(&pool->arrived, 1) < pool->size - 1) {
        wait_for_change(pool, &pool->phase, phase);
        return;
    }
    if (work)
        work(context);
    if (alone)
        return;
    atomic_store(&pool->arrived, 0);
    count_on(pool, &pool->phase);
}

void skv_pool_barrier(skv_pool *pool)
{
    skv_pool_gather(pool, NULL, NULL);
}

void skv_pool_reach(skv_pool *pool, skv_progress *own, unsigned reached)
{
    if (!pool || pool->size == 1)
        return;
    atomic_store(&own->reached, reached);
    skv_threads_wake(pool->workers);
}

void skv_pool_await(skv_pool *pool, skv_progress *other, unsigned reached)
{
    for (;;) {
        unsigned now = atomic_load_explicit(&other->reached, memory_order_acquire);
        if (now >= reached)
            return;
        wait_for_change(pool, &other->reached, now);
    }
}

static void worker_main(void *argument)
{
    const start *own = argument;
    skv_pool *pool = own->pool;
    for (unsigned seen = 0;; seen++) {
        if (!spin(&pool->generation, seen, SPINS))
            skv_threads_sleep(pool->workers, &pool->generation, seen);
        if (pool->quit)
            return;
        pool->member(own->thread, pool->size, pool->context);
        skv_pool_barrier(pool);
    }
}

/* A pool of so many threads, none of them started; null if memory is out. */
static skv_pool *make_pool(int threads, skv_error *error)
{
    skv_pool *pool = skv_calloc(1, sizeof *pool);
    skv_threads *workers = skv_threads_create();
    if (!pool || !workers) {
        skv_threads_join(workers);
        skv_free(pool);
        skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the task pool");
        return NULL;
    }
    pool->workers = workers;
    pool->threads = pool->size = threads;
    atomic_init(&pool->patience, SPINS);
    return pool;
}

skv_result skv_pool_create(int threads, skv_pool **out, skv_error *error)
{
    *out = NULL;
    if (threads < 0 || threads > MAX_THREADS)
        return skv_fail(error, SKV_ERROR_VALUE, "threads: %d is out of range; allowed is 0..%d",
                        threads, MAX_THREADS);
    int cores = skv_platform_cores();
    int wanted = threads ? threads : cores < MAX_THREADS ? cores : MAX_THREADS;
    skv_pool *pool = make_pool(wanted, error);
    if (!pool)
        return SKV_ERROR_MEMORY;
    for (int i = 1; i < wanted; i++) {
        pool->starts[i] = (start){pool, i};
        if (!skv_threads_start(pool->workers, worker_main, &pool->starts[i])) {
            skv_pool_destroy(pool);
            return skv_fail(error, SKV_ERROR_LIMIT,
                            "the system refused to start thread %d of %d; use fewer threads", i + 1,
                            wanted);
        }
    }
    *out = pool;
    return SKV_OK;
}

skv_result skv_pool_create_lent(const skv_task_system *tasks, skv_pool **out, skv_error *error)
{
    *out = NULL;
    if (tasks->threads < 1 || tasks->threads > MAX_THREADS)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "tasks.threads: %d is out of range; allowed is 1..%d", tasks->threads,
                        MAX_THREADS);
    skv_pool *pool = make_pool(tasks->threads, error);
    if (!pool)
        return SKV_ERROR_MEMORY;
    pool->lent = *tasks;
    *out = pool;
    return SKV_OK;
}

void skv_pool_destroy(skv_pool *pool)
{
    if (!pool)
        return;
    pool->quit = true;
    count_on(pool, &pool->generation);
    skv_threads_join(pool->workers);
    skv_free(pool);
}

int skv_pool_threads(const skv_pool *pool)
{
    return pool ? pool->threads : 1;
}

/* Takes a place in the team that is gathering: its index, or -1 if the team is complete. */
static int join(skv_pool *pool)
{
    unsigned joined = atomic_load(&pool->joined);
    while (!(joined & CLOSED) && joined < (unsigned)pool->threads)
        if (atomic_compare_exchange_weak(&pool->joined, &joined, joined + 1))
            return (int)joined;
    return -1;
}

/* What a lent thread runs. */
static void enter(void *team)
{
    skv_pool *pool = team;
    int thread = join(pool);
    if (thread < 0)
        return;
    if (thread == 0) {
        for (int t = 0; t < GATHERING && atomic_load(&pool->joined) < (unsigned)pool->threads; t++)
            relax_cpu();
        unsigned joined = atomic_load(&pool->joined);
        do
            pool->size = (int)joined;
        while (!atomic_compare_exchange_weak(&pool->joined, &joined, joined | CLOSED));
    }
    for (int turns = 0; !(atomic_load(&pool->joined) & CLOSED);)
        pause_or_yield(&turns);
    pool->member(thread, pool->size, pool->context);
}

void skv_pool_team(skv_pool *pool, skv_member *member, void *context)
{
    if (!pool || pool->threads == 1) {
        member(0, 1, context);
        return;
    }
    pool->member = member;
    pool->context = context;
    if (pool->lent.run) {
        atomic_store(&pool->joined, 0);
        pool->lent.run(pool->lent.user, pool->threads, enter, pool);
        /* Does the work if the host has called nobody; else the team is closed. */
        enter(pool);
        return;
    }
    count_on(pool, &pool->generation);
    member(0, pool->size, context);
    skv_pool_barrier(pool);
}

/* A range of indices that a team shares out in chunks. */
typedef struct range {
    atomic_int next;
    int count;
    skv_task *task;
    void *context;
} range;

static void take_chunks(int thread, int threads, void *context)
{
    (void)thread;
    (void)threads;
    range *r = context;
    for (;;) {
        int begin = atomic_fetch_add(&r->next, CHUNK);
        if (begin >= r->count)
            return;
        r->task(begin, begin + CHUNK < r->count ? begin + CHUNK : r->count, r->context);
    }
}

void skv_pool_run(skv_pool *pool, int count, skv_task *task, void *context)
{
    if (!pool || pool->threads == 1 || count <= CHUNK) {
        if (count > 0)
            task(0, count, context);
        return;
    }
    range shared = {0, count, task, context};
    skv_pool_team(pool, take_chunks, &shared);
}
