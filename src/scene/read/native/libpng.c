/* PNG by libpng. Invariant: libpng leaves through longjmp; everything it may leave behind is in
 * `decoder`. */
#include <png.h>
#include <setjmp.h>
#include <string.h>

#include "base/memory.h"
#include "scene/read/png.h"
#include "skvalp/terrain.h"

typedef struct decoder {
    const uint8_t *data;
    size_t size, at;
    png_structp png;
    png_infop info;
    png_bytep *rows;
    bool no_memory;
    char *reason;
} decoder;

static void on_error(png_structp png, png_const_charp message)
{
    decoder *d = png_get_error_ptr(png);
    skv_format(d->reason, SKV_PNG_REASON, "%s", message);
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

/* Asks libpng for four bytes a pixel and for nothing that is not needed. */
static void configure(decoder *d)
{
    png_set_user_limits(d->png, SKV_TERRAIN_MAX_PIXELS, SKV_TERRAIN_MAX_PIXELS);
    /* What it would forgive, other decoders may not; but a colour beyond the palette is black. */
    png_set_benign_errors(d->png, 0);
    png_set_check_for_invalid_index(d->png, -1);
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
    d->rows = skv_calloc((size_t)image->height, sizeof *d->rows);
    if (d->rows == NULL) {
        d->no_memory = true;
        return false;
    }
    for (int y = 0; y < image->height; y++)
        d->rows[y] = image->pixels + (size_t)y * row_bytes;
    png_read_image(d->png, d->rows);
    png_read_end(d->png, NULL);
    return true;
}

skv_result skv_png_decode(const uint8_t *data, size_t size, const skv_image *image,
                          char reason[SKV_PNG_REASON])
{
    decoder d = {.data = data, .size = size, .reason = reason};
    d.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &d, on_error, on_warning, &d,
                                     on_allocate, on_release);
    d.info = d.png != NULL ? png_create_info_struct(d.png) : NULL;
    bool done = d.info != NULL && decode(&d, image);
    png_destroy_read_struct(&d.png, &d.info, NULL);
    skv_free(d.rows);
    return done ? SKV_OK : d.no_memory ? SKV_ERROR_MEMORY : SKV_ERROR_FORMAT;
}
