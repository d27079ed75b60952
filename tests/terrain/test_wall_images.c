/* Images of walls: their distances beside flat walls, what they leave of the wall sums against sums
 * over a fine lattice of points, and edits. */
#include "shapes.h"
#include "support/failing_memory.h"
#include "terrain/boundary.h"
#include "terrain/terrain.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 120 };
static const float pixel = 0.01f, h = 0.2f;

static skv_boundary boundary_of(const skv_terrain *terrain, const skv_wall_map *map)
{
    return (skv_boundary){.terrain = terrain, .walls = map, .unit = 1, .per_unit = 1};
}

static double density(double r)
{
    double q = fmax(1 - r, 0);
    return q * q * q * (4 - 3 * q);
}

/* Beside a flat wall D is the distance, and images leave nothing. */
static void check_flat_wall(double degrees)
{
    static uint8_t picture[SIDE * SIDE];
    shape wall = wall_shape("wall", SIDE * 0.5 + 0.3, SIDE * 0.5 + 0.2, degrees);
    paint_shape(&wall, SIDE, SIDE, true, picture);
    skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, pixel, 15);
    skv_wall_map *map = make_image_map(terrain, h);
    const double full = (double)map->kernel.full[SKV_WALL_R];
    double worst = 0, worst_gradient = 0, worst_rest = 0, worst_push = 0;
    for (double d = 0; d < 1.2; d += 0.05) {
        for (int i = -20; i <= 20; i++) {
            double along = i * 0.0371 * (double)h, off = d * (double)h;
            double x = wall.x * (double)pixel + wall.ny * along + wall.nx * off;
            double y = wall.y * (double)pixel - wall.nx * along + wall.ny * off;
            skv_image_sample m;
            skv_wall_map_sample_image(map, (float)x, (float)y, &m);
            double nx = (double)m.nx - wall.nx, ny = (double)m.ny - wall.ny;
            worst_rest = fmax(worst_rest, fabs((double)m.r) / full);
            worst_push = fmax(worst_push, 12 * hypot((double)m.f1x, (double)m.f1y) / full);
            if (d < 0.049 || d > 0.91)
                continue;
            /* Not d: the picture's wall may lie a share of a pixel off. */
            double distance = (double)(skv_distance_at(terrain, (float)x, (float)y) / h);
            worst = fmax(worst, fabs((double)m.distance - distance));
            if (d > 0.14 && d < 0.76)
                worst_gradient = fmax(worst_gradient, hypot(nx, ny));
        }
    }
    print_message("%4.0f deg: distances %.4f, gradients %.3f, rests %.4f and %.3f\n", degrees,
                  worst, worst_gradient, worst_rest, worst_push);
    assert_true(worst < 0.02 && worst_gradient < 0.05);
    assert_true(worst_rest < 0.005 && worst_push < 0.03);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
}

static void flat_walls_are_mirrors(void **state)
{
    (void)state;
    const double degrees[] = {0, 17, 45, 90, 197};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        check_flat_wall(degrees[i]);
}

/* What the particles of a uniform fluid, their images and the rest give at a point, against what
 * the middle of the fluid has: a lattice of points over what is free and seen. */
static double fullness(const skv_boundary *b, double x, double y)
{
    const double step = 0.025, radius = b->walls->radius;
    skv_image_sample own;
    skv_boundary_sample_image(b, (float)x, (float)y, &own);
    double sum = 0;
    for (double v = -1 + 0.5 * step; v < 1; v += step) {
        for (double u = -1 + 0.5 * step; u < 1; u += step) {
            double r2 = u * u + v * v;
            float px = (float)(x + u * radius), py = (float)(y + v * radius);
            if (r2 >= 1 || skv_distance_at(b->terrain, px, py) <= 0 ||
                skv_boundary_occluded(b, (float)x, (float)y, 0, px, py, 0))
                continue;
            skv_image_sample other;
            skv_boundary_sample_image(b, px, py, &other);
            sum += density(sqrt(r2)) +
                   density(sqrt(r2 + 4 * (double)own.distance * (double)other.distance));
        }
    }
    double particles = b->walls->density;
    return (sum * step * step * particles + (double)own.r) / (particles * acos(-1.0) / 5);
}

/* The worst and the root of the mean square in a box, a fifth of h or more from walls. */
static void check_fullness(const char *name, const skv_terrain *terrain, double x0, double y0,
                           double x1, double y1, double most, double most_rms)
{
    skv_wall_map *map = make_image_map(terrain, h);
    const skv_boundary b = boundary_of(terrain, map);
    double worst = 0, squares = 0, largest = 0;
    int count = 0;
    for (double y = y0; y < y1; y += 0.0137) {
        for (double x = x0; x < x1; x += 0.0151) {
            if (skv_distance_at(terrain, (float)x, (float)y) < 0.2f * h)
                continue;
            skv_image_sample m;
            skv_boundary_sample_image(&b, (float)x, (float)y, &m);
            double error = fabs(fullness(&b, x, y) - 1);
            worst = fmax(worst, error);
            largest = fmax(largest, fabs((double)m.r) / (double)map->kernel.full[SKV_WALL_R]);
            squares += error * error;
            count++;
        }
    }
    print_message("%s: off by %.4f, rms %.4f; rests up to %.3f\n", name, worst,
                  sqrt(squares / count), largest);
    assert_true(worst < most && sqrt(squares / count) < most_rms);
    skv_wall_map_destroy(map);
}

/* A tank of SIDE x SIDE pixels, and in it a box of solid. */
static skv_terrain *tank_with_box(int x0, int y0, int x1, int y1)
{
    static uint8_t picture[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        picture[i] = x >= x0 && x < x1 && y >= y0 && y < y1 ? 255 : 0;
    }
    return make_terrain(SIDE, SIDE, picture, pixel, 0);
}

static void rests_fill_up(void **state)
{
    (void)state;
    skv_terrain *tank = tank_with_box(50, 40, 90, 80);
    check_fullness("corner of a tank", tank, 0, 0, 0.25, 0.25, 0.02, 0.008);
    check_fullness("corner of a box", tank, 0.3, 0.6, 0.6, 1, 0.02, 0.005);
    skv_terrain_destroy(tank);
    skv_terrain *parted = tank_with_box(59, 0, 61, SIDE);
    check_fullness("thin wall", parted, 0.4, 0.5, 0.8, 0.6, 0.02, 0.01);
    check_fullness("foot of a thin wall", parted, 0.4, 0, 0.8, 0.25, 0.03, 0.01);
    skv_terrain_destroy(parted);
}

/* F1 = -(h/12) grad R holds for what is left of both, in the corner of a tank. */
static void pushes_are_gradients(void **state)
{
    (void)state;
    skv_terrain *tank = tank_with_box(0, 0, 0, 0);
    skv_wall_map *map = make_image_map(tank, h);
    const float cell = h / SKV_WALL_REACH;
    double worst = 0, largest = 0, squares = 0;
    int count = 0;
    for (int j = 1; j < 14; j++) {
        for (int i = 1; i < 14; i++) {
            /* In the corner itself the rest changes so much from cell to cell that differences say
             * little. */
            if (i + j < 6)
                continue;
            float x = ((float)i + 0.5f) * cell, y = ((float)j + 0.5f) * cell;
            skv_image_sample m, low, high, left, right;
            skv_wall_map_sample_image(map, x, y, &m);
            skv_wall_map_sample_image(map, x, y - cell, &low);
            skv_wall_map_sample_image(map, x, y + cell, &high);
            skv_wall_map_sample_image(map, x - cell, y, &left);
            skv_wall_map_sample_image(map, x + cell, y, &right);
            float gx = -(right.r - left.r) * (SKV_WALL_REACH / 24.0f);
            float gy = -(high.r - low.r) * (SKV_WALL_REACH / 24.0f);
            double error = hypot((double)(m.f1x - gx), (double)(m.f1y - gy));
            worst = fmax(worst, error);
            squares += error * error;
            largest = fmax(largest, hypot((double)m.f1x, (double)m.f1y));
            count++;
        }
    }
    print_message("pushes up to %.4f, off by %.4f, rms %.4f\n", largest, worst,
                  sqrt(squares / count));
    assert_true(largest > 0.1 && worst < 0.08 * largest);
    assert_true(sqrt(squares / count) < 0.03 * largest);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);
}

static void expect_same(const skv_wall_map *a, const skv_wall_map *b)
{
    assert_int_equal(a->thin != NULL, b->thin != NULL);
    for (int k = 0; k < a->columns * a->rows; k++) {
        assert_int_equal(a->index[k] < 0 ? a->index[k] : 0, b->index[k] < 0 ? b->index[k] : 0);
        if (a->index[k] < 0)
            continue;
        assert_memory_equal(&a->blocks[a->index[k]], &b->blocks[b->index[k]], sizeof *a->blocks);
        assert_memory_equal(&a->images[a->index[k]], &b->images[b->index[k]], sizeof *a->images);
    }
}

static skv_result update(skv_wall_map *map, const skv_terrain *before, const skv_terrain *after,
                         skv_pool *pool, skv_error *error)
{
    skv_squares changed;
    skv_result result = skv_squares_create(after->columns, after->rows, &changed, error);
    if (result != SKV_OK)
        return result;
    skv_squares_add_differences(&changed, before->coverage, after->coverage, after->columns,
                                after->rows);
    result = skv_wall_map_update(map, before, after, &changed, pool, error);
    skv_squares_destroy(&changed);
    return result;
}

/* A stroke near the last one or anywhere; thin ones make thin walls. */
static skv_brush_stroke next_stroke(dice *d, const skv_brush_stroke *last)
{
    const float width = 2 * SIDE * pixel, height = SIDE * pixel;
    skv_brush_stroke s = {.x0 = last->x1, .y0 = last->y1};
    if (roll(d) < 0.3) {
        s.x0 = width * (float)roll(d);
        s.y0 = height * (float)roll(d);
    }
    s.x1 = s.x0 + 0.6f * (float)(roll(d) - 0.5);
    s.y1 = s.y0 + 0.6f * (float)(roll(d) - 0.5);
    /* Free ends of thin walls count as thick: right through the picture. */
    if (roll(d) < 0.2) {
        s.y0 = -0.1f;
        s.y1 = height + 0.1f;
    }
    s.radius = roll(d) < 0.6 ? 0.6f * pixel : 8 * pixel * (float)roll(d);
    s.erase = roll(d) < 0.35;
    return s;
}

static void paint_and_compare(float radius, unsigned open_sides, skv_pool *pool, uint64_t seed)
{
    dice d = {seed};
    skv_terrain *terrain = make_terrain(2 * SIDE, SIDE, NULL, pixel, open_sides);
    skv_wall_map *map = make_image_map(terrain, radius);
    skv_brush_stroke stroke = {.x1 = 1, .y1 = 0.5f, .radius = pixel};
    bool thin = false;
    for (int i = 0; i < 30; i++) {
        skv_terrain *painted;
        stroke = next_stroke(&d, &stroke);
        assert_int_equal(skv_terrain_paint(terrain, &stroke, 1, &painted, NULL), SKV_OK);
        assert_int_equal(update(map, terrain, painted, pool, NULL), SKV_OK);
        thin = thin || map->thin;
        skv_terrain_destroy(terrain);
        terrain = painted;
        if (i % 3 != 2)
            continue;
        skv_wall_map *anew = make_image_map(painted, radius);
        expect_same(map, anew);
        skv_wall_map_destroy(anew);
    }
    assert_true(thin);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(terrain);
}

static void edited_maps_are_as_new(void **state)
{
    (void)state;
    skv_pool *pool;
    assert_int_equal(skv_pool_create(2, &pool, NULL), SKV_OK);
    paint_and_compare(0.05f, 0, NULL, 1);
    paint_and_compare(0.09f, SKV_SIDE_TOP | SKV_SIDE_RIGHT, pool, 2);
    paint_and_compare(0.2f, 15, pool, 3);
    skv_pool_destroy(pool);
}

/* Whatever allocation fails, the map stays as it was: when images are added, and when it is updated
 * and needs more room. */
static void failures_change_nothing(void **state)
{
    (void)state;
    const skv_brush_stroke strokes[2] = {{0.2f, 0, 0.2f, 1, pixel, false},
                                         {0.6f, 0.5f, 0.9f, 0.6f, 0.1f, false}};
    skv_terrain *tank = tank_with_box(0, 0, 0, 0), *painted;
    assert_int_equal(skv_terrain_paint(tank, strokes, 2, &painted, NULL), SKV_OK);
    skv_wall_map *map, *before = make_image_map(tank, 0.1f), *after = make_image_map(painted, 0.1f);
    assert_int_equal(skv_wall_map_create(tank, 0.1f, 0.1f / 3, SKV_KERNEL_SMOOTH, NULL, &map, NULL),
                     SKV_OK);
    assert_int_equal(skv_wall_map_shade(map, tank, NULL, NULL), SKV_OK);
    failing_memory memory;
    int failures = 0;
    skv_result result = SKV_ERROR_MEMORY;
    for (; result != SKV_OK && failures < 10; failures += result != SKV_OK) {
        failing_memory_start(&memory, failures);
        result = skv_wall_map_add_images(map, tank, NULL, NULL);
        failing_memory_stop();
        assert_true(result == SKV_OK || (result == SKV_ERROR_MEMORY && !map->images));
        assert_int_equal(memory.live, result == SKV_OK ? 1 : 0);
    }
    assert_int_equal(failures, 2);
    expect_same(map, before);
    assert_true(skv_wall_map_bytes(map) > map->room * 2 * sizeof *map->blocks);
    failures = 0;
    for (result = SKV_ERROR_MEMORY; result != SKV_OK && failures < 100;
         failures += result != SKV_OK) {
        failing_memory_start(&memory, failures);
        result = update(map, tank, painted, NULL, NULL);
        failing_memory_stop();
        expect_same(map, result == SKV_OK ? after : before);
    }
    assert_true(failures > 8);
    skv_wall_map_destroy(map);
    skv_wall_map_destroy(before);
    skv_wall_map_destroy(after);
    skv_terrain_destroy(painted);
    skv_terrain_destroy(tank);
}

/* In other units and axes the same; where no block is stored, air and solid. */
static void boundaries_convert(void **state)
{
    (void)state;
    skv_terrain *tank = tank_with_box(59, 0, 61, SIDE);
    skv_wall_map *map = make_image_map(tank, h);
    const skv_boundary b = boundary_of(tank, map);
    const skv_boundary seen = skv_boundary_seen(&b, 0.5f, 2, true);
    skv_image_sample m, other;
    /* A thin wall's side, and the tank's corner. */
    const float places[2][2] = {{0.57f, 0.3f}, {0.05f, 0.08f}};
    for (int i = 0; i < 2; i++) {
        float x = places[i][0], y = places[i][1];
        float distance = skv_boundary_sample_image(&b, x, y, &m);
        assert_true(skv_boundary_sample_image(&seen, 2 * y, 2 * x, &other) == 2 * distance);
        assert_true(m.distance == other.distance && m.r == other.r);
        assert_true(m.nx == other.ny && m.ny == other.nx && m.f1x == other.f1y &&
                    m.f1y == other.f1x);
    }
    /* Nearer to the thin wall than its samples are mixed: still the distance. */
    for (float off = 0.001f; off < 0.1f; off += 0.004f) {
        skv_boundary_sample_image(&b, 0.59f - off, 0.7f, &m);
        assert_true(fabsf(m.distance - off / h) < 0.02f && m.nx < -0.9f && fabsf(m.ny) < 0.1f);
    }
    skv_boundary_sample_image(&b, 0.3f, 0.6f, &m);
    assert_true(m.distance == 1 && m.nx == 0 && m.ny == 0 && m.r == 0 && m.f1x == 0 && m.f1y == 0);
    skv_boundary_sample_image(&b, -1, 0.6f, &m);
    assert_true(m.distance < 0.003f && m.r == 0 && m.f1x == 0 && m.f1y == 0);
    skv_wall_map_destroy(map);
    skv_terrain_destroy(tank);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_walls_are_mirrors),  cmocka_unit_test(rests_fill_up),
        cmocka_unit_test(pushes_are_gradients),    cmocka_unit_test(edited_maps_are_as_new),
        cmocka_unit_test(failures_change_nothing), cmocka_unit_test(boundaries_convert),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
