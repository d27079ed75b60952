/** @file
 * World: a fluid in a terrain, and the step that moves it.
 *
 * A world owns its particles and its terrain. Particles are numbered in the order in which they
 * were added; every view and every hash uses that order. The same calls give the same bits on any
 * number of threads. Units are SI: metres, seconds, kilograms per square metre of the sheet; y is
 * up. The method is Mansson 2013 (after Clavet, Beaudoin, Poulin 2005) with the errata and the
 * calibrated pressure law of docs/model.md.
 *
 * What a world is made of and how it steps is here. The rest is told by subject: its fluid in
 * fluid.h, its parameters by name in parameters.h, its particles in particles.h, what acts on them
 * in acting.h, what can be asked of it in query.h, and its state as bytes in snapshot.h.
 */
#ifndef SKVALP_WORLD_H
#define SKVALP_WORLD_H

#include "skvalp/base.h"
#include "skvalp/fluid.h"
#include "skvalp/terrain.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MAX_PARTICLES 2000000
#define SKV_MAX_THREADS   64

/** Which of the two solvers steps a world. They compute the same model; the reference is written
 * pass by pass for reading and is about ten times slower. Their results differ by rounding, and by
 * the moment at which viscosity is read (docs/model.md). */
typedef enum skv_solver_kind { SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE } skv_solver_kind;

/** Receives one line of text, without a line feed, that the library would print if it printed. It
 * may read the world that calls it, but for saving and copying it. */
typedef void skv_logger(const char *text, void *user);

/** How to make a world. Initialise with skv_default_world_def. Ranges and defaults of what is not
 * explained here are those of skv_world_field. */
typedef struct skv_world_def {
    uint32_t cookie;
    /** Taken over by the world if skv_world_create succeeds, left to the caller if it fails. Null:
     * the default terrain, a closed tank of 1.6 x 0.9 m. */
    skv_terrain *terrain;
    skv_fluid_def fluid;
    float gravity_x, gravity_y; /**< m/s^2 */
    float
        depth; /**< m: the deepest fluid to expect along this gravity, for the substep rule; 0: all
                  the free height. Along another gravity as much of the way counts as filled. */
    int substeps;   /**< a 1/60 s frame, at most 1000; 0: by the rule of docs/model.md,
                       and by the load at most so many */
    int threads;    /**< 1..SKV_MAX_THREADS, 0: one per physical core */
    skv_pool *pool; /**< threads shared with other worlds; null: threads of its own. If set,
                       `threads` and `tasks` are ignored. */
    skv_task_system
        tasks; /**< a host's threads instead, if tasks.run is set; `threads` is ignored */
    skv_solver_kind solver;              /**< default SKV_SOLVER_FAST */
    skv_instruction_set instruction_set; /**< of the fast solver; default SKV_ISA_BEST. One that
                                            this machine lacks: SKV_ERROR_VALUE */
    bool sleep; /**< default true: fluid that has been at rest for a while is not stepped until
                   something disturbs it (docs/model.md). Only with SKV_SOLVER_FAST. */
    int emission_limit;     /**< emitters stop at so many particles in the world */
    bool emission_replaces; /**< ... or else the oldest particles go for new ones */
    int capacity;    /**< particles to make room for at creation; the world grows beyond it */
    skv_logger *log; /**< as by skv_world_set_log, from the first moment on; default null */
    void *log_user;
    /** The fluids beside `fluid`, which has the number 0: so many of the list have the numbers from
     * 1 on. Default: none. */
    int liquid_count;
    skv_liquid liquids[SKV_MAX_FLUIDS - 1];
} skv_world_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_world_def skv_default_world_def(void);
SKV_API void skv_world_def_init(skv_world_def *def, size_t size);

typedef struct skv_world skv_world;

/** Makes an empty world; `*world` is null on failure. */
SKV_API skv_result skv_world_create(const skv_world_def *def, skv_world **world, skv_error *error);

/** Frees a world and its terrain; null is allowed. */
SKV_API void skv_world_destroy(skv_world *world);

/** Puts another terrain under the fluid, made by skv_terrain_paint or of the same size otherwise:
 * it is taken over if this succeeds, and left to the caller if it fails. The world's own is given
 * up; who wants to come back to it, for undoing or with a snapshot, shares it before. The world is
 * then what it would be if it had been created with that terrain, but the cost follows what differs
 * between the two. Fluid near it wakes. Particles in new walls are pushed out to their surface;
 * those deeper than a smoothing radius (or than SKV_TERRAIN_REACH pixels) are removed, and their
 * number written to *removed (null is allowed). On failure nothing has changed: SKV_ERROR_VALUE
 * (another size) or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_world_set_terrain(skv_world *world, skv_terrain *terrain, int *removed,
                                         skv_error *error);

/** Advances the world by dt seconds, 1e-6f..0.1f, usually 1/60. A substep is 1/(60 substeps) long,
 * whatever dt is: as many are taken as the time owed holds, none perhaps, and the rest stays owed
 * to the next call. So frames may have any length; 1/60 s is a frame exactly. Unless the definition
 * gave their number, it follows the load after each 1/60 s, so that frames of other lengths give
 * another, as good a flow. Fails with
 * SKV_ERROR_VALUE for a dt out of range, with SKV_STOPPED (skv_pool_set_stop), or with
 * SKV_ERROR_MEMORY: with the fast solver nothing has
 * happened then; the reference may have taken some of the substeps, and owes the others. A warm
 * world, whose number of particles has not grown, allocates nothing. */
SKV_API skv_result skv_world_step(skv_world *world, float dt, skv_error *error);

/** Where the time goes: seconds spent since the last call with `reset`, by phase (the fast solver's
 * phases or the reference's passes). Not part of the deterministic state. */
typedef struct skv_profile {
    int count;            /**< passes */
    const char *name[16]; /**< e.g. "density" */
    double seconds[16];   /**< wall time summed over substeps */
} skv_profile;
SKV_API skv_profile skv_world_profile(skv_world *world, bool reset);

/** The name of an instruction set: "scalar", "sse2", "avx2", "avx512", "neon" or "wasm"; of
 * SKV_ISA_BEST, that of the best one. Null if this machine, or this build, does not have it.
 * Thread-safe. */
SKV_API const char *skv_instruction_set_name(skv_instruction_set set);

/** Bytes that a world holds, but for what belongs to its walls (terrain, distances, wall density),
 * to its area (a state for each tile of 2 h of those that sleep) and to events. With the fast
 * solver `particles` is at most 128 a particle of one fluid from 20 000 on, whatever it is and
 * whether it sleeps, where there is room for as many as were added at once; fewer pay for the ends
 * of many rows. */
typedef struct skv_memory {
    size_t particles;  /**< all arrays by particle, the world's and the solver's */
    size_t kept;       /**< what the threads keep of pairs, walls and sums in the rows at work */
    size_t grid;       /**< where the solver finds particles */
    size_t histograms; /**< for filling the grid, once for each thread */
} skv_memory;
SKV_API skv_memory skv_world_memory(const skv_world *world);

/** Plain facts. Reading functions may run on several threads at once, never beside a step. */
SKV_API int skv_world_particle_count(const skv_world *world);
/** Particles and bodies that do not sleep: those that the last step moved, and those added or woken
 * since. A fixed body counts while it moves. */
SKV_API int skv_world_awake_count(const skv_world *world);
/** Of 1/60 s, at present: unless given, they follow the load. */
SKV_API int skv_world_substeps_per_frame(const skv_world *world);
SKV_API int skv_world_threads(const skv_world *world);
SKV_API double skv_world_time(const skv_world *world);            /**< s, of the substeps taken */
SKV_API int64_t skv_world_substep_count(const skv_world *world);  /**< substeps taken */
SKV_API float skv_world_spacing(const skv_world *world);          /**< s, m */
SKV_API float skv_world_smoothing_radius(const skv_world *world); /**< h, m */
SKV_API const skv_fluid_def *skv_world_fluid(const skv_world *world);
/** A fluid of the world by its number, the first one's as its fluid is at present; null past the
 * last. Valid as long as the world is. */
SKV_API const skv_liquid *skv_world_liquid(const skv_world *world, int number);
SKV_API void skv_world_gravity(const skv_world *world, float *gx, float *gy);
SKV_API const skv_terrain *skv_world_terrain(const skv_world *world);

/* Callbacks: what a host's function may do to the world that calls it. Another world it may treat
 * as it likes. What it must not do is its mistake (skv_set_assert_handler), and does nothing:
 *
 *   skv_before_substep     anything but step, settle, save, copy, restore or destroy the world, or
 *                          set its terrain
 *   skv_inside             read it: what takes a constant world, but for save and copy
 *   skv_logger             the same
 *   skv_task_system.run    nothing, for half of the particles may have moved; this alone is not
 *                          noticed where it only reads
 *   skv_allocator          nothing, with any object of the library
 */

/** Called before each substep, by the thread that called skv_world_step: the place for forces of
 * the host's own, as velocities that it adds. `dt` is the substep's length, s. It is called for a
 * world that sleeps, too. It may change particles, hands, forces, emitters, drains and parameters,
 * and lead bodies; views have to be asked for anew once the revision changes. A step that is half
 * done has no state that another could go on from: it must not step, settle, save, copy, restore or
 * destroy the world or set its terrain. Substeps of a length given by gravity stay as they are
 * until the step ends.
 */
typedef void skv_before_substep(skv_world *world, float dt, void *user);

/** Sets that callback; null: none. As long as it does the same, the world's future is the same on
 * any number of threads. A world with one steps its substeps one by one, which costs a little and
 * rounds differently. */
SKV_API void skv_world_set_before_substep(skv_world *world, skv_before_substep *callback,
                                          void *user);

/** Sets where a world says what is no failure but worth knowing: that it had to grow, that
 * emitters have filled it, or that it is overfull: filled to more than 1.1 of what lies in it at
 * rest, where it begins to boil. Null, the default: nowhere. Called by the thread that calls the
 * world. */
SKV_API void skv_world_set_log(skv_world *world, skv_logger *log, void *user);

/** A pointer for the host's own use; null at first. */
SKV_API void skv_world_set_user(skv_world *world, void *user);
SKV_API void *skv_world_user(const skv_world *world);

#ifdef __cplusplus
}
#endif
#endif
