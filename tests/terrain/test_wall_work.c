/* The work of walls: a particle that is taken round a closed loop gains nothing. Walls push along
 * grad D and F1, so what keeps them from driving a fluid round is that both, as they are sampled,
 * have no curl. */
#include "shapes.h"
#include "terrain/boundary.h"
#include "terrain/terrain.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { SIDE = 120 };
static const float pixel = 0.01f;

/* In h. Mirror particles act as far as the two distances of a pair add up to 1. Close by, at walls'
 * own cells, the samples are taken from a little off the wall. */
#define FARTHEST 0.75
#define NEAREST  0.1

/* Of a push of 1 along grad D, by which D itself rises from 0 to 1, and along the gradient of R, of
 * the whole of R. */
typedef struct work {
    double distance, rest;
} work;

static void add(work *sum, work more)
{
    sum->distance += more.distance;
    sum->rest += more.rest;
}

static void keep_worst(work *worst, work other)
{
    worst->distance = fmax(worst->distance, fabs(other.distance));
    worst->rest = fmax(worst->rest, fabs(other.rest));
}

/* On the straight way from (x0, y0) to (x1, y1), m. */
static work walk(const skv_wall_map *map, double x0, double y0, double x1, double y1)
{
    const double dx = (x1 - x0) / map->radius, dy = (y1 - y0) / map->radius;
    const double whole = (double)map->kernel.full[SKV_WALL_R] / SKV_SMOOTH_GAIN;
    const int steps = 1 + (int)(hypot(dx, dy) * 250);
    work sum = {0, 0};
    for (int i = 0; i < steps; i++) {
        double part = (i + 0.5) / steps;
        skv_image_sample m;
        skv_wall_map_sample_image(map, (float)(x0 + part * (x1 - x0)),
                                  (float)(y0 + part * (y1 - y0)), &m);
        add(&sum, (work){((double)m.nx * dx + (double)m.ny * dy) / steps,
                         -((double)m.f1x * dx + (double)m.f1y * dy) / steps / whole});
    }
    return sum;
}

/* Along a wall close to it, and back farther off: corners by how far along and off they are, h. */
static work walk_along(const skv_wall_map *map, const shape *wall, double along, double near,
                       double length)
{
    const double off[] = {near, near, FARTHEST, FARTHEST};
    const double on[] = {along, along + length, along + length, along};
    double x[4], y[4];
    for (int i = 0; i < 4; i++) {
        x[i] = wall->x * (double)pixel + map->radius * (on[i] * wall->ny + off[i] * wall->nx);
        y[i] = wall->y * (double)pixel + map->radius * (off[i] * wall->ny - on[i] * wall->nx);
    }
    work sum = {0, 0};
    for (int i = 0; i < 4; i++)
        add(&sum, walk(map, x[i], y[i], x[(i + 1) % 4], y[(i + 1) % 4]));
    return sum;
}

/* Walls of all slopes, at 6, 11 and 20 pixels in h. */
static void slopes_do_no_work(void **state)
{
    (void)state;
    static uint8_t picture[SIDE * SIDE];
    const float radii[] = {0.06f, 0.11f, 0.2f};
    work worst = {0, 0};
    for (int degrees = 0; degrees <= 85; degrees += 5) {
        shape wall = wall_shape("wall", SIDE * 0.5 + 0.3, SIDE * 0.5 + 0.2, degrees);
        paint_shape(&wall, SIDE, SIDE, true, picture);
        skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, pixel, 15);
        for (int r = 0; r < 3; r++) {
            skv_wall_map *map = make_image_map(terrain, radii[r]);
            for (int i = 0; i < 12; i++)
                keep_worst(&worst, walk_along(map, &wall, 0.137 * i - 1.3, NEAREST + 0.05 * (i % 5),
                                              0.9 + 0.07 * i));
            skv_wall_map_destroy(map);
        }
        skv_terrain_destroy(terrain);
    }
    print_message("slopes: up to %.5f of D, %.5f of R\n", worst.distance, worst.rest);
    assert_true(worst.distance < 0.002 && worst.rest < 0.001);
}

/* The places of a circle, m. */
typedef struct circle {
    double x, y, radius;
} circle;

enum { SIDES = 24 };

static void place_on(const circle *c, int side, double *x, double *y)
{
    double angle = side * 2 * acos(-1.0) / SIDES;
    *x = c->x + c->radius * cos(angle);
    *y = c->y + c->radius * sin(angle);
}

/* Whether walls act all along it, and it meets none. */
static bool lies_before_walls(const skv_wall_map *map, const skv_terrain *terrain, const circle *c)
{
    for (int i = 0; i < SIDES; i++) {
        double x, y;
        place_on(c, i, &x, &y);
        skv_image_sample m;
        skv_wall_map_sample_image(map, (float)x, (float)y, &m);
        if ((double)m.distance > FARTHEST ||
            (double)skv_distance_at(terrain, (float)x, (float)y) < NEAREST * map->radius)
            return false;
    }
    return true;
}

/* Round circles of 0.05 to 0.3 h at any place where walls act. */
static void check_circles(const char *name, skv_terrain *terrain)
{
    enum { CIRCLES = 200 };
    const float radii[] = {0.06f, 0.2f};
    work worst = {0, 0};
    for (int r = 0; r < 2; r++) {
        skv_wall_map *map = make_image_map(terrain, radii[r]);
        dice d = {7};
        for (int found = 0; found < CIRCLES;) {
            double side = SIDE * (double)pixel;
            circle c = {side * roll(&d), side * roll(&d), (0.05 + 0.25 * roll(&d)) * map->radius};
            if (!lies_before_walls(map, terrain, &c))
                continue;
            found++;
            work sum = {0, 0};
            for (int i = 0; i < SIDES; i++) {
                double x0, y0, x1, y1;
                place_on(&c, i, &x0, &y0);
                place_on(&c, i + 1, &x1, &y1);
                add(&sum, walk(map, x0, y0, x1, y1));
            }
            keep_worst(&worst, sum);
        }
        skv_wall_map_destroy(map);
    }
    skv_terrain_destroy(terrain);
    print_message("%s: up to %.5f of D, %.5f of R\n", name, worst.distance, worst.rest);
    assert_true(worst.distance < 0.02 && worst.rest < 0.02);
}

/* The inner corners of a tank and the outer ones of a box in it, a bowl and a disc. */
static void corners_and_bends_do_no_work(void **state)
{
    (void)state;
    static uint8_t picture[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++)
        picture[i] = i % SIDE >= 50 && i % SIDE < 90 && i / SIDE >= 40 && i / SIDE < 80 ? 255 : 0;
    check_circles("corners", make_terrain(SIDE, SIDE, picture, pixel, 0));
    shape bends[] = {bowl_shape("bowl", 60.2, 59.7, 45), disc_shape("disc", 60.2, 59.7, 25)};
    for (int i = 0; i < 2; i++) {
        paint_shape(&bends[i], SIDE, SIDE, true, picture);
        check_circles(bends[i].name, make_terrain(SIDE, SIDE, picture, pixel, 15));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_do_no_work),
        cmocka_unit_test(corners_and_bends_do_no_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
