/** @file
 * Air: closed pockets of it push, as what is trapped in an upturned glass or rises as a bubble.
 *
 * A world has none unless it is asked for. Then all that no fluid and no solid fills is air. The
 * atmosphere is what reaches an open side of the world; in a closed one it is the largest piece,
 * and what that becomes. Its pressure never changes. Every other piece is a pocket: it obeys
 * Boyle's law, so it pushes the more, the less room it has. docs/air.md tells how that is computed
 * and what it measures.
 */
#ifndef SKVALP_AIR_H
#define SKVALP_AIR_H

#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Gives a world air of a pressure, Pa m: of the atmosphere, and at first of all pockets.
 * 0..100000; 0, the default: none. At another pressure than before pockets keep what they hold of
 * the atmosphere's. Fails with SKV_ERROR_VALUE (out of range), SKV_ERROR_LIMIT (more than four
 * million squares of a spacing in the world) or SKV_ERROR_MEMORY, and then nothing has changed. */
SKV_API skv_result skv_world_set_air(skv_world *world, float pressure, skv_error *error);
/** That pressure, Pa m; 0: none. */
SKV_API float skv_world_air(const skv_world *world);

/** A pocket of air as it was before the last substep; a world that was restored has yet to find
 * its own in the next one. */
typedef struct skv_pocket {
    float x, y;     /**< its middle, m */
    float volume;   /**< m^2 */
    float pressure; /**< above that of the atmosphere, Pa m */
} skv_pocket;

/** Writes at most `capacity` of a world's pockets, from the highest on, and returns how many there
 * are. */
SKV_API int skv_world_pockets(const skv_world *world, skv_pocket *pockets, int capacity);

#ifdef __cplusplus
}
#endif

#endif
