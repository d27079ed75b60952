/* Potential flow through a U-tube: its inertial length.
 *
 * The flow of an ideal liquid has a potential with Laplace's equation, no flow through walls and
 * one value on each free surface. With 1 between the surfaces and Q flowing through, the kinetic
 * energy rho Q / 2 equals rho L w v^2 / 2 for v = Q / w: L = w / Q. By symmetry half of the tube is
 * enough, with half the potential at the middle of the bend. Invariant: the solution is on cells of
 * one size; the error at the two inner corners, of the order 4/3 of the cell, is removed by
 * extrapolation from two sizes.
 */
#include "base/exact.h"
#include "base/memory.h"
#include "experiments/theory.h"

#include <math.h>

/* One half of the tube: the arm's columns of cells, the bend's rows. */
typedef struct half_tube {
    int across;        /* cells across an arm, and across the bend */
    int columns, rows; /* of the whole grid: from the outer wall to the middle, floor to level */
    double *potential;
} half_tube;

static bool is_fluid(const half_tube *t, int column, int row)
{
    return column >= 0 && row >= 0 && column < t->columns && row < t->rows &&
           (column < t->across || row < t->across);
}

/* Adds a neighbour's share to a cell's equation. A cell's own potential stands in for a wall; the
 * surface and the middle lie half a cell away, so they count twice. */
static void add_neighbour(const half_tube *t, int column, int row, double *sum, double *weight)
{
    if (is_fluid(t, column, row)) {
        *sum += t->potential[row * t->columns + column];
        *weight += 1;
    } else if (row == t->rows && column < t->across) {
        *sum += 2; /* the surface: potential 1 */
        *weight += 2;
    } else if (column == t->columns && row < t->across) {
        *weight += 2; /* the middle of the bend: potential 0 */
    }
}

/* One sweep of successive over-relaxation; returns the largest change. */
static double sweep(half_tube *t, double omega)
{
    double most = 0;
    for (int row = 0; row < t->rows; row++) {
        int columns = row < t->across ? t->columns : t->across;
        for (int column = 0; column < columns; column++) {
            double sum = 0, weight = 0;
            add_neighbour(t, column - 1, row, &sum, &weight);
            add_neighbour(t, column + 1, row, &sum, &weight);
            add_neighbour(t, column, row - 1, &sum, &weight);
            add_neighbour(t, column, row + 1, &sum, &weight);
            double *value = &t->potential[row * t->columns + column];
            double change = omega * (sum / weight - *value);
            *value += change;
            most = fmax(most, fabs(change));
        }
    }
    return most;
}

/* So many widths from a corner the flow is straight to 1e-5 (it straightens like exp(-pi x)). */
#define STRAIGHT 4.5

/* The inertial length in arm widths, on a grid of `across` cells an arm; negative without memory.
 */
static double length_on_grid(double gap, double level, int across)
{
    half_tube t = {.across = across};
    t.columns = (int)(fmin((gap + 1) / 2, STRAIGHT) * across + 0.5);
    t.rows = (int)(fmin(level, STRAIGHT) * across + 0.5);
    t.potential = skv_calloc((size_t)t.columns * (size_t)t.rows, sizeof *t.potential);
    if (!t.potential)
        return -1;
    double omega = 2 / (1 + 3.14159265358979 / (t.columns + t.rows));
    for (int i = 0; i < 20000 && sweep(&t, omega) > 1e-10; i++) {
    }
    double flow = 0;
    for (int column = 0; column < across; column++)
        flow += 2 * (1 - t.potential[(t.rows - 1) * t.columns + column]);
    skv_free(t.potential);
    /* What was left out, or taken away or added by rounding to cells, flows straight. */
    double missing = 2 * (level - (double)t.rows / across) + gap + 1 - 2.0 * t.columns / across;
    /* Half a tube with a drop of 1: the whole one has twice the drop. */
    return 2 / flow + missing;
}

double skv_theory_inertial_length(double arm, double gap, double level)
{
    double coarse = length_on_grid(gap / arm, level / arm, 12);
    double fine = length_on_grid(gap / arm, level / arm, 24);
    if (coarse < 0 || fine < 0)
        return 2 * level + gap - arm; /* the centre line's */
    double extrapolation = 1 / (skv_pow(2, 4.0 / 3) - 1);
    return arm * (fine + extrapolation * (fine - coarse));
}
