/* Lattice sums in double precision. Invariant: only +, -, *, / and sqrt, so every machine computes
 * the same rest density. */
#include "model/lattice.h"

#include <math.h>

skv_lattice skv_lattice_sums(skv_kernel kernel, double eta)
{
    /* A hexagonal cell of side a has the area a^2 sqrt(3)/2 = s^2; in units of h, s = 1/eta. */
    double a = sqrt(2 / sqrt(3.0)) / eta;
    int reach = (int)(eta * 1.5) + 2;
    skv_lattice sums = {0};
    for (int row = -reach; row <= reach; row++) {
        for (int column = -2 * reach; column <= 2 * reach; column++) {
            double x = a * (column + 0.5 * row), y = a * row * sqrt(3.0) / 2;
            double r = sqrt(x * x + y * y);
            if (r >= 1 || (row == 0 && column == 0))
                continue;
            double q = 1 - r, force = skv_kernel_force(kernel, q);
            sums.density += skv_kernel_density(kernel, q);
            sums.response += force * force;
            sums.near_density += q * q * q;
            sums.virial += r * force;
            sums.near_virial += r * q * q;
        }
    }
    return sums;
}
