/* How fluid lies where it was put: which of it would stay there, and the weight above each
 * particle. */
#ifndef SKV_CALM_REGIONS_H
#define SKV_CALM_REGIONS_H

#include "calm/drawn.h"
#include "world/world_internal.h"

/* How a particle lies. */
typedef enum skv_lie {
    SKV_HANGS, /* the fluid below it ends in the air: it is going to fall */
    SKV_LEANS, /* it is carried, but its region is going to flow: a dam, a heap, unequal levels */
    SKV_RESTS  /* its region fills what holds it up to one level */
} skv_lie;

typedef struct skv_lies {
    float ux, uy;  /* upwards; 0 without gravity */
    uint8_t *lie;  /* skv_lie, of each particle */
    float *weight; /* the integral of the depth, from the bottom of a particle's column up to it,
                      m^2; 0 for what hangs. Depth is pressure over that of a metre of own fluid */
    double depth;  /* the mean of all particles' depths, m */
    /* Of each particle that rests below a surface that is drawn uneven; else null. */
    const skv_drawn_surface **drawn;
    skv_drawn_surface *surfaces; /* of regions */
    skv_drawn_place *places;     /* of surfaces */
} skv_lies;

/* Where fluid is drawn, which may be finer than its particles; null: nobody knows. */
typedef struct skv_drawing {
    skv_inside *inside;
    void *user;
} skv_drawing;

/* Finds out, for gravity as it is. Without gravity all of them hang. The lies are to be destroyed,
 * even on failure. */
skv_result skv_world_find_lies(const skv_world *world, const skv_drawing *drawing, skv_lies *lies,
                               skv_error *error);

void skv_lies_destroy(skv_lies *lies);

#endif
