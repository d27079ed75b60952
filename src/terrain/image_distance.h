/* The image distance: how far a point is from the walls for a mirror, by the share of its kernel
 * that lies in the solid.
 *
 * Particles i and j feel each other's images at r'^2 = r^2 + 4 D_i D_j, in radii. Beside a flat
 * wall D is the distance, and r' the way to the image behind it; elsewhere D is the distance at
 * which a flat wall would take as much of the kernel. For the smooth kernel alone.
 */
#ifndef SKV_TERRAIN_IMAGE_DISTANCE_H
#define SKV_TERRAIN_IMAGE_DISTANCE_H

#include "terrain/wall_kernel.h"

#include <stdbool.h>

enum {
    SKV_IMAGE_CELL = 25, /* steps a cell of the wall maps, ... */
    SKV_IMAGE_RADIUS = SKV_WALL_REACH * SKV_IMAGE_CELL,
    SKV_IMAGE_STEPS = SKV_IMAGE_RADIUS + SKV_IMAGE_CELL /* and as far as their cells' sums reach */
};

/* The share that lies beyond a flat wall, and how fast it falls, by the distance in steps. */
typedef struct skv_image_law {
    double share[SKV_IMAGE_STEPS + 1], fall[SKV_IMAGE_STEPS + 1];
    double near_share, near_slope; /* at the least distance that is taken as it is; -dD/dshare */
} skv_image_law;

/* For shares that are integrals, or with `cells` for sums over the maps' cells, which blur both the
 * kernel and the wall by a cell's width. */
void skv_image_law_make(bool cells, skv_image_law *law);

/* D in radii by the share, and how fast it falls with it: 1 and 0 where the share is 0. Nearer than
 * 0.03 it goes on smoothly and stays above 0, however deep in the solid: particles whose image lay
 * on themselves would feel it without end. */
double skv_image_distance(const skv_image_law *law, double share, double *slope);

/* The share of which that is the distance, 0..1, and how fast it falls with the distance: its
 * inverse, which is more than any share deep in the solid. */
double skv_image_share_at(const skv_image_law *law, double distance, double *fall);

/* The share at a distance from a flat wall, 0..1 radii, and how fast it falls with it. */
double skv_image_share(const skv_image_law *law, double distance, double *fall);

#endif
