/* Rasteriser: shapes to coverage, the share of each pixel that is solid. */
#ifndef SKV_SCENE_RASTER_H
#define SKV_SCENE_RASTER_H

#include "scene/shape.h"
#include "skvalp/base.h"

/* Adds and carves the shapes, in order, into `coverage` (width * height bytes, row 0 at the bottom,
 * 255 = solid), which holds the picture below them. */
skv_result skv_raster_solids(const skv_shape *shapes, int count, int width, int height,
                             double pixel_size, uint8_t *coverage, skv_error *error);

#endif
