/* Deflate by zlib. Invariant: it takes memory from nowhere but the library's hooks. */
#include <zlib.h>

#include "base/memory.h"
#include "link/deflate.h"

enum { RAW = -15 }; /* zlib's word for deflate without a head, in windows of 32 KiB */

static voidpf allocate(voidpf user, uInt count, uInt size)
{
    (void)user;
    return skv_calloc(count, size);
}

static void release(voidpf user, voidpf memory)
{
    (void)user;
    skv_free(memory);
}

bool skv_deflate(const void *data, size_t size, uint8_t *to, size_t room, size_t *used)
{
    z_stream stream = {.zalloc = allocate, .zfree = release};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, RAW, 9, Z_DEFAULT_STRATEGY) != Z_OK)
        return false;
    stream.next_in = (z_const Bytef *)data;
    stream.avail_in = (uInt)size;
    stream.next_out = to;
    stream.avail_out = (uInt)room;
    int status = deflate(&stream, Z_FINISH);
    *used = status == Z_STREAM_END ? stream.total_out : 0;
    deflateEnd(&stream);
    return true;
}

skv_inflated skv_inflate(const uint8_t *packed, size_t size, uint8_t *to, size_t room, size_t *used)
{
    z_stream stream = {.zalloc = allocate, .zfree = release};
    *used = 0;
    if (inflateInit2(&stream, RAW) != Z_OK)
        return SKV_INFLATED_NO_MEMORY;
    stream.next_in = (z_const Bytef *)packed;
    stream.avail_in = (uInt)size;
    stream.next_out = to;
    stream.avail_out = (uInt)room;
    int status = inflate(&stream, Z_FINISH);
    bool whole = status == Z_STREAM_END && stream.avail_in == 0;
    *used = stream.total_out;
    inflateEnd(&stream);
    return whole                   ? SKV_INFLATED_WHOLE
           : status == Z_MEM_ERROR ? SKV_INFLATED_NO_MEMORY
                                   : SKV_INFLATED_DAMAGED;
}
