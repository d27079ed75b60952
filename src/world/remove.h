/* Taking particles out of a world: what the step needs of it. */
#ifndef SKV_WORLD_REMOVE_H
#define SKV_WORLD_REMOVE_H

#include "world/world_internal.h"

/* Takes out who has left through an open side; there is room for an event of every particle. */
void skv_world_remove_leavers(skv_world *world);

/* A removal by the host of at most so many particles: begin, which alone can fail, those who go,
 * and end with their number. Fluid that sleeps beside them begins to move. */
skv_result skv_world_begin_removal(skv_world *world, int most, skv_error *error);
void skv_world_remove_one(skv_world *world, int particle);
void skv_world_end_removal(skv_world *world, int count);

/* The same for what drains take within `dt`, and for the oldest particles, for which an emitter has
 * others; returns how many there were. */
void skv_world_remove_drained(skv_world *world, float dt);
int skv_world_remove_oldest(skv_world *world, int count, int emitter);

#endif
