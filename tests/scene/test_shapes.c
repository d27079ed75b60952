/* Shapes: containment and scan lines agree, and coverage is the area that a shape takes. */
#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/raster.h"
#include "scene/scan.h"
#include "scene/shape.h"

#define SIZE 64

static const double zigzag[] = {5, 5, 50, 20, 20, 30, 55, 60};
static const double star[] = {32, 60, 10, 8, 58, 42, 6, 42, 54, 8};
static const double triangle[] = {10, 10, 50, 20, 20, 50};

static skv_shape line(const double *points, int count, double thickness)
{
    skv_shape s = {
        .kind = SKV_SHAPE_LINE, .points = points, .point_count = count, .radius = thickness / 2};
    skv_shape_set_bounds(&s);
    return s;
}

static skv_shape polygon(const double *points, int count)
{
    skv_shape s = {.kind = SKV_SHAPE_POLYGON, .points = points, .point_count = count};
    skv_shape_set_bounds(&s);
    return s;
}

static skv_shape circle(double x, double y, double radius)
{
    skv_shape s = {.kind = SKV_SHAPE_CIRCLE, .x = x, .y = y, .radius = radius};
    skv_shape_set_bounds(&s);
    return s;
}

static skv_shape box(double x0, double y0, double x1, double y1)
{
    return (skv_shape){.kind = SKV_SHAPE_BOX, .x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1};
}

static void test_spans_hold_what_the_shape_contains(void **state)
{
    (void)state;
    const skv_shape shapes[] = {box(3.2, 4.1, 40.7, 60.3), circle(31.5, 30.2, 21.7),
                                polygon(triangle, 3),      polygon(star, 5),
                                line(zigzag, 4, 7.5),      line(triangle, 3, 0.8)};
    uint32_t seed = 5;
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
        const skv_shape *s = &shapes[i];
        skv_span spans[8];
        skv_scan scan;
        skv_scan_edge edges[8];
        assert_true(skv_scan_edges(s) <= 8);
        skv_scan_begin(&scan, s, edges);
        for (int k = 0; k < 20000; k++) {
            double x = dice(&seed) % 65536 / 1000.0, y = (k + dice(&seed) % 100 / 100.0) / 300;
            int count = skv_scan_line(&scan, y, spans);
            bool in_span = false;
            for (int j = 0; j < count; j++) {
                assert_true(spans[j].begin <= spans[j].end);
                assert_true(j == 0 || spans[j].begin > spans[j - 1].end);
                in_span |= x > spans[j].begin && x < spans[j].end;
            }
            if (in_span != skv_shape_contains(s, x, y))
                fail_msg("shape %zu at %f, %f", i, x, y);
        }
    }
}

/* ---- Coverage -------------------------------------------------------------------------------- */

static double total(const uint8_t *coverage)
{
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        sum += coverage[i] / 255.0;
    return sum;
}

static void draw(const skv_shape *shapes, int count, uint8_t *coverage)
{
    memset(coverage, 0, SIZE * SIZE);
    assert_int_equal(skv_raster_solids(shapes, count, SIZE, SIZE, 1.0, coverage, NULL), SKV_OK);
}

static void test_coverage_is_area(void **state)
{
    (void)state;
    uint8_t coverage[SIZE * SIZE];
    const double pi = 3.14159265358979;
    const double straight[] = {10, 12, 40, 52};
    /* Corners exactly on scan lines. */
    const double diamond[] = {30, 5.03125, 50, 20.03125, 30, 35.03125, 10, 20.03125};
    const struct {
        skv_shape shape;
        double area;
    } cases[] = {
        {box(3.25, 4.5, 40.5, 60.75), 37.25 * 56.25},
        {box(-10, -10, 100, 0.5), 64 * 0.5},
        {box(7.3, 8.2, 7.6, 9.4), 0.3 * 1.2},
        {circle(31.5, 30.2, 21.7), pi * 21.7 * 21.7},
        {circle(30.3, 30.2, 0.4), pi * 0.16},
        {polygon(triangle, 3), 750},
        {polygon(diamond, 4), 600},
        {line(straight, 2, 6), 50 * 6 + pi * 9},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        draw(&cases[i].shape, 1, coverage);
        double difference = fabs(total(coverage) - cases[i].area);
        /* Half a grey level in each of up to 64 edge pixels, and the scan lines' steps. */
        if (difference > 64 * 0.5 / 255 + 0.001 * cases[i].area)
            fail_msg("case %zu: %f, not %f", i, total(coverage), cases[i].area);
    }
}

/* Pixels on an edge hold the share of the shape, within a scan line's 1/16. */
static void test_edges_are_grey(void **state)
{
    (void)state;
    uint8_t coverage[SIZE * SIZE];
    skv_shape s = box(10.25, 20.5, 30.75, 40.25);
    draw(&s, 1, coverage);
    assert_int_equal(coverage[30 * SIZE + 9], 0);
    assert_int_equal(coverage[30 * SIZE + 10], 191);
    assert_int_equal(coverage[30 * SIZE + 11], 255);
    assert_int_equal(coverage[30 * SIZE + 30], 191);
    assert_int_equal(coverage[30 * SIZE + 31], 0);
    assert_int_equal(coverage[20 * SIZE + 15], 128);
    assert_int_equal(coverage[40 * SIZE + 15], 64);
    assert_int_equal(coverage[19 * SIZE + 15], 0);
    assert_int_equal(coverage[41 * SIZE + 15], 0);
}

/* Shapes that share an edge inside a pixel leave no seam; what is carved is gone, and may be filled
 * again. */
static void test_shapes_combine(void **state)
{
    (void)state;
    uint8_t coverage[SIZE * SIZE];
    skv_shape shapes[4] = {box(5, 5, 20.4, 40), box(20.4, 5, 35, 40), circle(20, 20, 8.3),
                           box(15, 15, 17, 17)};
    draw(shapes, 2, coverage);
    assert_int_equal(coverage[30 * SIZE + 20], 255);
    shapes[2].carve = true;
    draw(shapes, 3, coverage);
    assert_int_equal(coverage[20 * SIZE + 20], 0);
    assert_true(fabs(total(coverage) - (30 * 35 - 3.14159265 * 8.3 * 8.3)) < 0.3);
    draw(shapes, 4, coverage);
    assert_int_equal(coverage[16 * SIZE + 16], 255);
    assert_int_equal(coverage[20 * SIZE + 20], 0);
}

/* What no shape touches of the picture below stays, also a part of a pixel. */
static void test_the_picture_below_stays(void **state)
{
    (void)state;
    uint8_t coverage[SIZE * SIZE];
    memset(coverage, 100, sizeof coverage);
    skv_shape shapes[2] = {box(10, 10, 20.5, 20), box(40.5, 10, 50, 20)};
    shapes[1].carve = true;
    assert_int_equal(skv_raster_solids(shapes, 2, SIZE, SIZE, 1.0, coverage, NULL), SKV_OK);
    assert_int_equal(coverage[5 * SIZE + 5], 100);
    assert_int_equal(coverage[15 * SIZE + 5], 100);
    assert_int_equal(coverage[15 * SIZE + 15], 255);
    assert_int_equal(coverage[15 * SIZE + 20], 178);
    assert_int_equal(coverage[15 * SIZE + 40], 50);
    assert_int_equal(coverage[15 * SIZE + 45], 0);
}

/* A shape that is thick enough stays; a thin one is widened around its middle. */
static void test_thin_shapes_are_thickened(void **state)
{
    (void)state;
    skv_shape wall = box(10, 20, 10.5, 40), block = box(10, 20, 14, 40), dot = circle(8, 9, 0.2);
    skv_shape thread = line(zigzag, 4, 0.5), big = polygon(triangle, 3);
    static const double corners[] = {10, 10, 50, 10, 50, 10.5, 10, 10.5};
    skv_shape sliver = polygon(corners, 4);
    assert_true(skv_shape_thicken(&wall, 2));
    assert_true(wall.x0 == 9.25 && wall.x1 == 11.25 && wall.y0 == 20 && wall.y1 == 40);
    assert_false(skv_shape_thicken(&block, 2));
    assert_true(block.x0 == 10 && block.x1 == 14);
    assert_true(skv_shape_thicken(&dot, 2) && dot.radius == 1 && dot.x0 == 7);
    assert_true(skv_shape_thicken(&thread, 2) && thread.radius == 1 && thread.x0 == 4);
    assert_false(skv_shape_thicken(&big, 2));
    assert_true(skv_shape_thicken(&sliver, 2));
    for (int i = 0; i < 100; i++)
        assert_true(skv_shape_contains(&sliver, 10 + 0.4 * i, 10.25));
    assert_false(skv_shape_contains(&sliver, 30, 12));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_thin_shapes_are_thickened),
        cmocka_unit_test(test_spans_hold_what_the_shape_contains),
        cmocka_unit_test(test_coverage_is_area),
        cmocka_unit_test(test_edges_are_grey),
        cmocka_unit_test(test_shapes_combine),
        cmocka_unit_test(test_the_picture_below_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
