/* One pair of particles as the passes see it: neighbours of each other, and each other's images. */
#ifndef SKV_SOLVER_REFERENCE_PAIR_H
#define SKV_SOLVER_REFERENCE_PAIR_H

#include "solver/direction.h"
#include "solver/reference/reference.h"
#include "solver/wall_image.h"

#include <math.h>

/* From particle i to particle j: the unit vector and q = 1 - r/h. */
typedef struct skv_pair {
    double ux, uy, q;
} skv_pair;

/* A particle's list: its partners are those of the places from the first to before the end. */
static inline int skv_first_partner(const skv_reference *f, int i)
{
    return f->neighbours.start[i];
}

static inline int skv_end_of_partners(const skv_reference *f, int i)
{
    return f->neighbours.start[i + 1];
}

static inline int skv_partner(const skv_reference *f, int place)
{
    return f->neighbours.list[place];
}

/* Fills `pair` and returns true if j is within the radius of i: lists are older than the positions
 * and reach farther (erratum of Algorithm 5). Pairs are taken a little behind these. */
static inline bool skv_pair_of(const skv_reference *f, int i, int j, skv_pair *pair)
{
    const double h = (double)f->constants->h;
    double dx = f->x[j] - f->x[i] - (f->behind_x[j] - f->behind_x[i]);
    double dy = f->y[j] - f->y[i] - (f->behind_y[j] - f->behind_y[i]);
    double r = sqrt(dx * dx + dy * dy);
    if (!(r < h))
        return false;
    if (r > (double)SKV_COINCIDENT * h) {
        *pair = (skv_pair){dx / r, dy / r, 1 - r / h};
        return true;
    }
    float ux, uy;
    skv_fallback_direction(f->id[i], f->id[j], &ux, &uy);
    *pair = (skv_pair){(double)ux, (double)uy, 1 - r / h};
    return true;
}

/* How much more the density of a pair is where its particles are than where it is taken, to first
 * order, per q^2: that of the pair itself or of its images, whose distances to the square change
 * alike. */
static inline double skv_density_ahead(const skv_reference *f, int i, int j, const skv_pair *pair)
{
    double apart =
        (f->behind_x[j] - f->behind_x[i]) * pair->ux + (f->behind_y[j] - f->behind_y[i]) * pair->uy;
    return -SKV_SMOOTH_GAIN * (1 - pair->q) * apart / (double)f->constants->h;
}

/* Whether a particle has an image behind a wall. */
static inline bool skv_has_image(const skv_reference *f, int i)
{
    return f->constants->images && f->image[i] < 1;
}

/* q of the image of j as seen from i, whose pair has q: wall_image.h; 0 if there is none. */
static inline double skv_image_of(const skv_reference *f, int i, int j, double q)
{
    if (!skv_has_image(f, i) || !skv_has_image(f, j))
        return 0;
    double way = sqrt((1 - q) * (1 - q) + 4 * f->image[i] * f->image[j]);
    return way < 1 ? 1 - skv_max(way, (double)SKV_LEAST_IMAGE) : 0;
}

/* The same of its own image. */
static inline double skv_own_image_of(const skv_reference *f, int i)
{
    return skv_has_image(f, i) ? skv_max(1 - 2 * f->image[i], 0) : 0;
}

#endif
