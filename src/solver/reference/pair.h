/* One pair of particles as the gather passes see it. */
#ifndef SKV_SOLVER_REFERENCE_PAIR_H
#define SKV_SOLVER_REFERENCE_PAIR_H

#include "model/constants.h"
#include "solver/direction.h"
#include "solver/reference/pass_data.h"
#include "solver/wall_image.h"

#include <math.h>
#include <stdbool.h>

/* From particle i to particle j: the unit vector and q = 1 - r/h. */
typedef struct skv_pair {
    float ux, uy, q;
} skv_pair;

/* Below this share of h two particles coincide and their direction is made up. */
#define SKV_COINCIDENT 1e-6f

/* Fills the pair of two particles (dx, dy) apart; returns false if that is beyond the radius. */
static inline bool skv_pair_apart(const skv_constants *c, float dx, float dy, uint32_t id_i,
                                  uint32_t id_j, skv_pair *pair)
{
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
        skv_fallback_direction(id_i, id_j, &pair->ux, &pair->uy);
    }
    return true;
}

/* Fills `pair` and returns true if j is still within the radius of i: lists are older than the
 * positions (erratum of Algorithm 5). Pairs are taken a little behind these. */
static inline bool skv_pair_of(const skv_pass_data *s, const skv_constants *c, int i, int j,
                               skv_pair *pair)
{
    float dx = s->x[j] - s->x[i] - (s->behind_x[j] - s->behind_x[i]);
    float dy = s->y[j] - s->y[i] - (s->behind_y[j] - s->behind_y[i]);
    return skv_pair_apart(c, dx, dy, s->id[i], s->id[j], pair);
}

/* How much more the density of a pair is where its particles are than where it is taken, to first
 * order, per q^2: that of the pair itself or of its images, whose distances to the square change
 * alike. */
static inline float skv_density_ahead(const skv_pass_data *s, const skv_constants *c, int i, int j,
                                      const skv_pair *pair)
{
    float apart =
        (s->behind_x[j] - s->behind_x[i]) * pair->ux + (s->behind_y[j] - s->behind_y[i]) * pair->uy;
    return -SKV_SMOOTH_GAIN * (1 - pair->q) * (apart * c->inv_h);
}

/* q of the image of j as seen from i, whose pair has q: wall_image.h; 0 if there is none. */
static inline float skv_image_of(const skv_pass_data *s, const skv_constants *c, int i, int j,
                                 float q)
{
    if (!c->images || !(s->image[i] < 1) || !(s->image[j] < 1))
        return 0;
    float way = sqrtf((1 - q) * (1 - q) + 4 * s->image[i] * s->image[j]);
    return way < 1 ? 1 - (way > SKV_LEAST_IMAGE ? way : SKV_LEAST_IMAGE) : 0;
}

/* The same of its own image. */
static inline float skv_own_image_of(const skv_pass_data *s, const skv_constants *c, int i)
{
    float q = c->images ? 1 - 2 * s->image[i] : 0;
    return q > 0 ? q : 0;
}

#endif
