/* A direction for two particles in one place. */
#ifndef SKV_SOLVER_DIRECTION_H
#define SKV_SOLVER_DIRECTION_H

#include <math.h>
#include <stdint.h>

/* Below this share of h two particles coincide and their direction is made up. */
#define SKV_COINCIDENT 1e-6f

/* A direction for coincident particles, hashed from their numbers: antisymmetric, so the pair's
 * momentum is kept, and the same on every machine (erratum of Algorithm 6, r = 0). */
static inline void skv_fallback_direction(uint32_t a, uint32_t b, float *ux, float *uy)
{
    uint32_t low = a < b ? a : b, high = a < b ? b : a;
    uint32_t bits = (low * 0x9e3779b1u) ^ (high * 0x85ebca6bu);
    bits ^= bits >> 15;
    bits *= 0x2c1b3c6du;
    bits ^= bits >> 12;
    float u = (float)(bits & 0xffff) / 32768.0f - 1, v = (float)(bits >> 16) / 32768.0f - 1;
    float length = sqrtf(u * u + v * v);
    if (length < 0.01f) {
        u = 1;
        v = 0;
        length = 1;
    }
    float sign = a < b ? 1.0f : -1.0f;
    *ux = sign * u / length;
    *uy = sign * v / length;
}

#endif
