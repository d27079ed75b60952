/* What walls do to the fluid, added up: changes of the particles' displacement, times their mass
 * over the first fluid's, and their moments about the origin.
 *
 * In fixed point, for integers have the same sum in every order: threads add up what they come
 * upon, and the result does not depend on how many they are.
 */
#ifndef SKV_SOLVER_IMPULSE_H
#define SKV_SOLVER_IMPULSE_H

#include <stdint.h>

/* In smoothing radii, and in their squares. */
typedef struct skv_impulse {
    double x, y, moment;
} skv_impulse;

/* The same as whole multiples of the steps below; unsigned, so that they wrap around. */
typedef struct skv_impulse_sum {
    uint64_t x, y, moment;
} skv_impulse_sum;

/* Steps a unit. A sum may reach 1e8 radii, a moment 3e10 square radii: more than a million
 * particles give in a step. */
#define SKV_IMPULSE_STEPS 68719476736.0 /* 2^36 */
#define SKV_MOMENT_STEPS  268435456.0   /* 2^28 */

/* Written so that a NaN becomes 0. */
static inline uint64_t skv_fixed(double steps)
{
    return steps > -4e18 && steps < 4e18 ? (uint64_t)(int64_t)steps : 0;
}

static inline void skv_impulse_add(skv_impulse_sum *sum, double x, double y, double moment)
{
    sum->x += skv_fixed(x * SKV_IMPULSE_STEPS);
    sum->y += skv_fixed(y * SKV_IMPULSE_STEPS);
    sum->moment += skv_fixed(moment * SKV_MOMENT_STEPS);
}

/* Adds what a particle at (x, y) is given. */
static inline void skv_impulse_give(skv_impulse_sum *sum, float x, float y, float dx, float dy)
{
    skv_impulse_add(sum, (double)dx, (double)dy, (double)x * (double)dy - (double)y * (double)dx);
}

static inline void skv_impulse_join(skv_impulse_sum *sum, const skv_impulse_sum *other)
{
    sum->x += other->x;
    sum->y += other->y;
    sum->moment += other->moment;
}

static inline skv_impulse skv_impulse_value(const skv_impulse_sum *sum)
{
    return (skv_impulse){(double)(int64_t)sum->x / SKV_IMPULSE_STEPS,
                         (double)(int64_t)sum->y / SKV_IMPULSE_STEPS,
                         (double)(int64_t)sum->moment / SKV_MOMENT_STEPS};
}

#endif
