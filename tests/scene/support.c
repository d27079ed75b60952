/* Helpers of the scene tests. Invariant: nothing depends on time, addresses or libm. */
#include "support.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

skv_result load_text(const char *text, const char *const *settings, skv_scene **scene,
                     skv_error *error)
{
    skv_scene_options options = skv_default_scene_options();
    skv_setting list[8];
    for (int i = 0; settings != NULL && settings[2 * i] != NULL; i++) {
        list[i] = (skv_setting){settings[2 * i], settings[2 * i + 1]};
        options.setting_count = i + 1;
    }
    options.settings = list;
    return skv_scene_load_memory(text, strlen(text), "json", "a.json", &options, scene, error);
}

skv_world *open_text(const char *text)
{
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (load_text(text, NULL, &scene, &error) != SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_scene_destroy(scene);
    return world;
}

/* ---- Files ----------------------------------------------------------------------------------- */

static void append(buffer *b, const void *data, size_t size)
{
    if (b->size + size > b->capacity) {
        b->capacity = 2 * (b->size + size);
        b->data = realloc(b->data, b->capacity);
        assert_non_null(b->data);
    }
    memcpy(b->data + b->size, data, size);
    b->size += size;
}

void buffer_free(buffer *b)
{
    free(b->data);
    *b = (buffer){0};
}

buffer buffer_read(const char *path)
{
    buffer b = {0};
    uint8_t block[4096];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    for (size_t got; (got = fread(block, 1, sizeof block, file)) > 0;)
        append(&b, block, got);
    fclose(file);
    return b;
}

/* ---- Pictures -------------------------------------------------------------------------------- */

static void on_write(png_structp png, png_bytep data, size_t size)
{
    append(png_get_io_ptr(png), data, size);
}

static void on_flush(png_structp png)
{
    (void)png;
}

static void write_palette(png_structp png, png_infop info, const png_form *form)
{
    png_color colours[256];
    for (int i = 0; i < form->palette_size; i++)
        colours[i] =
            (png_color){form->palette[3 * i], form->palette[3 * i + 1], form->palette[3 * i + 2]};
    png_set_PLTE(png, info, colours, form->palette_size);
    if (form->palette_alpha != NULL)
        png_set_tRNS(png, info, form->palette_alpha, form->palette_size, NULL);
}

buffer write_png(const png_form *form, const uint8_t *pixels)
{
    return write_noted_png(form, pixels, NULL, 0);
}

buffer write_noted_png(const png_form *form, const uint8_t *pixels, char *note, int compression)
{
    buffer b = {0};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &b, on_write, on_flush);
    png_set_IHDR(png, info, (png_uint_32)form->width, (png_uint_32)form->height, form->depth,
                 form->colour, form->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (form->palette != NULL)
        write_palette(png, info, form);
    if (form->clear_grey >= 0 && form->colour == PNG_COLOR_TYPE_GRAY)
        png_set_tRNS(png, info, NULL, 0, &(png_color_16){.gray = (png_uint_16)form->clear_grey});
    if (note != NULL)
        png_set_text(png, info,
                     &(png_text){.compression = compression,
                                 .key = (char[]){"Comment"},
                                 .text = note,
                                 .text_length = strlen(note)},
                     1);
    png_write_info(png, info);
    size_t stride = png_get_rowbytes(png, info);
    png_bytep *rows = calloc((size_t)form->height, sizeof *rows);
    for (int y = 0; y < form->height; y++)
        rows[y] = (png_bytep)pixels + (size_t)y * stride;
    png_write_image(png, rows);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(rows);
    return b;
}

buffer write_rgb(int width, int height, paint_at *at, void *user)
{
    uint8_t *pixels = calloc((size_t)width * (size_t)height, 3);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            rgb c = at(x, y, user);
            uint8_t *p = pixels + 3 * ((size_t)y * (size_t)width + (size_t)x);
            p[0] = c.r;
            p[1] = c.g;
            p[2] = c.b;
        }
    }
    png_form form = {width, height, 8, PNG_COLOR_TYPE_RGB, 0, NULL, 0, NULL, -1};
    buffer b = write_png(&form, pixels);
    free(pixels);
    return b;
}

/* ---- Memory ---------------------------------------------------------------------------------- */

static int held, allowed = -1;

static void *counted_allocate(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    if (allowed == 0)
        return NULL;
    allowed -= allowed > 0;
    size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    void *memory = aligned_alloc(alignment, rounded > 0 ? rounded : alignment);
    held += memory != NULL;
    return memory;
}

static void counted_release(void *memory, void *user)
{
    (void)user;
    held--;
    free(memory);
}

void watch_memory(void)
{
    held = 0;
    allowed = -1;
    skv_set_allocator(&(skv_allocator){counted_allocate, counted_release, NULL});
}

void limit_allocations(int count)
{
    allowed = count;
}

int blocks_held(void)
{
    return held;
}

void unwatch_memory(void)
{
    skv_set_allocator(NULL);
}

uint32_t dice(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}
