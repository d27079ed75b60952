/** @file
 * Bodies: rigid things that float, sink, roll and are pushed about, by the fluid and by each other.
 *
 * A body has a shape, a density and a pose. The fluid meets its sides as it meets walls, and what
 * it gives the body changes its velocity and its spin in every substep. Bodies are part of a
 * world's state: snapshots have them, and the same calls give the same bits on any number of
 * threads. docs/bodies.md tells how they are computed and what they measure.
 */
#ifndef SKVALP_BODIES_H
#define SKVALP_BODIES_H

#include "skvalp/acting.h"
#include "skvalp/area.h"
#include "skvalp/base.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SKV_MAX_BODIES 64 /**< in a world at once */

/** How to make a body. Initialise with skv_default_body_def. */
typedef struct skv_body_def {
    uint32_t cookie;
    /** In the body's own frame, m: a circle, a box, a polygon whose sides do not cross, or a swept
     * circle. At least as large as a particle (spacing squared), and at most 8 m from its middle.
     */
    skv_area shape;
    float x, y;     /**< m: where that frame's origin lies; each -100..100 */
    float angle;    /**< rad, counter-clockwise: how it is turned about its origin; -100..100 */
    float vx, vy;   /**< m/s: of its centre of mass; each -100..100 */
    float spin;     /**< rad/s, counter-clockwise; -1000..1000 */
    float density;  /**< kg/m^2 of the sheet, 10..50000; default 500 */
    float friction; /**< Coulomb's number against walls and other bodies, 0..10; default 0.3 */
    float
        restitution; /**< share of the speed with which it leaves what it hits, 0..1; default 0.2 */
    bool fixed;  /**< nothing moves it but its velocity, which stays as it is set; default false */
    bool pinned; /**< it turns about (pin_x, pin_y) without friction and goes nowhere else: vx and
                    vy follow from its spin; default false */
    float pin_x, pin_y; /**< m: a place in the world, in the body or beside it; each -100..100 */
    float motor_speed;  /**< rad/s, counter-clockwise: what a motor at the pin drives it at;
                           -1000..1000; 0 brakes it */
    float motor_torque; /**< N, torque per metre of depth: the most that the motor gives,
                           0..1000000; default 0: there is none */
    bool hosted; /**< an engine of the host's own moves it, see skv_world_lead_body: neither walls
                    nor other hosted bodies stop it by themselves. Not with fixed or pinned; default
                    false */
} skv_body_def;

/** A box of 0.1 x 0.1 m about the origin, at (0, 0) and at rest; and the same for binders. */
SKV_API skv_body_def skv_default_body_def(void);
SKV_API void skv_body_def_init(skv_body_def *def, size_t size);

/** A body as it is. */
typedef struct skv_body {
    skv_body_id id;
    float x, y;  /**< its centre of mass, m */
    float angle; /**< rad, how far it is turned against its shape's frame */
    float vx, vy, spin;
    float density, friction, restitution;
    bool fixed, pinned, hosted;
    float pin_x, pin_y, motor_speed, motor_torque; /**< as in skv_body_def */
    float area, mass,
        inertia; /**< m^2, kg/m and kg m about the centre of mass; of fixed ones, too */
    float moved_mass,
        moved_inertia;      /**< the same with the layer of fluid that moves along with it */
    float force_x, force_y; /**< N/m: what the fluid gave it, mean of the last step ... */
    float torque;           /**< ... and about its centre of mass, N */
    int corners;            /**< of its outline, a polygon that runs counter-clockwise ... */
    float outline[2 * SKV_MAX_CORNERS]; /**< ... x, y, x, y, ...: m about its centre of mass, as it
                                           lies when the angle is 0 */
} skv_body;

/** Adds a body and writes its name. Particles that lie inside it are taken out, their number
 * written to *removed; `id` and `removed` may be null. Fails with SKV_ERROR_VALUE (a number out of
 * range, a shape that is none), SKV_ERROR_LIMIT (SKV_MAX_BODIES) or SKV_ERROR_MEMORY; then nothing
 * has changed. Takes some milliseconds. */
SKV_API skv_result skv_world_add_body(skv_world *world, const skv_body_def *def, skv_body_id *id,
                                      int *removed, skv_error *error);

/** Takes a body away; the fluid closes up. False, and nothing has changed, if it is gone already:
 * bodies that have left through an open side are. */
SKV_API bool skv_world_remove_body(skv_world *world, skv_body_id id);

/** A body by its name; false, and `*body` is all 0, if it is gone. */
SKV_API bool skv_world_body(const skv_world *world, skv_body_id id, skv_body *body);

/** Number of bodies, and one by its place in the order in which they were added. */
SKV_API int skv_world_body_count(const skv_world *world);
SKV_API bool skv_world_body_at(const skv_world *world, int index, skv_body *body);

/** Puts a body's centre of mass to (x, y), each -100..100 m, turned by `angle`. It pushes fluid
 * aside as if it had come there: particles inside it are taken out. A pin comes along. Fails with
 * SKV_ERROR_VALUE (a number out of range, or no such body). */
SKV_API skv_result skv_world_set_body_pose(skv_world *world, skv_body_id id, float x, float y,
                                           float angle, skv_error *error);

/** Sets how a body moves, in the ranges of skv_body_def; a fixed one goes on like that. */
SKV_API skv_result skv_world_set_body_velocity(skv_world *world, skv_body_id id, float vx, float vy,
                                               float spin, skv_error *error);

/** Tells what the host's own engine makes of a hosted body, from skv_before_substep and for that
 * substep: that its centre of mass is at (x, y), m, that it is turned by `angle`, and how it goes
 * on from there. Fluid on its way is swept along, none is taken out, so it is to lead on from where
 * the body is, as far as the engine has corrected that: 0.1 m and 1 rad at most. Until the next
 * substep the fluid, gravity and hands change the velocity, together with that of the fluid that
 * lies on the body, so what is light is not thrown: take it from skv_world_body, and let the engine
 * add no gravity. Else the ranges are those of skv_body_def. Fails with SKV_ERROR_VALUE (a number
 * out of range, no such body, or none that is hosted). docs/bodies.md shows how. */
SKV_API skv_result skv_world_lead_body(skv_world *world, skv_body_id id, float x, float y,
                                       float angle, float vx, float vy, float spin,
                                       skv_error *error);

/** Sets the motor of a pinned body that is not fixed, in the ranges of skv_body_def. Fails with
 * SKV_ERROR_VALUE (a number out of range, no such body, or a motor where it would turn nothing). */
SKV_API skv_result skv_world_set_body_motor(skv_world *world, skv_body_id id, float speed,
                                            float torque, skv_error *error);

/** Makes `*hand` hold the body that lies nearest to (x, y), m, at that point, which may lie beside
 * it: not farther than `reach`, m, which is cut to a smoothing radius. A fixed one goes along with
 * the hand, too, and stops where it is let go. False, and `*hand` holds no body, if there is none.
 * The hand's other members stay as they are. */
SKV_API bool skv_world_grasp(const skv_world *world, float x, float y, float reach, skv_hand *hand);

#ifdef __cplusplus
}
#endif
#endif
