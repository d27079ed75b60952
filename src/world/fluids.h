/* The fluids of a world that runs. */
#ifndef SKV_WORLD_FLUIDS_H
#define SKV_WORLD_FLUIDS_H

#include "skvalp/world.h"

/* Takes over the fluids of a definition that has been checked. */
void skv_world_put_liquids(skv_world *world, const skv_world_def *def);

/* Makes the first of the list what the world's fluid is, and particles as heavy and as viscous as
 * theirs. */
void skv_liquids_follow(skv_world *world);

/* Makes particles as heavy and as viscous as their fluids. */
void skv_world_weigh(skv_world *world);

/* The greatest density of its fluids over the least: 1 for one fluid. */
double skv_world_contrast(const skv_world *world);

/* How many substeps of the rule bear a load, and the most viscous fluid, the greatest cohesion and
 * the stiffest springs of the list; and how many are as stiff as so many of these, if they start
 * warm. */
int skv_world_substep_rule(const skv_world *world, double load);
int skv_world_warm_substeps(const skv_world *world, int cold);

/* What the world's particles weigh, over that of the first fluid's; null if all weigh as much, and
 * are as viscous. */
const float *skv_world_masses(const skv_world *world);

/* Their viscosities, as in solver.h; null if all are as viscous as the first fluid. */
const float *skv_world_drags(const skv_world *world);

#endif
