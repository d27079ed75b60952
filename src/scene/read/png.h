/* PNG reader: any PNG to pixels, whatever the bytes. */
#ifndef SKV_SCENE_PNG_H
#define SKV_SCENE_PNG_H

#include "scene/image.h"
#include "skvalp/base.h"

/* Decodes a PNG of SKV_TERRAIN_MIN_PIXELS..SKV_TERRAIN_MAX_PIXELS each way: 1 to 16 bits, grey,
 * palette or colour, with or without transparency, interlaced or not. `label` is the file's name in
 * messages. */
skv_result skv_png_read(const uint8_t *data, size_t size, const char *label, skv_image *image,
                        skv_error *error);

/* ---- What decodes ---------------------------------------------------------------------------- */

/* native/ has it from libpng, wasm/ from the host. Decodes a PNG of sound chunks (png_chunks.h)
 * whose size is the image's into its pixels: red, green, blue and alpha, of 16 bits the nearest 8;
 * a colour beyond the palette is black. Fails with SKV_ERROR_FORMAT and a reason of at most 120
 * bytes, also if the stream of pixels is unsound in any way or not just as long as they are; or
 * with SKV_ERROR_MEMORY. */
#define SKV_PNG_REASON 120
skv_result skv_png_decode(const uint8_t *data, size_t size, const skv_image *image,
                          char reason[SKV_PNG_REASON]);

#endif
