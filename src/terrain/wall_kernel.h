/* Cell-integrated kernels of the wall density maps, in units of the smoothing radius. */
#ifndef SKV_TERRAIN_WALL_KERNEL_H
#define SKV_TERRAIN_WALL_KERNEL_H

#include "model/kernel.h"

/* Map cells a smoothing radius. Ten is enough: finer buys nothing, below seven it shows. */
#define SKV_WALL_REACH 10
#define SKV_WALL_SPAN  (2 * SKV_WALL_REACH + 1)

/* The six maps, in the order of skv_wall_sample. */
enum {
    SKV_WALL_R,
    SKV_WALL_RN,
    SKV_WALL_F1X,
    SKV_WALL_F1Y,
    SKV_WALL_F2X,
    SKV_WALL_F2Y,
    SKV_WALL_MAPS
};

/* What a solid cell contributes to a point in the middle of another cell that lies `x` columns to
 * its left and `row - REACH` rows below it. The mirrored half, negative x, has the same values but
 * for the sign of F1X and F2X, which are odd. */
typedef struct skv_wall_kernel {
    float weight[SKV_WALL_SPAN][SKV_WALL_REACH + 1][SKV_WALL_MAPS];
    float row_sum[SKV_WALL_SPAN][SKV_WALL_MAPS]; /* over a whole row of solid cells */
    float full[SKV_WALL_MAPS];                   /* deep inside solid */
    int half_width[SKV_WALL_SPAN];               /* the largest x with a weight */
} skv_wall_kernel;

/* Fills the table for n0 h^2 = (h / s)^2 and the kernel of the pressure. */
void skv_wall_kernel_make(skv_kernel pressure, double particles_per_square_radius,
                          skv_wall_kernel *kernel);

#endif
