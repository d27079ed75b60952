/* What a picture holds besides its pixels takes no memory to speak of. */
#include "support.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "scene/read/png.h"

#define SIZE 32

static size_t largest; /* block asked for, bytes */

static void *note_size(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    largest = bytes > largest ? bytes : largest;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void give_back(void *memory, void *user)
{
    (void)user;
    free(memory);
}

/* A small picture with a note of `size` letters in it, compressed or not. */
static buffer write_noted(size_t size, int compression)
{
    uint8_t *pixels = calloc(SIZE, SIZE);
    char *note = malloc(size + 1);
    memset(note, 'a', size);
    note[size] = '\0';
    png_form form = {SIZE, SIZE, 8, PNG_COLOR_TYPE_GRAY, 0, NULL, 0, NULL, -1};
    buffer b = write_noted_png(&form, pixels, note, compression);
    free(note);
    free(pixels);
    return b;
}

/* What a chunk beside the pixels inflates to is bounded, whatever it claims. */
static void test_notes_do_not_fill_the_memory(void **state)
{
    (void)state;
    buffer bomb = write_noted(4 << 20, PNG_TEXT_COMPRESSION_zTXt);
    assert_true(bomb.size < 65536);
    skv_set_allocator(&(skv_allocator){note_size, give_back, NULL});
    largest = 0;
    skv_image image;
    skv_error error;
    if (skv_png_read(bomb.data, bomb.size, "p.png", &image, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_true(largest >= SIZE * SIZE * 4 && largest <= 2 * 65536);
    skv_free(image.pixels);
    skv_set_allocator(NULL);
    buffer_free(&bomb);

    buffer large = write_noted(100000, PNG_TEXT_COMPRESSION_NONE);
    if (skv_png_read(large.data, large.size, "p.png", &image, &error) != SKV_OK)
        fail_msg("%s", error.text);
    skv_free(image.pixels);
    buffer_free(&large);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_notes_do_not_fill_the_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
