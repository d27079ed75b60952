/* PNG reader (libpng): any PNG to pixels, whatever the bytes. */
#ifndef SKV_SCENE_PNG_H
#define SKV_SCENE_PNG_H

#include "scene/image.h"
#include "skvalp/base.h"

/* Decodes a PNG of SKV_TERRAIN_MIN_PIXELS..SKV_TERRAIN_MAX_PIXELS each way: 1 to 16 bits, grey,
 * palette or colour, with or without transparency, interlaced or not. `label` is the file's name in
 * messages. */
skv_result skv_png_read(const uint8_t *data, size_t size, const char *label, skv_image *image,
                        skv_error *error);

#endif
