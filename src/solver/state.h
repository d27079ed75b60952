/* What the passes of a substep read and write: plain arrays and constants.
 *
 * Every pass takes a range [begin, end) of particles and writes only to those particles' own
 * elements of arrays that it does not read from other particles. So passes can run on any number of
 * threads, and the result does not depend on how the range is cut.
 */
#ifndef SKV_SOLVER_STATE_H
#define SKV_SOLVER_STATE_H

#include "base/kernels.h"

#include <stdint.h>

/* One element per particle. SI units unless it says otherwise. */
typedef struct skv_state {
    int count;
    float *x, *y;   /* position, m */
    float *vx, *vy; /* velocity at the start of the substep, m/s */
    float *wx, *wy; /* sum of the substep's position corrections, m (docs/model.md, "float32") */
    float *dx, *dy; /* what a gather pass has found: a change of velocity or of position */

    float *density, *near_density; /* sum W, sum q^3, walls included; dimensionless */
    float *gradient_x,
        *gradient_y;         /* sum F r^, walls included, less what the bulk has; dimensionless */
    float *push, *near_push; /* P and N of the pressure law, m */
    float *pressure;         /* gauge pressure of the substep, Pa m */

    float *wall_density, *wall_near; /* R, Rn of the wall maps; dimensionless */
    float *f1x, *f1y, *f2x, *f2y;    /* F1, F2 of the wall maps; dimensionless */
    float *clearance;                /* lower bound of the distance to the nearest wall, m */
    float *depth;                    /* to push out of the contact distance, m; 0: no contact */
    float *normal_x, *normal_y;      /* out of the wall; valid where depth > 0 */

    uint32_t *id; /* number at creation; names the direction of coincident pairs */
} skv_state;

/* Constants of a substep. Lengths in m, times in s. */
typedef struct skv_constants {
    float h, inv_h, h_squared;
    float dt, inv_dt;
    float max_speed; /* clamp at the advance, m/s */

    float viscosity_linear, viscosity_quadratic; /* sigma 1/s, beta 1/m */

    /* Pressure laws. Densities are dimensionless. */
    skv_kernel kernel;     /* of the density; the near density has its own */
    float rest_density;    /* rho0 */
    float push_scale;      /* calibrated: omega h/gain; clavet: dt^2 k/2; m */
    float near_push_scale; /* the same for the near density; m */
    float push_limit;      /* clavet: bound of rho N, m */
    float wall_virial;     /* distance times push of a smooth solid, per h R */
    /* Calibrated law alone. */
    float response_slope; /* how strongly the density answers to a push, per density, ... */
    float response_floor; /* ... and at least */
    float near_share;     /* near density per density in the lattice at rest: more is a crowd */
    float cohesion_scale; /* cohesion per missing density, m */
    float cohesion_below; /* density from which on none is missing */
    float cohesion_from;  /* density up to which there is no cohesion ... */
    float cohesion_slope; /* ... and how steeply its share grows to 1 from there */
    float tension_scale;  /* of the surface tension, m */
    float tension_from;   /* gradient up to which there is none */

    float pressure_scale; /* gauge: Pa m per m^2 of virial (sum of distance times displacement) */

    float contact_distance; /* m */
    float softness;         /* share of the penetration corrected a substep */
    float friction;         /* share of the tangential displacement removed a substep */
} skv_constants;

#endif
