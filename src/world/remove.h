/* Taking particles out of a world: what the step needs of it. */
#ifndef SKV_WORLD_REMOVE_H
#define SKV_WORLD_REMOVE_H

#include "world/world_internal.h"

/* Takes out who has left through an open side; there is room for an event of every particle. */
void skv_world_remove_leavers(skv_world *world);

#endif
