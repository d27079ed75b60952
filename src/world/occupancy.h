/* Which places of a world are taken: particles by hashed cells. */
#ifndef SKV_WORLD_OCCUPANCY_H
#define SKV_WORLD_OCCUPANCY_H

#include "base/region.h"
#include "terrain/boundary.h"
#include "world/state.h"

typedef struct skv_occupancy {
    float reach;          /* closer than this is occupied, m; also the size of a cell */
    unsigned mask;        /* of the table's slots, a power of two less one */
    int *head;            /* by slot: number of the last place put there, from 1; 0: none */
    struct place *places; /* in the order in which they were taken */
    int count, capacity;
    const skv_boundary *boundary; /* places that its thin walls part do not occupy each other; null:
                                     none are parted */
} skv_occupancy;

/* Takes the places of the particles in a region, with room for `more`. */
skv_result skv_occupancy_create(skv_occupancy *occupancy, const skv_state *state,
                                const skv_region *region, int more, float reach, skv_error *error);
void skv_occupancy_destroy(skv_occupancy *occupancy);

bool skv_is_occupied(const skv_occupancy *occupancy, float x, float y);

/* Takes one place more; there is room for it. */
void skv_occupy(skv_occupancy *occupancy, float x, float y);

#endif
