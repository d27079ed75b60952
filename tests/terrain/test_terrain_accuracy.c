/* How well distances and normals match analytic shapes, from grey and from black and white
 * pictures, and beside it the thesis' Manhattan field on the same pictures. */
#include "manhattan.h"
#include "shapes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

#define SIDE  512
#define PIXEL (1.6f / SIDE)

/* Errors of one field over points in a band from 3 pixels inside to 12 outside the wall. */
typedef struct errors {
    double sum, worst;
    int count;
} errors;

static void note(errors *e, double error)
{
    e->sum += error * error;
    e->worst = fmax(e->worst, fabs(error));
    e->count++;
}

static double rms(const errors *e)
{
    return sqrt(e->sum / e->count);
}

/* Angle between two unit vectors in degrees. */
static double angle(double ax, double ay, double bx, double by)
{
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) * 180 / acos(-1.0);
}

typedef struct result {
    errors distance, normal;             /* this library */
    errors raw, corrected, their_normal; /* the thesis */
} result;

static double bilinear(const float *field, int stride, double x, double y)
{
    double gx = x + 0.5, gy = y + 0.5; /* pixel centres, plus the frame */
    int i = (int)gx, j = (int)gy;
    double u = gx - i, v = gy - j;
    const float *low = field + j * stride + i, *high = low + stride;
    return (1 - v) * ((1 - u) * (double)low[0] + u * (double)low[1]) +
           v * ((1 - u) * (double)high[0] + u * (double)high[1]);
}

static result measure(const shape *s, bool grey)
{
    static uint8_t picture[SIDE * SIDE];
    paint_shape(s, SIDE, SIDE, grey, picture);
    skv_terrain *terrain = make_terrain(SIDE, SIDE, picture, PIXEL, 0);
    manhattan m = manhattan_create(SIDE, SIDE, picture);
    result r = {0};
    dice d = {1};
    for (int i = 0; i < 200000; i++) {
        double x = 40 + roll(&d) * (SIDE - 80), y = 40 + roll(&d) * (SIDE - 80);
        double truth = shape_distance(s, x, y), nx, ny;
        if (truth < -3 || truth > 12)
            continue;
        shape_normal(s, x, y, &nx, &ny);
        float ox, oy;
        float metres = skv_terrain_normal(terrain, (float)x * PIXEL, (float)y * PIXEL, &ox, &oy);
        note(&r.distance, (double)metres / (double)PIXEL - truth);
        note(&r.normal, angle(nx, ny, (double)ox, (double)oy));
        int at = ((int)y + 1) * m.width + (int)x + 1;
        note(&r.raw, (double)m.raw[at] - truth);
        note(&r.corrected, bilinear(m.corrected, m.width, x, y) - truth);
        note(&r.their_normal, angle(nx, ny, (double)m.nx[at], (double)m.ny[at]));
    }
    manhattan_destroy(&m);
    skv_terrain_destroy(terrain);
    return r;
}

/* What is allowed: rms and worst, in pixels and degrees. */
typedef struct limits {
    double distance[2], normal[2];
} limits;

/* A shape with the limits of this library for grey and for binary input and with those of the
 * thesis' field: measured, plus a few hundredths. The thesis' limits guard the comparison. */
typedef struct expectation {
    shape shape;
    limits grey, binary;
    double raw[2];
    limits thesis;
} expectation;

static void check(const char *name, const char *what, const errors *e, const double limit[2])
{
    if (rms(e) > limit[0] || e->worst > limit[1])
        fail_msg("%s, %s: rms %.3f, worst %.3f; allowed are %.3f and %.3f", name, what, rms(e),
                 e->worst, limit[0], limit[1]);
}

static void print_row(const char *name, const char *input, const result *r)
{
    const errors *columns[] = {&r->distance, &r->normal, &r->raw, &r->corrected, &r->their_normal};
    print_message("%-14s %-6s", name, input);
    for (int i = 0; i < 5; i++)
        print_message("  %5.2f /%5.2f", rms(columns[i]), columns[i]->worst);
    print_message("\n");
}

static void errors_stay_in_bounds(void **state)
{
    (void)state;
    const double c = 256.3, cx = 256.2, cy = 256.4;
    const expectation expected[] = {
        {disc_shape("disc r=100", c, 255.7, 100),
         {{0.045, 0.11}, {1.5, 4.5}},
         {{0.24, 0.52}, {5.8, 25}},
         {1.65, 6.7},
         {{0.26, 0.97}, {2.6, 8.8}}},
        {bowl_shape("bowl r=150", c, 255.7, 150),
         {{0.045, 0.11}, {1.5, 4.5}},
         {{0.24, 0.52}, {5.9, 28}},
         {1.4, 5.8},
         {{0.24, 0.78}, {2.4, 8.4}}},
        {wall_shape("wall 0 deg", cx, cy, 0),
         {{0.10, 0.10}, {0.01, 0.01}},
         {{0.41, 0.41}, {0.01, 0.01}},
         {1.0, 1.45},
         {{0.41, 0.41}, {0.01, 0.01}}},
        {wall_shape("wall 10 deg", cx, cy, 10),
         {{0.055, 0.10}, {2.6, 4.6}},
         {{0.26, 0.51}, {8.1, 19.5}},
         {0.75, 1.75},
         {{0.25, 0.52}, {1.2, 2.3}}},
        {wall_shape("wall 22.5 deg", cx, cy, 22.5),
         {{0.035, 0.085}, {0.85, 2.4}},
         {{0.24, 0.48}, {5.0, 16}},
         {1.1, 2.6},
         {{0.21, 0.53}, {1.1, 1.8}}},
        {wall_shape("wall 30 deg", cx, cy, 30),
         {{0.030, 0.08}, {0.7, 2.4}},
         {{0.22, 0.45}, {4.6, 14}},
         {1.5, 3.6},
         {{0.20, 0.56}, {1.05, 1.4}}},
        {wall_shape("wall 45 deg", cx, cy, 45),
         {{0.068, 0.068}, {0.03, 0.05}},
         {{0.22, 0.22}, {0.03, 0.05}},
         {2.9, 6.3},
         {{0.22, 0.22}, {0.03, 0.05}}},
        {wall_shape("wall 60 deg", cx, cy, 60),
         {{0.030, 0.08}, {0.7, 2.4}},
         {{0.22, 0.45}, {4.6, 14}},
         {1.5, 3.6},
         {{0.20, 0.56}, {1.05, 1.4}}},
    };
    print_message("rms / worst errors in pixels and degrees\n%-21s  %-13s  %-13s  %-13s  %-13s  "
                  "%-13s\n",
                  "", "distance", "3x3 normal", "Manhattan", "corrected", "9x9 normal");
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const expectation *e = &expected[i];
        const char *name = e->shape.name;
        for (int grey = 1; grey >= 0; grey--) {
            result r = measure(&e->shape, grey);
            const limits *own = grey ? &e->grey : &e->binary;
            print_row(name, grey ? "grey" : "binary", &r);
            check(name, "distance", &r.distance, own->distance);
            check(name, "normal", &r.normal, own->normal);
            check(name, "Manhattan distance", &r.raw, e->raw);
            check(name, "corrected distance", &r.corrected, e->thesis.distance);
            check(name, "9x9 normal", &r.their_normal, e->thesis.normal);
            if (grey)
                assert_true(rms(&r.distance) < 0.4 * rms(&r.corrected));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_stay_in_bounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
