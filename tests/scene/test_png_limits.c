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

/* ---- Large pictures in short files ----------------------------------------------------------- */

enum { MARK = 0xa5, APART = 1 << 20 /* bytes from mark to mark */ };

static size_t blocks, touched; /* that were marked, and of these written to */

/* Only marks and size are written, so that the rest takes no memory. */
static void *mark_large(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    size_t head = alignment > sizeof bytes ? alignment : sizeof bytes;
    uint8_t *block = aligned_alloc(alignment, (bytes + 2 * head) / alignment * alignment);
    assert_non_null(block);
    memcpy(block, &bytes, sizeof bytes);
    for (size_t at = APART; at < bytes; at += APART)
        block[head + at] = MARK;
    blocks += bytes > APART;
    return block + head;
}

static void look_at_marks(void *memory, void *user)
{
    (void)user;
    size_t bytes, written = 0;
    uint8_t *block = (uint8_t *)memory - 64;
    memcpy(&bytes, block, sizeof bytes);
    for (size_t at = APART; at < bytes; at += APART)
        written += ((uint8_t *)memory)[at] != MARK;
    touched += written > 0;
    free(block);
}

static void write_big_endian(uint8_t *bytes, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        bytes[i] = (uint8_t)(value >> (24 - 8 * i));
}

static void claim_size(buffer *b, uint32_t side)
{
    write_big_endian(b->data + 16, side);
    write_big_endian(b->data + 20, side);
    uint32_t sum = 0xffffffffu;
    for (size_t i = 12; i < 29; i++) {
        sum ^= b->data[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    write_big_endian(b->data + 29, ~sum);
}

/* A short file that claims to be large is refused before a large block is written to. */
static void test_a_claim_costs_nothing(void **state)
{
    (void)state;
    buffer b = write_noted(10, PNG_TEXT_COMPRESSION_NONE);
    claim_size(&b, 8192);
    skv_set_allocator(&(skv_allocator){mark_large, look_at_marks, NULL});
    blocks = touched = 0;
    skv_image image;
    skv_error error;
    assert_int_equal(skv_png_read(b.data, b.size, "p.png", &image, &error), SKV_ERROR_FORMAT);
    assert_true(blocks >= 1);
    assert_int_equal(touched, 0);
    skv_set_allocator(NULL);
    buffer_free(&b);
}

/* ---- Large pictures, opened ------------------------------------------------------------------ */

enum { HEAD = 64, LARGE = 2048 };

static size_t held, peak; /* bytes */

static void *count_bytes(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    assert_true(alignment <= HEAD);
    uint8_t *block = aligned_alloc(HEAD, (bytes + 2 * HEAD - 1) / HEAD * HEAD);
    assert_non_null(block);
    memcpy(block, &bytes, sizeof bytes);
    held += bytes;
    peak = held > peak ? held : peak;
    return block + HEAD;
}

static void uncount_bytes(void *memory, void *user)
{
    (void)user;
    size_t bytes;
    memcpy(&bytes, (uint8_t *)memory - HEAD, sizeof bytes);
    held -= bytes;
    free((uint8_t *)memory - HEAD);
}

/* A basin of slanted walls, half full. */
static rgb paint_basin(int x, int y, void *user)
{
    (void)user;
    if (x < y / 8 || x > LARGE - y / 8)
        return (rgb){255, 255, 255};
    return y > LARGE / 2 ? (rgb){32, 64, 255} : (rgb){0, 0, 0};
}

/* A picture takes at most eight bytes a pixel to open, 512 MiB for the largest: its colours, four
 * of them, go once they are read. */
static void test_a_large_picture_is_opened_in_little(void **state)
{
    (void)state;
    buffer b = write_rgb(LARGE, LARGE, paint_basin, NULL);
    skv_set_allocator(&(skv_allocator){count_bytes, uncount_bytes, NULL});
    held = peak = 0;
    skv_scene *scene;
    skv_world *world = NULL;
    skv_error error;
    if (skv_scene_load_memory(b.data, b.size, "png", "p.png", NULL, &scene, &error) != SKV_OK ||
        skv_scene_create_world(scene, 1, &world, &error) != SKV_OK)
        fail_msg("%s", error.text);
    double each = (double)peak / LARGE / LARGE;
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    assert_int_equal(held, 0);
    skv_set_allocator(NULL);
    buffer_free(&b);
    if (!(each <= 8))
        fail_msg("%.2f bytes a pixel", each);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_notes_do_not_fill_the_memory),
        cmocka_unit_test(test_a_claim_costs_nothing),
        cmocka_unit_test(test_a_large_picture_is_opened_in_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
