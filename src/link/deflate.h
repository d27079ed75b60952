/* Deflate without a head (RFC 1951): native/ has it from zlib, wasm/ from the host. */
#ifndef SKV_LINK_DEFLATE_H
#define SKV_LINK_DEFLATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Deflates as small as it can; *used is 0 if that takes more than `room`. False if memory is out.
 */
bool skv_deflate(const void *data, size_t size, uint8_t *to, size_t room, size_t *used);

typedef enum skv_inflated {
    SKV_INFLATED_WHOLE,
    SKV_INFLATED_DAMAGED, /* or cut short, with something after it, or larger than `room` */
    SKV_INFLATED_NO_MEMORY
} skv_inflated;

/* Inflates any bytes; *used is how many came out, at most `room`. */
skv_inflated skv_inflate(const uint8_t *packed, size_t size, uint8_t *to, size_t room,
                         size_t *used);

#endif
