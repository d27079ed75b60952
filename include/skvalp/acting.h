/** @file
 * Acting: what moves the fluid beside its own weight and pressure: gravity, hands, forces, emitters
 * and drains. All of it is plain data, is part of the state, and acts until it is changed.
 */
#ifndef SKVALP_ACTING_H
#define SKVALP_ACTING_H

#include "skvalp/area.h"
#include "skvalp/base.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MAX_HANDS    16
#define SKV_MAX_FORCES   16
#define SKV_MAX_EMITTERS 16
#define SKV_MAX_DRAINS   16

/** Sets gravity, m/s^2, each component -1000..1000, from the next substep on. Unless the definition
 * gave their number, the substeps follow it by the rule: up at once, down when a third of them can
 * be spared; and by the load. */
SKV_API skv_result skv_world_set_gravity(skv_world *world, float gx, float gy, skv_error *error);

/** A body's name: the number that it was given when it was added, never 0, which names nothing, and
 * never given to another in the same world. It is part of the state, as skv_acting_id is. */
typedef uint32_t skv_body_id;

/** A finger or the mouse holding fluid (thesis, section 3.5): within `radius` of (x, y), and fading
 * with the distance, particles are pulled towards the point, slowed down, and carried along with
 * the pointer's velocity. Or it holds a body (skv_world_grasp) by a point, which follows (x, y) as
 * a spring without swing does, and no fluid; and (x, y) goes on with the hand's velocity until it
 * is changed. */
typedef struct skv_hand {
    float x, y;       /**< m */
    float vx, vy;     /**< the pointer's velocity, m/s */
    float radius;     /**< m, > 0; default 0.15 */
    float attraction; /**< m/s^2 towards the point, at half the radius; default 60. At most so much
                         for a body and as much fluid as it displaces */
    float friction;   /**< 1/s: how fast the particles' own velocity fades; default 6. For a body
                         its swing about the point */
    float follow;     /**< 1/s: how fast they take the pointer's velocity; default 6. For a body the
                         frequency of the spring, as an angle */
    skv_body_id body; /**< 0, the default: fluid; else the body that is held, or nothing if that is
                         gone */
    float at_x, at_y; /**< m: where it is held, about its centre of mass as it lies when its angle
                         is 0; each -100..100 */
} skv_hand;

SKV_API skv_hand skv_default_hand(void);

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
    int fluid;    /**< number of the fluid that comes, as skv_world_liquid; 0: the first */
} skv_emitter;

/** A drain: particles in an area are taken out between substeps. */
typedef struct skv_drain {
    skv_area area;
    float rate; /**< m^2/s, at most so much, 0..10000; 0: all that comes */
} skv_drain;

/** What acts has a name: the number that it was given when it was added, never 0, which names
 * nothing, and never given to another in the same world. It stays when others are changed or
 * removed, and is part of the state: after skv_world_restore it names what it named then. */
typedef uint32_t skv_acting_id;

/** The kinds of what has such a name. */
typedef enum skv_acting_kind {
    SKV_ACTING_HAND,
    SKV_ACTING_FORCE,
    SKV_ACTING_EMITTER,
    SKV_ACTING_DRAIN
} skv_acting_kind;

/* One by one. Each kind is a list in the order in which its members were added: what is added comes
 * last, what is changed keeps its place and its name, and where one is removed the others close up.
 * Forces and hands are summed in that order, and emitters and drains take their turns in it; so the
 * same calls in the same order give the same bits. All of it acts from the next substep on, and
 * fails with SKV_ERROR_VALUE (a number out of range, or an id that names none of that kind) or
 * SKV_ERROR_LIMIT (as many as there may be, or 2^30 names given); then nothing has changed, and an
 * `id` that was to be written is 0. `id` may be null. */

/** Adds a hand, force, emitter or drain, and writes its name. */
SKV_API skv_result skv_world_add_hand(skv_world *world, const skv_hand *hand, skv_acting_id *id,
                                      skv_error *error);
SKV_API skv_result skv_world_add_force(skv_world *world, const skv_force *force, skv_acting_id *id,
                                       skv_error *error);
SKV_API skv_result skv_world_add_emitter(skv_world *world, const skv_emitter *emitter,
                                         skv_acting_id *id, skv_error *error);
SKV_API skv_result skv_world_add_drain(skv_world *world, const skv_drain *drain, skv_acting_id *id,
                                       skv_error *error);

/** Makes another of it, with the same name. An emitter that stays where and as fast as it is goes
 * on without a gap. */
SKV_API skv_result skv_world_change_hand(skv_world *world, skv_acting_id id, const skv_hand *hand,
                                         skv_error *error);
SKV_API skv_result skv_world_change_force(skv_world *world, skv_acting_id id,
                                          const skv_force *force, skv_error *error);
SKV_API skv_result skv_world_change_emitter(skv_world *world, skv_acting_id id,
                                            const skv_emitter *emitter, skv_error *error);
SKV_API skv_result skv_world_change_drain(skv_world *world, skv_acting_id id,
                                          const skv_drain *drain, skv_error *error);

/** Takes one of any kind away; the others go on without a gap. False, and nothing has changed, if
 * it is gone already. */
SKV_API bool skv_world_remove_acting(skv_world *world, skv_acting_id id);

/** Its place in the list of its kind (skv_world_hands and so on), counted from 0; -1 if it is gone.
 * `*kind` (null is allowed) is its kind, unless it is gone. */
SKV_API int skv_world_acting_index(const skv_world *world, skv_acting_id id, skv_acting_kind *kind);

/** The name of what is in a place of a list; 0 if there is none. */
SKV_API skv_acting_id skv_world_acting_id(const skv_world *world, skv_acting_kind kind, int index);

/* All of a kind at once: what is in the same place before and after keeps its name, as if it had
 * been changed; more are added, and what has no place any more is removed. */

/** Sets the hands that act from the next step on, replacing all earlier ones; count 0 lets go.
 * Fails with SKV_ERROR_VALUE (a field not finite or out of range: the old hands stay) or
 * SKV_ERROR_LIMIT (more than SKV_MAX_HANDS). */
SKV_API skv_result skv_world_set_hands(skv_world *world, const skv_hand *hands, int count,
                                       skv_error *error);

/** The hands that act; they belong to the world and are valid until the next ones are set. */
SKV_API const skv_hand *skv_world_hands(const skv_world *world, int *count);

/** Sets the forces that act from the next substep on, replacing all earlier ones, and wakes the
 * fluid. Substeps follow as they follow gravity. Fails with SKV_ERROR_VALUE (not finite or out of
 * range: the old forces stay) or SKV_ERROR_LIMIT (more than SKV_MAX_FORCES). */
SKV_API skv_result skv_world_set_forces(skv_world *world, const skv_force *forces, int count,
                                        skv_error *error);

/** The forces that act; they belong to the world and are valid until the next ones are set. */
SKV_API const skv_force *skv_world_forces(const skv_world *world, int *count);

/** Sets the emitters from the next substep on, replacing all earlier ones; one that stays where and
 * as fast as it is goes on without a gap. They stop when the world holds as many particles as
 * `emission_limit`, or with `emission_replaces` the oldest particles go. Fails with SKV_ERROR_VALUE
 * (not finite or out of range: the old ones stay) or SKV_ERROR_LIMIT (more than SKV_MAX_EMITTERS).
 */
SKV_API skv_result skv_world_set_emitters(skv_world *world, const skv_emitter *emitters, int count,
                                          skv_error *error);
/** The emitters; they belong to the world and are valid until the next ones are set. */
SKV_API const skv_emitter *skv_world_emitters(const skv_world *world, int *count);

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

#ifdef __cplusplus
}
#endif
#endif
