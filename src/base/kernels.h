/* The smoothing kernels by q = 1 - r/h. A density sums up W; a push along a pair is F, and
 * dW/dr = -gain F/h. Near density and near push, q^3 and q^2, are the same for all laws. */
#ifndef SKV_BASE_KERNELS_H
#define SKV_BASE_KERNELS_H

/* Spiky: W = q^2, F = q; the thesis' and Clavet's. Smooth: W = q^3 (4 - 3q) = q^3 (1 + 3 r/h), F =
 * (r/h) q^2: Wendland's C2 for one dimension. It hardly feels where its neighbours are as long as
 * they are equally many, so calm particles slide past each other (docs/model.md, "The lattice"). */
typedef enum skv_kernel { SKV_KERNEL_SPIKY, SKV_KERNEL_SMOOTH } skv_kernel;

static inline double skv_kernel_density(skv_kernel kernel, double q)
{
    return kernel == SKV_KERNEL_SMOOTH ? q * q * q * (4 - 3 * q) : q * q;
}

static inline double skv_kernel_force(skv_kernel kernel, double q)
{
    return kernel == SKV_KERNEL_SMOOTH ? (1 - q) * q * q : q;
}

static inline double skv_kernel_gain(skv_kernel kernel)
{
    return kernel == SKV_KERNEL_SMOOTH ? 12 : 2;
}

#endif
