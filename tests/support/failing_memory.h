/* An allocator that counts and can be told to fail, to show that nothing leaks. */
#ifndef SKV_TESTS_SUPPORT_FAILING_MEMORY_H
#define SKV_TESTS_SUPPORT_FAILING_MEMORY_H

#include <stddef.h>

typedef struct failing_memory {
    int calls;      /* allocations asked for */
    int fail_at;    /* the number, from 0, of the one that fails; -1: none */
    int live;       /* blocks not yet released */
    size_t largest; /* bytes */
} failing_memory;

/* Puts the allocator in place, its counts at zero; end with failing_memory_stop. */
void failing_memory_start(failing_memory *memory, int fail_at);
void failing_memory_stop(void);

#endif
