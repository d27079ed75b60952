/* Steps of a run: to any moment, on the way of whole frames. */
#ifndef CLI_STEPPING_H
#define CLI_STEPPING_H

#include "skvalp/player.h"
#include "timeline.h"

/* What is stepped: a world, or a replay. */
typedef struct run_stepping {
    skv_world *world;   /* null for a replay */
    skv_player *player; /* null for a world */
    uint8_t *frame;     /* the world at the last frame, while it is between two */
    size_t size, room;
} run_stepping;

const skv_world *stepping_world(const run_stepping *stepping);

/* Steps from the timeline's present moment to its next one. A moment between two frames only looks:
 * from the frame after it on, all is as without it. A replay knows whole frames alone, and shows
 * the last one there. */
skv_result stepping_advance(run_stepping *stepping, run_timeline *timeline, skv_error *error);

/* Frees all of it. */
void stepping_free(run_stepping *stepping);

#endif
