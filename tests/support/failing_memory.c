/* The counting, failing allocator. */
#include "support/failing_memory.h"

#include "skvalp/base.h"

#include <stdint.h>
#include <stdlib.h>

static void *allocate(size_t bytes, size_t alignment, void *user)
{
    failing_memory *m = user;
    m->largest = bytes > m->largest ? bytes : m->largest;
    /* More than half of all addresses no system gives; sanitizers would stop at the question. */
    if (m->calls++ == m->fail_at || bytes > PTRDIFF_MAX)
        return NULL;
    m->live++;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void release(void *block, void *user)
{
    failing_memory *m = user;
    m->live--;
    free(block);
}

void failing_memory_start(failing_memory *memory, int fail_at)
{
    *memory = (failing_memory){.fail_at = fail_at};
    const skv_allocator allocator = {allocate, release, memory};
    skv_set_allocator(&allocator);
}

void failing_memory_stop(void)
{
    skv_set_allocator(NULL);
}
