/* PNG reader.
 *
 * Invariant: nothing is allocated by what a file claims before its width and height are known to be
 * allowed, and the decoder holds no more than those pixels: whatever a chunk inflates to is bounded
 * by them. libpng leaves through longjmp; everything it may leave behind is in `decoder`.
 */
#include "scene/read/png.h"

#include <png.h>
#include <setjmp.h>
#include <string.h>

#include "base/memory.h"
#include "skvalp/terrain.h"

#define CHUNK_LIMIT 65536 /* bytes of a chunk beside the pixels, such as a palette */

typedef struct decoder {
    const uint8_t *data;
    size_t size, at;
    png_structp png;
    png_infop info;
    uint8_t *pixels;
    png_bytep *rows;
    bool no_memory;
    char reason[120];
} decoder;

static void on_error(png_structp png, png_const_charp message)
{
    decoder *d = png_get_error_ptr(png);
    skv_format(d->reason, sizeof d->reason, "%s", message);
    longjmp(png_jmpbuf(png), 1);
}

/* Warnings concern chunks that have no say in a scene. */
static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void on_read(png_structp png, png_bytep target, size_t bytes)
{
    decoder *d = png_get_io_ptr(png);
    if (bytes > d->size - d->at)
        png_error(png, "the file ends too early");
    memcpy(target, d->data + d->at, bytes);
    d->at += bytes;
}

static png_voidp on_allocate(png_structp png, png_alloc_size_t bytes)
{
    decoder *d = png_get_mem_ptr(png);
    void *memory = skv_calloc(1, bytes);
    d->no_memory = d->no_memory || memory == NULL;
    return memory;
}

static void on_release(png_structp png, png_voidp memory)
{
    (void)png;
    skv_free(memory);
}

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

/* Looks at the signature and the size in the first chunk before libpng sees anything. */
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

/* Asks libpng for four bytes a pixel and for nothing that is not needed. */
static void configure(decoder *d)
{
    png_set_user_limits(d->png, SKV_TERRAIN_MAX_PIXELS, SKV_TERRAIN_MAX_PIXELS);
    png_set_chunk_malloc_max(d->png, CHUNK_LIMIT);
    png_set_keep_unknown_chunks(d->png, PNG_HANDLE_CHUNK_NEVER, NULL, 0);
    png_set_read_fn(d->png, d, on_read);
    png_read_info(d->png, d->info);
    png_set_expand(d->png); /* palette, few bits and tRNS */
    png_set_scale_16(d->png);
    png_set_gray_to_rgb(d->png);
    png_set_add_alpha(d->png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(d->png);
    png_read_update_info(d->png, d->info);
}

/* Runs libpng; false if it left through longjmp. */
static bool decode(decoder *d, const skv_image *image)
{
    if (setjmp(png_jmpbuf(d->png)) != 0)
        return false;
    configure(d);
    size_t row_bytes = (size_t)image->width * 4;
    if (png_get_rowbytes(d->png, d->info) != row_bytes)
        png_error(d->png, "its pixels have an unknown form");
    d->pixels = skv_calloc((size_t)image->height, row_bytes);
    d->rows = skv_calloc((size_t)image->height, sizeof *d->rows);
    if (d->pixels == NULL || d->rows == NULL) {
        d->no_memory = true;
        return false;
    }
    for (int y = 0; y < image->height; y++)
        d->rows[y] = d->pixels + (size_t)y * row_bytes;
    png_read_image(d->png, d->rows);
    png_read_end(d->png, NULL);
    return true;
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
    decoder d = {.data = data, .size = size};
    d.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &d, on_error, on_warning, &d,
                                     on_allocate, on_release);
    d.info = d.png != NULL ? png_create_info_struct(d.png) : NULL;
    bool done = d.info != NULL && decode(&d, image);
    png_destroy_read_struct(&d.png, &d.info, NULL);
    skv_free(d.rows);
    if (!done) {
        skv_free(d.pixels);
        if (d.no_memory)
            return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
        return fail_damaged(label, d.reason, error);
    }
    compose(d.pixels, (size_t)image->width * (size_t)image->height);
    image->pixels = d.pixels;
    return SKV_OK;
}
