/* Arrays that grow together: several arrays of one structure in one block of memory. */
#ifndef SKV_BASE_ARRAYS_H
#define SKV_BASE_ARRAYS_H

#include <stdbool.h>
#include <stddef.h>

/* One of the arrays. Fill with SKV_ARRAY, from the variable that points to it. */
typedef struct skv_array {
    void *pointer; /* address of that variable */
    size_t size;   /* of an element, bytes */
    size_t room;   /* elements to have room for */
    size_t kept;   /* elements to carry over, at most what there was room for; the rest is 0 */
} skv_array;

#define SKV_ARRAY(array, room, kept) {(void *)&(array), sizeof *(array), (room), (kept)}

/* Puts all the arrays into a new block, and frees the one at `*block`, in which all of them lay, or
 * null. All or nothing: false, with everything as it was, if memory is out. */
bool skv_arrays_grow(void **block, const skv_array *arrays, int count);

/* Bytes of such a block. */
size_t skv_arrays_bytes(const skv_array *arrays, int count);

#endif
