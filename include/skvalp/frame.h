/** @file
 * Frame: what can be seen of a world at one moment, as plain data.
 *
 * Whoever shows a world (renderers, hosts' own pictures) reads a frame and nothing else, so that a
 * world may be stepped on one thread and shown on another: there, the frame is a copy.
 */
#ifndef SKVALP_FRAME_H
#define SKVALP_FRAME_H

#include "skvalp/base.h"
#include "skvalp/bodies.h"
#include "skvalp/particles.h"
#include "skvalp/terrain.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A world at a moment. Nothing in it changes or frees what it points at. */
typedef struct skv_frame {
    double time;                /**< s, of the substeps taken */
    skv_particles particles;    /**< in the order in which they were added */
    int awake;                  /**< of them and of the bodies; 0: the world is at rest */
    const skv_terrain *terrain; /**< never changes */
    float spacing;              /**< s, m */
    float smoothing_radius;     /**< h, m */
    float density;              /**< at rest, kg/m^2 of the sheet */
    float gravity_x, gravity_y; /**< m/s^2 */
    const skv_liquid *fluids;   /**< by number, the first included */
    int fluid_count;            /**< of them; 0: who shows particles of his own knows none */
    const skv_body *bodies;     /**< in the order in which they were added; null: there are none */
    int body_count;             /**< of them */
} skv_frame;

/** The world as it is, without a copy: its arrays and terrain, which are valid as long as
 * skv_world_revision stays the same, and change with the next step. */
SKV_API skv_frame skv_world_frame(const skv_world *world);

#ifdef __cplusplus
}
#endif
#endif
