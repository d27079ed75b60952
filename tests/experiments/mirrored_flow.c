/* Boundary elements for Laplace's equation between mirrors.
 *
 * Green's third identity holds on the surface alone, for walls and floor are mirrors: with its
 * images the surface is closed. A tank has endlessly many; but z -> -cos(pi z) makes its walls and
 * its floor one straight mirror, and keeps potentials and what flows through an element. Elements
 * are straight, the potential is linear on each, the speed through it one number, and the identity
 * is asked of their middles, where no corner disturbs it. Invariant: all integrals are exact, also
 * where surface and image nearly touch.
 */
#include "mirrored_flow.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
/* Logarithms are of lengths in these, larger than any liquid here: with 1 as the unit a liquid of
 * one certain size would have no solution. */
#define FAR 50.0

/* What one element means to a point: integrals of ln r, and of its slope along the normal. */
typedef struct influence {
    double single, first,
        second; /* `first` and `second` for potential 1 at one end, 0 at the other */
} influence;

static influence influence_of(double x1, double y1, double x2, double y2, double px, double py)
{
    double dx = x2 - x1, dy = y2 - y1, length = sqrt(dx * dx + dy * dy);
    double tx = dx / length, ty = dy / length;
    double rx = x1 - px, ry = y1 - py;
    double along = rx * tx + ry * ty, across = ry * tx - rx * ty, end = along + length;
    double log1 = 0.5 * log((along * along + across * across) / (FAR * FAR));
    double log2 = 0.5 * log((end * end + across * across) / (FAR * FAR));
    double angle = atan2(across * length, along * end + across * across);
    double moment = (across * (log2 - log1) - along * angle) / length;
    return (influence){end * log2 - along * log1 - length + across * angle, angle - moment, moment};
}

/* Adds those of an element and its images, for the middle of an element. There are two images, by
 * the floor y = 0, or four, by the wall x = 0 as well. */
static influence influence_with_images(const double *x, const double *y, int images, int element,
                                       double px, double py, bool own)
{
    influence sum = {0, 0, 0};
    for (int image = 0; image < images; image++) {
        /* The image of the point stands for that of the element. */
        influence i = influence_of(x[element], y[element], x[element + 1], y[element + 1],
                                   image & 2 ? -px : px, image & 1 ? -py : py);
        sum.single += i.single;
        if (own && image == 0)
            continue; /* a straight element does not turn past its own middle */
        sum.first += i.first;
        sum.second += i.second;
    }
    return sum;
}

/* Solves in place by elimination with row exchange; false if a pivot vanishes. */
static bool solve(int n, double *matrix, double *value)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(matrix[i * n + k]) > fabs(matrix[best * n + k]))
                best = i;
        if (!(fabs(matrix[best * n + k]) > 0))
            return false;
        for (int j = k; j < n && best != k; j++) {
            double kept = matrix[k * n + j];
            matrix[k * n + j] = matrix[best * n + j];
            matrix[best * n + j] = kept;
        }
        double kept = value[k];
        value[k] = value[best];
        value[best] = kept;
        for (int i = k + 1; i < n; i++) {
            double share = matrix[i * n + k] / matrix[k * n + k];
            for (int j = k + 1; j < n; j++)
                matrix[i * n + j] -= share * matrix[k * n + j];
            value[i] -= share * value[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            value[k] -= matrix[k * n + j] * value[j];
        value[k] /= matrix[k * n + k];
    }
    return true;
}

static bool flow(int count, const double *x, const double *y, int images, const double *potential,
                 double *through)
{
    int n = count - 1;
    double *matrix = malloc((size_t)n * (size_t)n * sizeof *matrix);
    if (!matrix)
        return false;
    for (int i = 0; i < n; i++) {
        double px = (x[i] + x[i + 1]) / 2, py = (y[i] + y[i + 1]) / 2;
        through[i] = -PI * (potential[i] + potential[i + 1]) / 2;
        for (int j = 0; j < n; j++) {
            influence at = influence_with_images(x, y, images, j, px, py, i == j);
            matrix[i * n + j] = at.single;
            through[i] += at.first * potential[j] + at.second * potential[j + 1];
        }
    }
    bool solved = solve(n, matrix, through);
    free(matrix);
    return solved;
}

bool quarter_flow(int count, const double *x, const double *y, const double *potential,
                  double *through)
{
    return flow(count, x, y, 4, potential, through);
}

bool tank_flow(int count, const double *x, const double *y, const double *potential,
               double *through)
{
    double *across = malloc(2 * (size_t)count * sizeof *across);
    if (!across)
        return false;
    double *up = across + count;
    double scale = 1 / cosh(PI * y[0]); /* so that a deep tank is not FAR */
    for (int i = 0; i < count; i++) {
        across[i] = -scale * cos(PI * x[i]) * cosh(PI * y[i]);
        up[i] = scale * sin(PI * x[i]) * sinh(PI * y[i]);
    }
    up[0] = up[count - 1] = 0;
    bool solved = flow(count, across, up, 2, potential, through);
    for (int i = 0; i + 1 < count; i++)
        through[i] *= hypot(across[i + 1] - across[i], up[i + 1] - up[i]) /
                      hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
    free(across);
    return solved;
}
