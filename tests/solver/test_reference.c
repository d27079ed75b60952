/* The reference's passes on random states: what pushes particles is the slope of an energy, by
 * differences of the densities that the same particles have, and pairs keep momentum. */
#include "solver/direction.h"
#include "solver/reference/reference.h"
#include "solver/wall_image.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 12, N = SIDE * SIDE };

static uint32_t random_state;

static double uniform(double lo, double hi)
{
    random_state = random_state * 1664525u + 1013904223u;
    return lo + (hi - lo) * (double)(random_state >> 8) / 16777216.0;
}

static const skv_fluid_def *fluid_of(skv_law law, bool images)
{
    static skv_fluid_def f;
    f = skv_default_fluid_def(law);
    f.spacing = 0.02f;
    f.viscosity_linear = 20;
    f.viscosity_quadratic = 3;
    f.wall_images = images;
    return &f;
}

static skv_constants constants;
static float place_x[N], place_y[N];
static uint32_t id[N];
static uint8_t fluid[N];
static const float cohesion[] = {1, 0.125f, 0.5f};
static const skv_boundary no_walls;

/* Particles about a spacing apart, some much closer, displaced and pressed at random; with images
 * one in three stands beside a wall of its own. */
static void randomise(skv_reference *f, bool images)
{
    const double spacing = (double)constants.h / 3;
    for (int i = 0; i < N; i++) {
        double close = uniform(0, 1) < 0.1 ? 0.05 : 0.8, angle = uniform(0, 6.28);
        place_x[i] = (float)(spacing * (i % SIDE + uniform(-close, close)));
        place_y[i] = (float)(spacing * (i / SIDE + uniform(-close, close)));
        f->x[i] = (double)place_x[i];
        f->y[i] = (double)place_y[i];
        f->moved_x[i] = spacing * uniform(-0.1, 0.1);
        f->moved_y[i] = spacing * uniform(-0.1, 0.1);
        f->lambda[i] = spacing * uniform(-0.01, 0.1);
        f->near_lambda[i] = spacing * uniform(0, 0.05);
        bool beside = images && uniform(0, 1) < 0.3;
        f->image[i] = beside ? uniform(0.02, 0.9) : (double)SKV_FAR;
        f->facing_x[i] = beside ? cos(angle) : 0;
        f->facing_y[i] = beside ? sin(angle) : 0;
    }
}

/* Weightless, of three cohesions, and pairs do not lag behind. */
static skv_reference *make(skv_law law, bool images, uint32_t seed)
{
    static float zero[N];
    random_state = seed;
    constants = skv_make_constants(fluid_of(law, images), 0, 1.0f / 480);
    skv_solver *solver;
    const skv_solver_def def = {.x1 = 0.3f, .y1 = 0.3f, .h = constants.h};
    assert_int_equal(skv_reference_solver.create(&def, &solver, NULL), SKV_OK);
    for (uint32_t i = 0; i < N; i++)
        id[i] = i;
    const skv_solver_step step = {
        .particles = {.count = N, .x = zero, .y = zero, .id = id},
        .constants = &constants,
    };
    assert_int_equal(solver->type->reserve(solver, &step, NULL), SKV_OK);
    skv_reference *f = (skv_reference *)solver;
    f->constants = &constants;
    f->count = N;
    f->boundary = &no_walls;
    for (int i = 0; i < N; i++) {
        f->mass[i] = 1;
        fluid[i] = (uint8_t)(i % 3);
    }
    f->fluid = fluid;
    f->cohesion = cohesion;
    f->id = id;
    randomise(f, images);
    skv_neighbours_build(&f->neighbours, place_x, place_y, N, 1.02f * constants.h);
    return f;
}

static void clear_displacements(skv_reference *f)
{
    for (int i = 0; i < N; i++)
        f->dx[i] = f->dy[i] = 0;
}

/* Of which displacements are the slope, per h: that of the densities, P and N being what they are,
 * or that of the gradients, which have been multiplied by the cohesion of each particle's fluid. */
typedef double energy(skv_reference *f);

static double of_densities(skv_reference *f)
{
    double sum = 0;
    f->first = false;
    skv_pass_density(f);
    for (int i = 0; i < N; i++)
        sum += f->lambda[i] * f->density[i] / skv_kernel_gain(constants.kernel) +
               f->near_lambda[i] * f->near_density[i] / SKV_NEAR_GAIN;
    return sum;
}

static double of_gradients(skv_reference *f)
{
    double sum = 0;
    f->first = true;
    skv_pass_density(f);
    for (int i = 0; i < N; i++)
        sum += (f->gradient_x[i] * f->gradient_x[i] + f->gradient_y[i] * f->gradient_y[i]) /
               (double)cohesion[fluid[i]];
    return (double)constants.tension_scale * sum / 2;
}

static double shifted(skv_reference *f, energy *of, int i, double dx, double dy)
{
    const double h = (double)constants.h, x = f->x[i], y = f->y[i], image = f->image[i];
    f->x[i] += dx;
    f->y[i] += dy;
    f->image[i] += (dx * f->facing_x[i] + dy * f->facing_y[i]) / h;
    double found = of(f);
    f->x[i] = x;
    f->y[i] = y;
    f->image[i] = image;
    return found;
}

/* What a pass has put into dx, dy is minus the slope of an energy, per h. */
static void expect_slope(skv_reference *f, energy *of)
{
    static double dx[N], dy[N];
    const double h = (double)constants.h, small = 1e-6 * h;
    double largest = 0;
    memcpy(dx, f->dx, sizeof dx);
    memcpy(dy, f->dy, sizeof dy);
    for (int i = 0; i < N; i++)
        largest = fmax(largest, hypot(dx[i], dy[i]));
    assert_true(largest > 1e-6 * h);
    for (int i = 0; i < N; i++) {
        double slope_x = shifted(f, of, i, small, 0) - shifted(f, of, i, -small, 0);
        double slope_y = shifted(f, of, i, 0, small) - shifted(f, of, i, 0, -small);
        double off = hypot(dx[i] + h * slope_x / (2 * small), dy[i] + h * slope_y / (2 * small));
        if (!(off < 1e-6 * largest))
            fail_msg("particle %d is pushed by (%g, %g), off by %g", i, dx[i], dy[i], off);
    }
}

static void pushes_are_the_slope_of_the_densities(void **unused)
{
    (void)unused;
    for (uint32_t seed = 0; seed < 3; seed++) {
        for (int kind = 0; kind < 3; kind++) {
            skv_law law = kind == 2 ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED;
            skv_reference *f = make(law, kind == 1, seed);
            skv_pass_displacement(f);
            expect_slope(f, of_densities);
            f->solver.type->destroy(&f->solver);
        }
    }
}

static void tension_is_the_slope_of_the_gradients(void **unused)
{
    (void)unused;
    for (uint32_t seed = 0; seed < 3; seed++) {
        skv_reference *f = make(SKV_LAW_CALIBRATED, false, seed);
        of_gradients(f);
        clear_displacements(f);
        skv_pass_tension(f);
        expect_slope(f, of_gradients);
        f->solver.type->destroy(&f->solver);
    }
}

/* Each pair's parts are opposite, so what is left is the rounding of the sums. */
static void pairs_keep_momentum(void **unused)
{
    (void)unused;
    skv_pass *const passes[] = {skv_pass_displacement, skv_pass_tension, skv_pass_viscosity};
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        skv_reference *f = make((skv_law)law, false, 99);
        f->first = true;
        skv_pass_density(f);
        for (int p = 0; p < 3; p++) {
            if (passes[p] == skv_pass_tension && law == SKV_LAW_CLAVET)
                continue;
            double sum_x = 0, sum_y = 0, size = 0;
            clear_displacements(f);
            passes[p](f);
            for (int i = 0; i < N; i++) {
                sum_x += f->dx[i];
                sum_y += f->dy[i];
                size += fabs(f->dx[i]) + fabs(f->dy[i]);
            }
            assert_true(size > 0);
            assert_true(fabs(sum_x) < 1e-14 * size && fabs(sum_y) < 1e-14 * size);
        }
        f->solver.type->destroy(&f->solver);
    }
}

/* Two particles in one place part in opposite directions, whatever their numbers. */
static void coincident_particles_part(void **unused)
{
    (void)unused;
    for (uint32_t a = 0; a < 200; a++) {
        float ux, uy, wx, wy;
        skv_fallback_direction(a, 3 * a + 1, &ux, &uy);
        skv_fallback_direction(3 * a + 1, a, &wx, &wy);
        assert_true(fabsf(ux * ux + uy * uy - 1) < 1e-5f);
        assert_true(ux == -wx && uy == -wy);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pushes_are_the_slope_of_the_densities),
        cmocka_unit_test(tension_is_the_slope_of_the_gradients),
        cmocka_unit_test(pairs_keep_momentum),
        cmocka_unit_test(coincident_particles_part),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
