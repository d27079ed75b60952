/* Adding particles: what filling shares with it. */
#ifndef SKV_WORLD_ADD_H
#define SKV_WORLD_ADD_H

#include "world/occupancy.h"
#include "world/world_internal.h"

/* Makes room for `more` particles, and sees that there are ids for them; nothing changes on
 * failure. */
skv_result skv_world_make_room(skv_world *world, int more, skv_error *error);

/* The places that particles take, for telling where others would be too close; with room for
 * `more`. Needs skv_occupancy_destroy. */
skv_result skv_world_find_taken(const skv_world *world, int more, skv_occupancy *taken,
                                skv_error *error);

/* Tells the host's log if the particles just added have made the world overfull. */
void skv_world_say_if_overfull(const skv_world *world, int added);

#endif
