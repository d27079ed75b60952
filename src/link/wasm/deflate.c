/* Deflate by the host. */
#include "link/deflate.h"
#include "base/wasm/host.h"

/* How many bytes it wrote, 0 if `room` is too small; and a skv_inflated with the number of bytes.
 */
SKV_HOST(deflate)
size_t host_deflate(const void *data, size_t size, uint8_t *to, size_t room);
SKV_HOST(inflate)
int host_inflate(const uint8_t *packed, size_t size, uint8_t *to, size_t room, size_t *used);

bool skv_deflate(const void *data, size_t size, uint8_t *to, size_t room, size_t *used)
{
    *used = host_deflate(data, size, to, room);
    return true;
}

skv_inflated skv_inflate(const uint8_t *packed, size_t size, uint8_t *to, size_t room, size_t *used)
{
    *used = 0;
    return (skv_inflated)host_inflate(packed, size, to, room, used);
}
