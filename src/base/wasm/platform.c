/* The platform in WebAssembly: no C library, no clock, no environment.
 *
 * Memory lies from the end of the static data to the end of the linear memory, which grows. It is
 * cut into blocks, each with a header of one alignment before it; free ones are in a list by
 * address. Invariant: no two free blocks touch. Memory is asked for by one thread at a time.
 */
#include "base/platform.h"

#include "base/memory.h"
#include "base/wasm/host.h"

#include <stdint.h>
#include <string.h>

enum { PAGE = 65536 };

typedef struct block {
    size_t size; /* header included, a multiple of SKV_ALIGNMENT */
    struct block *next;
} block;

_Static_assert(sizeof(block) <= SKV_ALIGNMENT, "a header fits before aligned memory");

/* Where the linker has put the end of the static data. */
extern unsigned char __heap_base;

static block *free_list;
static uintptr_t heap_end; /* of what has been handed to the list so far */

/* Puts a block into the list and joins it with its neighbours. */
static void give(block *b)
{
    block *before = NULL, **link = &free_list;
    while (*link && *link < b) {
        before = *link;
        link = &before->next;
    }
    b->next = *link;
    *link = b;
    if (b->next && (char *)b + b->size == (char *)b->next) {
        b->size += b->next->size;
        b->next = b->next->next;
    }
    if (before && (char *)before + before->size == (char *)b) {
        before->size += b->size;
        before->next = b->next;
    }
}

/* The first free block that is large enough, cut to size; null if there is none. */
static block *take(size_t size)
{
    for (block **link = &free_list; *link; link = &(*link)->next) {
        block *b = *link;
        if (b->size < size)
            continue;
        if (b->size > size) {
            block *rest = (block *)(void *)((char *)b + size);
            *rest = (block){b->size - size, b->next};
            *link = rest;
            b->size = size;
        } else {
            *link = b->next;
        }
        return b;
    }
    return NULL;
}

/* Hands `size` more bytes to the list: first what is left of the memory that there is. */
static bool grow(size_t size)
{
    uintptr_t begin = heap_end;
    if (begin == 0)
        begin = ((uintptr_t)&__heap_base + SKV_ALIGNMENT - 1) & ~(uintptr_t)(SKV_ALIGNMENT - 1);
    uintptr_t end = (uintptr_t)__builtin_wasm_memory_size(0) * PAGE;
    if (end - begin < size) {
        size_t pages = (size - (end - begin) + PAGE - 1) / PAGE;
        if (__builtin_wasm_memory_grow(0, pages) == SIZE_MAX)
            return false;
        end += pages * PAGE;
    }
    /* The very last block of the address space would end at 0. */
    heap_end = end ? end : begin + size;
    block *b = (block *)begin;
    *b = (block){heap_end - begin, NULL};
    give(b);
    return true;
}

void *skv_platform_allocate(size_t bytes)
{
    size_t size = ((bytes + SKV_ALIGNMENT - 1) & ~(size_t)(SKV_ALIGNMENT - 1)) + SKV_ALIGNMENT;
    if (size < bytes)
        return NULL;
    block *b = take(size);
    if (!b && grow(size))
        b = take(size);
    return b ? (char *)b + SKV_ALIGNMENT : NULL;
}

void skv_platform_release(void *memory)
{
    if (memory)
        give((block *)(void *)((char *)memory - SKV_ALIGNMENT));
}

/* Memory for what the host has to hand over. */
SKV_EXPORT(skv_wasm_allocate) void *skv_wasm_allocate(size_t bytes);
SKV_EXPORT(skv_wasm_release) void skv_wasm_release(void *memory);

void *skv_wasm_allocate(size_t bytes)
{
    return skv_platform_allocate(bytes);
}

void skv_wasm_release(void *memory)
{
    skv_platform_release(memory);
}

void skv_platform_abort(const char *text, size_t length)
{
    (void)text;
    (void)length;
    __builtin_trap();
}

double skv_clock(void)
{
    return 0;
}

/* <string.h>: the compiler calls the first four by itself. no_builtin, or it would turn the loops
 * into calls of themselves. */
__attribute__((no_builtin)) void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    for (size_t i = 0; i < size; i++)
        ((char *)to)[i] = ((const char *)from)[i];
    return to;
}

__attribute__((no_builtin)) void *memmove(void *to, const void *from, size_t size)
{
    if ((uintptr_t)to <= (uintptr_t)from) {
        for (size_t i = 0; i < size; i++)
            ((char *)to)[i] = ((const char *)from)[i];
    } else {
        for (size_t i = size; i > 0; i--)
            ((char *)to)[i - 1] = ((const char *)from)[i - 1];
    }
    return to;
}

__attribute__((no_builtin)) void *memset(void *memory, int value, size_t size)
{
    for (size_t i = 0; i < size; i++)
        ((unsigned char *)memory)[i] = (unsigned char)value;
    return memory;
}

__attribute__((no_builtin)) int memcmp(const void *a, const void *b, size_t size)
{
    const unsigned char *p = a, *q = b;
    for (size_t i = 0; i < size; i++)
        if (p[i] != q[i])
            return p[i] - q[i];
    return 0;
}

__attribute__((no_builtin)) void *memchr(const void *memory, int value, size_t size)
{
    const unsigned char *p = memory;
    for (size_t i = 0; i < size; i++)
        if (p[i] == (unsigned char)value)
            return (void *)(uintptr_t)(p + i);
    return NULL;
}

__attribute__((no_builtin)) int strcmp(const char *a, const char *b)
{
    while (*a && *a == *b) {
        a++;
        b++;
    }
    return (unsigned char)*a - (unsigned char)*b;
}

__attribute__((no_builtin)) size_t strlen(const char *text)
{
    size_t length = 0;
    while (text[length])
        length++;
    return length;
}
