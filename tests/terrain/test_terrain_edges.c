/* A terrain's edges: sizes, sides, pictures without a wall, bad definitions, memory failures. */
#include "shapes.h"
#include "support/failing_memory.h"
#include "support/long.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#define NEAR(a, b, tolerance) assert_true(fabs((double)(a) - (double)(b)) < (tolerance))

static void default_is_a_tank(void **state)
{
    (void)state;
    skv_terrain_def def = skv_default_terrain_def();
    skv_terrain *t = NULL;
    assert_int_equal(skv_terrain_create(&def, &t, NULL), SKV_OK);
    assert_int_equal(skv_terrain_pixels_x(t), 640);
    assert_int_equal(skv_terrain_pixels_y(t), 360);
    NEAR(skv_terrain_width(t), 1.6, 1e-6);
    NEAR(skv_terrain_height(t), 0.9, 1e-6);
    assert_true(skv_terrain_pixel_size(t) == 0.0025f);
    assert_int_equal(skv_terrain_open_sides(t), 0);
    /* The walls are at the picture's edges, and distances to them are exact. */
    NEAR(skv_terrain_distance(t, 0, 0.45f), 0, 1e-6);
    NEAR(skv_terrain_distance(t, 1.6f, 0.45f), 0, 1e-6);
    NEAR(skv_terrain_distance(t, 0.8f, 0), 0, 1e-6);
    NEAR(skv_terrain_distance(t, 0.8f, 0.9f), 0, 1e-6);
    NEAR(skv_terrain_distance(t, 0.001f, 0.45f), 0.001, 1e-6);
    NEAR(skv_terrain_distance(t, 0.3f, 0.1f), 0.1, 1e-6);
    NEAR(skv_terrain_distance(t, -0.002f, 0.45f), -0.002, 1e-6);
    NEAR(skv_terrain_distance(t, -1, 0.45f), -1, 1e-5);
    NEAR(skv_terrain_distance(t, 0.8f, 1.9f), -1, 1e-5);
    float lowest, highest, nx, ny;
    skv_terrain_free_range(t, &lowest, &highest);
    NEAR(lowest, 0, 1e-7);
    NEAR(highest, 0.9, 1e-6);
    NEAR(skv_terrain_normal(t, 0.001f, 0.45f, &nx, &ny), 0.001, 1e-6);
    NEAR(nx, 1, 1e-5);
    NEAR(ny, 0, 1e-5);
    skv_terrain_normal(t, 0.8f, 0.8999f, &nx, &ny);
    NEAR(nx, 0, 1e-5);
    NEAR(ny, -1, 1e-5);
    /* From outside, normals lead back. */
    skv_terrain_normal(t, -3, 0.45f, &nx, &ny);
    NEAR(nx, 1, 1e-4);
    skv_terrain_normal(t, 0.8f, -5, &nx, &ny);
    NEAR(ny, 1, 1e-4);
    skv_terrain_normal(t, 1.7f, 1.0f, &nx, &ny);
    assert_true(nx < -0.6f && ny < -0.6f);
    skv_terrain_destroy(t);
}

static void middle_of_a_channel_has_a_normal(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(64, 16, NULL, 0.01f, SKV_SIDE_LEFT | SKV_SIDE_RIGHT);
    float nx = 7, ny = 7;
    skv_terrain_normal(t, 0.32f, 0.08f, &nx, &ny);
    assert_true(nx == 0 && ny == 1);
    skv_terrain_destroy(t);
}

/* Walks a grid of points in and around a terrain; every answer must be finite and normals long 1.
 */
static void probe_everywhere(const skv_terrain *t)
{
    float width = skv_terrain_width(t), height = skv_terrain_height(t);
    for (int j = -8; j <= 40; j++) {
        for (int i = -8; i <= 40; i++) {
            float x = width * (float)i / 32, y = height * (float)j / 32, nx, ny;
            float d = skv_terrain_normal(t, x, y, &nx, &ny);
            assert_true(isfinite(d) && d == skv_terrain_distance(t, x, y));
            NEAR(nx * nx + ny * ny, 1, 1e-5);
            float share = skv_terrain_sweep(t, x, y, width - x, height - y, 0.001f);
            assert_true(share >= 0 && share <= 1);
        }
    }
}

static void pictures_without_a_wall(void **state)
{
    (void)state;
    static uint8_t solid[32 * 16];
    memset(solid, 255, sizeof solid);
    float lowest, highest;
    for (unsigned open = 0; open < 16; open++) {
        skv_terrain *t = make_terrain(32, 16, solid, 0.01f, open);
        probe_everywhere(t);
        assert_true(skv_terrain_distance(t, 0.16f, 0.08f) < 0);
        skv_terrain_free_range(t, &lowest, &highest);
        assert_true(lowest == 0 && highest == 0);
        if (open & SKV_SIDE_LEFT) {
            NEAR(skv_terrain_distance(t, 0, 0.08f), 0, 1e-6);
            NEAR(skv_terrain_distance(t, -0.3f, 0.08f), 0.3, 1e-5);
        }
        if (open == 0)
            NEAR(skv_terrain_distance(t, 0.16f, 0.08f), -0.48, 1e-5);
        skv_terrain_destroy(t);

        t = make_terrain(32, 16, NULL, 0.01f, open);
        probe_everywhere(t);
        assert_true(skv_terrain_distance(t, 0.16f, 0.08f) > 0);
        skv_terrain_free_range(t, &lowest, &highest);
        NEAR(lowest, 0, 1e-7);
        NEAR(highest, 0.16, 1e-6);
        if (open == 15)
            NEAR(skv_terrain_distance(t, 0.16f, 0.08f), 0.48, 1e-5);
        skv_terrain_destroy(t);
    }
}

static void open_sides_are_free(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(64, 32, NULL, 0.01f, SKV_SIDE_TOP | SKV_SIDE_RIGHT);
    /* Free beyond the open sides, and the corner between them is no wall either. The walls' ends
     * are cut like all corners of the contour. */
    NEAR(skv_terrain_distance(t, 0.62f, 0.16f), 0.16, 1e-5);
    NEAR(skv_terrain_distance(t, 0.64f, 0.16f), 0.16, 3e-4);
    NEAR(skv_terrain_distance(t, 0.3f, 0.32f), 0.3, 3e-4);
    assert_true(skv_terrain_distance(t, 1.5f, 0.16f) > 0.8f);
    assert_true(skv_terrain_distance(t, 0.3f, 2) > 1.5f);
    assert_true(skv_terrain_distance(t, 0.9f, 0.9f) > 0.5f);
    assert_true(skv_terrain_distance(t, -0.2f, 0.16f) < -0.1f);
    assert_true(skv_terrain_distance(t, 0.3f, -0.2f) < -0.1f);
    skv_terrain_destroy(t);
}

static void free_range_finds_the_walls(void **state)
{
    (void)state;
    static uint8_t picture[32 * 32];
    memset(picture, 255, sizeof picture);
    float lowest, highest;
    /* A chamber from row 8 to row 19, with a soft ceiling. */
    for (int y = 8; y < 20; y++)
        memset(picture + y * 32 + 5, 0, 12);
    memset(picture + 20 * 32 + 5, 200, 12);
    skv_terrain *t = make_terrain(32, 32, picture, 0.01f, 0);
    skv_terrain_free_range(t, &lowest, &highest);
    NEAR(lowest, 0.08, 1e-6);
    NEAR(highest, 0.195 + 0.01 * 127.5 / 200, 1e-6);
    skv_terrain_destroy(t);
}

/* Flat greys are as solid, or as free, as black and white. */
static void flat_greys_count_fully(void **state)
{
    (void)state;
    static uint8_t picture[64 * 64];
    for (int i = 0; i < 64 * 64; i++)
        picture[i] = i % 64 < 32 ? 140 : 115;
    skv_terrain *t = make_terrain(64, 64, picture, 0.01f, 0);
    NEAR(skv_terrain_distance(t, 0.32f, 0.32f), 0, 1e-6);
    NEAR(skv_terrain_distance(t, 0.22f, 0.32f), -0.1, 1e-6);
    NEAR(skv_terrain_distance(t, 0.42f, 0.32f), 0.1, 1e-6);
    skv_terrain_destroy(t);
}

static void all_sizes_work(void **state)
{
    (void)state;
    const int sizes[][2] = {{16, 16}, {16, 17}, {8192, 64}, {64, 8192}, {333, 257}};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        int width = sizes[k][0], height = sizes[k][1];
        int longer = width > height ? width : height;
        float pixel = longer > 4000 ? 16.0f / 8192 : 0.004f;
        uint8_t *picture = calloc((size_t)width, (size_t)height);
        for (int i = 0; i < width * height; i++)
            picture[i] = (i % width / 6 + i / width / 6) % 3 == 0 ? 255 : 0;
        skv_terrain *t = make_terrain(width, height, picture, pixel, 0);
        skv_terrain *again = make_terrain(width, height, picture, pixel, 0);
        probe_everywhere(t);
        int stride, stride_again;
        const float *field = skv_terrain_distances(t, &stride);
        const float *field_again = skv_terrain_distances(again, &stride_again);
        assert_true(stride >= width && stride == stride_again);
        for (int y = 0; y < height; y += 3) {
            assert_memory_equal(field + (size_t)y * (size_t)stride,
                                field_again + (size_t)y * (size_t)stride,
                                (size_t)width * sizeof *field);
            for (int x = 0; x < width; x += 5) {
                float d = field[(size_t)y * (size_t)stride + (size_t)x];
                assert_int_equal(d < 0, picture[y * width + x] >= 128);
                NEAR(skv_terrain_distance(t, ((float)x + 0.5f) * pixel, ((float)y + 0.5f) * pixel),
                     d, 2e-3 * (double)pixel);
            }
        }
        skv_terrain_destroy(t);
        skv_terrain_destroy(again);
        free(picture);
    }
}

static void expect_refusal(const skv_terrain_def *def, const char *word)
{
    skv_terrain *t = (skv_terrain *)1;
    skv_error error = {0};
    assert_int_equal(skv_terrain_create(def, &t, &error), SKV_ERROR_VALUE);
    assert_null(t);
    assert_int_equal(error.code, SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, word));
    assert_int_equal(skv_terrain_create(def, &t, NULL), SKV_ERROR_VALUE);
}

static void bad_definitions_are_refused(void **state)
{
    (void)state;
    const int sizes[] = {-1, 0, 15, 8193, INT32_MAX};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        skv_terrain_def def = skv_default_terrain_def();
        def.width = sizes[i];
        expect_refusal(&def, "pixels");
        def = skv_default_terrain_def();
        def.height = sizes[i];
        expect_refusal(&def, "pixels");
    }
    const float pixels[] = {0, -1, NAN, INFINITY, -INFINITY, FLT_MIN, FLT_MAX, 0.0251f};
    for (size_t i = 0; i < sizeof pixels / sizeof *pixels; i++) {
        skv_terrain_def def = skv_default_terrain_def();
        def.pixel_size = pixels[i];
        expect_refusal(&def, " m");
    }
    skv_terrain_def def = skv_default_terrain_def();
    def.open_sides = 16;
    expect_refusal(&def, "open_sides");
    def = skv_default_terrain_def();
    def.pixel_size = 0.025f;
    skv_terrain *t = NULL;
    assert_int_equal(skv_terrain_create(&def, &t, NULL), SKV_OK);
    skv_terrain_destroy(t);
    skv_terrain_destroy(NULL);
}

enum { BARRED = 1920 }; /* pixels along each side */

/* A picture of horizontal bars: `period` rows from one to the next, the first half of them solid.
 */
static skv_result create_bars(int period, skv_terrain **made, skv_error *error)
{
    uint8_t *picture = calloc(BARRED, BARRED);
    assert_non_null(picture);
    for (int y = 0; y < BARRED; y++)
        if (y % period < period / 2)
            memset(picture + (size_t)y * BARRED, 255, BARRED);
    skv_terrain_def def = skv_default_terrain_def();
    def.width = def.height = BARRED;
    def.pixel_size = 1.6f / BARRED;
    def.coverage = picture;
    skv_result result = skv_terrain_create(&def, made, error);
    free(picture);
    return result;
}

/* Of 1920 x 1920 pixels bars of one row have 3.7 million edges, of three 1.2 million; then a row is
 * painted in the air between any two of these. */
static void too_many_edges_are_refused(void **state)
{
    (void)state;
    enum { BARS = BARRED / 6 };
    skv_terrain *t = NULL, *painted = NULL;
    skv_error error = {0};
    assert_int_equal(create_bars(2, &t, &error), SKV_ERROR_LIMIT);
    assert_null(t);
    assert_non_null(strstr(error.text, "sides of pixels"));
    assert_int_equal(create_bars(6, &t, &error), SKV_OK);
    skv_brush_stroke strokes[BARS];
    const float pixel = 1.6f / BARRED;
    for (int i = 0; i < BARS; i++) {
        float y = (6 * (float)i + 4.5f) * pixel;
        strokes[i] = (skv_brush_stroke){.x1 = 1.6f, .y0 = y, .y1 = y, .radius = 0.5f * pixel};
    }
    assert_int_equal(skv_terrain_paint(t, strokes, BARS, &painted, &error), SKV_ERROR_LIMIT);
    assert_null(painted);
    assert_non_null(strstr(error.text, "sides of pixels"));
    assert_int_equal(skv_terrain_paint(t, strokes, BARS / 2, &painted, &error), SKV_OK);
    skv_terrain_destroy(painted);
    skv_terrain_destroy(t);
}

static void count_assertion(const char *condition, const char *file, int line, void *user)
{
    (void)condition;
    (void)file;
    (void)line;
    ++*(int *)user;
}

static void misuse_is_asserted(void **state)
{
    (void)state;
    int count = 0;
    float a, b;
    int stride;
    skv_set_assert_handler(count_assertion, &count);
    skv_terrain_def def = {.width = 64, .height = 64, .pixel_size = 0.01f};
    skv_terrain *t = NULL;
    assert_int_equal(skv_terrain_create(&def, &t, NULL), SKV_ERROR_VALUE); /* no cookie */
    assert_int_equal(skv_terrain_create(NULL, &t, NULL), SKV_ERROR_VALUE);
    def = skv_default_terrain_def();
    assert_int_equal(skv_terrain_create(&def, NULL, NULL), SKV_ERROR_VALUE);
    assert_true(skv_terrain_width(NULL) == 0 && skv_terrain_height(NULL) == 0);
    assert_true(skv_terrain_pixels_x(NULL) == 0 && skv_terrain_pixels_y(NULL) == 0);
    assert_true(skv_terrain_pixel_size(NULL) == 0 && skv_terrain_open_sides(NULL) == 0);
    assert_true(skv_terrain_distance(NULL, 0, 0) == 0);
    assert_true(skv_terrain_normal(NULL, 0, 0, &a, &b) == 0);
    assert_true(skv_terrain_sweep(NULL, 0, 0, 1, 1, 0) == 0);
    skv_terrain_free_range(NULL, &a, &b);
    assert_null(skv_terrain_distances(NULL, &stride));
    skv_set_assert_handler(NULL, NULL);
    assert_int_equal(count, 14);
}

static void odd_points_are_harmless(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(64, 64, NULL, 0.01f, 0);
    const float odd[] = {1e30f, -1e30f, FLT_MAX, -FLT_MAX, FLT_MIN, NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        float nx, ny, d = skv_terrain_normal(t, odd[i], 0.3f, &nx, &ny);
        if (isfinite(odd[i]) && fabsf(odd[i]) > 1)
            assert_true(d < -1e29f);
        if (isfinite(odd[i]))
            NEAR(nx * nx + ny * ny, 1, 1e-5);
        skv_terrain_distance(t, 0.3f, odd[i]);
        skv_terrain_sweep(t, 0.3f, odd[i], odd[i], 0.3f, 0.01f);
    }
    skv_terrain_destroy(t);
}

static void a_shared_terrain_lives_as_long_as_one_holds_it(void **state)
{
    (void)state;
    failing_memory memory;
    failing_memory_start(&memory, -1);
    skv_terrain *first = make_terrain(48, 40, NULL, 0.01f, SKV_SIDE_TOP);
    skv_terrain *second = skv_terrain_share(first), *third = skv_terrain_share(second);
    assert_ptr_equal(second, first);
    skv_terrain_destroy(first);
    skv_terrain_destroy(third);
    assert_true(memory.live > 0);
    NEAR(skv_terrain_distance(second, 0.24f, 0.1f), 0.1, 1e-5);
    skv_terrain_destroy(second);
    assert_int_equal(memory.live, 0);
    failing_memory_stop();
}

static void memory_failures_leave_nothing(void **state)
{
    (void)state;
    skv_terrain_def def = skv_default_terrain_def();
    failing_memory memory;
    int allocations = 0;
    for (int fail_at = 0; fail_at < 100; fail_at++) {
        skv_terrain *t = NULL;
        skv_error error = {0};
        failing_memory_start(&memory, fail_at);
        skv_result result = skv_terrain_create(&def, &t, &error);
        if (result == SKV_OK) {
            skv_terrain_destroy(t);
            assert_int_equal(memory.live, 0);
            break;
        }
        allocations++;
        assert_int_equal(result, SKV_ERROR_MEMORY);
        assert_int_equal(error.code, SKV_ERROR_MEMORY);
        assert_null(t);
        assert_int_equal(memory.live, 0);
    }
    failing_memory_stop();
    assert_int_equal(allocations, 6);
}

/* The largest picture; takes seconds and 650 MB, so only where it is asked for. */
static void largest_picture(void **state)
{
    (void)state;
    if (!long_tests())
        skip();
    const int side = SKV_TERRAIN_MAX_PIXELS;
    uint8_t *picture = malloc((size_t)side * (size_t)side);
    for (int y = 0; y < side; y++) {
        for (int x = 0; x < side; x++) {
            int u = x % 1024 - 512, v = y % 1024 - 512;
            picture[(size_t)y * (size_t)side + (size_t)x] = u * u + v * v < 300 * 300 ? 255 : 0;
        }
    }
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    skv_terrain *t = make_terrain(side, side, picture, 16.0f / 8192, 0);
    clock_gettime(CLOCK_MONOTONIC, &to);
    double seconds = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
    print_message("%d x %d pixels: %.2f s, %.0f ns a pixel\n", side, side, seconds,
                  seconds * 1e9 / side / side);
    const float pixel = 16.0f / 8192;
    float middle = 512.5f * pixel; /* of the first disc */
    NEAR(skv_terrain_distance(t, middle + 280 * pixel, middle), -20 * pixel, pixel);
    NEAR(skv_terrain_distance(t, middle, middle), -SKV_TERRAIN_REACH * pixel, 1e-6);
    skv_terrain_destroy(t);
    free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(default_is_a_tank),
        cmocka_unit_test(middle_of_a_channel_has_a_normal),
        cmocka_unit_test(pictures_without_a_wall),
        cmocka_unit_test(open_sides_are_free),
        cmocka_unit_test(free_range_finds_the_walls),
        cmocka_unit_test(flat_greys_count_fully),
        cmocka_unit_test(all_sizes_work),
        cmocka_unit_test(bad_definitions_are_refused),
        cmocka_unit_test(too_many_edges_are_refused),
        cmocka_unit_test(misuse_is_asserted),
        cmocka_unit_test(odd_points_are_harmless),
        cmocka_unit_test(a_shared_terrain_lives_as_long_as_one_holds_it),
        cmocka_unit_test(memory_failures_leave_nothing),
        cmocka_unit_test(largest_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
