/* Areas as the world and its solvers ask them. */
#ifndef SKV_WORLD_AREA_H
#define SKV_WORLD_AREA_H

#include "base/bytes.h"
#include "base/region.h"
#include "skvalp/area.h"
#include "world/state.h"

/* Whether an area is of a known kind and finite. */
bool skv_area_is_sane(const skv_area *area);

/* The region of an area, whose corners it refers to; of one that is not sane, an empty one. */
skv_region skv_area_region(const skv_area *area);

/* The first particle from `from` on in a region, or in its box alone; the number of particles if
 * there is none. Blocks of particles of which none is in the box cost little. */
int skv_next_in_region(const skv_state *state, const skv_region *region, int from);
int skv_next_in_box(const skv_state *state, const skv_region *box, int from);

/* Writes or reads an area; what has been read need not be sane. */
void skv_exchange_area(skv_port *port, skv_area *area);

#endif
