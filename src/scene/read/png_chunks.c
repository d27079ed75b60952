/* Chunks of a PNG. Decoders differ in how much disorder they forgive; what is wrong with the order,
 * the number, the size or the checksum of chunks that matter is found here, and the others are left
 * out, so that every decoder sees the same sound file.
 *
 * Invariant: no byte is read beyond the file's end, nor written beyond its size.
 */
#include "scene/read/png_chunks.h"

#include <stdbool.h>
#include <string.h>

enum { SIGNATURE = 8, FRAME = 12 /* a chunk's length, name and checksum */ };

/* Chunks that matter, in their order. */
typedef enum kind { OTHER, HEADER, PALETTE, TRANSPARENCY, PIXELS, END } kind;

/* Colour types, as the header has them. */
enum { GREY = 0, COLOUR = 2, INDEXED = 3, GREY_ALPHA = 4, COLOUR_ALPHA = 6 };

typedef struct walk {
    int colour_type;
    kind last;        /* of those that matter */
    bool interrupted; /* something has come after pixels */
    size_t colours;   /* of the palette */
} walk;

static uint32_t big_endian(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* CRC-32, half a byte at a time. */
static uint32_t checksum(const uint8_t *bytes, size_t size)
{
    static const uint32_t table[16] = {0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac,
                                       0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
                                       0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
                                       0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
    uint32_t crc = 0xffffffff;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return ~crc;
}

static kind kind_of(const uint8_t *name)
{
    static const char *const names[] = {"", "IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
    for (int i = HEADER; i <= END; i++) {
        if (memcmp(name, names[i], 4) == 0)
            return (kind)i;
    }
    return OTHER;
}

static bool is_name(const uint8_t *name)
{
    for (int i = 0; i < 4; i++) {
        uint8_t lower = name[i] | 0x20;
        if (lower < 'a' || lower > 'z')
            return false;
    }
    return true;
}

static const char *check_header(walk *w, const uint8_t *header)
{
    static const uint32_t depths[] = {[GREY] = 1 << 1 | 1 << 2 | 1 << 4 | 1 << 8 | 1 << 16,
                                      [COLOUR] = 1 << 8 | 1 << 16,
                                      [INDEXED] = 1 << 1 | 1 << 2 | 1 << 4 | 1 << 8,
                                      [GREY_ALPHA] = 1 << 8 | 1 << 16,
                                      [COLOUR_ALPHA] = 1 << 8 | 1 << 16};
    int depth = header[8], type = header[9];
    bool known = type <= COLOUR_ALPHA && depth <= 16 && (depths[type] >> depth & 1);
    w->colour_type = type;
    return known && header[10] == 0 && header[11] == 0 && header[12] <= 1
               ? NULL
               : "its pixels have an unknown form";
}

/* Sets whether a chunk is of use. */
static const char *check_palette(walk *w, size_t length, bool *wanted)
{
    *wanted = w->colour_type == INDEXED;
    w->colours = length / 3;
    bool sound = length % 3 == 0 && length >= 3 && length <= 768;
    return sound || !*wanted ? NULL : "its palette is damaged";
}

static const char *check_transparency(const walk *w, size_t length, bool *wanted)
{
    *wanted = w->colour_type <= INDEXED;
    bool sound = w->colour_type == INDEXED ? length >= 1 && length <= w->colours
                                           : length == (w->colour_type == GREY ? 2 : 6);
    return sound || !*wanted ? NULL : "its transparency is damaged";
}

/* One that matters. */
static const char *check(walk *w, kind k, const uint8_t *content, size_t length, bool *wanted)
{
    *wanted = true;
    bool next = k > w->last || (k == PIXELS && w->last == PIXELS && !w->interrupted);
    if (!next)
        return "its parts are out of order";
    w->last = k;
    switch (k) {
    case HEADER:
        return check_header(w, content);
    case PALETTE:
        return check_palette(w, length, wanted);
    case TRANSPARENCY:
        return check_transparency(w, length, wanted);
    case PIXELS:
        return w->colour_type == INDEXED && w->colours == 0 ? "its palette is missing" : NULL;
    default:
        return length > 0 ? "its end is damaged" : NULL;
    }
}

const char *skv_png_strip(const uint8_t *data, size_t size, uint8_t *clean, size_t *clean_size)
{
    walk w = {0};
    bool pixels = false;
    memcpy(clean, data, SIGNATURE);
    *clean_size = SIGNATURE;
    for (size_t at = SIGNATURE; w.last != END;) {
        size_t left = size - at, length = left >= FRAME ? big_endian(data + at) : 0;
        if (left < FRAME || length > left - FRAME)
            return "the file ends too early";
        const uint8_t *name = data + at + 4;
        kind k = kind_of(name);
        bool optional = name[0] & 0x20, wanted = false;
        if (!is_name(name) || (k == OTHER && !optional))
            return "it holds something unknown";
        if (k != OTHER) {
            if (checksum(name, length + 4) != big_endian(name + 4 + length))
                return "a checksum is wrong";
            const char *wrong = check(&w, k, name + 4, length, &wanted);
            if (wrong != NULL)
                return wrong;
        }
        pixels = pixels || k == PIXELS;
        w.interrupted = w.last == PIXELS && k != PIXELS;
        if (wanted) {
            memcpy(clean + *clean_size, data + at, length + FRAME);
            *clean_size += length + FRAME;
        }
        at += length + FRAME;
    }
    return pixels ? NULL : "its pixels are missing";
}
