/* The platform on Linux and other POSIX systems. Invariant: nothing here has a say in a result;
 * what the environment and the clock tell chooses instruction sets and fills profiles. */
#include "base/platform.h"

#include "base/memory.h"

#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { MAX_CREW = 64 };

struct skv_threads {
    pthread_t thread[MAX_CREW];
    struct job {
        void (*work)(void *argument);
        void *argument;
    } job[MAX_CREW];
    int count;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    atomic_int sleepers;
};

void *skv_platform_allocate(size_t bytes)
{
    /* aligned_alloc wants a multiple of the alignment. */
    size_t rounded = (bytes + SKV_ALIGNMENT - 1) & ~(size_t)(SKV_ALIGNMENT - 1);
    return rounded < bytes ? NULL : aligned_alloc(SKV_ALIGNMENT, rounded);
}

void skv_platform_release(void *memory)
{
    free(memory);
}

void skv_platform_abort(void)
{
    abort();
}

double skv_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

const char *skv_platform_variable(const char *name)
{
    return getenv(name);
}

/* A core's first hardware thread is the one that heads its sibling list. */
int skv_platform_cores(void)
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
    return cores < 1 ? 1 : cores;
}

void skv_platform_yield(void)
{
    sched_yield();
}

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

bool skv_threads_start(skv_threads *threads, void (*work)(void *argument), void *argument)
{
    if (threads->count == MAX_CREW)
        return false;
    struct job *job = &threads->job[threads->count];
    *job = (struct job){work, argument};
    if (pthread_create(&threads->thread[threads->count], NULL, run_job, job))
        return false;
    threads->count++;
    return true;
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
