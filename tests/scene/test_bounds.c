/* Small inputs that ask for much: they are refused in one line before any of it is made. What is
 * counted is memory, which is the same on every machine. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "skvalp/world.h"

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

static void check_refused(skv_result result, const skv_scene *scene, const skv_error *error,
                          const char *text)
{
    assert_null(scene);
    assert_string_equal(error->text, text);
    assert_int_equal(result, SKV_ERROR_LIMIT);
}

/* A billion particles are not laid before they are counted. */
static void test_too_fine_a_spacing(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_error error = {0};
    skv_result result =
        load_text("{ \"fluid\": { \"spacing\": 0.0005 },\n  \"world\": { \"width\": 16, "
                  "\"height\": 16, \"pixel\": 0.1 }, \"water\": [ { \"shape\": \"box\" } ] }",
                  NULL, &scene, &error);
    check_refused(result, scene, &error,
                  "a.json:1: fluid.spacing: makes more than 2000000 particles, which are allowed; "
                  "with 0.01132 m it does not");
    result = load_text("{ \"fluid\": { \"spacing\": 0.01132 },\n  \"world\": { \"width\": 16, "
                       "\"height\": 16, \"pixel\": 0.1 }, \"water\": [ { \"shape\": \"box\" } ] }",
                       NULL, &scene, &error);
    assert_int_equal(result, SKV_OK);
    assert_in_range(skv_scene_particles(scene), SKV_MAX_PARTICLES / 2, SKV_MAX_PARTICLES);
    skv_scene_destroy(scene);
}

/* The pixel that is offered for a small or a large world makes it, also of the longest side. */
static void test_offered_pixels(void **state)
{
    (void)state;
    static const struct {
        double width, height, pixel;
        int particles;
    } worlds[] = {{0.01, 0.01, 0.0025, 100}, {0.01, 1, 0.0025, 100}, {0.013, 0.3, 0.0025, 100},
                  {0.0407, 9, 0.01, 100},    {0.333, 16, 0.1, 1000}, {16, 9, 0.001, 20000},
                  {7.77, 0.5, 0.0005, 1000}};
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++) {
        const char *form = "{ \"particles\": %d, \"world\": { \"width\": %.4f, \"height\": %.4f, "
                           "\"pixel\": %.9g }, \"water\": [ { \"shape\": \"box\" } ] }";
        char text[256];
        skv_scene *scene;
        skv_error error = {0};
        snprintf(text, sizeof text, form, worlds[i].particles, worlds[i].width, worlds[i].height,
                 worlds[i].pixel);
        assert_int_equal(load_text(text, NULL, &scene, &error), SKV_ERROR_VALUE);
        const char *offer = strstr(error.text, "each way; ");
        assert_non_null(offer);
        double pixel = strtod(offer + strlen("each way; "), NULL);
        assert_true(pixel > 0);
        snprintf(text, sizeof text, form, worlds[i].particles, worlds[i].width, worlds[i].height,
                 pixel);
        assert_int_equal(load_text(text, NULL, &scene, &error), SKV_OK);
        skv_scene_destroy(scene);
    }
}

static rgb checker(int x, int y, void *user)
{
    (void)user;
    uint8_t grey = (x + y) % 2 ? 255 : 0;
    return (rgb){grey, grey, grey};
}

/* Walls beside every particle: their maps would take a gigabyte. */
static void test_too_fine_walls(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_error error = {0};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 100000;
    buffer picture = write_rgb(512, 512, checker, NULL);
    skv_set_allocator(&(skv_allocator){note_size, give_back, NULL});
    largest = 0;
    skv_result result =
        skv_scene_load_memory(picture.data, picture.size, "png", "c.png", &options, &scene, &error);
    check_refused(result, scene, &error,
                  "c.png: its walls are too fine for a fluid with a radius of 3.98 mm: they take "
                  "more than 32768 blocks; choose fewer particles or a wider spacing, or shorter "
                  "walls");
    assert_true(largest < 16 << 20);
    skv_set_allocator(NULL);
    buffer_free(&picture);
}

static rgb green_dots(int x, int y, void *user)
{
    (void)user;
    return (rgb){0, x % 8 == 0 && y % 8 == 0 ? 255 : 0, 0};
}

/* Too many areas are told before distances are looked for: nothing is made that is larger than the
 * picture. */
static void test_too_many_taps(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_error error = {0};
    buffer picture = write_rgb(512, 512, green_dots, NULL);
    skv_set_allocator(&(skv_allocator){note_size, give_back, NULL});
    largest = 0;
    skv_result result =
        skv_scene_load_memory(picture.data, picture.size, "png", "c.png", NULL, &scene, &error);
    check_refused(result, scene, &error,
                  "c.png: there are more than 16 green (emitter) areas; paint fewer, or join some");
    assert_int_equal(largest, 512 * 512 * 4);
    skv_set_allocator(NULL);
    buffer_free(&picture);
}

/* Loads a world of 16 x 8000 pixels with lines up and down it, of so many pieces in all. */
static skv_result load_lines(int pieces, skv_scene **scene, skv_error *error)
{
    enum { MOST = 999, SIZE = 65536 };
    char *text = malloc(SIZE);
    assert_non_null(text);
    int used = snprintf(text, SIZE,
                        "{ \"world\": { \"width\": 0.032, \"height\": 16, \"pixel\": 0.002 },\n"
                        "  \"water\": [ { \"shape\": \"box\", \"x0\": 0.006 } ],\n  \"solid\": [");
    for (int made = 0; made < pieces; made += MOST) {
        used += snprintf(text + used, (size_t)(SIZE - used),
                         "%s\n{ \"shape\": \"line\", \"thickness\": 0.0024, \"points\": [[0, 0]",
                         made > 0 ? "," : "");
        for (int i = made; i < made + MOST && i < pieces; i++)
            used += snprintf(text + used, (size_t)(SIZE - used), ", [0, %d]", i % 2 ? 0 : 16);
        used += snprintf(text + used, (size_t)(SIZE - used), "] }");
    }
    used += snprintf(text + used, (size_t)(SIZE - used), " ] }");
    assert_in_range(used, 1, SIZE - 1);
    skv_result result = load_text(text, NULL, scene, error);
    free(text);
    return result;
}

/* What thick lines may ask for is counted before they are drawn: pieces times rows of pixels. */
static void test_too_long_lines(void **state)
{
    (void)state;
    skv_scene *scene;
    skv_error error = {0};
    int most = 2097152 / 8000;
    int refused[] = {2500, most + 1};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        skv_result result = load_lines(refused[i], &scene, &error);
        check_refused(result, scene, &error,
                      "a.json:4: solid: its lines are too long for pixels so small: all pieces "
                      "together may go through 2097152 rows of pixels; choose larger pixels or "
                      "fewer points");
    }
    assert_int_equal(load_lines(most, &scene, &error), SKV_OK);
    skv_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_too_fine_a_spacing), cmocka_unit_test(test_offered_pixels),
        cmocka_unit_test(test_too_fine_walls),     cmocka_unit_test(test_too_many_taps),
        cmocka_unit_test(test_too_long_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
