/* Walls by weights: what a particle beside a wall stands for; the same in both solvers. On trial,
 * by the parameter fluid.wall_weights; docs/walls.md tells what it measures and what is open.
 *
 * Fluid ends at a wall, so beside it every sum over neighbours lacks what the solid hides. Instead
 * of the solid, which would add its density, the particles there stand for more than one each, for
 * g, so that evenly spread fluid has the same density everywhere. g solves
 *
 *     g (g * W) = 1 over the free space, W normalised
 *
 * and beside a flat wall it is a function of the share of the kernel that lies in the solid, which
 * the wall maps hold. It is part of one energy for fluid and wall, so a layer beside a wall gets
 * all of a pressure's slope along it; with a density that the wall adds it gets the neighbours'
 * part alone, 0.61 in the first layer, and drags behind.
 *
 * Invariant: where no wall is within h, the weight is exactly 1 and its slope 0.
 */
#ifndef SKV_SOLVER_WALL_WEIGHT_H
#define SKV_SOLVER_WALL_WEIGHT_H

#include "terrain/boundary.h"

/* gain/3 of the calibrated law: what the near density counts in a swell, where the density is 1. */
#define SKV_NEAR_SWELL 4

/* The solid's share a fifth of a spacing from a flat wall, with h = 3 s. */
#define SKV_TOUCH_SHARE 0.42f

typedef struct skv_wall_weight {
    float weight; /* g, 0.98 or more */
    float slope;  /* -(h/gain) grad g is slope F1 */
} skv_wall_weight;

/* The share of the kernel that lies in the solid, 0..1, by R of the wall maps. */
static inline float skv_solid_share(const skv_boundary *boundary, float r)
{
    return r / boundary->walls->kernel.full[SKV_WALL_R];
}

/* A fit, within 0.6 % of the fixed point beside a flat wall; in the corner of two, where the share
 * is 3/4, it is 2.55. tests/solver/test_weights.c solves the fixed point. */
static inline skv_wall_weight skv_weigh(const skv_boundary *boundary, const skv_wall_sample *wall)
{
    const float a = 0.395f, b = 1.1235f, c = 1.529f, dip = 0.02819f, width = 0.004f;
    float share = skv_solid_share(boundary, wall->r), rest = 1 / (share + width);
    float slope = a + share * (2 * b + 3 * c * share) - dip * width * (rest * rest);
    return (skv_wall_weight){1 + share * (a + share * (b + c * share) - dip * rest),
                             slope / boundary->walls->kernel.full[SKV_WALL_R]};
}

/* What a wall does to a particle whose energy changes with its weight: `swell` is what pushes it
 * towards a smaller one, times h/gain. Where its pressure is negative it would be drawn to the
 * wall; of that only the share `adhesion` acts. */
static inline float skv_wall_share(float swell, float slope, float adhesion)
{
    return slope * (swell < 0 ? adhesion * swell : swell);
}

/* How much of a particle's gauge pressure is the virial of its pairs: all in the bulk, where its
 * weight is exactly 1, and nothing beside a wall. There pairs are missing, and the pressure follows
 * from the swell. The factor makes any other weight one of a wall. */
#define SKV_BULK_STEEPNESS 1e15f
static inline float skv_bulk_share(float weight)
{
    float more = SKV_BULK_STEEPNESS * (weight - 1), share = 1 - more * more;
    return share > 0 ? share : 0;
}

/* How much of the slip beside a wall a substep takes: friction, whole where a particle touches the
 * wall and fading towards the second layer; and viscosity, for a fluid whose pairs have the
 * strength `drag` there. The solid's part of the pairs, which rest and mirror the slip: beside a
 * flat wall int q (T/r)^2 X/d over the solid, T along it, X across it and d the distance, is within
 * 4 % share (0.5 - 0.4 share) / (1 - 2 share). */
static inline float skv_wall_grip(float friction, float drag, float share)
{
    float touch = share < SKV_TOUCH_SHARE ? share / SKV_TOUCH_SHARE : 1;
    float grip = friction * (touch * touch);
    if (drag > 0)
        grip += share < 0.49f ? drag * share * (0.5f - 0.4f * share) / (1 - 2 * share) : 1;
    return grip < 1 ? grip : 1;
}

#endif
