/* How unlike particles of which the heavier one lies above turn about each other: what is the same
 * in both solvers. The lattice of calm particles bears a shear stress, so light fluid would stay
 * below heavy fluid for ever. What turns changes places after half a turn. Invariant: a pair always
 * turns in one sense, which its two numbers tell; to and fro it would stay where it is. */
#ifndef SKV_SOLVER_TURN_H
#define SKV_SOLVER_TURN_H

#include "base/exact.h"

/* One over the share of the heavier mass by which a pair has to differ for all of its turn. A pair
 * that differs less turns less: by eight times the difference of its weights, with 0.8 of gravity.
 * With twice that 0.95 below 1 goes on stirring itself; equal masses do not turn. */
#define SKV_TURN_CONTRAST 10.0f

/* What a pair at no distance turns with, of gravity: with half fine grains lock, with all coarse
 * ones go on stirring themselves. */
#define SKV_TURN 0.8f

/* 1 or -1, each for half of the pairs, by both numbers. */
static inline float skv_turn_sense(uint32_t a, uint32_t b)
{
    return skv_scatter(a) * skv_scatter(b) < 0 ? -1.0f : 1.0f;
}

#endif
