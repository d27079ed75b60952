/* How fluid lies where it was put: which of it would stay there, and the weight above each
 * particle. */
#ifndef SKV_CALM_REGIONS_H
#define SKV_CALM_REGIONS_H

#include "world/world_internal.h"

/* How a particle lies. */
typedef enum skv_lie {
    SKV_HANGS, /* the fluid below it ends in the air: it is going to fall */
    SKV_LEANS, /* it is carried, but its region is going to flow: a dam, a heap, unequal levels */
    SKV_RESTS  /* its region fills what holds it up to one level */
} skv_lie;

typedef struct skv_lies {
    uint8_t *lie;  /* skv_lie, of each particle */
    float *weight; /* the integral of the depth, from the bottom of a particle's column up to it,
                      m^2; 0 for what hangs */
} skv_lies;

/* Finds out, for gravity as it is, and writes to arrays with room for all particles. Without
 * gravity all of them hang. */
skv_result skv_world_find_lies(const skv_world *world, skv_lies *lies, skv_error *error);

#endif
