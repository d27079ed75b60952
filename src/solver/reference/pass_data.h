/* What the passes of a substep read and write: plain arrays, SI units unless it says otherwise.
 *
 * Every pass takes a range [begin, end) of particles and writes only to those particles' own
 * elements of arrays that it does not read from other particles. So passes can run on any number of
 * threads, and the result does not depend on how the range is cut.
 */
#ifndef SKV_SOLVER_REFERENCE_PASS_DATA_H
#define SKV_SOLVER_REFERENCE_PASS_DATA_H

#include <stdint.h>

/* One element per particle. */
typedef struct skv_pass_data {
    int count;

    /* The caller's, see solver.h. */
    float *x, *y;       /* position, m */
    float *vx, *vy;     /* velocity at the start of the substep, m/s */
    float *clearance;   /* lower bound of the distance to the nearest wall, m */
    float *pressure;    /* gauge pressure of the substep, Pa m */
    float *warm_lambda; /* what the pressure term has pushed, m/s^2 */
    const uint32_t *id; /* number at creation; names the direction of coincident pairs */

    /* The solver's own, meaningful within a substep. */
    float *wx, *wy; /* sum of the substep's position corrections, m (docs/model.md, "float32") */
    float *behind_x, *behind_y; /* how far behind the position pairs are taken, m */
    float *dx, *dy; /* what a gather pass has found: a change of velocity or of position */
    float *density, *near_density; /* sum W, sum q^3, walls included; dimensionless */
    float *gradient_x,
        *gradient_y; /* sum F r^, walls included, less what the bulk has; dimensionless */
    float *lambda, *near_lambda;     /* P and N of the pressure law, m */
    float *wall_density, *wall_near; /* R, Rn of the wall maps; dimensionless */
    float *f1x, *f1y, *f2x, *f2y;    /* F1, F2 of the wall maps; dimensionless */
    float *image;                    /* D of images, in h: wall_image.h */
    float *facing_x, *facing_y;      /* its slope: about the unit vector out of the wall */
    float *depth;                    /* to push out of the contact distance, m; 0: no contact */
    float *normal_x, *normal_y;      /* out of the wall; valid where depth > 0 */
} skv_pass_data;

#endif
