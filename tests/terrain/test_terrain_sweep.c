/* The swept test: nothing crosses a thin wall, whatever its direction and shade; moves stop where
 * they should and go on where they may. Lengths are in pixels unless they say otherwise. */
#include "shapes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SIDE  128
#define PIXEL 0.0025f

/* What rounding of positions may cost. */
#define SLACK 3e-4

static uint8_t picture[SIDE * SIDE];

static double distance(const skv_terrain *t, double x, double y)
{
    return (double)skv_terrain_distance(t, (float)x * PIXEL, (float)y * PIXEL) / (double)PIXEL;
}

static double sweep(const skv_terrain *t, double x0, double y0, double x1, double y1, double margin)
{
    return (double)skv_terrain_sweep(t, (float)x0 * PIXEL, (float)y0 * PIXEL, (float)x1 * PIXEL,
                                     (float)y1 * PIXEL, (float)margin * PIXEL);
}

/* Moves (x, y) as far as it may go. */
static void move(const skv_terrain *t, double *x, double *y, double dx, double dy, double margin)
{
    double before = distance(t, *x, *y);
    double share = sweep(t, *x, *y, *x + dx, *y + dy, margin);
    assert_true(share >= 0 && share <= 1);
    *x += share * dx;
    *y += share * dy;
    assert_true(distance(t, *x, *y) >= fmin(margin, before) - SLACK);
}

/* Paints a line through the middle, `wide` pixels across along the axis it is steeper to. */
static void paint_line(double degrees, int wide, uint8_t shade)
{
    memset(picture, 0, sizeof picture);
    double angle = degrees * acos(-1.0) / 180, c = cos(angle), s = sin(angle);
    bool flat = fabs(c) >= fabs(s);
    for (int i = 0; i < SIDE; i++) {
        double along = i - SIDE / 2;
        int j = SIDE / 2 + (int)floor(along * (flat ? s / c : c / s) + 0.5);
        for (int k = 0; k < wide; k++) {
            if (j + k >= 0 && j + k < SIDE)
                picture[flat ? (j + k) * SIDE + i : i * SIDE + j + k] = shade;
        }
    }
}

/* Fires at a line from both sides, then pushes on in small steps: nobody gets across. */
static void thin_walls_hold(void **state)
{
    (void)state;
    const double angles[] = {0, 90, 45, 135, 10, 22.5, 30, 63, 100, 171};
    const uint8_t shades[] = {255, 160, 130};
    const double margins[] = {0, 0.3, 1.5};
    dice d = {7};
    int stopped = 0;
    for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
        for (int variant = 0; variant < 18; variant++) {
            int wide = 1 + variant % 2;
            double margin = margins[variant / 2 % 3];
            double angle = angles[a] * acos(-1.0) / 180, nx = -sin(angle), ny = cos(angle);
            paint_line(angles[a], wide, shades[variant / 6]);
            skv_terrain *t = make_terrain(SIDE, SIDE, picture, PIXEL, 0);
            for (int shot = 0; shot < 150; shot++) {
                double x = SIDE * (0.3 + 0.4 * roll(&d)), y = SIDE * (0.3 + 0.4 * roll(&d));
                bool flat = fabs(nx) <= fabs(ny);
                double mx = SIDE / 2 + (flat ? 0.5 : 0.5 * wide);
                double my = SIDE / 2 + (flat ? 0.5 * wide : 0.5);
                double side = (x - mx) * nx + (y - my) * ny;
                if (distance(t, x, y) < 0.2 || fabs(side) < 1.5)
                    continue;
                double towards = side > 0 ? -1 : 1, speed = 1 + 40 * roll(&d);
                double dx = towards * speed * nx + 10 * (roll(&d) - 0.5);
                double dy = towards * speed * ny + 10 * (roll(&d) - 0.5);
                double was_x = x, was_y = y;
                move(t, &x, &y, dx, dy, margin);
                stopped += hypot(x - was_x, y - was_y) < 0.99 * hypot(dx, dy);
                for (int push = 0; push < 60; push++) {
                    double length = push % 3 == 0 ? 0.002 : push % 3 == 1 ? 0.02 : 3;
                    move(t, &x, &y, towards * length * nx, towards * length * ny, margin);
                }
                /* The line's middle wanders by half a pixel around the straight one. */
                double now = (x - mx) * nx + (y - my) * ny;
                assert_true(now * side > 0 || fabs(now) < 1.01);
                /* On its own side: going back there meets no wall. */
                double away = -towards * 3;
                double back = sweep(t, x, y, x + away * nx, y + away * ny, -10);
                assert_true(back == 1);
                assert_true(((x + away * nx - mx) * nx + (y + away * ny - my) * ny) * side > 0);
            }
            skv_terrain_destroy(t);
        }
    }
    /* The shots were aimed: most must have met the wall. */
    assert_true(stopped > 5000);
}

/* From far outside an open side inwards, and back: a share of the way, from within the grid, and
 * the wall in the middle holds. */
static void moves_from_far_away_stay_in_the_grid(void **state)
{
    (void)state;
    const double far[] = {1e3, 3e4, 1e5, 1e7, 1e20, 1e37};
    dice d = {11};
    paint_line(90, 1, 255);
    for (unsigned open = 0; open < 16; open++) {
        skv_terrain *t = make_terrain(SIDE, SIDE, picture, PIXEL, open);
        for (int shot = 0; shot < 3000; shot++) {
            double away = far[shot % 6] * (2 * roll(&d) - 1);
            double x = SIDE * roll(&d), y = SIDE * (0.1 + 0.8 * roll(&d)),
                   height = shot % 4 ? y : away;
            double in = sweep(t, away, height, x, y, 0.3), out = sweep(t, x, y, away, height, 0.3);
            assert_true(in >= 0 && in <= 1 && out >= 0 && out <= 1);
            bool to_right = x < SIDE / 2 - 2 && away > SIDE, to_left = x > SIDE / 2 + 3 && away < 0;
            bool from_air = open & (to_right ? SKV_SIDE_RIGHT : SKV_SIDE_LEFT);
            if (shot % 4 && (to_right || to_left))
                assert_true(out < 1 && (in < 1 || !from_air));
        }
        skv_terrain_destroy(t);
    }
}

/* The regions of air, joined over pixel edges only. */
static void label_regions(int *labels)
{
    static int queue[SIDE * SIDE];
    int label = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        labels[i] = 0;
    for (int seed = 0; seed < SIDE * SIDE; seed++) {
        if (labels[seed] || picture[seed] >= 128)
            continue;
        int head = 0, tail = 0;
        labels[seed] = ++label;
        queue[tail++] = seed;
        while (head < tail) {
            int at = queue[head++], x = at % SIDE, y = at / SIDE;
            const int next[4] = {x > 0 ? at - 1 : at, x + 1 < SIDE ? at + 1 : at,
                                 y > 0 ? at - SIDE : at, y + 1 < SIDE ? at + SIDE : at};
            for (int k = 0; k < 4; k++) {
                if (!labels[next[k]] && picture[next[k]] < 128) {
                    labels[next[k]] = label;
                    queue[tail++] = next[k];
                }
            }
        }
    }
}

/* The region of a point in air: that of the nearest air pixel of the four around it, which is on
 * the same side of the wall. */
static int region(const int *labels, double x, double y)
{
    int left = (int)floor(x - 0.5), low = (int)floor(y - 0.5), best = 0;
    double nearest = 9;
    for (int j = low; j <= low + 1; j++) {
        for (int i = left; i <= left + 1; i++) {
            if (i < 0 || j < 0 || i >= SIDE || j >= SIDE || picture[j * SIDE + i] >= 128)
                continue;
            double square = (x - i - 0.5) * (x - i - 0.5) + (y - j - 0.5) * (y - j - 0.5);
            if (square < nearest) {
                nearest = square;
                best = labels[j * SIDE + i];
            }
        }
    }
    return best;
}

/* Wanderers in random mazes and in noise never change the region of air they live in. */
static void nobody_leaves_a_region(void **state)
{
    (void)state;
    static int labels[SIDE * SIDE];
    dice d = {11};
    for (int world = 0; world < 12; world++) {
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE, y = i / SIDE, cell = 8;
            bool wall = x % cell == 0 || y % cell == 0 || (x + y) % 24 == 0;
            double share = world % 3 == 0   ? (wall && roll(&d) > 0.02)
                           : world % 3 == 1 ? roll(&d) < 0.45
                                            : roll(&d);
            picture[i] = (uint8_t)(share * 255 + 0.5);
        }
        label_regions(labels);
        skv_terrain *t = make_terrain(SIDE, SIDE, picture, PIXEL, 0);
        for (int walker = 0; walker < 200; walker++) {
            double x = SIDE * roll(&d), y = SIDE * roll(&d);
            if (distance(t, x, y) < 0.05)
                continue;
            int home = region(labels, x, y);
            for (int step = 0; step < 60; step++) {
                double reach = step % 2 ? 20 : 2;
                move(t, &x, &y, reach * (roll(&d) - 0.5), reach * (roll(&d) - 0.5),
                     walker % 2 ? 0.02 : 0.2);
                assert_int_equal(region(labels, x, y), home);
            }
        }
        skv_terrain_destroy(t);
    }
}

/* Who is inside a wall, say after an edit, may leave on the own side only, in walls of one pixel
 * and of two, whose middle is no deeper than what is beside it. */
static void nobody_crosses_from_inside(void **state)
{
    (void)state;
    dice d = {13};
    for (int wide = 1; wide <= 2; wide++) {
        paint_line(90, wide, 255);
        skv_terrain *t = make_terrain(SIDE, SIDE, picture, PIXEL, 0);
        double middle = SIDE / 2 + 0.5 * wide;
        for (int i = 0; i < 2000; i++) {
            double side = i % 2 ? 1 : -1, depth = 0.02 + 0.46 * wide * roll(&d);
            double x = middle + side * depth, y = 20 + 80 * roll(&d);
            double dy = 4 * (roll(&d) - 0.5), slow = i % 3 ? 3 : 0.1;
            for (int push = 0; push < 20; push++) {
                double share = sweep(t, x, y, x - side * slow, y + dy, 0);
                assert_true((x - share * side * slow - middle) * side > 0);
                x -= share * side * slow;
            }
            assert_true(sweep(t, x, y, x + side * 3, y, 0) == 1);
        }
        skv_terrain_destroy(t);
    }
}

/* Straight at a floor, from near and far and at all angles: the move ends at the margin. */
static void stops_at_the_margin(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(SIDE, SIDE, NULL, PIXEL, 0);
    dice d = {3};
    for (int i = 0; i < 3000; i++) {
        double margin = i % 3 * 0.7, height = margin + 0.01 + 40 * roll(&d);
        double x = 64, dx = 30 * (roll(&d) - 0.5), dy = -height - 20 * roll(&d);
        double share = sweep(t, x, height, x + dx, height + dy, margin);
        double end = height + share * dy;
        assert_true(fabs(end - margin) < SLACK);
    }
    skv_terrain_destroy(t);
}

/* Pushing again and again gains nothing, however often. */
static void pushing_gains_nothing(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(SIDE, SIDE, NULL, PIXEL, 0);
    for (int k = 0; k < 3; k++) {
        double x = 100.3 + 9 * k, y = 0.5 * k + 0.01;
        for (int push = 0; push < 1000; push++)
            move(t, &x, &y, 0.3 * k, -1, 0.5 * k);
        assert_true(y > 0.5 * k - 1e-3);
    }
    skv_terrain_destroy(t);
}

static void free_moves_go_all_the_way(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(SIDE, SIDE, NULL, PIXEL, SKV_SIDE_TOP);
    dice d = {5};
    for (int i = 0; i < 1000; i++) {
        double x = SIDE * (0.1 + 0.8 * roll(&d)), y = SIDE * (0.1 + 0.8 * roll(&d));
        assert_true(
            sweep(t, x, y, SIDE * (0.1 + 0.8 * roll(&d)), SIDE * (0.1 + 0.8 * roll(&d)), 5) == 1);
    }
    /* Along the floor, at the margin and below it; away from it; out through the open top. */
    assert_true(sweep(t, 10, 1, 110, 1, 1) == 1);
    assert_true(sweep(t, 10, 0.5, 110, 0.5, 1) == 1);
    assert_true(sweep(t, 10, 0.5, 30, 5, 1) == 1);
    assert_true(sweep(t, 64, 60, 64, 1e6, 1) == 1);
    assert_true(sweep(t, 64, 60, 64, 60, 1) == 1);
    /* Below the margin and deeper: not at all. */
    assert_true(sweep(t, 10, 0.5, 10, -5, 1) < 0.001);
    /* From behind a closed side: back in, not farther out. */
    assert_true(sweep(t, 10, -9, 10, 20, 1) == 1);
    assert_true(sweep(t, 10, -9, 10, -20, 1) < 0.01);
    skv_terrain_destroy(t);
}

static void numbers_that_are_none_stay_put(void **state)
{
    (void)state;
    skv_terrain *t = make_terrain(SIDE, SIDE, NULL, PIXEL, 0);
    assert_true(skv_terrain_sweep(t, NAN, 0.1f, 0.1f, 0.1f, 0) == 0);
    assert_true(skv_terrain_sweep(t, 0.1f, 0.1f, NAN, 0.1f, 0) == 0);
    assert_true(skv_terrain_sweep(t, 0.1f, 0.1f, 0.1f, INFINITY, 0) == 0);
    float share = skv_terrain_sweep(t, 0.1f, 0.1f, 3e38f, -3e38f, 0);
    assert_true(share >= 0 && share <= 1);
    /* Along the outside for ever: must come back, and not from beyond its limit. */
    share = skv_terrain_sweep(t, -0.1f, 0.1f, -0.1f, 1e20f, 0);
    assert_true(share >= 0 && share <= 1);
    skv_terrain_destroy(t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thin_walls_hold),
        cmocka_unit_test(moves_from_far_away_stay_in_the_grid),
        cmocka_unit_test(nobody_leaves_a_region),
        cmocka_unit_test(nobody_crosses_from_inside),
        cmocka_unit_test(stops_at_the_margin),
        cmocka_unit_test(pushing_gains_nothing),
        cmocka_unit_test(free_moves_go_all_the_way),
        cmocka_unit_test(numbers_that_are_none_stay_put),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
