/* Adding particles: what filling shares with it. */
#ifndef SKV_WORLD_ADD_H
#define SKV_WORLD_ADD_H

#include "base/region.h"
#include "world/occupancy.h"
#include "world/world_internal.h"

/* Makes room for `more` particles, and sees that there are ids for them; nothing changes on
 * failure. */
skv_result skv_world_make_room(skv_world *world, int more, skv_error *error);

/* True for a place in solid, or outside of where particles may be added. */
bool skv_world_is_blocked(const skv_world *world, float x, float y);

/* Particles are not added closer to each other than this, in spacings: such pairs fly apart. */
#define SKV_LEAST_SPACING 0.7f

/* The places that particles take, for telling which of those in a box would be closer than so
 * many spacings; null: in all of the world. With room for `more`. Needs skv_occupancy_destroy. */
skv_result skv_world_find_taken(const skv_world *world, const skv_region *box, int more,
                                float spacings, skv_occupancy *taken, skv_error *error);

/* Sees to the weight of the particles just added, and tells the host's log if they have made the
 * world overfull. */
void skv_world_note_added(skv_world *world, int added);

/* Tells the host's log, once, that emitters have filled the world. They go on until the fluid
 * around them is pressed, and nobody sees that it is. */
void skv_world_say_if_full(skv_world *world);

#endif
