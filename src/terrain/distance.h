/* The signed distance to the contour at every pixel centre. */
#ifndef SKV_TERRAIN_DISTANCE_H
#define SKV_TERRAIN_DISTANCE_H

#include "terrain/contour.h"

/* Fills `field`, one float a pixel of `coverage` in its order: positive in air, negative in solid,
 * times `pixel_size`. If there is no wall at all, the distance is the picture's width plus height.
 * Needs four more bytes a pixel while it runs. */
skv_result skv_distance_transform(const skv_coverage *coverage, float pixel_size, float *field,
                                  skv_error *error);

#endif
