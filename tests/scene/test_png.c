/* Pictures as scenes: every form of PNG reads the same, sizes are limited, and what is painted ends
 * in the world. */
#include "support.h"

#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "scene/read/png.h"
#include <skvalp/acting.h>
#include <skvalp/particles.h>

#define SIZE 32

static skv_result load(const buffer *b, skv_scene **scene, skv_error *error)
{
    return skv_scene_load_memory(b->data, b->size, "png", "p.png", NULL, scene, error);
}

/* ---- Forms ----------------------------------------------------------------------------------- */

/* 0..3 in a pattern that touches every row and column. */
static int shade(int x, int y)
{
    return (x * 7 + y * 3 + x * y) % 4;
}

/* Writes one sample of `depth` bits. */
static void put(uint8_t *row, int index, int depth, unsigned value)
{
    if (depth == 16) {
        row[2 * index] = (uint8_t)(value >> 8);
        row[2 * index + 1] = (uint8_t)value;
    } else if (depth == 8) {
        row[index] = (uint8_t)value;
    } else {
        int bit = index * depth;
        row[bit / 8] |= (uint8_t)(value << (8 - depth - bit % 8));
    }
}

/* The pattern in grey of any depth; with fewer bits than two only black and white are asked. */
static void check_grey(int depth, int colour, int interlaced)
{
    int channels = colour == PNG_COLOR_TYPE_GRAY         ? 1
                   : colour == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                   : colour == PNG_COLOR_TYPE_RGB        ? 3
                                                         : 4;
    uint8_t *pixels = calloc(SIZE, SIZE * 8);
    size_t stride = (size_t)(SIZE * channels * depth + 7) / 8;
    unsigned top = (1u << depth) - 1;
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            unsigned value =
                depth == 1 ? (unsigned)shade(x, y) / 2 : top / 3 * (unsigned)shade(x, y);
            if (depth == 16 && shade(x, y) == 1)
                value -= 0x56; /* 84.66 of 255: rounded, not cut off */
            for (int c = 0; c < channels; c++) {
                bool alpha = c == channels - 1 && channels % 2 == 0;
                put(pixels + (size_t)y * stride, x * channels + c, depth, alpha ? top : value);
            }
        }
    }
    png_form form = {SIZE, SIZE, depth, colour, interlaced, NULL, 0, NULL, -1};
    buffer b = write_png(&form, pixels);
    skv_image image;
    skv_error error = {0};
    if (skv_png_read(b.data, b.size, "p.png", &image, &error) != SKV_OK)
        fail_msg("depth %d, colour %d: %s", depth, colour, error.text);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            int expected = depth == 1 ? shade(x, y) / 2 * 255 : shade(x, y) * 85;
            for (int c = 0; c < 3; c++)
                assert_int_equal(image.pixels[4 * (y * SIZE + x) + c], expected);
        }
    }
    skv_free(image.pixels);
    buffer_free(&b);
    free(pixels);
}

static void test_every_depth_and_colour_type(void **state)
{
    (void)state;
    for (int interlaced = 0; interlaced < 2; interlaced++) {
        for (int depth = 1; depth <= 16; depth *= 2)
            check_grey(depth, PNG_COLOR_TYPE_GRAY, interlaced);
        for (int depth = 8; depth <= 16; depth *= 2) {
            check_grey(depth, PNG_COLOR_TYPE_GRAY_ALPHA, interlaced);
            check_grey(depth, PNG_COLOR_TYPE_RGB, interlaced);
            check_grey(depth, PNG_COLOR_TYPE_RGB_ALPHA, interlaced);
        }
    }
}

static void test_palettes(void **state)
{
    (void)state;
    static const uint8_t palette[12] = {0, 0, 0, 255, 255, 255, 0, 0, 255, 200, 100, 50};
    static const uint8_t alpha[4] = {255, 255, 255, 128};
    for (int depth = 2; depth <= 8; depth *= 2) {
        uint8_t *pixels = calloc(SIZE, SIZE);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++)
                put(pixels + y * SIZE * depth / 8, x, depth, (unsigned)shade(x, y));
        }
        png_form form = {SIZE, SIZE, depth, PNG_COLOR_TYPE_PALETTE, 0, palette, 4, alpha, -1};
        buffer b = write_png(&form, pixels);
        skv_image image;
        assert_int_equal(skv_png_read(b.data, b.size, "p.png", &image, NULL), SKV_OK);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                int index = shade(x, y);
                for (int c = 0; c < 3; c++) {
                    int expected = palette[3 * index + c];
                    expected = index == 3 ? (expected * 128 + 127) / 255 : expected;
                    assert_int_equal(image.pixels[4 * (y * SIZE + x) + c], expected);
                }
            }
        }
        skv_free(image.pixels);
        buffer_free(&b);
        free(pixels);
    }
}

/* What is transparent shows the black of air, by alpha or by a transparent grey. */
static void test_transparency_is_air(void **state)
{
    (void)state;
    uint8_t *pixels = calloc(SIZE * SIZE, 4);
    memset(pixels, 255, SIZE * SIZE * 4);
    for (int i = 0; i < SIZE * SIZE; i++)
        pixels[4 * i + 3] = i % 2 ? 0 : 51;
    png_form form = {SIZE, SIZE, 8, PNG_COLOR_TYPE_RGB_ALPHA, 0, NULL, 0, NULL, -1};
    buffer b = write_png(&form, pixels);
    skv_image image;
    assert_int_equal(skv_png_read(b.data, b.size, "p.png", &image, NULL), SKV_OK);
    for (int i = 0; i < SIZE * SIZE; i++)
        assert_int_equal(image.pixels[4 * i], i % 2 ? 0 : 51);
    skv_free(image.pixels);
    buffer_free(&b);

    memset(pixels, 200, SIZE * SIZE);
    form = (png_form){SIZE, SIZE, 8, PNG_COLOR_TYPE_GRAY, 0, NULL, 0, NULL, 200};
    b = write_png(&form, pixels);
    assert_int_equal(skv_png_read(b.data, b.size, "p.png", &image, NULL), SKV_OK);
    assert_int_equal(image.pixels[0], 0);
    skv_free(image.pixels);
    buffer_free(&b);
    free(pixels);
}

/* ---- Sizes ----------------------------------------------------------------------------------- */

static rgb lower_half_blue(int x, int y, void *user)
{
    (void)x;
    return y >= *(int *)user / 2 ? (rgb){0, 0, 255} : (rgb){0, 0, 0};
}

static void test_sizes(void **state)
{
    (void)state;
    const struct {
        int width, height;
        skv_result code;
        const char *message;
    } cases[] = {
        {16, 16, SKV_OK, NULL},
        {8192, 16, SKV_OK, NULL},
        {16, 160, SKV_OK, NULL},
        {15, 16, SKV_ERROR_VALUE,
         "p.png: the picture has 15 x 16 pixels; allowed are 16 to 8192 each way"},
        {16, 15, SKV_ERROR_VALUE,
         "p.png: the picture has 16 x 15 pixels; allowed are 16 to 8192 each way"},
        {8193, 16, SKV_ERROR_LIMIT,
         "p.png: the picture has 8193 x 16 pixels; allowed are 16 to 8192 each way"},
        {16, 8193, SKV_ERROR_LIMIT,
         "p.png: the picture has 16 x 8193 pixels; allowed are 16 to 8192 each way"},
        {16, 8192, SKV_OK, NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int height = cases[i].height;
        buffer b = write_rgb(cases[i].width, height, lower_half_blue, &height);
        skv_scene *scene;
        skv_error error = {0};
        skv_result result = load(&b, &scene, &error);
        if (cases[i].message != NULL)
            assert_string_equal(error.text, cases[i].message);
        assert_int_equal(result, cases[i].code);
        skv_scene_destroy(scene);
        buffer_free(&b);
    }
}

/* A tall picture becomes narrow rather than too high, unless the width was asked for. */
static void test_a_tall_picture(void **state)
{
    (void)state;
    int height = 400;
    buffer b = write_rgb(16, height, lower_half_blue, &height);
    skv_scene *scene;
    skv_error error = {0};
    assert_int_equal(load(&b, &scene, &error), SKV_OK);
    assert_string_equal(skv_scene_notice(scene, 0),
                        "the picture is so tall that it is made 0.64 m wide");
    skv_scene_destroy(scene);
    skv_scene_options options = skv_default_scene_options();
    options.settings = &(skv_setting){"world.width", "1.6"};
    options.setting_count = 1;
    assert_int_equal(
        skv_scene_load_memory(b.data, b.size, "png", "p.png", &options, &scene, &error),
        SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "--set world.width: makes the picture 40 m high; allowed are 16 "
                        "m, so choose a smaller width");
    buffer_free(&b);
}

/* A header may claim anything; nothing is allocated for it. */
static void test_a_huge_claim_allocates_nothing(void **state)
{
    (void)state;
    int height = 16;
    buffer b = write_rgb(16, 16, lower_half_blue, &height);
    memcpy(b.data + 16, "\x7f\xff\xff\xff\x7f\xff\xff\xff", 8);
    watch_memory();
    limit_allocations(10); /* the builder's few; no pixels */
    skv_scene *scene;
    skv_error error;
    assert_int_equal(load(&b, &scene, &error), SKV_ERROR_LIMIT);
    assert_string_equal(error.text,
                        "p.png: the picture has 2147483647 x 2147483647 pixels; allowed "
                        "are 16 to 8192 each way");
    assert_int_equal(blocks_held(), 0);
    unwatch_memory();
    buffer_free(&b);
}

static void test_files_that_are_no_pictures(void **state)
{
    (void)state;
    const struct {
        const char *bytes;
        size_t size;
        const char *message;
    } cases[] = {
        {"", 0, "p.png: is empty; a PNG picture is needed"},
        {"hello, world", 12,
         "p.png: is not a PNG picture; open it in a painting program and export it as PNG"},
        {"\xff\xd8\xff\xe0", 4,
         "p.png: is a JPEG picture, whatever its name says; open it in a painting program and "
         "export it as PNG"},
        {"RIFF....WEBPVP8 ", 16,
         "p.png: is a WebP picture, whatever its name says; open it in a painting program and "
         "export it as PNG"},
        {"\x89PNG\r\n\x1a\n", 8,
         "p.png: damaged PNG: the file ends too early; save it again, or fetch another copy"},
        {"\x89PNG\r\n\x1a\n....IDAT.........................", 40,
         "p.png: damaged PNG: it begins without a header; save it again, or fetch another copy"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        skv_scene *scene;
        skv_error error;
        assert_int_equal(skv_scene_load_memory(cases[i].bytes, cases[i].size, "png", "p.png", NULL,
                                               &scene, &error),
                         SKV_ERROR_FORMAT);
        assert_string_equal(error.text, cases[i].message);
    }
}

/* ---- Worlds ---------------------------------------------------------------------------------- */

/* A basin with water up to the middle, a green tap above and a red sink in the floor. */
static rgb basin(int x, int y, void *user)
{
    (void)user;
    if (x < 4 || x >= 156 || y >= 86)
        return x == 80 && y == 88 ? (rgb){255, 0, 0} : (rgb){255, 255, 255};
    if (y == 2 && x >= 10 && x < 13)
        return (rgb){0, 255, 0};
    return y >= 45 ? (rgb){0, 0, 255} : (rgb){0, 0, 0};
}

static void test_a_basin(void **state)
{
    (void)state;
    buffer b = write_rgb(160, 90, basin, NULL);
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    if (load(&b, &scene, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_string_equal(skv_scene_name(scene), "p");
    assert_string_equal(skv_scene_title(scene), "p");
    assert_int_equal(skv_scene_particles(scene), 3000);
    assert_string_equal(skv_scene_notice(scene, 0), "1 green area emits fluid at 1 m/s");
    assert_string_equal(skv_scene_notice(scene, 1), "1 red area drains it");
    assert_null(skv_scene_notice(scene, 2));
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    int count;
    const skv_emitter *tap = skv_world_emitters(world, &count);
    assert_int_equal(count, 1);
    assert_float_equal(tap->x, 0.115f, 1e-6f);
    assert_float_equal(tap->y, 0.875f, 1e-6f);
    assert_float_equal(tap->width, 0.03f, 1e-6f);
    assert_true(fabsf(tap->vx) < 1e-6f && tap->vy == -1);
    const skv_drain *sink = skv_world_drains(world, &count);
    assert_int_equal(count, 1);
    assert_int_equal(sink->area.count, 4);
    assert_float_equal(sink->area.corners[0], 0.81f, 1e-6f);
    assert_float_equal(sink->area.corners[1], 0.01f, 1e-6f);
    assert_int_equal(skv_world_particle_count(world), 3000);
    assert_float_equal(skv_terrain_width(skv_world_terrain(world)), 1.6f, 1e-6f);
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < p.count; i++) {
        assert_true(p.x[i] > 0.04f && p.x[i] < 1.56f);
        assert_true(p.y[i] > 0.04f && p.y[i] < 0.451f);
    }
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    buffer_free(&b);
}

/* Draws a 64 x 64 picture from a character per 8 x 8 block. */
static rgb blocks(int x, int y, void *user)
{
    const char *const *rows = user;
    switch (rows[y / 8][x / 8]) {
    case '#':
        return (rgb){255, 255, 255};
    case '~':
        return (rgb){0, 0, 255};
    default:
        return (rgb){0, 0, 0};
    }
}

static skv_result load_blocks(const char *const *rows, skv_scene **scene, skv_error *error)
{
    buffer b = write_rgb(64, 64, blocks, (void *)rows);
    skv_result result = load(&b, scene, error);
    buffer_free(&b);
    return result;
}

static void test_no_blue_pixel(void **state)
{
    (void)state;
    const char *const rows[] = {"########", "#      #", "#      #", "#      #",
                                "#      #", "#      #", "########", "########"};
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    assert_int_equal(load_blocks(rows, &scene, &error), SKV_OK);
    assert_string_equal(skv_scene_notice(scene, 0),
                        "no blue pixel: the lower part starts as water");
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    skv_particles p = skv_world_particles(world);
    float top = 0;
    for (int i = 0; i < p.count; i++)
        top = p.y[i] > top ? p.y[i] : top;
    assert_float_equal(top, 0.4f + 0.4f * 1.0f, 0.03f);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

static void test_pictures_without_room(void **state)
{
    (void)state;
    const char *const solid[] = {"########", "########", "########", "########",
                                 "########", "########", "########", "########"};
    skv_scene *scene;
    skv_error error;
    assert_int_equal(load_blocks(solid, &scene, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "p.png: no pixel is free; paint air dark and fluid blue");

    /* One blue pixel in a slit of one pixel. */
    uint8_t *pixels = calloc(400 * 400, 3);
    memset(pixels, 255, 400 * 400 * 3);
    memset(pixels + 3 * (200 * 400 + 200), 0, 2);
    png_form form = {400, 400, 8, PNG_COLOR_TYPE_RGB, 0, NULL, 0, NULL, -1};
    buffer b = write_png(&form, pixels);
    skv_result result = load(&b, &scene, &error);
    if (result == SKV_OK)
        assert_true(skv_scene_particles(scene) >= 1);
    else
        assert_string_equal(error.text, "p.png: the blue (fluid) pixels have no room for a "
                                        "particle; paint more blue or make the passages wider");
    skv_scene_destroy(scene);
    buffer_free(&b);
    free(pixels);
}

/* A few blue pixels do not become 3000 grains of dust. */
static void test_a_little_blue_takes_few_particles(void **state)
{
    (void)state;
    const char *const rows[] = {"########", "#      #", "#      #", "#  ~   #",
                                "#      #", "#      #", "#      #", "########"};
    skv_scene *scene;
    skv_world *world;
    skv_error error = {0};
    assert_int_equal(load_blocks(rows, &scene, &error), SKV_OK);
    assert_int_equal(skv_scene_create_world(scene, 1, &world, &error), SKV_OK);
    assert_float_equal(skv_world_spacing(world), 1.6f / 400, 1e-5f);
    assert_in_range(skv_scene_particles(scene), 2300, 2600);
    assert_int_equal(skv_world_particle_count(world), skv_scene_particles(scene));
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* ---- Beside a JSON file ---------------------------------------------------------------------- */

static void write_file(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

static void expect(const char *path, skv_result code, const char *message)
{
    skv_scene *scene;
    skv_error error = {0};
    skv_result result = skv_scene_load(path, NULL, &scene, &error);
    if (message != NULL)
        assert_string_equal(error.text, message);
    assert_int_equal(result, code);
    skv_scene_destroy(scene);
}

/* The files that a scene was read from: none for a built-in one. */
static void expect_files(const char *name, const char *first, const char *second)
{
    skv_scene *scene;
    assert_int_equal(skv_scene_load(name, NULL, &scene, NULL), SKV_OK);
    const char *const files[] = {first, second, NULL};
    for (int i = 0; i < 3; i++) {
        if (files[i] != NULL)
            assert_string_equal(skv_scene_file(scene, i), files[i]);
        else
            assert_null(skv_scene_file(scene, i));
    }
    assert_null(skv_scene_file(scene, -1));
    skv_scene_destroy(scene);
}

static rgb white(int x, int y, void *user)
{
    (void)x;
    (void)y;
    (void)user;
    return (rgb){255, 255, 255};
}

static void test_a_picture_beside_a_scene(void **state)
{
    (void)state;
    char folder[] = "/tmp/skvalp-scene-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(chdir(folder), 0);
    assert_int_equal(mkdir("sub", 0700), 0);
    buffer b = write_rgb(160, 90, basin, NULL);
    write_file("sub/basin.png", b.data, b.size);
    write_file("sub/UPPER.PNG", b.data, b.size);
    const struct {
        const char *text;
        skv_result code;
        const char *message;
    } cases[] = {
        {"{\"world\": {\"picture\": \"basin.png\"}}", SKV_OK, NULL},
        {"{\"world\": {\"picture\": \"UPPER.PNG\", \"width\": 3}}", SKV_OK, NULL},
        {"{\"world\": {\n\"picture\": \"missing.png\"}}", SKV_ERROR_FILE,
         "sub/a.json:2: world.picture: sub/missing.png: cannot be opened: No such file or "
         "directory; check the name and the folder"},
        {"{\"world\": {\"picture\": \"../sub/basin.png\"}}", SKV_ERROR_VALUE,
         "sub/a.json:1: world.picture: \"../sub/basin.png\" leaves the scene's folder; allowed is "
         "a path below it"},
        {"{\"world\": {\"picture\": \"/etc/x.png\"}}", SKV_ERROR_VALUE,
         "sub/a.json:1: world.picture: \"/etc/x.png\" leaves the scene's folder; allowed is a path "
         "below it"},
        {"{\"world\": {\"picture\": \"a.json\"}}", SKV_ERROR_VALUE,
         "sub/a.json:1: world.picture: \"a.json\" is not a PNG; allowed is a name that ends in "
         ".png"},
        {"{\"world\": {\"picture\": \"basin.png\",\n\"height\": 1}}", SKV_ERROR_VALUE,
         "sub/a.json:2: world.height: has no place beside a picture; its size follows from "
         "world.width"},
        {"{\"world\": {\n\"picture\": \"bad.png\"}}", SKV_ERROR_FORMAT,
         "sub/a.json:2: world.picture: sub/bad.png: is not a PNG picture; open it in a painting "
         "program and export it as PNG"},
        {"{\"world\":\n\n{\"picture\": \"white.png\"}}", SKV_ERROR_VALUE,
         "sub/a.json:3: world.picture: sub/white.png: no pixel is free; paint air dark and fluid "
         "blue"},
    };
    write_file("sub/bad.png", "no picture", 10);
    buffer blank = write_rgb(32, 32, white, NULL);
    write_file("sub/white.png", blank.data, blank.size);
    buffer_free(&blank);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        write_file("sub/a.json", cases[i].text, strlen(cases[i].text));
        expect("sub/a.json", cases[i].code, cases[i].message);
    }
    expect("sub/UPPER.PNG", SKV_OK, NULL);
    expect_files("sub/UPPER.PNG", "sub/UPPER.PNG", NULL);
    write_file("sub/a.json", cases[0].text, strlen(cases[0].text));
    expect_files("sub/a.json", "sub/basin.png", "sub/a.json");
    expect_files("pool", NULL, NULL);
    expect("sub/none.json", SKV_ERROR_FILE,
           "sub/none.json: cannot be opened: No such file or directory; check the name and the "
           "folder");
    assert_int_equal(mkdir("d.json", 0700), 0);
    expect("d.json", SKV_ERROR_FILE, "d.json: is a directory; a file is needed");
    assert_int_equal(mkfifo("f.png", 0600), 0);
    expect("f.png", SKV_ERROR_FILE, "f.png: is not a regular file; copy what it holds into one");
    write_file("large.png", "", 0);
    assert_int_equal(truncate("large.png", 64 * 1024 * 1024 + 1), 0);
    expect("large.png", SKV_ERROR_LIMIT, "large.png: has 67108865 bytes; allowed are 67108864");

    const char *const left[] = {"sub/a.json",  "sub/basin.png", "sub/UPPER.PNG",
                                "sub/bad.png", "sub/white.png", "sub",
                                "d.json",      "f.png",         "large.png"};
    for (size_t i = 0; i < sizeof left / sizeof left[0]; i++)
        assert_int_equal(remove(left[i]), 0);
    assert_int_equal(chdir("/"), 0);
    assert_int_equal(rmdir(folder), 0);
    buffer_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_depth_and_colour_type),
        cmocka_unit_test(test_palettes),
        cmocka_unit_test(test_transparency_is_air),
        cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_a_tall_picture),
        cmocka_unit_test(test_a_huge_claim_allocates_nothing),
        cmocka_unit_test(test_files_that_are_no_pictures),
        cmocka_unit_test(test_a_basin),
        cmocka_unit_test(test_no_blue_pixel),
        cmocka_unit_test(test_pictures_without_room),
        cmocka_unit_test(test_a_little_blue_takes_few_particles),
        cmocka_unit_test(test_a_picture_beside_a_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
