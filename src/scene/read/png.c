/* PNG reader: looks at a file before a decoder does, and lays what that yields over black.
 *
 * Invariant: nothing is allocated by what a file claims before its width and height are known to be
 * allowed, and the decoder holds no more than those pixels: whatever a chunk inflates to is bounded
 * by them.
 */
#include "scene/read/png.h"

#include <string.h>

#include "base/memory.h"
#include "scene/read/png_chunks.h"
#include "skvalp/terrain.h"

static uint32_t big_endian(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static skv_result fail_damaged(const char *label, const char *reason, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_FORMAT,
                    "%s: damaged PNG: %s; save it again, or fetch another copy", label, reason);
}

/* What a file is that is no PNG, by its first bytes. */
static const char *name_format(const uint8_t *data, size_t size)
{
    static const struct {
        const char *bytes, *name;
        size_t at, count;
    } formats[] = {
        {"\xff\xd8\xff", "a JPEG picture, whatever its name says", 0, 3},
        {"GIF8", "a GIF picture, whatever its name says", 0, 4},
        {"BM", "a BMP picture, whatever its name says", 0, 2},
        {"WEBP", "a WebP picture, whatever its name says", 8, 4},
        {"II*", "a TIFF picture, whatever its name says", 0, 3},
        {"MM\0*", "a TIFF picture, whatever its name says", 0, 4},
    };
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        size_t end = formats[i].at + formats[i].count;
        if (size >= end && memcmp(data + formats[i].at, formats[i].bytes, formats[i].count) == 0)
            return formats[i].name;
    }
    return "not a PNG picture";
}

/* Looks at the signature and the size in the first chunk before the decoder sees anything. */
static skv_result check_header(const uint8_t *data, size_t size, const char *label,
                               skv_image *image, skv_error *error)
{
    static const uint8_t header[16] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n',
                                       0,    0,   0,   13,  'I',  'H',  'D',  'R'};
    if (size == 0)
        return skv_fail(error, SKV_ERROR_FORMAT, "%s: is empty; a PNG picture is needed", label);
    if (memcmp(data, header, size < 8 ? size : 8) != 0)
        return skv_fail(error, SKV_ERROR_FORMAT,
                        "%s: is %s; open it in a painting program and export it as PNG", label,
                        name_format(data, size));
    if (size < 33)
        return fail_damaged(label, "the file ends too early", error);
    if (memcmp(data, header, 16) != 0)
        return fail_damaged(label, "it begins without a header", error);
    uint32_t width = big_endian(data + 16), height = big_endian(data + 20);
    bool large = width > SKV_TERRAIN_MAX_PIXELS || height > SKV_TERRAIN_MAX_PIXELS;
    if (large || width < SKV_TERRAIN_MIN_PIXELS || height < SKV_TERRAIN_MIN_PIXELS)
        return skv_fail(error, large ? SKV_ERROR_LIMIT : SKV_ERROR_VALUE,
                        "%s: the picture has %lu x %lu pixels; allowed are %d to %d each way",
                        label, (unsigned long)width, (unsigned long)height, SKV_TERRAIN_MIN_PIXELS,
                        SKV_TERRAIN_MAX_PIXELS);
    image->width = (int)width;
    image->height = (int)height;
    return SKV_OK;
}

/* Lays the pixels over black. */
static void compose(uint8_t *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++, pixels += 4) {
        unsigned alpha = pixels[3];
        for (int c = 0; alpha != 255 && c < 3; c++)
            pixels[c] = (uint8_t)((pixels[c] * alpha + 127) / 255);
        pixels[3] = 255;
    }
}

skv_result skv_png_read(const uint8_t *data, size_t size, const char *label, skv_image *image,
                        skv_error *error)
{
    *image = (skv_image){0};
    skv_result result = check_header(data, size, label, image, error);
    if (result != SKV_OK)
        return result;
    size_t pixels = (size_t)image->width * (size_t)image->height, clean_size;
    char reason[SKV_PNG_REASON] = "";
    /* Memory that nothing is written to costs nothing: a short file may claim a large picture. */
    uint8_t *clean = skv_malloc(size, 1);
    image->pixels = skv_malloc(pixels, 4);
    result = SKV_ERROR_MEMORY;
    if (clean != NULL && image->pixels != NULL) {
        const char *wrong = skv_png_strip(data, size, clean, &clean_size);
        skv_format(reason, sizeof reason, "%s", wrong != NULL ? wrong : "");
        result =
            wrong != NULL ? SKV_ERROR_FORMAT : skv_png_decode(clean, clean_size, image, reason);
    }
    skv_free(clean);
    if (result == SKV_OK) {
        compose(image->pixels, pixels);
        return SKV_OK;
    }
    skv_free(image->pixels);
    image->pixels = NULL;
    return result == SKV_ERROR_MEMORY
               ? skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label)
               : fail_damaged(label, reason, error);
}
