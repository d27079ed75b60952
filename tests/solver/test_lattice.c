/* The rest lattice against published sums and against a sum over an enumeration of its own. */
#include "solver/lattice.h"

#include "support/oracle.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void densities_are_the_known_ones(void **unused)
{
    (void)unused;
    const double eta[] = {2.5, 3, 3.5, 4}, density[] = {2.461, 3.852, 5.551, 7.480};
    for (int i = 0; i < 4; i++)
        assert_true(fabs(skv_lattice_sums(SKV_KERNEL_SPIKY, eta[i]).density - density[i]) < 1e-3);
}

static void every_ratio_agrees_with_the_oracle(void **unused)
{
    (void)unused;
    for (double eta = 2; eta <= 4; eta += 0.01) {
        for (int k = SKV_KERNEL_SPIKY; k <= SKV_KERNEL_SMOOTH; k++) {
            double exact = oracle_lattice_density(k == SKV_KERNEL_SPIKY, eta);
            assert_true(fabs(skv_lattice_sums((skv_kernel)k, eta).density - exact) < 1e-9);
        }
    }
}

/* The force kernel is the density kernel's slope by the gain. */
static void kernels_agree(void **unused)
{
    (void)unused;
    for (int k = SKV_KERNEL_SPIKY; k <= SKV_KERNEL_SMOOTH; k++) {
        skv_kernel kernel = (skv_kernel)k;
        for (double q = 0.05; q < 0.99; q += 0.01) {
            double slope =
                (skv_kernel_density(kernel, q + 1e-6) - skv_kernel_density(kernel, q - 1e-6)) /
                2e-6;
            double force = skv_kernel_gain(kernel) * skv_kernel_force(kernel, q);
            assert_true(fabs(slope - force) < 1e-8);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_are_the_known_ones),
        cmocka_unit_test(every_ratio_agrees_with_the_oracle),
        cmocka_unit_test(kernels_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
