/* One pair of particles as the gather passes see it. */
#ifndef SKV_SOLVER_PAIR_H
#define SKV_SOLVER_PAIR_H

#include "solver/state.h"

#include <math.h>
#include <stdbool.h>

/* From particle i to particle j: the unit vector and q = 1 - r/h. */
typedef struct skv_pair {
    float ux, uy, q;
} skv_pair;

/* Below this share of h two particles coincide and their direction is made up. */
#define SKV_COINCIDENT 1e-6f

/* A direction for coincident particles, hashed from their numbers: antisymmetric, so the pair's
 * momentum is kept, and the same on every machine (erratum of Algorithm 6, r = 0). */
static inline void skv_made_up_direction(uint32_t a, uint32_t b, float *ux, float *uy)
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

/* Fills `pair` and returns true if j is still within the radius of i: lists are older than the
 * positions (erratum of Algorithm 5). */
static inline bool skv_pair_of(const skv_state *s, const skv_constants *c, int i, int j,
                               skv_pair *pair)
{
    float dx = s->x[j] - s->x[i], dy = s->y[j] - s->y[i];
    float r_squared = dx * dx + dy * dy;
    if (!(r_squared < c->h_squared))
        return false;
    float r = sqrtf(r_squared);
    pair->q = 1 - r * c->inv_h;
    if (r > SKV_COINCIDENT * c->h) {
        float inverse = 1 / r;
        pair->ux = dx * inverse;
        pair->uy = dy * inverse;
    } else {
        skv_made_up_direction(s->id[i], s->id[j], &pair->ux, &pair->uy);
    }
    return true;
}

#endif
