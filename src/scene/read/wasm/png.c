/* PNG by the host. Invariant: what comes has the image's size, whatever the host finds. */
#include "scene/read/png.h"
#include "base/wasm/host.h"

/* Writes 4 * width * height bytes; a skv_result, with a reason as text. */
SKV_HOST(decode_png)
int host_decode_png(const uint8_t *data, size_t size, int width, int height, uint8_t *pixels,
                    char *reason, size_t room);

skv_result skv_png_decode(const uint8_t *data, size_t size, const skv_image *image,
                          char reason[SKV_PNG_REASON])
{
    return (skv_result)host_decode_png(data, size, image->width, image->height, image->pixels,
                                       reason, SKV_PNG_REASON);
}
