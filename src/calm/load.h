/* How many substeps a frame takes, by what they must carry; see load.c. */
#ifndef SKV_CALM_LOAD_H
#define SKV_CALM_LOAD_H

#include "skvalp/base.h"

typedef struct skv_world skv_world;
typedef struct skv_tile_load skv_tile_load;

/* Loads are p/rho + v^2/2, m^2/s^2, rho being the fluid's own density. Substeps are those of the
 * rule, which start cold; a frame takes fewer warm ones for them. All of it is in a snapshot. */
typedef struct skv_load {
    int most;        /* substeps a frame for the greatest load that the rule expects */
    int wanted;      /* for the load that there is; most at most */
    float stiffness; /* substeps as stiff as the fluid is meanwhile */
    float peak;      /* since the last look */
} skv_load;

/* A load that substeps of the whole rule bear: `depth` m of fluid, and what forces add. */
double skv_load_of_depth(float gravity, float depth, float head);

skv_result skv_load_create(skv_world *world, skv_error *error);
void skv_load_destroy(skv_world *world);

/* Of a world to which so many substeps have been given, or by the rule. */
void skv_load_begin(skv_world *world, int substeps);

/* How many cold substeps a substep is as stiff as. */
float skv_load_stiffness(const skv_world *world);

/* The rule asks for `needed` substeps now: at most so many are taken, and as much more than before
 * at once as may be wanted for it. */
void skv_load_expect(skv_world *world, int needed);

/* Particles have been added, the last `count`: their weight will come. */
void skv_load_add(skv_world *world, int count);

/* All fluid is going to rest, so deep, m: takes at once what it would come to by and by. */
void skv_load_rest(skv_world *world, float depth);

/* After a step that began at `before`, s: follows the load. */
void skv_load_follow(skv_world *world, double before);

#endif
