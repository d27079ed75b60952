/* Integrates the density kernels W and q^3 and the force kernels F r^ and q^2 r^ over the cells of
 * a grid. Invariant: the kernels have the mirror symmetries of the grid exactly.
 */
#include "terrain/wall_kernel.h"

#include <math.h>
#include <string.h>

/* Sample points a cell side. */
#define SUBSAMPLES 8

static void integrate_cell(skv_kernel pressure, int column, int row, double values[SKV_WALL_MAPS])
{
    const double step = 1.0 / (SKV_WALL_REACH * SUBSAMPLES), area = step * step;
    const double middle = 0.5 * (SUBSAMPLES - 1);
    for (int j = 0; j < SUBSAMPLES; j++) {
        for (int i = 0; i < SUBSAMPLES; i++) {
            double x = (column * SUBSAMPLES + i - middle) * step;
            double y = (row * SUBSAMPLES + j - middle) * step;
            double r = sqrt(x * x + y * y), q = 1 - r;
            if (q <= 0)
                continue;
            double force = skv_kernel_force(pressure, q);
            values[SKV_WALL_R] += skv_kernel_density(pressure, q) * area;
            values[SKV_WALL_RN] += q * q * q * area;
            /* The push points from the solid to the particle. */
            values[SKV_WALL_F1X] -= force * x / r * area;
            values[SKV_WALL_F1Y] -= force * y / r * area;
            values[SKV_WALL_F2X] -= q * q * x / r * area;
            values[SKV_WALL_F2Y] -= q * q * y / r * area;
        }
    }
}

void skv_wall_kernel_make(skv_kernel pressure, double particles_per_square_radius,
                          skv_wall_kernel *kernel)
{
    memset(kernel, 0, sizeof *kernel);
    for (int j = 0; j < SKV_WALL_SPAN; j++) {
        int row = j - SKV_WALL_REACH;
        for (int column = 0; column <= SKV_WALL_REACH; column++) {
            double values[SKV_WALL_MAPS] = {0};
            integrate_cell(pressure, column, row < 0 ? -row : row, values);
            if (row < 0) {
                values[SKV_WALL_F1Y] = -values[SKV_WALL_F1Y];
                values[SKV_WALL_F2Y] = -values[SKV_WALL_F2Y];
            }
            /* Odd parts cancel inside the cell that the point is in the middle of; what rounding
             * leaves of them must not break the symmetry. */
            if (row == 0)
                values[SKV_WALL_F1Y] = values[SKV_WALL_F2Y] = 0;
            if (column == 0)
                values[SKV_WALL_F1X] = values[SKV_WALL_F2X] = 0;
            for (int k = 0; k < SKV_WALL_MAPS; k++)
                kernel->weight[j][column][k] = (float)(particles_per_square_radius * values[k]);
            if (values[SKV_WALL_R] > 0)
                kernel->half_width[j] = column;
        }
        for (int k = 0; k < SKV_WALL_MAPS; k++) {
            if (k == SKV_WALL_F1X || k == SKV_WALL_F2X)
                continue;
            float sum = kernel->weight[j][0][k];
            for (int column = 1; column <= SKV_WALL_REACH; column++)
                sum += 2 * kernel->weight[j][column][k];
            kernel->row_sum[j][k] = sum;
        }
    }
    for (int j = 0; j < SKV_WALL_SPAN; j++) {
        kernel->full[SKV_WALL_R] += kernel->row_sum[j][SKV_WALL_R];
        kernel->full[SKV_WALL_RN] += kernel->row_sum[j][SKV_WALL_RN];
    }
}
