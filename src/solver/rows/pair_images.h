/* What the pair passes do for walls by images (solver/wall_image.h). Included by pair_density.h
 * alone. Invariant: where no pair of a tile has an image the sums are those without images, to the
 * last bit.
 */
#ifndef SKV_ROW_PAIR_IMAGES_H
#define SKV_ROW_PAIR_IMAGES_H

#include "solver/rows/tiles.h"
#include "solver/wall_image.h"

/* Whether a tile's pairs may have images, or with `either` whether one of the partners may have
 * some at all. */
V8_INLINE bool meets_images(const skv_rows *s, int i, bool either)
{
    return s->beside[i / TILE] || (either && any_flag(s, i, s->beside, TILE));
}

/* How near to walls a partner must be for one of a tile's particles to see its image: r'^2 is 4 Di
 * Dj at least. A little more, for what is rounded. */
VARIANT float image_reach(const tile *t)
{
    const float *own = t->images + t->place;
    float least = own[0];
    for (int k = 1; k < TILE; k++)
        least = own[k] < least ? own[k] : least;
    return 0.250001f / (least > SKV_LEAST_IMAGE ? least : SKV_LEAST_IMAGE);
}

/* Whether one of the eight partners at j is as near as that. */
V8_INLINE bool within_reach(const tile *t, int j, float reach)
{
    return v8_any_below(v8_load(t->images + j), v8_set(reach));
}

/* q of the images of a tile's pairs, from their own: r'^2 = r^2 + 4 Di Dj. 0 where there is none.
 */
VARIANT void measure_images(const tile *t, int j, const wide *q, wide *seen)
{
    const float *image = t->images;
    const wide one = wide_set(1), zero = wide_set(0), least = wide_set(SKV_LEAST_IMAGE);
    wide partner = wide_mul(wide_set(4), wide_each(part_load(image + j)));
    EACH(k)
    {
        wide r = wide_sub(one, q[k]), own = wide_spread(image + t->place + k, WIDES);
        r = wide_sqrt(wide_add(wide_mul(r, r), wide_mul(own, partner)));
        seen[k] = wide_max(wide_sub(one, wide_max(r, least)), zero);
    }
}

/* Adds the images' kernels q^4 and q^3 to those of a tile and a part of its partners. r'^2 changes
 * by what r^2 does, so what is `ahead` of a pair is ahead of its images. */
RARE void add_image_kernels(const tile *t, int j, const wide *q, const wide *ahead, wide *quartic,
                            wide *cubic)
{
    wide seen[WIDES], square[WIDES];
    measure_images(t, j, q, seen);
    EACH(k) square[k] = wide_mul(seen[k], seen[k]);
    EACH(k)
    quartic[k] = wide_add(quartic[k], wide_mul(square[k], wide_add(square[k], ahead[k])));
    EACH(k) cubic[k] = wide_add(cubic[k], wide_mul(square[k], seen[k]));
}

/* Whether a particle is farther than h from walls: 1, else 0. */
VARIANT wide is_far(wide image)
{
    return wide_min(wide_max(wide_sub(image, wide_set(1)), wide_set(0)), wide_set(1));
}

/* Adds the images' pushes to those of a tile's pairs, along the wall, and sums up what they push
 * out of it: the partners' here, the tile's in `outward`. Where the gauge pressure is wanted,
 * particles far from walls get the virial instead. */
RARE void add_image_pushes(bool gauged, const pushes *own, wide lambda, wide near_lambda,
                           const tile *t, int j, const wide *q, const wide *virial, wide *size,
                           wide *outward, float *partners_outward)
{
    const wide one = wide_set(1), two = wide_set(2);
    const float *image = t->images, *tile_image = image + t->place;
    wide seen[WIDES], each[WIDES], other[WIDES], partner = wide_each(part_load(image + j));
    measure_images(t, j, q, seen);
    EACH(k) each[k] = wide_add(own->near_lambda[k], near_lambda);
    EACH(k) each[k] = wide_div(each[k], wide_sub(one, seen[k]));
    /* For each h of way to the image. */
    EACH(k) each[k] = wide_add(wide_add(own->lambda[k], lambda), each[k]);
    EACH(k) each[k] = wide_mul(wide_mul(each[k], seen[k]), seen[k]);
    EACH(k) size[k] = wide_add(size[k], each[k]);
    EACH(k) outward[k] = wide_mul(wide_mul(two, each[k]), partner);
    EACH(k) other[k] = wide_mul(wide_mul(two, each[k]), wide_spread(tile_image + k, WIDES));
    if (gauged) {
        EACH(k)
        {
            wide far = is_far(wide_spread(tile_image + k, WIDES)), theirs = is_far(partner);
            outward[k] = wide_add(outward[k], wide_mul(far, wide_sub(virial[k], outward[k])));
            other[k] = wide_add(other[k], wide_mul(theirs, wide_sub(virial[k], other[k])));
        }
    }
    add_at(partners_outward, over_tile(other));
}

#endif
