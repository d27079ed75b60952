/* Adding particles: what filling shares with it. */
#ifndef SKV_WORLD_ADD_H
#define SKV_WORLD_ADD_H

#include "world/world_internal.h"

/* Particles are not added closer to each other than this, in spacings: such pairs fly apart. */
#define SKV_LEAST_SPACING 0.7f

/* Makes room for `more` particles, at most SKV_MAX_PARTICLES + 1, and sees that there are ids for
 * them; nothing changes on failure. */
skv_result skv_world_make_room(skv_world *world, int more, skv_error *error);

#endif
