/* The rest lattice against published sums and against a sum over an enumeration of its own. */
#include "model/lattice.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_are_the_known_ones),
        cmocka_unit_test(every_ratio_agrees_with_the_oracle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
