/* The platform on Linux and other POSIX systems. Invariant: nothing here has a say in a result;
 * what the environment and the clock tell chooses instruction sets and fills profiles. */
#define _DEFAULT_SOURCE 1 /* madvise */
#include "base/platform.h"

#include "base/memory.h"

#include <sched.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

/* Bytes of a large page on most processors: 512 small ones, of which each costs a fault. */
#define LARGE_PAGE ((size_t)2 << 20)

/* What has room for a large page asks for them: a sixth of a large world's start is faults. */
void *skv_platform_allocate(size_t bytes)
{
    size_t alignment = bytes < LARGE_PAGE ? SKV_ALIGNMENT : LARGE_PAGE;
    void *memory;
    if (bytes > PTRDIFF_MAX || posix_memalign(&memory, alignment, bytes)) /* no object is larger */
        return NULL;
#ifdef MADV_HUGEPAGE
    if (alignment == LARGE_PAGE)
        madvise(memory, bytes & ~(LARGE_PAGE - 1), MADV_HUGEPAGE); /* or it stays as it is */
#endif
    return memory;
}

void skv_platform_release(void *memory)
{
    free(memory);
}

void skv_platform_abort(const char *text, size_t length)
{
    while (length > 0) {
        ssize_t written = write(STDERR_FILENO, text, length);
        if (written <= 0)
            break;
        text += written;
        length -= (size_t)written;
    }
    abort();
}

double skv_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
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
