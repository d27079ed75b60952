/** @file
 * Queries: what a world is like at present, what lies where, and what has happened in its last
 * step. Reading functions may run on several threads at once, never beside a step.
 */
#ifndef SKVALP_QUERY_H
#define SKVALP_QUERY_H

#include "skvalp/acting.h"
#include "skvalp/area.h"
#include "skvalp/base.h"
#include "skvalp/particles.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a run reports about a world: one look at every particle. */
typedef struct skv_stats {
    int particles;
    int escaped;                   /**< outside the world, or inside a wall deeper than h */
    int not_finite;                /**< particles with a NaN or infinity */
    double kinetic_energy;         /**< J per metre of depth: sum of m v^2 / 2, m = density s^2 of
                                        the particle's own fluid */
    double potential_energy;       /**< J per metre of depth, against the world's origin */
    double momentum_x, momentum_y; /**< kg/s */
    double rms_speed, max_speed;   /**< m/s */
    double centre_x, centre_y;     /**< of mass, m */
} skv_stats;
SKV_API skv_stats skv_world_stats(const skv_world *world);

/** The same of one fluid's particles, by its number (skv_world_liquid); zeros past the last. */
SKV_API skv_stats skv_world_fluid_stats(const skv_world *world, int fluid);

/** Springs between particles of fluids that have a shear modulus (skv_liquid). They are made in
 * steps: a new world has none. */
SKV_API int skv_world_spring_count(const skv_world *world);

/** How the particles of a world are packed. */
typedef struct skv_packing {
    double neighbours;   /**< particles within h of a particle, on average; 0 without particles */
    double volume_ratio; /**< area a particle takes in the bulk over s^2; 1 if there is no bulk */
} skv_packing;

/** Measures the packing. Unlike the statistics it has to find all pairs: it takes as long as two
 * substeps of the reference solver, and for that time some 200 bytes a particle. Fails with
 * SKV_ERROR_MEMORY. */
SKV_API skv_result skv_world_packing(const skv_world *world, skv_packing *packing,
                                     skv_error *error);

/** What walls did to the fluid in the last step, per metre of depth: the impulse that they gave it,
 * and its moment about the origin, counter-clockwise. Fluid that sleeps gets nothing. Over a second
 * at rest walls give the fluid its weight; the fluid gives them the opposite. The same bits for any
 * number of threads. */
typedef struct skv_wall_impulse {
    double x, y;   /**< N s/m */
    double moment; /**< N s */
} skv_wall_impulse;
SKV_API skv_wall_impulse skv_world_wall_impulse(const skv_world *world);

/** 64-bit FNV-1a hash over x, y, vx, vy of every particle in creation order, its dye if it has
 * one, and its fluid if it is not the first; then over springs and bodies, if there are any. */
SKV_API uint64_t skv_world_hash(const skv_world *world);

/** Writes the indices (into the arrays of skv_world_particles) of the particles in an area,
 * ascending, at most `capacity`; returns how many there are in all. */
SKV_API int skv_world_query(const skv_world *world, const skv_area *area, int *indices,
                            int capacity);

/** Where a ray meets something. */
typedef struct skv_hit {
    bool found;
    float share;  /**< of the ray's way, 0..1; 1 if nothing was found */
    float x, y;   /**< m */
    float nx, ny; /**< unit normal there, out of what was met; 0 if nothing was */
    int particle; /**< index of the particle met; -1 for a wall or nothing */
} skv_hit;
typedef struct skv_ray {
    skv_hit wall;
    skv_hit fluid; /**< before the wall; a particle counts as a disc of area spacing^2 */
} skv_ray;

/** What the straight way from (x0, y0) to (x1, y1), m, each within 1000 m, meets first. A ray that
 * begins in solid or in fluid meets it at share 0. */
SKV_API skv_ray skv_world_ray(const skv_world *world, float x0, float y0, float x1, float y1);

/** What has happened to a particle. */
typedef enum skv_event_kind {
    SKV_EVENT_LEFT,    /**< went out through an open side */
    SKV_EVENT_REMOVED, /**< was removed by skv_world_remove or skv_world_remove_area, or lay deep in
                          a wall that skv_world_set_terrain brought */
    SKV_EVENT_EMITTED, /**< came out of an emitter */
    SKV_EVENT_BLOCKED, /**< a row of particles that an emitter could not emit, or not all of it */
    SKV_EVENT_DRAINED, /**< was taken out by a drain */
    SKV_EVENT_REPLACED, /**< was the oldest, and went for one that was emitted */
} skv_event_kind;
typedef struct skv_event {
    skv_event_kind kind;
    skv_particle_id particle; /**< SKV_NO_PARTICLE if it is about none */
    skv_acting_id source;     /**< the emitter or drain that did it; 0: none */
} skv_event;

/** The most events that are kept of a step: each particle may come and go, and 48 MB. */
#define SKV_MAX_EVENTS (2 * SKV_MAX_PARTICLES)

/** The events of the last step, in the order in which they happened: from the end of the step
 * before it to its own end, so that whoever reads them after each step misses none. Writes their
 * number, SKV_MAX_EVENTS at most. They belong to the world and are valid until the next call that
 * steps or changes it. */
SKV_API const skv_event *skv_world_events(const skv_world *world, int *count);

/** How many events came after those: what is filled and removed for long while nothing steps. */
SKV_API int64_t skv_world_dropped_events(const skv_world *world);

#ifdef __cplusplus
}
#endif
#endif
