/* Rasteriser: shapes to coverage, the share of each pixel that is solid. */
#ifndef SKV_SCENE_RASTER_H
#define SKV_SCENE_RASTER_H

#include "scene/shape.h"
#include "skvalp/base.h"

/* The rows of pixels that the pieces of thick lines may go through, each piece counted by itself:
 * a row takes a piece 1 to 2 us, so all of them 2 to 4 s. */
#define SKV_RASTER_MOST_ROWS 2097152

/* The first shape with which thick lines go through more rows than that; `count` if none is. */
int skv_raster_too_much(const skv_shape *shapes, int count, int height, double pixel_size);

/* Adds and carves the shapes, in order, into `coverage` (width * height bytes, row 0 at the bottom,
 * 255 = solid), which holds the picture below them. */
skv_result skv_raster_solids(const skv_shape *shapes, int count, int width, int height,
                             double pixel_size, uint8_t *coverage, skv_error *error);

#endif
