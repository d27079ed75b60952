/** @file
 * Particles: their ids, adding, changing and removing them, and the view of all. They are numbered
 * in the order in which they were added.
 */
#ifndef SKVALP_PARTICLES_H
#define SKVALP_PARTICLES_H

#include "skvalp/area.h"
#include "skvalp/base.h"
#include "skvalp/terrain.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A particle's name: the number at which it was added to its world, from 0. It stays when others
 * are removed, and is never given to another. */
typedef uint32_t skv_particle_id;

/** The id of no particle. */
#define SKV_NO_PARTICLE UINT32_MAX

/** Dye: a colour that particles carry along, 1 to SKV_DYES; 0 is none. It changes nothing of how
 * they move, and wakes nobody: it stays with its particle, and fluids mix as their particles do. */
#define SKV_DYES 4

/** "none", "rose", "amber", "green", "violet"; null for a number that is no dye. Static. */
SKV_API const char *skv_dye_name(int dye);

/** A number that changes whenever particles have been added, have left or were removed: as long as
 * it is the same, the arrays of skv_world_particles lie where they did and an index means the same
 * particle; only the values change, with steps. */
SKV_API uint32_t skv_world_revision(const skv_world *world);

/** The particles, in the order in which they were added. The arrays belong to the world and are
 * valid until skv_world_revision changes. */
typedef struct skv_particles {
    int count;
    const float *x, *y;     /**< m */
    const float *vx, *vy;   /**< m/s */
    const float *pressure;  /**< Pa m (force per length of the sheet), 0 at the free surface; from
                               the last substep; 0 before the first, unless it was settled at
                               rest */
    const float *clearance; /**< m: a lower bound of the distance to the nearest wall, from the
                               last substep; 0: not known */
    const skv_particle_id *id; /**< ascending */
    const uint8_t *dye;        /**< colours, 0..SKV_DYES; 0: none. Who shows particles of his own
                                  may leave it null: none has any */
    const uint8_t *fluid;      /**< numbers of their fluids, as skv_world_liquid; may be null, too:
                                  all are of the first */
} skv_particles;
SKV_API skv_particles skv_world_particles(const skv_world *world);

/** The index of a particle in the arrays of skv_world_particles, -1 if it is gone. Costs a binary
 * search. */
SKV_API int skv_world_index(const skv_world *world, skv_particle_id id);

/** Adds one particle, position in m and velocity in m/s, whether or not others are near. A place in
 * solid or outside the world (through an open side, more than a smoothing radius) is refused with
 * SKV_ERROR_VALUE, as is anything that is not finite. */
SKV_API skv_result skv_world_add_particle(skv_world *world, float x, float y, float vx, float vy,
                                          skv_error *error);

/** Tells whether a point (m) belongs to the fluid that is to be added. It may read the world that
 * is filled, but for saving and copying it. */
typedef bool skv_inside(float x, float y, void *user);

/** A fill: the rest lattice (hexagonal, one particle per spacing^2) inside a box. Initialise with
 * skv_default_fill_def. */
typedef struct skv_fill_def {
    uint32_t cookie;
    /** The box, m, each -100..100; what lies outside the terrain does not count. Default: all of
     * the terrain. */
    float x0, y0, x1, y1;
    const skv_area *area; /**< only places in it; null, the default: all of the box */
    /** For a brush that is dragged from frame to frame: the lattice begins at the world's origin
     * instead of the box's corner, so that fills beside each other join without a seam, and 0.95
     * instead of 0.7 spacings are kept from other particles. Default false. */
    bool aligned;
    skv_inside *inside; /**< asked once for every place, from the bottom up; null: everywhere */
    void *user;         /**< handed to `inside` */
    int limit;          /**< at most so many particles are added; negative, the default: no limit */
    float vx, vy;       /**< their velocity, m/s, each -1000..1000; default 0 */
    int dye;            /**< their colour, 0..SKV_DYES; default 0 */
    int fluid;          /**< number of their fluid, as skv_world_liquid; default 0 */
} skv_fill_def;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_fill_def skv_default_fill_def(void);
SKV_API void skv_fill_def_init(skv_fill_def *def, size_t size);

/** What became of the places at which particles were to be added. */
typedef struct skv_placed {
    int added;
    int occupied; /**< skipped: closer than 0.7 spacings (0.95 for an aligned fill) to another
                     particle, earlier or new */
    int blocked;  /**< skipped: in solid or outside the world; for a fill, closer than a third of a
                     spacing to a wall */
    skv_particle_id
        first; /**< of those added; the others' follow one by one. SKV_NO_PARTICLE: none */
} skv_placed;

/** Adds particles on the rest lattice, from the bottom up, where they keep a third of a spacing
 * from walls and 0.7 spacings (aligned 0.95) from other particles. Writes what became of the
 * lattice's places to *placed (null is allowed). All or nothing on failure: SKV_ERROR_VALUE (box or
 * velocity out of range), SKV_ERROR_LIMIT (more than SKV_MAX_PARTICLES) or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_world_fill(skv_world *world, const skv_fill_def *def, skv_placed *placed,
                                  skv_error *error);

/** How many particles the fill would add to an empty world of a given spacing (m) in this terrain:
 * for choosing the spacing that gives a wanted number. */
SKV_API int skv_fill_count(const skv_terrain *terrain, float spacing, const skv_fill_def *def);

/** Relaxes the fluid where it lies, so that what would rest there begins at rest instead of with a
 * jolt: call it once after a fill, before the first step. The particles keep their velocities, the
 * world its time; only places change, at rest by up to a few spacings. What is going to flow or to
 * fall, a dam or a drop in the air, keeps its shape. Takes at most 500 substeps of the longest
 * length, 200 of each half of it, and 1000 of the world's own (Clavet's law: 1200 of each); fewer
 * where particles times substeps would pass 5 million, in which those beside thin walls count more
 * if a smoothing radius is longer than 48 pixels. SKV_ERROR_MEMORY: some of it may have been done.
 */
SKV_API skv_result skv_world_settle(skv_world *world, skv_error *error);

/** The same where it is known how the fluid was drawn: `inside` tells whether fluid is drawn at a
 * point (null: as skv_world_settle). A surface that is drawn uneven by more than a spacing, as a
 * wave, keeps that shape instead of being levelled, and begins in the balance that it would have if
 * it were held. */
SKV_API skv_result skv_world_settle_drawn(skv_world *world, skv_inside *inside, void *user,
                                          skv_error *error);

/** A particle to add. */
typedef struct skv_particle {
    float x, y;   /**< m */
    float vx, vy; /**< m/s */
} skv_particle;

/** Adds many particles, those that find a free place; *placed (null is allowed) counts them and
 * those skipped. `ids` (null is allowed) has room for `count` and takes each one's id,
 * SKV_NO_PARTICLE for a skipped one. All or nothing on failure: SKV_ERROR_VALUE (a number that is
 * not finite or beyond 100 m, 1000 m/s), SKV_ERROR_LIMIT (too many) or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_world_add_particles(skv_world *world, const skv_particle *particles,
                                           int count, skv_particle_id *ids, skv_placed *placed,
                                           skv_error *error);

/** Adds (vx, vy) m/s to the velocity of particles [first, first+count), and wakes them. */
SKV_API skv_result skv_world_add_velocity(skv_world *world, int first, int count, float vx,
                                          float vy, skv_error *error);

/** Sets the velocities of particles [first, first+count), m/s, each within 1000: vx[0] and vy[0]
 * are those of `first`. Wakes the particles whose velocity changes. SKV_ERROR_VALUE, and nothing
 * changes, if a number is out of range or a particle does not exist. */
SKV_API skv_result skv_world_set_velocities(skv_world *world, int first, int count, const float *vx,
                                            const float *vy, skv_error *error);

/** Moves particles, named by their ids, to other places (m), whatever lies between and whether or
 * not others are near; those that are gone are passed over. They keep their velocities, and are
 * awake, as is fluid that slept where they were. skv_world_revision changes. All or nothing:
 * SKV_ERROR_VALUE, which names the particle, for a place that is in solid, outside of the world or
 * not within 100 m, where skv_world_add_particle would put none either. */
SKV_API skv_result skv_world_set_positions(skv_world *world, const skv_particle_id *ids, int count,
                                           const float *x, const float *y, skv_error *error);

/** Dyes particles [first, first+count): dyes[0] is the colour of `first`. SKV_ERROR_VALUE, and
 * nothing changed, for a number above SKV_DYES or a particle that does not exist. */
SKV_API skv_result skv_world_set_dyes(skv_world *world, int first, int count, const uint8_t *dyes,
                                      skv_error *error);

/** Dyes all particles in an area. Writes how many changed colour to *dyed (null is allowed).
 * SKV_ERROR_VALUE if there is no such dye. */
SKV_API skv_result skv_world_dye_area(skv_world *world, const skv_area *area, int dye, int *dyed,
                                      skv_error *error);

/** Makes particles [first, first+count) such of other fluids: fluids[0] is the number of the
 * fluid that `first` is to be of. Wakes those that change. SKV_ERROR_VALUE, and nothing changed,
 * for a number that no fluid of the world has or a particle that does not exist. */
SKV_API skv_result skv_world_set_fluids(skv_world *world, int first, int count,
                                        const uint8_t *fluids, skv_error *error);

/** Removes the particles with these ids; those that are gone already are passed over. Fluid that
 * sleeps beside them wakes. Writes how many were removed to *removed (null is allowed). On failure,
 * SKV_ERROR_MEMORY, nothing changes. */
SKV_API skv_result skv_world_remove(skv_world *world, const skv_particle_id *ids, int count,
                                    int *removed, skv_error *error);

/** The same for all particles in an area. */
SKV_API skv_result skv_world_remove_area(skv_world *world, const skv_area *area, int *removed,
                                         skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
