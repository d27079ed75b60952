/* Threads on Linux and other POSIX systems. Invariants: a thread sleeps only while it counts among
 * the sleepers, so that waking costs next to nothing when nobody sleeps; a host's signals come to
 * threads of the host only, which may so hold them back. */
#include "base/memory.h"
#include "base/platform.h"

#include <pthread.h>
#include <signal.h>

enum { MOST_THREADS = 64 };

struct skv_threads {
    pthread_t thread[MOST_THREADS];
    struct job {
        void (*work)(void *argument);
        void *argument;
    } job[MOST_THREADS];
    int count;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    atomic_int sleepers;
};

skv_threads *skv_threads_create(void)
{
    skv_threads *threads = skv_calloc(1, sizeof *threads);
    if (threads) {
        pthread_mutex_init(&threads->mutex, NULL);
        pthread_cond_init(&threads->changed, NULL);
    }
    return threads;
}

static void *run_job(void *argument)
{
    const struct job *job = argument;
    job->work(job->argument);
    return NULL;
}

/* What a thread brings on itself stays open: a debugger or a host's crash handler waits for it. */
static void block_signals_from_outside(sigset_t *before)
{
    static const int from_inside[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, SIGABRT};
    sigset_t outside;
    sigfillset(&outside);
    for (size_t i = 0; i < sizeof from_inside / sizeof from_inside[0]; i++)
        sigdelset(&outside, from_inside[i]);
    pthread_sigmask(SIG_BLOCK, &outside, before);
}

bool skv_threads_start(skv_threads *threads, void (*work)(void *argument), void *argument)
{
    if (threads->count == MOST_THREADS)
        return false;
    struct job *job = &threads->job[threads->count];
    *job = (struct job){work, argument};
    sigset_t before;
    block_signals_from_outside(&before); /* a thread begins with its creator's mask */
    bool started = pthread_create(&threads->thread[threads->count], NULL, run_job, job) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    threads->count += started;
    return started;
}

void skv_threads_join(skv_threads *threads)
{
    if (!threads)
        return;
    for (int i = 0; i < threads->count; i++)
        pthread_join(threads->thread[i], NULL);
    pthread_cond_destroy(&threads->changed);
    pthread_mutex_destroy(&threads->mutex);
    skv_free(threads);
}

/* A sleeper counts itself before it looks again, and who wakes looks for sleepers after the counter
 * has changed: one of the two sees the other. */
void skv_threads_sleep(skv_threads *threads, atomic_uint *counter, unsigned old)
{
    pthread_mutex_lock(&threads->mutex);
    atomic_fetch_add(&threads->sleepers, 1);
    while (atomic_load(counter) == old)
        pthread_cond_wait(&threads->changed, &threads->mutex);
    atomic_fetch_sub(&threads->sleepers, 1);
    pthread_mutex_unlock(&threads->mutex);
}

void skv_threads_wake(skv_threads *threads)
{
    if (atomic_load(&threads->sleepers) == 0)
        return;
    pthread_mutex_lock(&threads->mutex);
    pthread_cond_broadcast(&threads->changed);
    pthread_mutex_unlock(&threads->mutex);
}
