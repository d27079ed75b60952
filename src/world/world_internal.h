/* The world's inside, shared by the files of src/world and src/calm; besides them only
 * src/measure/wall_force.c, which takes a substep on a copy, reads it. */
#ifndef SKV_WORLD_INTERNAL_H
#define SKV_WORLD_INTERNAL_H

#include "base/pool.h"
#include "calm/load.h"
#include "calm/sleep.h"
#include "skvalp/acting.h"
#include "skvalp/parameters.h"
#include "skvalp/particles.h"
#include "skvalp/query.h"
#include "skvalp/snapshot.h"
#include "skvalp/world.h"
#include "solver/solver.h"
#include "terrain/wall_map.h"
#include "world/acting.h"
#include "world/events.h"
#include "world/ramp.h"
#include "world/state.h"
#include "world/tiling.h"

/* What is at work on a world, and so what a host's callback may do to it: the less, the later. */
typedef enum skv_busy {
    SKV_IDLE,        /* nothing is; no callback */
    SKV_IN_SUBSTEPS, /* skv_before_substep: change particles and what acts on them */
    SKV_READ,        /* skv_inside and skv_logger: read */
    SKV_AT_WORK      /* a solver or a new terrain, perhaps on a host's threads: nothing */
} skv_busy;

/* What decides the future is in a snapshot, too: see snapshot.c. */
/* Of the area: what is compressed more has been given too few substeps, and is no liquid. */
#define SKV_MOST_COMPRESSION 0.1

struct skv_world {
    skv_fluid_def fluid;                /* as it was set; skv_ramp_fluid: what acts */
    skv_liquid liquids[SKV_MAX_FLUIDS]; /* all fluids; the first follows `fluid` */
    float sigmas[SKV_MAX_FLUIDS];       /* of their linear viscosity, 1/s */
    float cohesions[SKV_MAX_FLUIDS];    /* their cohesions over the greatest of the list, above 0 */
    bool cohesions_differ;
    int fluid_count;
    skv_ramp ramp;
    skv_terrain *terrain;
    skv_wall_map *walls;
    skv_boundary boundary;
    float gravity_x, gravity_y;
    float h;     /* smoothing radius, m */
    float depth; /* as in the definition */
    /* How much fluid at rest is compressed by its weight, on average: weightless it would take so
     * much more room. 0, or what settling has found. */
    float compression;
    int substeps;        /* a 1/60 s frame, at present */
    bool substeps_fixed; /* the definition gave them */
    float filled;        /* expected depth over the free extent, both along gravity */
    double due;          /* time owed to the next step, in substeps: below 1 */
    skv_acting acting;
    int emission_limit;
    bool emission_replaces;
    bool told_full; /* the host, that emitters have filled it */

    skv_state state;
    uint32_t next_id;
    uint32_t revision;    /* another one when particles have come, gone or changed places */
    uint32_t array_moves; /* how often the particles' arrays went to other memory */
    skv_tiling tiling;
    skv_sleep sleep;
    skv_load load;
    skv_tile_load *tile_loads; /* load.c */
    skv_solver *solver;
    struct skv_bodies *bodies;     /* world/bodies/bodies.h; null: there have been none */
    struct skv_springs *springs;   /* world/springs/springs.h; null: there have been none */
    struct skv_air *air;           /* world/air/air.h; null: none pushes */
    skv_wall_impulse wall_impulse; /* of the last step */
    skv_constants constants;
    float constants_dt, constants_stiffness; /* what they were made for */
    skv_pool *pool;
    bool shares_pool;     /* with other worlds: it is not ours to destroy */
    bool constants_stale; /* they were of another fluid */

    double time;
    int64_t steps;

    skv_events events;
    skv_busy busy;
    skv_before_substep *before_substep;
    void *before_substep_user;
    skv_logger *log;
    void *log_user;
    void *user;
};

/* A particle's mass by its fluid, over that of the first fluid's. */
static inline float skv_mass_of(const skv_world *world, int fluid)
{
    return world->liquids[fluid].density / world->fluid.density;
}

/* sigma of its linear viscosity times that mass, 1/s. */
static inline float skv_drag_of(const skv_world *world, int fluid)
{
    return skv_mass_of(world, fluid) * world->sigmas[fluid];
}

/* step.c: the constants of a substep at present. */
skv_constants skv_world_make_constants(const skv_world *world);

/* step.c: what a solver is to take one substep of: all particles, with what acts on them. */
skv_solver_step skv_world_describe_step(const skv_world *world, const skv_constants *constants,
                                        skv_external_force forces[SKV_SOLVER_MOST_FORCES]);

/* change.c: the greatest load that the rule expects; how far the free region goes along gravity, m;
 * the substeps a 1/60 s frame that the rule asks for; goes on with a fluid that differs only in
 * what may change while a world runs. */
double skv_expected_load(const skv_world *world);
float skv_extent_along_gravity(const skv_world *world);
int skv_substeps_needed(const skv_world *world);
void skv_world_adapt_substeps(skv_world *world); /* to what they are needed for, if not fixed */
void skv_world_change_fluid(skv_world *world, const skv_fluid_def *fluid);
/* Takes over when emitters stop. */
void skv_world_put_emission(skv_world *world, const skv_world_def *def);

/* world.c: makes room for `count` particles in all; nothing changes on failure. */
skv_result skv_world_reserve(skv_world *world, int count, skv_error *error);
/* Makes room for their fluids, of which there are several. */
skv_result skv_world_admit_fluids(skv_world *world, skv_error *error);
/* Appends a particle that has been checked; there is room for it. */
void skv_world_append(skv_world *world, float x, float y, float vx, float vy, int dye, int fluid);
/* Notes that particles have come, gone or changed places. */
void skv_world_revise(skv_world *world);

/* host.c: tells the host's log, if there is one, one line. */
void skv_world_say(skv_world *world, const char *format, ...) SKV_PRINTF(2, 3);
/* Conditions of every public function that changes a world: there is one, and no callback of its is
 * at work, or only one that may change it. */
bool skv_may_step(const skv_world *world);
bool skv_may_change(const skv_world *world);

#endif
