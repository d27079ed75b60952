/* The platform on Linux and other POSIX systems. Invariant: nothing here has a say in a result;
 * what the environment and the clock tell chooses instruction sets and fills profiles. */
#include "base/platform.h"

#include "base/memory.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

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
