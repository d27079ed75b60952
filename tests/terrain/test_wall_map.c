/* Wall density maps against the analytic half plane, and their limits: uniform regions, open
 * sides, scale, memory. */
#include "shapes.h"
#include "terrain/wall_map.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* One map value at distance d (in units of h, -1..1) from a half plane, for h = s = 1: integrates
 * over circles of radius r around the point, of which the arc beyond the wall is solid. `power` is
 * q's; `vector` asks for the component along the wall's normal. */
static double half_plane(double d, int power, bool vector)
{
    const int steps = 4000;
    double sum = 0;
    for (int i = 0; i < steps; i++) {
        double r = (i + 0.5) / steps;
        double cosine = fmin(1, fmax(-1, d / r));
        double arc = vector ? 2 * sqrt(1 - cosine * cosine) : 2 * acos(cosine);
        sum += pow(1 - r, power) * arc * r / steps;
    }
    return sum;
}

/* Largest errors over one wall, as shares of the values at the wall: scalars and vectors. */
typedef struct errors {
    double scalar, vector, rms;
} errors;

static errors measure(double degrees, double radius_pixels, bool grey)
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
    assert_int_equal(skv_wall_map_create(terrain, h, s, &map, NULL), SKV_OK);
    const double at_wall[4] = {half_plane(0, 2, false), half_plane(0, 3, false),
                               half_plane(0, 1, true), half_plane(0, 2, true)};
    errors worst = {0};
    int count = 0;
    for (int i = -4; i <= 22; i++) {
        double d = i * 0.05;
        double truth[4] = {half_plane(d, 2, false), half_plane(d, 3, false), half_plane(d, 1, true),
                           half_plane(d, 2, true)};
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

static void maps_match_the_half_plane(void **state)
{
    (void)state;
    const double angles[] = {0, 10, 22.5, 30, 45};
    const double radii[] = {3, 5, 10, 30, 77, 200};
    for (size_t r = 0; r < sizeof radii / sizeof *radii; r++) {
        for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
            for (int grey = 1; grey >= 0; grey--) {
                errors e = measure(angles[a], radii[r], grey);
                print_message("h %5.1f px, %4.1f deg, %s: scalars %.4f (rms %.4f), vectors %.4f\n",
                              radii[r], angles[a], grey ? "grey  " : "binary", e.scalar, e.rms,
                              e.vector);
                /* What the map's own cells cost, and a wall that is misplaced by a share of a
                 * pixel. */
                double misplaced = 1 / radii[r];
                assert_true(e.scalar < 0.016 + (grey ? 0.25 : 0.9) * misplaced);
                assert_true(e.vector < 0.056 + (grey ? 0.07 : 0.65) * misplaced);
                assert_true(e.rms < 0.006 + (grey ? 0.13 : 0.45) * misplaced);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_match_the_half_plane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
