/* A running world's way to new numbers of Clavet's law; see ramp.c. */
#ifndef SKV_WORLD_RAMP_H
#define SKV_WORLD_RAMP_H

#include "skvalp/fluid.h"

typedef struct skv_world skv_world;

enum { SKV_RAMP_NUMBERS = 4 };

/* s: how long a way is. Fluid that spreads until its particles are out of reach gets radius_ratio
 * times as long. To add no more than half the speed that its depth H gives in a fall, it takes
 * (radius_ratio - 1) sqrt(2 H/g). Of the law's 2.85 and Earth's gravity, that is 1 s at 1.4 m; the
 * scenes that come with the program are 0.9 m high. */
#define SKV_RAMP_TIME 1.0

/* All of it is in a snapshot. */
typedef struct skv_ramp {
    double left;                 /* s; 0: the fluid's own numbers act */
    float now[SKV_RAMP_NUMBERS]; /* that act meanwhile */
} skv_ramp;

/* What acts, of a fluid to which there is a way. */
skv_fluid_def skv_ramp_fluid(const skv_fluid_def *fluid, const skv_ramp *ramp);

/* The way from what acts in a world to a fluid that has been set. */
skv_ramp skv_ramp_begin(const skv_world *world, const skv_fluid_def *fluid);

/* Goes on with a fluid and a way to it, and nothing follows from it: neither substeps nor sleep. */
void skv_world_put_fluid(skv_world *world, const skv_fluid_def *fluid, skv_ramp ramp);

/* After a step that began at `before`, s: goes on by its length. */
void skv_ramp_follow(skv_world *world, double before);

#endif
