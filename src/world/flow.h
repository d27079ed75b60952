/* What emitters and drains do between substeps. */
#ifndef SKV_WORLD_FLOW_H
#define SKV_WORLD_FLOW_H

#include "world/world_internal.h"

/* Particles come and go for a substep of `dt`. Fails with SKV_ERROR_MEMORY, and nothing has
 * happened. */
skv_result skv_world_let_flow(skv_world *world, float dt, skv_error *error);

#endif
