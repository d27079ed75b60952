/* The chunks of a PNG, before a decoder sees them. */
#ifndef SKV_SCENE_PNG_CHUNKS_H
#define SKV_SCENE_PNG_CHUNKS_H

#include <stddef.h>
#include <stdint.h>

/* Copies what a decoder needs of a PNG that begins with signature and header: the header, the
 * palette and the transparency where the pixels have a use for them, the pixels and the end, of
 * each of which the checksum is right. `clean` has room for `size` bytes. Returns what is wrong
 * with the file; null if nothing is. */
const char *skv_png_strip(const uint8_t *data, size_t size, uint8_t *clean, size_t *clean_size);

#endif
