/* The distance transform against the brute force over all segments of the contour, and the contour
 * itself on the cases that matter. */
#include "shapes.h"
#include "terrain/contour.h"
#include "terrain/distance.h"
#include "terrain/terrain.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SIDE 64

static double distance_to(const skv_wall_segment *s, double x, double y)
{
    double ux = (double)s->x1 - (double)s->x0, uy = (double)s->y1 - (double)s->y0;
    double px = x - (double)s->x0, py = y - (double)s->y0, square = ux * ux + uy * uy;
    double t = square > 0 ? fmin(1, fmax(0, (px * ux + py * uy) / square)) : 0;
    return hypot(px - t * ux, py - t * uy);
}

/* Pictures with walls of all sorts. */
static uint8_t paint(int kind, int x, int y, dice *d)
{
    double share = 0;
    switch (kind) {
    case 0: /* grey noise */
        share = roll(d);
        break;
    case 1: /* lone pixels */
        share = roll(d) < 0.02;
        break;
    case 2: /* binary noise */
        share = roll(d) < 0.5;
        break;
    case 3: /* a soft landscape */
        share = 0.5 + 0.5 * sin(x * 0.2 + y * 0.03) * sin(y * 0.15);
        break;
    case 4: /* a disc */
        share = 20.8 - hypot(x - 40, y - 50);
        break;
    case 5: /* lines one pixel wide */
        share = x == y || x + y == 70 || x == 30;
        break;
    default: /* the inside of a bowl */
        share = hypot(x - 47.3, y - 50.1) - 40;
        break;
    }
    return (uint8_t)(255 * fmin(1, fmax(0, share)) + 0.5);
}

/* What is tested: the distances of all pixels, to be freed. */
static float *find_distances(const skv_coverage *coverage)
{
    float *field = calloc((size_t)coverage->columns * (size_t)coverage->rows, sizeof *field);
    assert_int_equal(skv_distance_fill(coverage, 1, NULL, field, NULL, NULL), SKV_OK);
    return field;
}

/* What it is tested by: the segments of all cells, to be freed. */
static skv_wall_segment *find_segments(const skv_coverage *coverage, int *count)
{
    size_t pixels = (size_t)coverage->columns * (size_t)coverage->rows;
    skv_wall_segment *segments = calloc(2 * pixels, sizeof *segments);
    *count = 0;
    for (int y = 0; y + 1 < coverage->rows; y++) {
        for (int x = 0; x + 1 < coverage->columns; x++)
            *count += skv_cell_segments(coverage, x, y, segments + *count);
    }
    return segments;
}

/* Each distance is the exact one, up to rounding, or the reach. */
static void transform_matches_brute_force(void **state)
{
    (void)state;
    for (int kind = 0; kind < 7; kind++) {
        static uint8_t picture[SIDE * SIDE];
        dice d = {(uint64_t)kind};
        for (int i = 0; i < SIDE * SIDE; i++)
            picture[i] = paint(kind, i % SIDE, i / SIDE, &d);
        skv_terrain_def def = skv_default_terrain_def();
        def.width = def.height = SIDE;
        def.coverage = picture;
        def.open_sides = (unsigned)kind;
        const int side = SIDE + 2 * SKV_TERRAIN_RIM;
        size_t pixels = (size_t)side * (size_t)side;
        skv_coverage coverage = {side, side, calloc(pixels, 1)};
        skv_coverage_fill(&def, &coverage);
        float *field = find_distances(&coverage);
        int count;
        skv_wall_segment *segments = find_segments(&coverage, &count);
        for (size_t i = 0; i < pixels; i++) {
            double best = SKV_TERRAIN_REACH;
            double x = (double)(i % (size_t)coverage.columns);
            double y = (double)(i / (size_t)coverage.columns);
            for (int k = 0; k < count; k++)
                best = fmin(best, distance_to(&segments[k], x, y));
            assert_int_equal(field[i] < 0, skv_is_solid(coverage.bytes[i]));
            assert_true(fabs(fabs((double)field[i]) - best) < 2e-5);
        }
        free(segments);
        free(field);
        free(coverage.bytes);
    }
}

/* ---- Dense walls ----------------------------------------------------------------------------- */

enum { DENSE_KINDS = 12, HOLES = 9 };

/* Pictures with walls everywhere; the last ones have round holes in them. */
static uint8_t paint_dense(int kind, int x, int y, dice *d)
{
    int hx = x % 94 - 47, hy = y % 94 - 47;
    bool hole = hx * hx + hy * hy < 45 * 45;
    switch (kind) {
    case 0:
    case 1:
    case 2: /* stripes */
        return x >> kind & 1 ? 255 : 0;
    case 3:
    case 4:
    case 5: /* a checkerboard */
        return ((x >> (kind - 3)) + (y >> (kind - 3))) & 1 ? 255 : 0;
    case 6: /* a comb */
        return y < 40 ? 0 : y == 90 || x % 3 == 0 ? 255 : 0;
    case 7: /* black and white noise */
        return roll(d) < 0.5 ? 255 : 0;
    case 8: /* grey noise */
        return (uint8_t)(roll(d) * 255.5);
    case 9:
        return !hole && (x + y) % 2 ? 255 : 0;
    case 10:
        return !hole && x % 4 < 2 ? 255 : 0;
    default:
        return !hole && roll(d) < 0.5 ? 255 : 0;
    }
}

/* Makes the coverage of such a picture, with open sides; its bytes are to be freed. */
static skv_coverage make_dense(int kind, int side)
{
    uint8_t *picture = calloc((size_t)side, (size_t)side);
    dice d = {(uint64_t)kind};
    for (int i = 0; i < side * side; i++)
        picture[i] = paint_dense(kind, i % side, i / side, &d);
    skv_terrain_def def = skv_default_terrain_def();
    def.width = def.height = side;
    def.coverage = picture;
    def.open_sides = (unsigned)kind;
    int all = side + 2 * SKV_TERRAIN_RIM;
    skv_coverage coverage = {all, all, calloc((size_t)all, (size_t)all)};
    skv_coverage_fill(&def, &coverage);
    free(picture);
    return coverage;
}

/* The squared distance by the same arithmetic. */
static float square_to(const skv_wall_segment *s, float x, float y)
{
    float px = x - s->x0, py = y - s->y0, ux = s->x1 - s->x0, uy = s->y1 - s->y0;
    float along = px * ux + py * uy, square = ux * ux + uy * uy;
    float t = fmaxf(fminf(along / fmaxf(square, FLT_MIN), 1), 0);
    float dx = px - t * ux, dy = py - t * uy;
    return dx * dx + dy * dy;
}

/* However dense walls are, each distance is the least of the numbers that all segments give, bit
 * for bit, on whichever way it was found. */
static void dense_walls_give_the_same_bits(void **state)
{
    (void)state;
    for (int kind = 0; kind < DENSE_KINDS; kind++) {
        skv_coverage coverage = make_dense(kind, 96);
        size_t pixels = (size_t)coverage.columns * (size_t)coverage.rows;
        float *field = find_distances(&coverage);
        int count;
        skv_wall_segment *segments = find_segments(&coverage, &count);
        for (size_t i = 0; i < pixels; i++) {
            float least = SKV_TERRAIN_REACH * SKV_TERRAIN_REACH;
            float x = (float)(i % (size_t)coverage.columns);
            float y = (float)(i / (size_t)coverage.columns);
            for (int k = 0; k < count; k++) {
                float square = square_to(&segments[k], x, y);
                least = square < least ? square : least;
            }
            float wanted = skv_is_solid(coverage.bytes[i]) ? -sqrtf(least) : sqrtf(least);
            if (field[i] != wanted)
                fail_msg("kind %d, pixel %zu: %.9g instead of %.9g", kind, i, (double)field[i],
                         (double)wanted);
        }
        free(segments);
        free(field);
        free(coverage.bytes);
    }
}

/* And each takes about as many steps. */
static void dense_walls_take_no_more_steps(void **state)
{
    (void)state;
    for (int kind = 0; kind < DENSE_KINDS; kind++) {
        skv_coverage coverage = make_dense(kind, 380);
        size_t pixels = (size_t)coverage.columns * (size_t)coverage.rows;
        float *field = calloc(pixels, sizeof *field);
        uint64_t steps = 0;
        assert_int_equal(skv_distance_fill(&coverage, 1, NULL, field, &steps, NULL), SKV_OK);
        if (steps > pixels * (kind >= HOLES ? 110 : 50) || steps < pixels)
            fail_msg("kind %d: %.1f steps a pixel", kind, (double)steps / (double)pixels);
        free(field);
        free(coverage.bytes);
    }
}

/* A diagonal line one pixel wide: distances are those of a band 0.707 pixels wide, and the wall is
 * closed between its pixels. */
static void saddles_join_solid(void **state)
{
    (void)state;
    static uint8_t picture[SIDE * SIDE];
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        memset(picture, 0, sizeof picture);
        for (int i = 0; i < SIDE; i++)
            picture[i * SIDE + (mirrored ? SIDE - 1 - i : i)] = 255;
        skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, 0.01f, 0);
        double half = sqrt(0.125);
        for (int i = 0; i < 40; i++) {
            double along = 15 + i * 0.75, across = (i % 9 - 4) * 0.25;
            double x = along + across * sqrt(0.5), y = along - across * sqrt(0.5);
            if (mirrored)
                x = SIDE - x;
            float distance =
                skv_terrain_distance(terrain, (float)(x * 0.01), (float)(y * 0.01)) * 100;
            assert_true(fabs((double)distance - (fabs(across) - half)) < 0.13);
            if (across == 0)
                assert_true(distance < -0.35f);
        }
        skv_terrain_destroy(terrain);
    }
}

static void crossing_depends_on_grey(void **state)
{
    (void)state;
    assert_true(skv_crossing(255, 0) == 0.5f);
    assert_true(fabsf(skv_crossing(200, 0) - 72.5f / 200) < 1e-6f);
    assert_true(fabsf(skv_crossing(127, 255) - 0.5f / 128) < 1e-6f);
    assert_true(skv_is_solid(128) && !skv_is_solid(127));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transform_matches_brute_force),
        cmocka_unit_test(dense_walls_give_the_same_bits),
        cmocka_unit_test(dense_walls_take_no_more_steps),
        cmocka_unit_test(saddles_join_solid),
        cmocka_unit_test(crossing_depends_on_grey),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
