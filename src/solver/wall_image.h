/* Walls by images: what stands behind a wall for the fluid before it; the same in both solvers. By
 * the parameter fluid.wall_images; docs/walls.md tells what it measures.
 *
 * Fluid before a flat wall moves without friction as if it went on behind it as its mirror image.
 * So every particle beside a wall meets, besides its partners, their images and its own. With
 * distances from the wall D, an image of j is seen from i at the distance r' with
 *
 *     r'^2 = r^2 + 4 Di Dj
 *
 * which asks for no place of the image, is the same from j to i, and holds for any field D. The
 * densities' sums run over partners and images, and all forces are slopes of the same energy: along
 * the wall an image's push is that of a pair, so the fluid there drags no more than inside, and
 * out of the wall it is that push times 2 Dj/r' grad Di.
 *
 * D is smooth: a function of the share of the kernel that lies in the solid, which beside a flat
 * wall is the distance. Where walls are not flat images alone would not make up for the solid; the
 * rest adds a density of its own (terrain/wall_images.c).
 *
 * Lengths here are in smoothing radii. Invariant: where no wall is within h, D is SKV_FAR, and no
 * image is seen from there.
 */
#ifndef SKV_SOLVER_WALL_IMAGE_H
#define SKV_SOLVER_WALL_IMAGE_H

#include "model/kernel.h"

/* D of what is farther than h from any wall: its square does not overflow. */
#define SKV_FAR 1e9f

/* Keeps r' above 0. */
#define SKV_LEAST_IMAGE 1e-6f

/* The gauge takes a fluid beside images for so many times as dense as at rest, at most. */
#define SKV_DENSEST 10.0f

/* D where a particle touches a wall, and where it is free of it: the first layer lies at 0.11, the
 * second at 0.43. */
#define SKV_TOUCH 0.067f
#define SKV_FREE  0.43f

/* How much of the slip beside a wall a substep takes: friction, whole where a particle touches the
 * wall and fading towards the second layer; and viscosity, for a fluid whose pairs have the
 * strength `drag` there. */
static inline float skv_slip_taken(float friction, float drag, float distance)
{
    float touch = (SKV_FREE - distance) / (SKV_FREE - SKV_TOUCH);
    touch = touch < 0 ? 0 : touch < 1 ? touch : 1;
    float taken = friction * (touch * touch);
    if (drag > 0)
        taken += skv_flat_drag(drag, distance);
    return taken < 1 ? taken : 1;
}

#endif
