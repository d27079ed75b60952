/* Allocation through the replaceable hooks. Everything is cache-line aligned. */
#ifndef SKV_BASE_MEMORY_H
#define SKV_BASE_MEMORY_H

#include "skvalp/base.h"

#define SKV_ALIGNMENT 64

/* `count` elements of `size` bytes, zeroed; null if the product overflows or memory is out. */
void *skv_calloc(size_t count, size_t size);

/* The same, not zeroed: for what is written over at once. */
void *skv_malloc(size_t count, size_t size);

/* Null is allowed. */
void skv_free(void *memory);

#endif
