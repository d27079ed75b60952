/* The kernels, and each integral that src/model/kernel.h states of them, by numerical integration.
 */
#include "model/kernel.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { STEPS = 400 };

typedef double integrand(skv_kernel kernel, double x, double y);

static double q_at(double x, double y)
{
    return fmax(0, 1 - hypot(x, y));
}

static double whole(skv_kernel kernel, double x, double y)
{
    return skv_kernel_density(kernel, q_at(x, y));
}

static double virial(skv_kernel kernel, double x, double y)
{
    return hypot(x, y) * skv_kernel_force(kernel, q_at(x, y));
}

static double near_whole(skv_kernel kernel, double x, double y)
{
    (void)kernel;
    return pow(q_at(x, y), 3);
}

static double near_virial(skv_kernel kernel, double x, double y)
{
    (void)kernel;
    return hypot(x, y) * pow(q_at(x, y), 2);
}

static double flat(skv_kernel kernel, double x, double y)
{
    return x > 0 ? skv_kernel_force(kernel, q_at(x, y)) * x / hypot(x, y) : 0;
}

static double viscous(skv_kernel kernel, double x, double y)
{
    (void)kernel;
    return x * y < 0 ? q_at(x, y) * pow(x * y / hypot(x, y), 2) / 4 : 0;
}

static double springs(skv_kernel kernel, double x, double y)
{
    (void)kernel;
    return q_at(x, y) * pow(x * y / hypot(x, y), 2) / 4;
}

/* Over the plane: rings by the middles of their widths, each by rays evenly spread. */
static double over_plane(skv_kernel kernel, integrand *f)
{
    const double turn = 2 * SKV_PI;
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        double r = (i + 0.5) / STEPS, ring = 0;
        for (int k = 0; k < STEPS; k++)
            ring += f(kernel, r * cos(turn * (k + 0.5) / STEPS), r * sin(turn * (k + 0.5) / STEPS));
        sum += ring * r;
    }
    return sum * turn / STEPS / STEPS;
}

static void integrals_are_those_of_the_kernels(void **unused)
{
    (void)unused;
    const skv_kernel spiky = SKV_KERNEL_SPIKY, smooth = SKV_KERNEL_SMOOTH;
    const struct {
        const char *what;
        skv_kernel kernel;
        integrand *f;
        double stated;
    } integrals[] = {
        {"spiky W", spiky, whole, SKV_PI / SKV_SPIKY_WHOLE},
        {"smooth W", smooth, whole, SKV_PI / SKV_SMOOTH_WHOLE},
        {"q^3", smooth, near_whole, SKV_PI / SKV_NEAR_WHOLE},
        {"spiky r F", spiky, virial, SKV_PI / SKV_SPIKY_VIRIAL},
        {"smooth r F", smooth, virial, SKV_PI / SKV_SMOOTH_VIRIAL},
        {"r q^2", smooth, near_virial, SKV_PI / SKV_NEAR_VIRIAL},
        {"spiky F, half a plane", spiky, flat, 1.0 / skv_kernel_flat(spiky)},
        {"smooth F, half a plane", smooth, flat, 1.0 / skv_kernel_flat(smooth)},
        {"viscosity", spiky, viscous, SKV_PI / SKV_VISCOUS},
        {"springs", spiky, springs, SKV_PI / SKV_SPRINGS},
    };
    for (size_t i = 0; i < sizeof integrals / sizeof *integrals; i++) {
        double found = over_plane(integrals[i].kernel, integrals[i].f);
        if (!(fabs(found / integrals[i].stated - 1) < 5e-5))
            fail_msg("%s: %.7g, stated is %.7g", integrals[i].what, found, integrals[i].stated);
    }
}

/* The force kernels are the density kernels' slopes by the gain. */
static void forces_are_slopes(void **unused)
{
    (void)unused;
    const double small = 1e-6;
    for (double q = 0.05; q < 0.99; q += 0.01) {
        for (int k = SKV_KERNEL_SPIKY; k <= SKV_KERNEL_SMOOTH; k++) {
            skv_kernel kernel = (skv_kernel)k;
            double slope =
                skv_kernel_density(kernel, q + small) - skv_kernel_density(kernel, q - small);
            double force = skv_kernel_gain(kernel) * skv_kernel_force(kernel, q);
            assert_true(fabs(slope / (2 * small) - force) < 1e-8);
        }
        double near_slope = (pow(q + small, 3) - pow(q - small, 3)) / (2 * small);
        assert_true(fabs(near_slope - SKV_NEAR_GAIN * q * q) < 1e-8);
    }
}

static void floats_are_rounded_doubles(void **unused)
{
    (void)unused;
    for (int k = SKV_KERNEL_SPIKY; k <= SKV_KERNEL_SMOOTH; k++) {
        skv_kernel kernel = (skv_kernel)k;
        for (float q = 0; q <= 1; q += 1.0f / 64) {
            assert_true(fabs((double)skv_kernel_densityf(kernel, q) -
                             skv_kernel_density(kernel, (double)q)) < 2e-7);
            assert_true(fabs((double)skv_kernel_forcef(kernel, q) -
                             skv_kernel_force(kernel, (double)q)) < 2e-7);
        }
    }
}

static void rays_sum_up_what_lies_beyond(void **unused)
{
    (void)unused;
    for (int k = SKV_KERNEL_SPIKY; k <= SKV_KERNEL_SMOOTH; k++) {
        skv_kernel kernel = (skv_kernel)k;
        skv_kernel_ray sum = {0};
        const double step = 1.0 / STEPS;
        for (int i = STEPS - 1; i >= 0; i--) {
            double r = (i + 0.5) * step, q = 1 - r;
            sum.density += skv_kernel_density(kernel, q) * r * step;
            sum.near_density += q * q * q * r * step;
            sum.push += skv_kernel_force(kernel, q) * r * step;
            sum.near_push += q * q * r * step;
            skv_kernel_ray stated = skv_kernel_beyond(kernel, i * step);
            assert_true(fabs(sum.density - stated.density) < 1e-6);
            assert_true(fabs(sum.near_density - stated.near_density) < 1e-6);
            assert_true(fabs(sum.push - stated.push) < 1e-6);
            assert_true(fabs(sum.near_push - stated.near_push) < 1e-6);
        }
    }
}

/* The smooth kernel along a line that passes its middle at a distance. */
static double along_line(double distance)
{
    double sum = 0, half = sqrt(1 - distance * distance);
    for (int k = 0; k < STEPS; k++)
        sum += whole(SKV_KERNEL_SMOOTH, distance, half * (k + 0.5) / STEPS);
    return 2 * half / STEPS * sum / (SKV_PI / SKV_SMOOTH_WHOLE);
}

static void shares_beside_a_flat_wall_are_the_kernels(void **unused)
{
    (void)unused;
    double share = 0;
    for (int k = STEPS - 1; k >= 0; k--) {
        double middle = (k + 0.5) / STEPS, line = along_line(middle);
        share += line / STEPS;
        assert_true(fabs(skv_kernel_fall(middle) - line) < 1e-5);
        assert_true(fabs((double)skv_flat_slope((float)middle) - line) < 0.001);
        assert_true(fabs((double)skv_flat_share((float)k / STEPS) - share) < 0.0005);
    }
    for (float beyond = 1; beyond < 1e9f; beyond *= 1000)
        assert_true(skv_flat_share(beyond) == 0 && skv_flat_slope(beyond) == 0 &&
                    skv_kernel_fall((double)beyond) == 0);
}

/* int q (T/r)^2 X/d over the solid. */
static double drag_at(double distance)
{
    double sum = 0, width = 1 - distance;
    for (int i = 0; i < STEPS; i++) {
        for (int k = 0; k < STEPS; k++) {
            double x = distance + width * (i + 0.5) / STEPS, t = (k + 0.5) / STEPS;
            sum += q_at(x, t) * pow(t / hypot(x, t), 2) * x / distance;
        }
    }
    return 2 * sum * width / STEPS / STEPS;
}

static void drag_beside_a_flat_wall_is_a_pairs(void **unused)
{
    (void)unused;
    for (double d = 0.05; d < 1; d += 0.05) {
        double found = drag_at(d), stated = (double)skv_flat_drag(1, (float)d);
        if (!(fabs(stated - found) < (d < 0.501 ? 0.05 * found : 0.001)))
            fail_msg("at %.2f: %.6g, stated is %.6g", d, found, stated);
    }
    assert_true(skv_flat_drag(1, 0) == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrals_are_those_of_the_kernels),
        cmocka_unit_test(forces_are_slopes),
        cmocka_unit_test(floats_are_rounded_doubles),
        cmocka_unit_test(rays_sum_up_what_lies_beyond),
        cmocka_unit_test(shares_beside_a_flat_wall_are_the_kernels),
        cmocka_unit_test(drag_beside_a_flat_wall_is_a_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
