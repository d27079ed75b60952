/** @file
 * World: a fluid in a terrain, and the step that moves it.
 *
 * A world owns its particles and its terrain. Particles are numbered in the order in which they
 * were added; every view and every hash uses that order. The same calls give the same bits on any
 * number of threads. Units are SI: metres, seconds, kilograms per square metre of the sheet; y is
 * up. The method is Mansson 2013 (after Clavet, Beaudoin, Poulin 2005) with the errata and the
 * calibrated pressure law of docs/model.md.
 */
#ifndef SKVALP_WORLD_H
#define SKVALP_WORLD_H

#include "skvalp/area.h"
#include "skvalp/base.h"
#include "skvalp/fields.h"
#include "skvalp/terrain.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MAX_PARTICLES 2000000
#define SKV_MAX_THREADS   64
#define SKV_MAX_HANDS     16
#define SKV_MAX_FORCES    16
#define SKV_MAX_EMITTERS  16
#define SKV_MAX_DRAINS    16

/** How density becomes displacement. Both go through the same passes. */
typedef enum skv_law {
    SKV_LAW_CALIBRATED, /**< density constraint: pressures and periods of a real liquid (default) */
    SKV_LAW_CLAVET      /**< the thesis' double density relaxation (Algorithm 6, symmetric) */
} skv_law;

/** "calibrated" or "clavet". */
SKV_API const char *skv_law_name(skv_law law);

/** A fluid's parameters. Initialise with skv_default_fluid_def, which depends on the law. Ranges
 * and defaults are those of skv_world_field. */
typedef struct skv_fluid_def {
    skv_law law;
    float spacing;               /**< s: one particle per s*s square metres at rest, m */
    float radius_ratio;          /**< h/s: smoothing radius in spacings */
    float density;               /**< kg/m^2 of the sheet */
    float viscosity;             /**< kinematic, m^2/s, on top of the method's own */
    float viscosity_linear;      /**< sigma, 1/s: removes a pair's approach speed */
    float viscosity_quadratic;   /**< beta, 1/m: the same, growing with the speed */
    float near_stiffness;        /**< k_near, m/s^2, calibrated law */
    float cohesion;              /**< k_coh, m/s^2, calibrated law */
    float relaxation;            /**< omega, share of the correction applied, calibrated law;
                                      more than 4 / radius_ratio^2 acts as that */
    int iterations;              /**< relaxation rounds a substep */
    float clavet_stiffness;      /**< k h^-1 dt^2, dimensionless */
    float clavet_near_stiffness; /**< k_near h^-1 dt^2, dimensionless */
    float clavet_rest_density;   /**< rho0, dimensionless */
    float wall_friction;         /**< share of the tangential speed lost at a wall in 1/60 s */
    float wall_softness;         /**< share of the penetration corrected in 1/60 s */
    float contact_distance;      /**< in spacings: closer than this to a wall is contact */
    bool wall_images;            /**< walls by images, which do not drag; calibrated law */
    float adhesion;              /**< share of their pull that holds fluid up against gravity */
    int cookie;
} skv_fluid_def;

/** The default fluid, water, for a law. */
SKV_API skv_fluid_def skv_default_fluid_def(skv_law law);

/** Liquids by name: density in kg/m^3 and kinematic viscosity in m^2/s at 20 degrees Celsius. */
typedef struct skv_material {
    const char *name;
    float density, viscosity;
} skv_material;

/** The materials; null past the last. Static. The first is water, the default fluid. */
SKV_API const skv_material *skv_material_info(int i);

/** Which of the two solvers steps a world. They compute the same model; the reference is written
 * pass by pass for reading and is about ten times slower. Their results differ by rounding, and by
 * the moment at which viscosity is read (docs/model.md). */
typedef enum skv_solver_kind { SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE } skv_solver_kind;

/** How to make a world. Initialise with skv_default_world_def. Ranges and defaults of what is not
 * explained here are those of skv_world_field. */
typedef struct skv_world_def {
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
    int capacity; /**< particles to make room for at creation; the world grows beyond it */
    int cookie;
} skv_world_def;

SKV_API skv_world_def skv_default_world_def(void);

/** The parameters of a definition, its fluid's included, by path: "gravity.y", "fluid.viscosity".
 * The fields in documentation order; null past the last. Static. */
SKV_API const skv_field *skv_world_field(int i);

/** Sets a parameter of a definition from text: "0.001", "clavet", "true". Setting fluid.law gives
 * the new law's defaults to what has the old law's; fluid.material sets density and viscosity.
 * SKV_ERROR_VALUE, and nothing changed, for an unknown path or a value that its field does not
 * allow; the message says what it does. */
SKV_API skv_result skv_world_def_set(skv_world_def *def, const char *path, const char *text,
                                     skv_error *error);

/** Writes a parameter as text that would set it, cut to `size`; 32 bytes hold any. fluid.material
 * is empty if no material has this density and viscosity. SKV_ERROR_VALUE for an unknown path. */
SKV_API skv_result skv_world_def_get(const skv_world_def *def, const char *path, char *text,
                                     size_t size, skv_error *error);

typedef struct skv_world skv_world;

/** Makes an empty world; `*world` is null on failure. */
SKV_API skv_result skv_world_create(const skv_world_def *def, skv_world **world, skv_error *error);

/** Frees a world and its terrain; null is allowed. */
SKV_API void skv_world_destroy(skv_world *world);

/** Adds one particle, position in m and velocity in m/s, whether or not others are near. A place in
 * solid or outside the world (through an open side, more than a smoothing radius) is refused with
 * SKV_ERROR_VALUE, as is anything that is not finite. */
SKV_API skv_result skv_world_add_particle(skv_world *world, float x, float y, float vx, float vy,
                                          skv_error *error);

/** Tells whether a point (m) belongs to the fluid that is to be added. */
typedef bool skv_inside(float x, float y, void *user);

/** A fill: the rest lattice (hexagonal, one particle per spacing^2) inside a box. Initialise with
 * skv_default_fill_def. */
typedef struct skv_fill_def {
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
    int cookie;
} skv_fill_def;

SKV_API skv_fill_def skv_default_fill_def(void);

/** A particle's name: the number at which it was added to its world, from 0. It stays when others
 * are removed, and is never given to another. */
typedef uint32_t skv_particle_id;

/** The id of no particle. */
#define SKV_NO_PARTICLE UINT32_MAX

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
 * fall, a dam or a drop in the air, keeps its shape. Takes as long as some 200 substeps, fewer of
 * more than 20 000 particles. SKV_ERROR_MEMORY: some of it may have been done. */
SKV_API skv_result skv_world_settle(skv_world *world, skv_error *error);

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

/** The index of a particle in the arrays of skv_world_particles, -1 if it is gone. Costs a binary
 * search. */
SKV_API int skv_world_index(const skv_world *world, skv_particle_id id);

/** Adds (vx, vy) m/s to the velocity of particles [first, first+count), and wakes them. */
SKV_API skv_result skv_world_add_velocity(skv_world *world, int first, int count, float vx,
                                          float vy, skv_error *error);

/** Sets the velocities of particles [first, first+count), m/s, each within 1000: vx[0] and vy[0]
 * are those of `first`. Wakes the particles whose velocity changes. SKV_ERROR_VALUE, and nothing
 * changes, if a number is out of range or a particle does not exist. */
SKV_API skv_result skv_world_set_velocities(skv_world *world, int first, int count, const float *vx,
                                            const float *vy, skv_error *error);

/** Dye: a colour that particles carry along, 1 to SKV_DYES; 0 is none. It changes nothing of how
 * they move, and wakes nobody: it stays with its particle, and fluids mix as their particles do. */
#define SKV_DYES 4

/** "none", "rose", "amber", "green", "violet"; null for a number that is no dye. Static. */
SKV_API const char *skv_dye_name(int dye);

/** Dyes particles [first, first+count): dyes[0] is the colour of `first`. SKV_ERROR_VALUE, and
 * nothing changed, for a number above SKV_DYES or a particle that does not exist. */
SKV_API skv_result skv_world_set_dyes(skv_world *world, int first, int count, const uint8_t *dyes,
                                      skv_error *error);

/** Dyes all particles in an area. Writes how many changed colour to *dyed (null is allowed).
 * SKV_ERROR_VALUE if there is no such dye. */
SKV_API skv_result skv_world_dye_area(skv_world *world, const skv_area *area, int dye, int *dyed,
                                      skv_error *error);

/** Removes the particles with these ids; those that are gone already are passed over. Fluid that
 * sleeps beside them wakes. Writes how many were removed to *removed (null is allowed). On failure,
 * SKV_ERROR_MEMORY, nothing changes. */
SKV_API skv_result skv_world_remove(skv_world *world, const skv_particle_id *ids, int count,
                                    int *removed, skv_error *error);

/** The same for all particles in an area. */
SKV_API skv_result skv_world_remove_area(skv_world *world, const skv_area *area, int *removed,
                                         skv_error *error);

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
 * SKV_ERROR_VALUE for a dt out of range, or with SKV_ERROR_MEMORY: with the fast solver nothing has
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
 * solver `particles` is at most 128 a particle from 20 000 on, whatever the fluid and whether it
 * sleeps, where there is room for as many as were added at once; fewer pay for the ends of many
 * rows. */
typedef struct skv_memory {
    size_t particles;  /**< all arrays by particle, the world's and the solver's */
    size_t kept;       /**< what the threads keep of pairs, walls and sums in the rows at work */
    size_t grid;       /**< where the solver finds particles */
    size_t histograms; /**< for filling the grid, once for each thread */
} skv_memory;
SKV_API skv_memory skv_world_memory(const skv_world *world);

/** A finger or the mouse holding fluid (thesis, section 3.5): within `radius` of (x, y), and fading
 * with the distance, particles are pulled towards the point, slowed down, and carried along with
 * the pointer's velocity. */
typedef struct skv_hand {
    float x, y;       /**< m */
    float vx, vy;     /**< the pointer's velocity, m/s */
    float radius;     /**< m, > 0; default 0.15 */
    float attraction; /**< m/s^2 towards the point, at half the radius; default 60 */
    float friction;   /**< 1/s: how fast the particles' own velocity fades; default 6 */
    float follow;     /**< 1/s: how fast they take the pointer's velocity; default 6 */
} skv_hand;

SKV_API skv_hand skv_default_hand(void);

/** Sets the hands that act from the next step on, replacing all earlier ones; count 0 lets go.
 * Fails with SKV_ERROR_VALUE (a field not finite or out of range: the old hands stay) or
 * SKV_ERROR_LIMIT (more than SKV_MAX_HANDS). */
SKV_API skv_result skv_world_set_hands(skv_world *world, const skv_hand *hands, int count,
                                       skv_error *error);

/** A force field: what is done to all fluid in an area, at the surface as below it. What is 0 does
 * nothing. Over the whole world: skv_box(-100, -100, 100, 100). */
typedef struct skv_force {
    skv_area area;
    float ax, ay;             /**< m/s^2, like gravity; each -1000..1000 */
    float toward_x, toward_y; /**< m: the point of attraction, in the area or not; +-1000 */
    float attraction;         /**< m/s^2 towards it, -1000..1000, negative: away; it fades away only
                                 within a smoothing radius of the point */
    float wind_x, wind_y; /**< m/s, each -100..100: the velocity that the fluid is to take ... */
    float drag;           /**< ... and how fast it does, 1/s, 0..1000 */
    float spin; /**< rad/s, -100..100: so fast the wind turns, counter-clockwise, about the middle
                   of the area, or of the box around it */
} skv_force;

/** Sets the forces that act from the next substep on, replacing all earlier ones, and wakes the
 * fluid. Substeps follow as they follow gravity. Fails with SKV_ERROR_VALUE (not finite or out of
 * range: the old forces stay) or SKV_ERROR_LIMIT (more than SKV_MAX_FORCES). */
SKV_API skv_result skv_world_set_forces(skv_world *world, const skv_force *forces, int count,
                                        skv_error *error);

/** The forces that act; they belong to the world and are valid until the next ones are set. */
SKV_API const skv_force *skv_world_forces(const skv_world *world, int *count);

/** An emitter: fluid appears along a line and flows off across it, width * speed m^2/s of it. From
 * the line on, as far as a smoothing radius, all fluid as wide as the line has the emitter's
 * velocity: the mouth, which should be free of walls; a wall right behind the line is welcome.
 * Where a place on the line is taken or solid, nothing appears, and the event SKV_EVENT_BLOCKED
 * tells. */
typedef struct skv_emitter {
    float x, y;   /**< m: the middle of the line; each -100..100 */
    float vx, vy; /**< m/s, each -20..20; both 0: closed */
    float width;  /**< m: the length of the line, above 0, and at most 1000 spacings */
    int dye;      /**< colour of what comes, 0..SKV_DYES */
} skv_emitter;

/** Sets the emitters from the next substep on, replacing all earlier ones; one that stays where and
 * as fast as it is goes on without a gap. They stop when the world holds as many particles as
 * `emission_limit`, or with `emission_replaces` the oldest particles go. Fails with SKV_ERROR_VALUE
 * (not finite or out of range: the old ones stay) or SKV_ERROR_LIMIT (more than SKV_MAX_EMITTERS).
 */
SKV_API skv_result skv_world_set_emitters(skv_world *world, const skv_emitter *emitters, int count,
                                          skv_error *error);
/** The emitters; they belong to the world and are valid until the next ones are set. */
SKV_API const skv_emitter *skv_world_emitters(const skv_world *world, int *count);

/** A drain: particles in an area are taken out between substeps. */
typedef struct skv_drain {
    skv_area area;
    float rate; /**< m^2/s, at most so much, 0..10000; 0: all that comes */
} skv_drain;

/** The same for drains; at most SKV_MAX_DRAINS. */
SKV_API skv_result skv_world_set_drains(skv_world *world, const skv_drain *drains, int count,
                                        skv_error *error);
SKV_API const skv_drain *skv_world_drains(const skv_world *world, int *count);

/** Particles that have come and gone while the world ran, since it was made: their number changes
 * by emitted - drained - left - replaced, and by what the host adds and removes. */
typedef struct skv_flow {
    int64_t emitted, drained;
    int64_t left;     /**< through open sides */
    int64_t replaced; /**< taken out to make room for new ones */
    int64_t blocked;  /**< could not be emitted */
} skv_flow;
SKV_API skv_flow skv_world_flow(const skv_world *world);

/** Sets gravity, m/s^2, each component -1000..1000, from the next substep on. Unless the definition
 * gave their number, the substeps follow it by the rule: up at once, down when a third of them can
 * be spared; and by the load. */
SKV_API skv_result skv_world_set_gravity(skv_world *world, float gx, float gy, skv_error *error);

/** The same as skv_world_def_set and _get for a world that runs. What skv_world_can_change denies
 * is refused with SKV_ERROR_VALUE. The substeps follow as they follow gravity. Fluid that sleeps
 * wakes up. */
SKV_API bool skv_world_can_change(const char *path);
SKV_API skv_result skv_world_set(skv_world *world, const char *path, const char *text,
                                 skv_error *error);
SKV_API skv_result skv_world_get(const skv_world *world, const char *path, char *text, size_t size,
                                 skv_error *error);

/** Plain facts. Reading functions may run on several threads at once, never beside a step. */
SKV_API int skv_world_particle_count(const skv_world *world);
/** Particles that do not sleep: those that the last step moved, and those added since. */
SKV_API int skv_world_awake_count(const skv_world *world);
/** Of 1/60 s, at present: unless given, they follow the load. */
SKV_API int skv_world_substeps_per_frame(const skv_world *world);
SKV_API int skv_world_threads(const skv_world *world);
SKV_API double skv_world_time(const skv_world *world);            /**< s, of the substeps taken */
SKV_API int64_t skv_world_substep_count(const skv_world *world);  /**< substeps taken */
SKV_API float skv_world_spacing(const skv_world *world);          /**< s, m */
SKV_API float skv_world_smoothing_radius(const skv_world *world); /**< h, m */
SKV_API const skv_fluid_def *skv_world_fluid(const skv_world *world);
SKV_API void skv_world_gravity(const skv_world *world, float *gx, float *gy);
SKV_API const skv_terrain *skv_world_terrain(const skv_world *world);

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
} skv_particles;
SKV_API skv_particles skv_world_particles(const skv_world *world);

/** What a run reports about a world: one look at every particle. */
typedef struct skv_stats {
    int particles;
    int escaped;                   /**< outside the world, or inside a wall deeper than h */
    int not_finite;                /**< particles with a NaN or infinity */
    double kinetic_energy;         /**< J per metre of depth: sum of m v^2 / 2, m = density s^2 */
    double potential_energy;       /**< J per metre of depth, against the world's origin */
    double momentum_x, momentum_y; /**< kg/s */
    double rms_speed, max_speed;   /**< m/s */
    double centre_x, centre_y;     /**< of mass, m */
} skv_stats;
SKV_API skv_stats skv_world_stats(const skv_world *world);

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

/** 64-bit FNV-1a hash over x, y, vx, vy of every particle in creation order, and its dye if it has
 * one. */
SKV_API uint64_t skv_world_hash(const skv_world *world);

/* Snapshots: the whole state of a world as bytes, the same on every machine (docs/snapshot.md). A
 * world that goes on from one gives the same bits as one that was never interrupted, whatever its
 * threads and instruction set. */

/** How many bytes skv_world_save writes. `with_terrain`: the snapshot holds the terrain's picture,
 * so that skv_world_load can make a world of it; else the world it is for has to be at hand. */
SKV_API size_t skv_world_snapshot_size(const skv_world *world, bool with_terrain);

/** Writes a snapshot of skv_world_snapshot_size bytes. Fails with SKV_ERROR_LIMIT if `size` is
 * less, or with SKV_ERROR_VALUE if a particle is not finite. */
SKV_API skv_result skv_world_save(const skv_world *world, bool with_terrain, void *data,
                                  size_t size, skv_error *error);

/** Puts a world back into a state that it, or one of the same terrain, law, spacing, radius ratio,
 * solver and sleep, has been in; whatever can change while a world runs comes from the snapshot.
 * Fails with SKV_ERROR_FORMAT (no snapshot, damaged, cut short, of another version),
 * SKV_ERROR_VALUE (of another kind of world, or with values that no world has), or
 * SKV_ERROR_MEMORY, and the world stays as it was. Any bytes may be given. */
SKV_API skv_result skv_world_restore(skv_world *world, const void *data, size_t size,
                                     skv_error *error);

/** Makes a world from a snapshot with terrain; `*world` is null on failure. `threads` as in
 * skv_world_def. Any bytes may be given. */
SKV_API skv_result skv_world_load(const void *data, size_t size, int threads, skv_world **world,
                                  skv_error *error);

/** Makes a second world in the same state, which shares the terrain; `*copy` is null on failure. */
SKV_API skv_result skv_world_copy(const skv_world *world, int threads, skv_world **copy,
                                  skv_error *error);

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

/* ---- The host ---- */

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
    int source;               /**< number of the emitter or drain; -1: none */
} skv_event;

/** The events of the last step, in the order in which they happened: from the end of the step
 * before it to its own end, so that whoever reads them after each step misses none. Writes their
 * number. They belong to the world and are valid until the next call that steps or changes it. */
SKV_API const skv_event *skv_world_events(const skv_world *world, int *count);

/** Called before each substep, by the thread that called skv_world_step: the place for forces of
 * the host's own, as velocities that it adds. `dt` is the substep's length, s. It is called for a
 * world that sleeps, too. It may read the world, set velocities, hands and gravity, add and remove
 * particles; views have to be asked for anew once the revision changes. It must not step, destroy
 * or restore the world. Substeps of a length given by gravity stay as they are until the step ends.
 */
typedef void skv_before_substep(skv_world *world, float dt, void *user);

/** Sets that callback; null: none. As long as it does the same, the world's future is the same on
 * any number of threads. A world with one steps its substeps one by one, which costs a little and
 * rounds differently. */
SKV_API void skv_world_set_before_substep(skv_world *world, skv_before_substep *callback,
                                          void *user);

/** Receives one line of text, without a line feed, that the library would print if it printed. */
typedef void skv_logger(const char *text, void *user);

/** Sets where a world says what is no failure but worth knowing: that it had to grow, or that it is
 * overfull: filled to more than 1.1 of what lies in it at rest, where it begins to boil. Null, the
 * default: nowhere. Called by the thread that calls the world. */
SKV_API void skv_world_set_log(skv_world *world, skv_logger *log, void *user);

/** A pointer for the host's own use; null at first. */
SKV_API void skv_world_set_user(skv_world *world, void *user);
SKV_API void *skv_world_user(const skv_world *world);

#ifdef __cplusplus
}
#endif
#endif
