/* The fluids of a world that runs. */
#ifndef SKV_WORLD_FLUIDS_H
#define SKV_WORLD_FLUIDS_H

#include "skvalp/world.h"

/* Takes over the fluids of a definition that has been checked. */
void skv_world_put_liquids(skv_world *world, const skv_world_def *def);

/* Makes the first of the list what the world's fluid is. */
void skv_liquids_follow(skv_world *world);

#endif
