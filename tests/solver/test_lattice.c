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
    const double swelling[] = {0.454, 0.802, 1.182, 1.656};
    for (int i = 0; i < 4; i++) {
        skv_lattice sums = skv_lattice_sums(eta[i]);
        assert_true(fabs(sums.density - density[i]) < 1e-3);
        assert_true(fabs(sums.near_density * sums.near_virial / sums.virial - swelling[i]) < 1e-3);
    }
}

static void every_ratio_agrees_with_the_oracle(void **unused)
{
    (void)unused;
    for (double eta = 2; eta <= 4; eta += 0.01)
        assert_true(fabs(skv_lattice_sums(eta).density - oracle_lattice_density(eta)) < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(densities_are_the_known_ones),
        cmocka_unit_test(every_ratio_agrees_with_the_oracle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
