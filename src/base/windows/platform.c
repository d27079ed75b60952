/* The platform on Windows. Invariant: nothing here has a say in a result; what the environment and
 * the clock tell chooses instruction sets and fills profiles. */
#include "base/platform.h"

#include "base/memory.h"

#include <malloc.h>
#include <process.h>
#include <windows.h>

enum { MAX_CREW = 64, MAX_PROCESSORS = 256 };

struct skv_threads {
    HANDLE thread[MAX_CREW];
    struct job {
        void (*work)(void *argument);
        void *argument;
    } job[MAX_CREW];
    int count;
    SRWLOCK lock;
    CONDITION_VARIABLE changed;
    atomic_int sleepers;
};

void *skv_platform_allocate(size_t bytes)
{
    return _aligned_malloc(bytes, SKV_ALIGNMENT);
}

void skv_platform_release(void *memory)
{
    _aligned_free(memory);
}

void skv_platform_abort(const char *text, size_t length)
{
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), text, (DWORD)length, &written, NULL);
    abort();
}

double skv_clock(void)
{
    LARGE_INTEGER now, frequency;
    QueryPerformanceCounter(&now);
    QueryPerformanceFrequency(&frequency);
    return (double)now.QuadPart / (double)frequency.QuadPart;
}

int skv_platform_cores(void)
{
    SYSTEM_LOGICAL_PROCESSOR_INFORMATION facts[MAX_PROCESSORS];
    DWORD size = sizeof facts;
    int cores = 0;
    if (GetLogicalProcessorInformation(facts, &size))
        for (DWORD i = 0; i < size / sizeof facts[0]; i++)
            cores += facts[i].Relationship == RelationProcessorCore;
    return cores < 1 ? 1 : cores;
}

void skv_platform_yield(void)
{
    SwitchToThread();
}

skv_threads *skv_threads_create(void)
{
    skv_threads *threads = skv_calloc(1, sizeof *threads);
    if (threads) {
        InitializeSRWLock(&threads->lock);
        InitializeConditionVariable(&threads->changed);
    }
    return threads;
}

static unsigned __stdcall run_job(void *argument)
{
    const struct job *job = argument;
    job->work(job->argument);
    return 0;
}

bool skv_threads_start(skv_threads *threads, void (*work)(void *argument), void *argument)
{
    if (threads->count == MAX_CREW)
        return false;
    struct job *job = &threads->job[threads->count];
    *job = (struct job){work, argument};
    HANDLE thread = (HANDLE)_beginthreadex(NULL, 0, run_job, job, 0, NULL);
    if (!thread)
        return false;
    threads->thread[threads->count++] = thread;
    return true;
}

void skv_threads_join(skv_threads *threads)
{
    if (!threads)
        return;
    for (int i = 0; i < threads->count; i++) {
        WaitForSingleObject(threads->thread[i], INFINITE);
        CloseHandle(threads->thread[i]);
    }
    skv_free(threads);
}

/* A sleeper counts itself before it looks again, and who wakes looks for sleepers after the counter
 * has changed: one of the two sees the other. */
void skv_threads_sleep(skv_threads *threads, atomic_uint *counter, unsigned old)
{
    AcquireSRWLockExclusive(&threads->lock);
    atomic_fetch_add(&threads->sleepers, 1);
    while (atomic_load(counter) == old)
        SleepConditionVariableSRW(&threads->changed, &threads->lock, INFINITE, 0);
    atomic_fetch_sub(&threads->sleepers, 1);
    ReleaseSRWLockExclusive(&threads->lock);
}

void skv_threads_wake(skv_threads *threads)
{
    if (atomic_load(&threads->sleepers) == 0)
        return;
    AcquireSRWLockExclusive(&threads->lock);
    WakeAllConditionVariable(&threads->changed);
    ReleaseSRWLockExclusive(&threads->lock);
}
