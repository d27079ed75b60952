/* The allocator hooks. Invariant: what skv_calloc returns is zeroed, and all is cache-line aligned.
 */
#include "base/memory.h"

#include "base/platform.h"

#include <string.h>

/* Only skv_malloc calls it, and always asks for SKV_ALIGNMENT. */
static void *default_allocate(size_t bytes, size_t alignment, void *user)
{
    (void)alignment;
    (void)user;
    return skv_platform_allocate(bytes);
}

static void default_release(void *memory, void *user)
{
    (void)user;
    skv_platform_release(memory);
}

static const skv_allocator default_allocator = {default_allocate, default_release, NULL};
static skv_allocator current = {default_allocate, default_release, NULL};

void skv_set_allocator(const skv_allocator *allocator)
{
    current = allocator ? *allocator : default_allocator;
}

void *skv_malloc(size_t count, size_t size)
{
    size_t bytes = count * size;
    if (size && bytes / size != count)
        return NULL;
    return current.allocate(bytes ? bytes : 1, SKV_ALIGNMENT, current.user);
}

void *skv_calloc(size_t count, size_t size)
{
    void *memory = skv_malloc(count, size);
    if (memory)
        memset(memory, 0, count * size);
    return memory;
}

void skv_free(void *memory)
{
    if (memory)
        current.release(memory, current.user);
}
