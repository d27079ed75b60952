/* The smoothing kernels and all that is integrated over them, in the fluid's one home for both.
 *
 * Lengths are in smoothing radii h, and q = 1 - r. A density sums up W; a push along a pair is F,
 * and dW/dr = -gain F. The near density q^3 and the near push q^2 are the same for all laws.
 *
 * Integrals run over the plane around a particle; n0 h^2 = (h/s)^2 of them are what the sums over a
 * uniform fluid with one particle in each spacing s squared would be. Invariant:
 * tests/model/test_kernel.c integrates each of them numerically.
 */
#ifndef SKV_MODEL_KERNEL_H
#define SKV_MODEL_KERNEL_H

#include "base/exact.h"

/* Spiky: W = q^2, F = q; the thesis' and Clavet's. Smooth: W = q^3 (4 - 3q) = q^3 (1 + 3 r), F =
 * r q^2: Wendland's C2 for one dimension. It hardly feels where its neighbours are as long as they
 * are equally many, so calm particles slide past each other (docs/model.md, "The lattice"). */
typedef enum skv_kernel { SKV_KERNEL_SPIKY, SKV_KERNEL_SMOOTH } skv_kernel;

enum {
    /* Smooth: W = 4 q^3 - 3 q^4. */
    SKV_SMOOTH_CUBES = 4,
    SKV_SMOOTH_QUARTICS = 3,

    /* How steeply densities fall: dW/dr = -gain F, d(q^3)/dr = -gain q^2. */
    SKV_SPIKY_GAIN = 2,
    SKV_SMOOTH_GAIN = 12,
    SKV_NEAR_GAIN = 3,
    /* How much of the push P a near push N weighs, for the density to answer alike. */
    SKV_NEAR_WEIGHT = SKV_SMOOTH_GAIN / SKV_NEAR_GAIN,

    /* Pi over them are int W and int q^3, ... */
    SKV_SPIKY_WHOLE = 6,
    SKV_SMOOTH_WHOLE = 5,
    SKV_NEAR_WHOLE = 10,
    /* ... and the virials int r F and int r q^2: by parts, 2/gain of those. */
    SKV_SPIKY_VIRIAL = SKV_SPIKY_WHOLE * SKV_SPIKY_GAIN / 2,
    SKV_SMOOTH_VIRIAL = SKV_SMOOTH_WHOLE * SKV_SMOOTH_GAIN / 2,
    SKV_NEAR_VIRIAL = SKV_NEAR_WHOLE * SKV_NEAR_GAIN / 2,

    /* 1 over them is int F x/r over a half plane with the particle on its edge, x across it. */
    SKV_SPIKY_FLAT = 3,
    SKV_SMOOTH_FLAT = 15,

    /* Pi over it is 1/4 int q x^2 y^2/r^2 over where x y < 0: the viscosity of pairs that approach
     * each other in a shear flow, per sigma n0 h^4. */
    SKV_VISCOUS = 640,
    /* Pi over it is 1/4 int q x^2 y^2/r^2: the shear modulus of pairs that push each other by k q/2
     * of what they are shortened by, per density and k n0 h^4. */
    SKV_SPRINGS = 320
};

static inline double skv_kernel_density(skv_kernel kernel, double q)
{
    return kernel == SKV_KERNEL_SMOOTH ? q * q * q * (SKV_SMOOTH_CUBES - SKV_SMOOTH_QUARTICS * q)
                                       : q * q;
}

static inline double skv_kernel_force(skv_kernel kernel, double q)
{
    return kernel == SKV_KERNEL_SMOOTH ? (1 - q) * q * q : q;
}

/* The same, as solvers round them. */
static inline float skv_kernel_densityf(skv_kernel kernel, float q)
{
    return kernel == SKV_KERNEL_SMOOTH ? q * q * q * (SKV_SMOOTH_CUBES - SKV_SMOOTH_QUARTICS * q)
                                       : q * q;
}

static inline float skv_kernel_forcef(skv_kernel kernel, float q)
{
    return kernel == SKV_KERNEL_SMOOTH ? (1 - q) * (q * q) : q;
}

static inline int skv_kernel_gain(skv_kernel kernel)
{
    return kernel == SKV_KERNEL_SMOOTH ? SKV_SMOOTH_GAIN : SKV_SPIKY_GAIN;
}

static inline int skv_kernel_flat(skv_kernel kernel)
{
    return kernel == SKV_KERNEL_SMOOTH ? SKV_SMOOTH_FLAT : SKV_SPIKY_FLAT;
}

/* What lies beyond a distance in one direction: integrals of a kernel times r dr from there to 1.
 */
typedef struct skv_kernel_ray {
    double density, near_density; /* of W and q^3 */
    double push, near_push;       /* of F and q^2 */
} skv_kernel_ray;

/* For a distance of up to 1. */
static inline skv_kernel_ray skv_kernel_beyond(skv_kernel kernel, double distance)
{
    double q = 1 - distance, q2 = q * q, q3 = q2 * q, q4 = q2 * q2, q5 = q4 * q;
    double square = q3 / 3 - q4 / 4;
    skv_kernel_ray ray = {square, q4 / 4 - q5 / 5, q2 / 2 - q3 / 3, square};
    if (kernel == SKV_KERNEL_SMOOTH) {
        ray.density = q4 - 1.4 * q5 + q3 * q3 / 2;
        ray.push = q3 / 3 - q4 / 2 + q5 / 5;
    }
    return ray;
}

/* The share of the smooth kernel's W on a straight line at a distance: so steeply the share beyond
 * a flat wall falls. */
double skv_kernel_fall(double distance);

/* The share of the smooth kernel in the solid at a distance from a flat wall; within 0.0005. */
static inline float skv_flat_share(float distance)
{
    float left = distance < 1 ? 1 - distance : 0;
    return left * left * left * (0.50011f + distance * (0.23053f - 0.92175f * distance));
}

/* How steeply it falls, skv_kernel_fall; within 0.001. */
static inline float skv_flat_slope(float distance)
{
    float left = distance < 1 ? 1 - distance : 0;
    float bend = 3.79846f + distance * (1.25245f - 4.08331f * distance);
    return left * left * left * (1.27397f + distance * bend);
}

/* How much of the slip beside a flat wall viscosity takes, for pairs of the strength `drag` with a
 * solid that rests and mirrors the slip: int q (T/r)^2 X/d over the solid, T along it, X across it
 * and d the distance; within 5 % up to half a radius, where it is 0.025, and within 0.001 beyond.
 * At most 1. */
static inline float skv_flat_drag(float drag, float distance)
{
    float share = skv_flat_share(distance);
    return share < 0.49f ? drag * share * (0.5f - 0.4f * share) / (1 - 2 * share) : 1;
}

#endif
