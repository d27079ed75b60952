/* What the scene tests share: loading from text, writing pictures, counting memory, and dice. */
#ifndef SKV_TESTS_SCENE_SUPPORT_H
#define SKV_TESTS_SCENE_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "skvalp/scene.h"

/* Loads a JSON text as the file "a.json"; with settings, a list of path, value, ..., null. */
skv_result load_text(const char *text, const char *const *settings, skv_scene **scene,
                     skv_error *error);

/* The world of a JSON text, on one thread; fails the test on any error. */
skv_world *open_text(const char *text);

/* A file in memory. */
typedef struct buffer {
    uint8_t *data;
    size_t size, capacity;
} buffer;

void buffer_free(buffer *b);
buffer buffer_read(const char *path);

/* How to write a PNG with libpng: `pixels` holds rows of `channels` samples of `depth` bits, packed
 * as the PNG format packs them. */
typedef struct png_form {
    int width, height;
    int depth;              /* 1, 2, 4, 8, 16 */
    int colour;             /* PNG_COLOR_TYPE_... */
    int interlaced;         /* not 0: Adam7 */
    const uint8_t *palette; /* 3 bytes an entry; null unless a palette */
    int palette_size;
    const uint8_t *palette_alpha; /* a byte an entry, or null */
    int clear_grey;               /* tRNS of a grey picture; -1: none */
} png_form;

buffer write_png(const png_form *form, const uint8_t *pixels);

/* The same with a text in it; `compression` is PNG_TEXT_COMPRESSION_... */
buffer write_noted_png(const png_form *form, const uint8_t *pixels, char *note, int compression);

/* A picture given by a callback as 8-bit RGB. */
typedef struct rgb {
    uint8_t r, g, b;
} rgb;
typedef rgb paint_at(int x, int y, void *user);
buffer write_rgb(int width, int height, paint_at *at, void *user);

/* Memory that the library holds, counted through its allocator hooks from watch_memory on. A limit
 * makes every allocation after that many fail; negative: none does. */
void watch_memory(void);
void limit_allocations(int count);
int blocks_held(void);
void unwatch_memory(void);

/* The same numbers on every machine. */
uint32_t dice(uint32_t *state);

#endif
