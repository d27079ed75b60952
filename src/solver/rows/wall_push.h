/* How a wall pushes a particle in the relaxation. */
#ifndef SKV_ROWS_WALL_PUSH_H
#define SKV_ROWS_WALL_PUSH_H

#include <stdbool.h>

/* Below this square gravity counts as none, h a substep squared. */
#define SKV_NO_GRAVITY_SQUARED 1e-30f

/* Takes from a wall's pull what would hold a particle up against (gx, gy), the direction in which
 * external forces would have it fall, or drops would hang from ceilings for ever; but for the
 * share `adhesion` of it. (nx, ny) points out of the wall. Leaving out all of the pull heats the
 * fluid where its surface meets a wall, since it has no energy then.
 */
static inline void skv_wall_let_fall(float gx, float gy, float nx, float ny, float adhesion,
                                     float *x, float *y)
{
    float down = *x * gx + *y * gy, square = gx * gx + gy * gy;
    if (*x * nx + *y * ny < 0 && down < 0 && square > SKV_NO_GRAVITY_SQUARED) {
        float share = (1 - adhesion) * (down / square);
        *x -= share * gx;
        *y -= share * gy;
    }
}

/* Writes the wall's part of a displacement, P F1 + N F2: a wall pushes with the particle's own
 * pressure, once; twice, as if it were a mirrored fluid, heats the fluid. Where P is negative it
 * pulls. `loose`: only up to this P is it let fall. */
static inline void skv_wall_push(float lambda, float near_lambda, float f1x, float f1y, float f2x,
                                 float f2y, float gx, float gy, float loose, float *x, float *y)
{
    *x = lambda * f1x + near_lambda * f2x;
    *y = lambda * f1y + near_lambda * f2y;
    if (lambda < loose)
        skv_wall_let_fall(gx, gy, f1x, f1y, 0, x, y);
}

#endif
