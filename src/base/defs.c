/* Definition structs of programs that may know less of them. Invariant: see defs.h. */
#include "base/defs.h"

#include "base/assert.h"

#include <string.h>

static uint32_t cookie_of(const void *def)
{
    uint32_t cookie;
    memcpy(&cookie, def, sizeof cookie);
    return cookie;
}

void skv_def_init(void *def, size_t size, const void *standard, size_t whole)
{
    SKV_ASSERT(def && size >= sizeof(uint32_t) && size <= whole);
    uint32_t cookie = (cookie_of(standard) & 0xffff0000u) | (uint32_t)size;
    memcpy(def, standard, size);
    memcpy(def, &cookie, sizeof cookie);
}

size_t skv_def_size(const void *def)
{
    return cookie_of(def) & 0xffff;
}

const void *skv_def_open(const void *def, void *own, size_t whole)
{
    if (!def || cookie_of(def) >> 16 != cookie_of(own) >> 16)
        return NULL;
    size_t size = skv_def_size(def);
    if (size == whole)
        return def;
    if (size < sizeof(uint32_t) || size > whole)
        return NULL;
    uint32_t cookie = cookie_of(own);
    memcpy(own, def, size);
    memcpy(own, &cookie, sizeof cookie);
    return own;
}
