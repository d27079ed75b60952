/* What a function of the library writes, kept in memory. */
#ifndef SKV_TEST_KEPT_H
#define SKV_TEST_KEPT_H

#include <stdbool.h>
#include <stddef.h>

/* All zero: nothing yet, and no limit. */
typedef struct kept {
    char *bytes; /* `size` of them, and a 0 that does not count; null before the first */
    size_t size;
    size_t limit; /* beyond which writing fails; 0: none */
} kept;

/* An skv_write whose user is a kept: adds the bytes. */
bool kept_add(const char *bytes, size_t size, void *user);

/* Forgets the bytes, not the limit. */
void kept_clear(kept *k);

#endif
