/* The signed distance to the contour at every pixel centre. */
#ifndef SKV_TERRAIN_DISTANCE_H
#define SKV_TERRAIN_DISTANCE_H

#include "terrain/contour.h"
#include "terrain/squares.h"

/* Fills `field`, one float a pixel of `coverage` in its order: positive in air, negative in solid,
 * times `pixel_size`. Farther from walls than SKV_TERRAIN_REACH pixels it is that many. Each is a
 * function of the picture within the reach alone. With `wanted`, the rest of the field stays as it
 * was. `steps`, if it is not null, says how many rows and segments were looked at: at most some
 * fifty a pixel, a hundred where round holes lie close together in dense grain. On failure nothing
 * has changed. */
skv_result skv_distance_fill(const skv_coverage *coverage, float pixel_size,
                             const skv_squares *wanted, float *field, uint64_t *steps,
                             skv_error *error);

#endif
