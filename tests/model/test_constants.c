/* The lattice at rest and the constants of a substep against the formulas of docs/model.md, in
 * double precision, with sums over an enumeration of its own. */
#include "model/constants.h"
#include "model/lattice.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static double cube(double q)
{
    return q * q * q;
}

static double spiky(double q)
{
    return q * q;
}

static double smooth(double q)
{
    return cube(q) * (4 - 3 * q);
}

/* Of the smooth kernel, squared. */
static double answer(double q)
{
    return pow((1 - q) * q * q, 2);
}

/* Sum over the hexagonal lattice with one point per s^2 of a function of q. */
static double lattice_sum(double eta, double (*of)(double))
{
    double side = sqrt(2 / sqrt(3)) / eta, sum = 0;
    int far = (int)(2 / side) + 1; /* more than what lies within h */
    for (int a = -far; a <= far; a++) {
        for (int b = -far; b <= far; b++) {
            double r = hypot(side * (a + 0.5 * b), side * b * sqrt(0.75));
            if ((a || b) && r < 1)
                sum += of(1 - r);
        }
    }
    return sum;
}

static void densities_are_the_known_ones(void **unused)
{
    (void)unused;
    const double eta[] = {2.5, 3, 3.5, 4}, density[] = {2.461, 3.852, 5.551, 7.480};
    for (int i = 0; i < 4; i++)
        assert_true(fabs(skv_lattice_sums(SKV_KERNEL_SPIKY, eta[i]).density - density[i]) < 1e-3);
}

static void lattices_of_every_ratio_are_summed_up(void **unused)
{
    (void)unused;
    for (double eta = 2; eta <= 4; eta += 0.01) {
        skv_lattice flat = skv_lattice_sums(SKV_KERNEL_SMOOTH, eta);
        assert_true(fabs(flat.density - lattice_sum(eta, smooth)) < 1e-9);
        assert_true(fabs(flat.near_density - lattice_sum(eta, cube)) < 1e-9);
        assert_true(fabs(flat.response - lattice_sum(eta, answer)) < 1e-9);
        double steep = skv_lattice_sums(SKV_KERNEL_SPIKY, eta).density;
        assert_true(fabs(steep - lattice_sum(eta, spiky)) < 1e-9);
    }
}

/* Names the constant unless it is the value but for rounding to float. */
#define assert_is(constant, value)                                                                 \
    do {                                                                                           \
        double is = (double)(constant), wanted = (value);                                          \
        if (!(fabs(is - wanted) <= 3e-7 * fabs(wanted)))                                           \
            fail_msg("%s is %.9g, not %.9g", #constant, is, wanted);                               \
    } while (0)

/* A fluid that has something of everything, the more the larger `k` is. */
static skv_fluid_def some_fluid(skv_law law, int k)
{
    skv_fluid_def f = skv_default_fluid_def(law);
    f.spacing = 0.002f * (float)(k + 1);
    f.radius_ratio = 2.5f + 0.1f * (float)k;
    f.viscosity_linear = (float)k;
    f.viscosity_quadratic = 0.5f * (float)k;
    f.wall_friction = 0.04f * (float)k;
    f.wall_softness = 0.1f + 0.07f * (float)k;
    f.wall_images = k % 2 == 1;
    f.adhesion = 0.1f * (float)k;
    return f;
}

enum { FLUIDS = 10 };
static const float dt = 1.0f / 60 / 7;

/* The lattice is that of particles with so much more room. */
static void check_calibrated(const skv_fluid_def *f, float compression)
{
    const double ratio = (double)f->radius_ratio, eta = ratio / sqrt(1 + (double)compression);
    const double h = (double)f->spacing * ratio, step = (double)dt;
    const double rest = lattice_sum(eta, smooth), response = lattice_sum(eta, answer);
    const double usual = lattice_sum(eta, cube) / rest;
    /* Accelerations become displacements of dt^2 each, shared out over the iterations. */
    const double share = step * step / f->iterations * response;
    const double pull = 1.785 * (double)f->cohesion / 2, flat = eta * eta / 15;
    skv_constants c = skv_make_constants(f, compression, dt);
    skv_set_stiffness(&c, 1.2f);
    assert_is(c.rest_density, rest);
    assert_is(c.lambda_scale, fmin((double)f->relaxation, 4 / (ratio * ratio)) * h / 12);
    assert_is(c.response_floor, response);
    assert_is(c.response_slope, response / rest);
    assert_is(c.near_share, usual);
    assert_is(c.near_lambda_scale, share * (double)f->near_stiffness / 2);
    assert_is(c.cohesion_scale, share * pull);
    assert_is(c.cohesion_below, 0.95 * rest);
    assert_is(c.cohesion_from, 0.25 * rest);
    assert_is(c.cohesion_slope, 1 / (0.25 * rest));
    assert_is(c.tension_scale, step * step * 0.255 * (double)f->cohesion);
    assert_is(c.tension_from, 0.2 * flat);
    assert_is(c.pair_lag, 0.7);
    assert_is(c.lag_rise, step * step / (0.010 * h * 0.010 * h));
    assert_is(c.wall_virial, 1.0 / 6);
    /* What the pressure pushes in a substep that starts warm, at the depth that it is made for. */
    const double warm = 1 - 1 / (1.2 * 1.2);
    const double found = f->iterations * (double)c.lambda_scale * 0.04 * rest / response;
    assert_is(c.warm_start, warm);
    assert_is(c.warm_limit, 0.7 * found / (1 - warm));
    assert_is(c.tension_until, 0.25 * found / (1 - warm));
    assert_is(c.warm_most, 6);
    if (!f->wall_images)
        return;
    const double half = 3.14159265358979 / 5 * eta * eta; /* int W over the plane */
    assert_is(c.image_gradient, half / 12);
    assert_is(c.image_virial, 2 * half / 6);
    assert_is(c.image_near_virial, 2 * 2.0 / 3 * half / 2);
    assert_is(c.residual_share, 2 * usual);
    assert_is(c.adhesion, (double)f->adhesion);
    assert_is(c.friction, 0);
}

static void calibrated_constants_are_those_of_the_model(void **unused)
{
    (void)unused;
    for (int k = 0; k < FLUIDS; k++) {
        skv_fluid_def f = some_fluid(SKV_LAW_CALIBRATED, k);
        check_calibrated(&f, 0);
        check_calibrated(&f, 0.02f);
    }
}

static void clavets_constants_are_those_of_the_model(void **unused)
{
    (void)unused;
    for (int k = 0; k < FLUIDS; k++) {
        skv_fluid_def f = some_fluid(SKV_LAW_CLAVET, k);
        const double eta = (double)f.radius_ratio, h = (double)f.spacing * eta;
        skv_constants c = skv_make_constants(&f, 0, dt);
        assert_true(c.clavet && !c.images && c.pair_lag == 0);
        assert_is(c.rest_density, (double)f.clavet_rest_density);
        assert_is(c.lambda_scale, (double)f.clavet_stiffness * h / 2);
        assert_is(c.near_lambda_scale, (double)f.clavet_near_stiffness * h / 2);
        assert_is(c.lambda_limit, 0.2 * h);
        assert_is(c.wall_virial, 1);
        double loose = 0.75 * lattice_sum(eta, spiky) - (double)f.clavet_rest_density;
        assert_is(c.loose_lambda, (double)c.lambda_scale * loose);
    }
}

static void constants_of_both_laws_are_those_of_the_model(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        for (int k = 0; k < FLUIDS; k++) {
            skv_fluid_def f = some_fluid((skv_law)law, k);
            f.wall_images = false;
            const double h = (double)f.spacing * (double)f.radius_ratio, step = (double)dt;
            skv_constants c = skv_make_constants(&f, 0, dt);
            assert_is(c.h, h);
            assert_is(c.inv_h, 1 / h);
            assert_is(c.max_speed, 0.9 * h / step);
            assert_is(c.pressure_scale, (double)f.density / (4 * step * step));
            assert_is(c.softness, 1 - pow(1 - (double)f.wall_softness, 60 * step));
            assert_is(c.friction, 1 - pow(1 - (double)f.wall_friction, 60 * step));
            assert_is(c.turn_reach, 1.6 / (double)f.radius_ratio);
            assert_is(c.viscosity_quadratic, (double)f.viscosity_quadratic);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_are_the_known_ones),
        cmocka_unit_test(lattices_of_every_ratio_are_summed_up),
        cmocka_unit_test(calibrated_constants_are_those_of_the_model),
        cmocka_unit_test(clavets_constants_are_those_of_the_model),
        cmocka_unit_test(constants_of_both_laws_are_those_of_the_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
