/* Wall density maps against the analytic half plane, and their limits: uniform regions, open
 * sides, scale, memory. */
#include "shapes.h"
#include "support/failing_memory.h"
#include "terrain/boundary.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The maps, and what each integrates, at distance r in h. */
enum { DENSITY, NEAR_DENSITY, PUSH, NEAR_PUSH };

static double integrand(skv_kernel pressure, int map, double r)
{
    bool smooth = pressure == SKV_KERNEL_SMOOTH;
    switch (map) {
    case DENSITY:
        return smooth ? pow(1 - r, 3) * (1 + 3 * r) : pow(1 - r, 2);
    case NEAR_DENSITY:
        return pow(1 - r, 3);
    case PUSH:
        return smooth ? r * pow(1 - r, 2) : 1 - r;
    default:
        return pow(1 - r, 2);
    }
}

/* One map value at distance d (in units of h, -1..1) from a half plane, for h = s = 1: integrates
 * over circles of radius r around the point, of which the arc beyond the wall is solid. Of the
 * pushes it is the component along the wall's normal. */
static double half_plane(skv_kernel pressure, double d, int map)
{
    const int steps = 4000;
    double sum = 0;
    for (int i = 0; i < steps; i++) {
        double r = (i + 0.5) / steps;
        double cosine = fmin(1, fmax(-1, d / r));
        double arc = map >= PUSH ? 2 * sqrt(1 - cosine * cosine) : 2 * acos(cosine);
        sum += integrand(pressure, map, r) * arc * r / steps;
    }
    return sum;
}

/* Where maps are compared with it: at these distances, in twentieths of h. */
enum { NEAREST = -4, FARTHEST = 22 };

/* The half plane's values there, which all walls of a kernel are compared with. */
typedef struct truths {
    double at[FARTHEST - NEAREST + 1][4];
} truths;

static truths find_truths(skv_kernel kernel)
{
    truths t;
    for (int i = NEAREST; i <= FARTHEST; i++)
        for (int k = 0; k < 4; k++)
            t.at[i - NEAREST][k] = half_plane(kernel, i * 0.05, k);
    return t;
}

/* Largest errors over one wall, as shares of the values at the wall: scalars and vectors. */
typedef struct errors {
    double scalar, vector, rms;
} errors;

static errors measure(skv_kernel kernel, const truths *t, double degrees, double radius_pixels,
                      bool grey)
{
    const float pixel = 0.004f;
    const float h = (float)radius_pixels * pixel, s = h / 3;
    int side = (int)(4 * radius_pixels);
    side = side < 64 ? 64 : side;
    /* Off the pixels' and the map cells' lines, as a wall usually is. */
    shape wall = wall_shape("wall", side * 0.5 + 0.3, side * 0.5 + 0.2, degrees);
    uint8_t *picture = malloc((size_t)side * (size_t)side);
    paint_shape(&wall, side, side, grey, picture);
    skv_terrain *terrain = make_terrain(side, side, picture, pixel, 15);
    skv_wall_map *map = NULL;
    assert_int_equal(skv_wall_map_create(terrain, h, s, kernel, NULL, &map, NULL), SKV_OK);
    const double *at_wall = t->at[-NEAREST];
    errors worst = {0};
    int count = 0;
    for (int i = NEAREST; i <= FARTHEST; i++) {
        double d = i * 0.05;
        const double *truth = t->at[i - NEAREST];
        for (int k = -20; k <= 20; k++) {
            double along = k * 0.0371 * radius_pixels;
            double x = wall.x + wall.ny * along + d * radius_pixels * wall.nx;
            double y = wall.y - wall.nx * along + d * radius_pixels * wall.ny;
            skv_wall_sample m;
            skv_wall_map_sample(map, (float)x * pixel, (float)y * pixel, &m);
            double nx = wall.nx, ny = wall.ny;
            double got[4] = {
                (double)m.r, (double)m.rn,
                hypot((double)m.f1x - 9 * truth[2] * nx, (double)m.f1y - 9 * truth[2] * ny),
                hypot((double)m.f2x - 9 * truth[3] * nx, (double)m.f2y - 9 * truth[3] * ny)};
            for (int q = 0; q < 2; q++) {
                double scalar = fabs(got[q] - 9 * truth[q]) / (9 * at_wall[q]);
                double vector = got[2 + q] / (9 * at_wall[2 + q]);
                worst.scalar = fmax(worst.scalar, scalar);
                worst.vector = fmax(worst.vector, vector);
                worst.rms += scalar * scalar;
                count++;
            }
        }
    }
    worst.rms = sqrt(worst.rms / count);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
    free(picture);
    return worst;
}

static void check_half_plane(skv_kernel kernel, const truths *t, double radius, double angle,
                             bool grey)
{
    errors e = measure(kernel, t, angle, radius, grey);
    print_message("%s, h %5.1f px, %4.1f deg, %s: scalars %.4f (rms %.4f), vectors %.4f\n",
                  kernel == SKV_KERNEL_SMOOTH ? "smooth" : "spiky ", radius, angle,
                  grey ? "grey  " : "binary", e.scalar, e.rms, e.vector);
    /* What the map's own cells cost, and a wall that is misplaced by a share of a pixel. */
    double misplaced = 1 / radius;
    assert_true(e.scalar < 0.016 + (grey ? 0.25 : 0.9) * misplaced);
    assert_true(e.vector < 0.056 + (grey ? 0.07 : 0.65) * misplaced);
    assert_true(e.rms < 0.006 + (grey ? 0.13 : 0.45) * misplaced);
}

static void maps_match_the_half_plane(void **state)
{
    (void)state;
    const double angles[] = {0, 10, 22.5, 30, 45};
    const double radii[] = {3, 5, 10, 30, 77, 200};
    const truths spiky = find_truths(SKV_KERNEL_SPIKY), smooth = find_truths(SKV_KERNEL_SMOOTH);
    for (size_t r = 0; r < sizeof radii / sizeof *radii; r++) {
        for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
            for (int grey = 0; grey < 2; grey++) {
                check_half_plane(SKV_KERNEL_SPIKY, &spiky, radii[r], angles[a], grey);
                check_half_plane(SKV_KERNEL_SMOOTH, &smooth, radii[r], angles[a], grey);
            }
        }
    }
}

static skv_wall_map *make_map_for(skv_kernel kernel, const skv_terrain *terrain, float h, float s)
{
    skv_wall_map *map = NULL;
    skv_error error = {0};
    if (skv_wall_map_create(terrain, h, s, kernel, NULL, &map, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return map;
}

/* For the default water. */
static skv_wall_map *make_map(const skv_terrain *terrain, float h, float s)
{
    return make_map_for(SKV_KERNEL_SMOOTH, terrain, h, s);
}

static skv_wall_sample sample(const skv_wall_map *map, double x, double y)
{
    skv_wall_sample m;
    skv_wall_map_sample(map, (float)x, (float)y, &m);
    return m;
}

static void assert_zero(const skv_wall_map *map, double x, double y)
{
    skv_wall_sample m = {1, 1, 1, 1, 1, 1};
    assert_false(skv_wall_map_sample(map, (float)x, (float)y, &m));
    assert_true(m.r == 0 && m.rn == 0);
    assert_true(m.f1x == 0 && m.f1y == 0 && m.f2x == 0 && m.f2y == 0);
}

/* Deep inside solid: the whole disc, n0 int W = pi/5 (h/s)^2 and int q^3 = pi/10 (h/s)^2. */
static void assert_full(const skv_wall_map *map, double x, double y)
{
    const double pi = acos(-1.0);
    skv_wall_sample m;
    assert_true(skv_wall_map_sample(map, (float)x, (float)y, &m));
    assert_true(fabs((double)m.r - 9 * pi / 5) < 2e-3);
    assert_true(fabs((double)m.rn - 9 * pi / 10) < 2e-3);
    assert_true(fabsf(m.f1x) < 1e-4f && fabsf(m.f1y) < 1e-4f);
    assert_true(fabsf(m.f2x) < 1e-4f && fabsf(m.f2y) < 1e-4f);
}

static void uniform_regions_are_constant(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(640, 360, NULL, 0.0025f, SKV_SIDE_TOP);
    skv_wall_map *map = make_map(tank, 0.03f, 0.01f);
    assert_zero(map, 0.8, 0.5);
    assert_zero(map, 0.034, 0.5);
    assert_zero(map, 0.8, 0.9);
    assert_zero(map, 0.8, 100);
    assert_full(map, -0.034, 0.5);
    assert_full(map, 0.8, -0.034);
    assert_full(map, -100, 0.5);
    assert_full(map, 1e30, 0.5);
    assert_full(map, 50, -50);
    skv_wall_sample m;
    skv_wall_map_sample(map, NAN, NAN, &m);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);

    static uint8_t solid[64 * 64];
    memset(solid, 255, sizeof solid);
    skv_terrain *rock = make_terrain(64, 64, solid, 0.01f, 0);
    map = make_map(rock, 0.03f, 0.01f);
    assert_full(map, 0.3, 0.3);
    assert_full(map, 0, 0.3);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(rock);

    skv_terrain *nothing = make_terrain(64, 64, NULL, 0.01f, 15);
    map = make_map(nothing, 0.03f, 0.01f);
    assert_zero(map, 0.3, 0.3);
    assert_zero(map, 0, 0);
    assert_zero(map, -1, 3);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(nothing);
}

/* A corner of a tank holds the two walls' values less the quarter they share; by symmetry of the
 * corner both components are equal on its diagonal. */
static void corners_add_up(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(400, 400, NULL, 0.002f, 0);
    skv_wall_map *map = make_map(tank, 0.05f, 0.05f / 3);
    for (double d = 0.002; d < 0.06; d += 0.003) {
        skv_wall_sample corner = sample(map, d, d), floor = sample(map, 0.4, d);
        assert_true(fabsf(corner.f1x - corner.f1y) < 1e-4f);
        assert_true(fabsf(corner.f2x - corner.f2y) < 1e-4f);
        /* The contour cuts the corner, which adds a little solid. */
        assert_true(corner.r < 2 * floor.r + 1e-3f && corner.r >= floor.r);
        assert_true(fabsf(floor.f1x) < 1e-5f && floor.f1y >= 0);
        /* The four corners are mirror images of each other. */
        skv_wall_sample far = sample(map, 0.8 - d, 0.8 - d);
        assert_true(fabsf(far.r - corner.r) < 2e-3f && fabsf(far.f1x + corner.f1x) < 2e-3f);
    }
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);
}

/* The same picture at another size, with h and s scaled alike, gives the same values. */
static void only_ratios_count(void **state)
{
    (void)state;
    static uint8_t picture[128 * 128];
    shape disc = disc_shape("disc", 60.3, 65.7, 31);
    paint_shape(&disc, 128, 128, true, picture);
    skv_terrain *small = make_terrain(128, 128, picture, 0.001f, 0);
    skv_terrain *large = make_terrain(128, 128, picture, 0.064f, 0);
    skv_wall_map *in_small = make_map(small, 0.012f, 0.004f);
    skv_wall_map *in_large = make_map(large, 0.768f, 0.256f);
    dice d = {3};
    for (int i = 0; i < 20000; i++) {
        double x = roll(&d) * 128, y = roll(&d) * 128;
        skv_wall_sample a = sample(in_small, x * 0.001, y * 0.001);
        skv_wall_sample b = sample(in_large, x * 0.064, y * 0.064);
        assert_true(fabsf(a.r - b.r) < 1e-4f && fabsf(a.rn - b.rn) < 1e-4f);
        assert_true(fabsf(a.f1x - b.f1x) < 1e-4f && fabsf(a.f2y - b.f2y) < 1e-4f);
    }
    skv_wall_map_destroy(in_small);
    skv_wall_map_destroy(in_large);
    skv_terrain_destroy(small);
    skv_terrain_destroy(large);
}

/* Flat grey walls push as much as white ones: the shade only shifts the contour. */
static void light_grey_is_solid(void **state)
{
    (void)state;
    static uint8_t picture[128 * 128];
    for (int i = 0; i < 128 * 128; i++)
        picture[i] = i / 128 < 64 ? 150 : 105;
    skv_terrain *terrain = make_terrain(128, 128, picture, 0.002f, 15);
    skv_wall_map *map = make_map(terrain, 0.02f, 0.02f / 3);
    assert_full(map, 0.128, 0.1);
    skv_wall_sample m = sample(map, 0.128, 0.128);
    assert_true(fabs((double)m.r - 9 * half_plane(SKV_KERNEL_SMOOTH, 0, DENSITY)) < 0.03);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
}

/* However thin walls are against the map's cells, their area counts: the integral of R is the
 * solid area times the value deep inside solid. */
static void thin_walls_keep_their_area(void **state)
{
    (void)state;
    enum { SIDE = 320 };
    static uint8_t picture[SIDE * SIDE];
    const double pixel = 0.001;
    for (int kind = 0; kind < 3; kind++) {
        memset(picture, 0, sizeof picture);
        int solid = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2;
            bool inside = abs(x) < 60 && abs(y) < 60;
            bool line = kind == 0 ? y == 3 : kind == 1 ? x == y || x == y + 1 : x % 9 / 2 == 0;
            if (inside && line) {
                picture[i] = 255;
                solid++;
            }
        }
        skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, (float)pixel, 15);
        const double radii[] = {3, 10, 33, 80};
        for (int k = 0; k < 4; k++) {
            double h = radii[k] * pixel, sum = 0;
            skv_wall_map *map = make_map(terrain, (float)h, (float)(h / 3));
            const double step = 0.25 * pixel * (1 + 0.05 * radii[k]);
            for (double y = 0.5 * step; y < (double)SIDE * pixel; y += step) {
                for (double x = 0.5 * step; x < (double)SIDE * pixel; x += step)
                    sum += (double)sample(map, x, y).r * step * step;
            }
            double expected = solid * pixel * pixel * 9 * acos(-1.0) / 5;
            /* Diagonal staircases lose their corners to the contour. */
            assert_true(sum > (kind == 1 ? 0.9 : 0.985) * expected && sum < 1.01 * expected);
            skv_wall_map_destroy(map);
        }
        skv_terrain_destroy(terrain);
    }
}

/* Along any line the values change smoothly: no seams between blocks, nor at the map's rim. */
static void there_are_no_seams(void **state)
{
    (void)state;
    static uint8_t picture[256 * 256];
    shape bowl = bowl_shape("bowl", 128, 128, 100);
    paint_shape(&bowl, 256, 256, true, picture);
    skv_terrain *terrain = make_terrain(256, 256, picture, 0.002f, SKV_SIDE_TOP);
    skv_wall_map *map = make_map(terrain, 0.03f, 0.01f);
    dice d = {9};
    for (int line = 0; line < 60; line++) {
        double x = 0.512 * roll(&d), y = 0.512 * roll(&d);
        double dx = 2e-5 * (roll(&d) - 0.5), dy = 2e-5 * (roll(&d) - 0.5);
        skv_wall_sample last = sample(map, x, y);
        for (int i = 1; i < 20000; i++) {
            skv_wall_sample m = sample(map, x + i * dx, y + i * dy);
            /* The steepest slopes are about 6 and 9 per h: 0.006 in a step of 1e-5 m. */
            assert_true(fabsf(m.r - last.r) < 0.006f && fabsf(m.f1x - last.f1x) < 0.009f);
            assert_true(fabsf(m.rn - last.rn) < 0.006f && fabsf(m.f2y - last.f2y) < 0.009f);
            last = m;
        }
    }
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
}

/* A tank for a million particles: its map stays small. */
static void large_tanks_stay_small(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(640, 360, NULL, 0.0025f, 0);
    skv_wall_map *map = make_map(tank, 0.0036f, 0.0012f);
    size_t bytes = skv_wall_map_bytes(map);
    print_message("1.6 x 0.9 m at h = 3.6 mm: %.1f MB\n", (double)bytes * 1e-6);
    assert_true(bytes > 1000000 && bytes < 16000000);
    assert_zero(map, 0.8, 0.45);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);
}

static void bad_values_are_refused(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(64, 64, NULL, 0.01f, 0);
    const float bad[][2] = {{0, 0.01f},        {-1, 0.01f},       {NAN, 0.01f},
                            {INFINITY, 0.01f}, {0.03f, 0},        {0.03f, -1},
                            {0.03f, NAN},      {0.03f, INFINITY}, {0.03f, 1}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        skv_wall_map *map = (skv_wall_map *)1;
        skv_error error = {0};
        assert_int_equal(
            skv_wall_map_create(tank, bad[i][0], bad[i][1], SKV_KERNEL_SMOOTH, NULL, &map, &error),
            SKV_ERROR_VALUE);
        assert_null(map);
        assert_non_null(strstr(error.text, "radius"));
    }
    skv_wall_map *map = NULL;
    assert_int_equal(skv_wall_map_create(tank, 1e-9f, 1e-9f, SKV_KERNEL_SMOOTH, NULL, &map, NULL),
                     SKV_ERROR_LIMIT);
    skv_wall_map_destroy(NULL);
    /* A radius larger than the world is odd but possible. */
    map = make_map(tank, 5, 1);
    assert_true(sample(map, 0.3, 0.3).r > 10);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);
}

/* Thin walls everywhere: samples beside them would take minutes. */
static void too_long_thin_walls_are_refused(void **state)
{
    (void)state;
    enum { SIDE = 700 };
    uint8_t *picture = calloc(SIDE, SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        picture[i] = i % SIDE / 4 % 2 ? 255 : 0;
    skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, 0.001f, 0);
    skv_wall_map *map = make_map(terrain, 0.007f, 0.0035f);
    skv_error error = {0};
    assert_int_equal(skv_wall_map_shade(map, terrain, NULL, &error), SKV_ERROR_LIMIT);
    assert_string_equal(
        error.text, "its thin walls are too long for a fluid with a radius of 7 mm; choose fewer "
                    "particles or a wider spacing, or make them thicker or shorter");
    assert_null(map->thin);
    assert_null(map->found);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
    free(picture);
}

static void memory_failures_leave_nothing(void **state)
{
    (void)state;
    skv_terrain *tank = make_terrain(64, 64, NULL, 0.01f, 0);
    failing_memory memory;
    int failures = 0;
    for (int fail_at = 0; fail_at < 100; fail_at++) {
        skv_wall_map *map = NULL;
        skv_error error = {0};
        failing_memory_start(&memory, fail_at);
        skv_result result =
            skv_wall_map_create(tank, 0.06f, 0.02f, SKV_KERNEL_SMOOTH, NULL, &map, &error);
        if (result == SKV_OK) {
            skv_wall_map_destroy(map);
            assert_int_equal(memory.live, 0);
            break;
        }
        failures++;
        assert_int_equal(result, SKV_ERROR_MEMORY);
        assert_int_equal(error.code, SKV_ERROR_MEMORY);
        assert_null(map);
        assert_int_equal(memory.live, 0);
    }
    failing_memory_stop();
    assert_int_equal(failures, 4);
    skv_terrain_destroy(tank);
}

/* A tank of 120 x 120 pixels with an upright wall between two heights. */
static skv_terrain *tank_with_wall(int first, int pixels, int from, int to)
{
    enum { SIDE = 120 };
    static uint8_t picture[SIDE * SIDE];
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            picture[y * SIDE + x] =
                x >= first && x < first + pixels && y >= from && y < to ? 255 : 0;
    return make_terrain(SIDE, SIDE, picture, 0.01f, 0);
}

/* Beside a wall of two pixels the shaded sums are those of a half plane, on both sides, and pairs
 * through it are parted. */
static void check_thin_wall(skv_kernel kernel)
{
    const double h = 0.16, s = h / 3;
    skv_terrain *terrain = tank_with_wall(59, 2, 0, 120);
    skv_wall_map *map = make_map_for(kernel, terrain, (float)h, (float)s);
    /* Shares of the values at the wall. */
    const double allowed[4] = {0.034, 0.042, 0.04, 0.066};
    assert_null(map->thin);
    assert_int_equal(skv_wall_map_shade(map, terrain, NULL, NULL), SKV_OK);
    assert_non_null(map->thin);
    for (int side = -1; side <= 1; side += 2) {
        for (double d = 0.02; d < 1; d += 0.07) {
            double x = 0.6 + side * (0.01 + d * h);
            float nx, ny, distance = skv_terrain_normal(terrain, (float)x, 0.61f, &nx, &ny);
            skv_wall_sample m;
            skv_wall_map_sample_beside(map, (float)x, 0.61f, distance, nx, ny, &m);
            const double got[4] = {(double)m.r, (double)m.rn, side * (double)m.f1x,
                                   side * (double)m.f2x};
            for (int k = 0; k < 4; k++)
                assert_true(fabs(got[k] / 9 - half_plane(kernel, d, k)) <
                            allowed[k] * half_plane(kernel, 0, k));
            assert_true(fabs((double)m.f1y) < 0.02 && fabs((double)m.f2y) < 0.02);
        }
    }
    assert_true(skv_wall_map_near_thin(map, 0.6f, 0.6f));
    assert_true(skv_wall_map_near_thin(map, 0.5f, 0.6f));
    assert_false(skv_wall_map_near_thin(map, 0.3f, 0.6f));
    const skv_boundary walls = {.terrain = terrain, .walls = map, .unit = 1, .per_unit = 1};
    assert_true(skv_boundary_occluded(&walls, 0.58f, 0.6f, 0, 0.62f, 0.65f, 0));
    assert_true(skv_boundary_occluded(&walls, 0.62f, 0.65f, 0, 0.58f, 0.6f, 0));
    assert_false(skv_boundary_occluded(&walls, 0.58f, 0.6f, 0, 0.58f, 0.7f, 0));
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
}

/* Which walls are thin: not those above 0.6 h, not corners of thick ones, not free ends but the
 * upper. */
static void only_thin_walls_are_thin(void **state)
{
    (void)state;
    const struct {
        int first, pixels, from, to;
        bool middle; /* whether pairs are cut in the middle of the tank */
        bool top;    /* and near the lid */
    } cases[] = {
        {59, 2, 0, 120, true, true},   {59, 30, 0, 120, false, false}, {59, 2, 0, 110, true, false},
        {59, 2, 10, 120, false, true}, {59, 2, 50, 70, false, false},  {0, 40, 0, 60, false, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_terrain *terrain =
            tank_with_wall(cases[i].first, cases[i].pixels, cases[i].from, cases[i].to);
        skv_wall_map *map = make_map(terrain, 0.12f, 0.04f);
        assert_int_equal(skv_wall_map_shade(map, terrain, NULL, NULL), SKV_OK);
        assert_int_equal(skv_wall_map_near_thin(map, 0.6f, 0.6f), cases[i].middle);
        assert_int_equal(skv_wall_map_near_thin(map, 0.6f, 1.05f), cases[i].top);
        skv_wall_map_destroy(map);
        skv_terrain_destroy(terrain);
    }
}

static void a_thin_wall_stands_for_what_is_behind(void **state)
{
    (void)state;
    check_thin_wall(SKV_KERNEL_SPIKY);
    check_thin_wall(SKV_KERNEL_SMOOTH);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_match_the_half_plane),
        cmocka_unit_test(uniform_regions_are_constant),
        cmocka_unit_test(corners_add_up),
        cmocka_unit_test(only_ratios_count),
        cmocka_unit_test(light_grey_is_solid),
        cmocka_unit_test(thin_walls_keep_their_area),
        cmocka_unit_test(there_are_no_seams),
        cmocka_unit_test(large_tanks_stay_small),
        cmocka_unit_test(bad_values_are_refused),
        cmocka_unit_test(too_long_thin_walls_are_refused),
        cmocka_unit_test(memory_failures_leave_nothing),
        cmocka_unit_test(a_thin_wall_stands_for_what_is_behind),
        cmocka_unit_test(only_thin_walls_are_thin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
