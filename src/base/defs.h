/* Definition structs, which a host hands in: skv_*_def and their like. Their first member,
 * `cookie`, says which struct it is and how many bytes of it the host's program knows of.
 *
 * Invariant: nothing is read or written beyond what the program knows; what lies there has its
 * default. So members may be added at the end of a struct. */
#ifndef SKV_BASE_DEFS_H
#define SKV_BASE_DEFS_H

#include "skvalp/base.h"

/* The cookie of a whole struct; `kind` is another 16-bit number for each struct. */
#define SKV_COOKIE(kind, type) ((uint32_t)(kind) << 16 | (uint32_t)sizeof(type))

/* Writes the first `size` bytes of a default of `whole` bytes: an skv_*_init. */
void skv_def_init(void *def, size_t size, const void *standard, size_t whole);

/* The whole of a def: itself, or `own`, which holds the default, with what the def has of it. Null
 * for one that was not initialised. */
const void *skv_def_open(const void *def, void *own, size_t whole);

/* Bytes that the program knows of a def that was initialised. */
size_t skv_def_size(const void *def);

/* A public function's first look at a def: `opened` is skv_def_open(def, ...). */
#define SKV_ASSERT_INITIALISED(def, opened, ...)                                                   \
    do {                                                                                           \
        (def) = (opened);                                                                          \
        if (!(def)) {                                                                              \
            SKV_ASSERT_FAILED(#def " was initialised by its _init or skv_default_... function");   \
            return __VA_ARGS__;                                                                    \
        }                                                                                          \
    } while (0)

#endif
