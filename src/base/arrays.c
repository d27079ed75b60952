/* Growing a structure of arrays. Invariant: every array begins on a cache line, and arrays of one
 * length never begin at the same place of a page: they would fight for the same cache sets, and a
 * load from one would wait for a store to another. */
#include "base/arrays.h"

#include "base/memory.h"

#include <string.h>

/* Bytes from an array's beginning to the next one's: an odd number of cache lines. 0: too many. */
static size_t extent(const skv_array *array)
{
    size_t bytes = array->room * array->size;
    if (array->room && (bytes / array->room != array->size || bytes > (size_t)-1 / 2))
        return 0;
    size_t lines = (bytes + SKV_ALIGNMENT - 1) / SKV_ALIGNMENT;
    return (lines | 1) * SKV_ALIGNMENT;
}

size_t skv_arrays_bytes(const skv_array *arrays, int count)
{
    size_t total = 0;
    for (int a = 0; a < count; a++)
        total += extent(&arrays[a]);
    return total;
}

bool skv_arrays_grow(void **block, const skv_array *arrays, int count)
{
    size_t total = 0;
    for (int a = 0; a < count; a++) {
        size_t bytes = extent(&arrays[a]);
        if (bytes == 0 || total + bytes < total)
            return false;
        total += bytes;
    }
    char *memory = skv_calloc(total, 1), *place = memory;
    if (!memory)
        return false;
    for (int a = 0; a < count; a++) {
        /* All pointers to objects look alike; their types forbid to say so otherwise. */
        const void *old;
        memcpy(&old, arrays[a].pointer, sizeof old);
        if (arrays[a].kept)
            memcpy(place, old, arrays[a].kept * arrays[a].size);
        memcpy(arrays[a].pointer, &place, sizeof place);
        place += extent(&arrays[a]);
    }
    skv_free(*block);
    *block = memory;
    return true;
}
