/* What the pair passes do for walls by images (solver/wall_image.h). Included by pair_passes.h
 * alone. Invariant: where no pair of a tile has an image the sums are those without images, to the
 * last bit.
 *
 * These are functions of their own, once for all variants of the loops, and take copies of what the
 * loops hold in registers.
 */
#ifndef SKV_ROW_PAIR_IMAGES_H
#define SKV_ROW_PAIR_IMAGES_H

#include "solver/rows/tiles.h"
#include "solver/wall_image.h"

/* Whether one of the particles in a range is beside a wall. */
static __attribute__((noinline)) bool has_image(const float *image, int begin, int end)
{
    const v8 one = v8_set(1);
    bool any = false;
    for (int j = begin; j < end && !any; j += ROW_LANES)
        any = v8_any_below(v8_load(image + j), one);
    return any;
}

/* Whether a tile's pairs may have images, or with `either` whether one of the partners may have
 * some at all. Farther than two radii from walls nobody has, but `clearance` is a lower bound only.
 */
static __attribute__((noinline)) bool meets_images(const skv_rows *s, int i, bool either)
{
    const float *clearance = s->set[s->current].clearance + i;
    bool near = false, own = false;
    for (int k = 0; k < TILE; k++) {
        near = near || clearance[k] < 1 + ROW_WALL_SLOPE;
        own = own || s->image[i + k] < 1;
    }
    if (!near || (!own && !either))
        return false;
    if (own && either)
        return true;
    /* The very blocks that the loops compute: the first is there even if it has no partner, and
     * what lies behind the last partner may have come near since the sort. */
    int own_end = s->own_end[i / TILE] > i + 1 ? s->own_end[i / TILE] : i + 2;
    return has_image(s->image, i + 1, own_end) ||
           has_image(s->image, s->next_begin[i / TILE], s->next_end[i / TILE]);
}

/* q of the images of a tile's pairs, from their own: r'^2 = r^2 + 4 Di Dj. 0 where there is none.
 */
VARIANT void measure_images(const float *image, int i, int j, const wide *q, wide *seen)
{
    const wide one = wide_set(1), zero = wide_set(0), least = wide_set(SKV_LEAST_IMAGE);
    wide partner = wide_mul(wide_set(4), wide_each(part_load(image + j)));
    EACH(k)
    {
        wide r = wide_sub(one, q[k]), own = wide_spread(image + i + k, WIDES);
        r = wide_sqrt(wide_add(wide_mul(r, r), wide_mul(own, partner)));
        seen[k] = wide_max(wide_sub(one, wide_max(r, least)), zero);
    }
}

/* Adds the images' kernels q^4 and q^3 to those of a tile and a part of its partners. */
static __attribute__((noinline)) void add_image_kernels(const float *image, int i, int j,
                                                        const wide q[WIDES], wide kernel[2][WIDES])
{
    wide seen[WIDES];
    measure_images(image, i, j, q, seen);
    EACH(k)
    {
        wide square = wide_mul(seen[k], seen[k]);
        kernel[0][k] = wide_add(kernel[0][k], wide_mul(square, square));
        kernel[1][k] = wide_add(kernel[1][k], wide_mul(square, seen[k]));
    }
}

/* Whether a particle is farther than h from walls: 1, else 0. */
VARIANT wide is_far(wide image)
{
    return wide_min(wide_max(wide_sub(image, wide_set(1)), wide_set(0)), wide_set(1));
}

/* Adds the images' pushes to those of a tile's pairs, along the wall, and sums up their thrust out
 * of it: the partners' here, the tile's in the place of q. Where the gauge pressure is wanted,
 * particles far from walls get the virial instead. */
static __attribute__((noinline)) void
add_image_pushes(bool gauged, const float *all_pushes, const float *all_near, const float *image,
                 int i, int j, wide q[WIDES], const wide *virial, wide size[WIDES], float *thrust)
{
    const wide one = wide_set(1), two = wide_set(2);
    wide seen[WIDES], other[WIDES];
    measure_images(image, i, j, q, seen);
    wide push = wide_each(part_load(all_pushes + j)),
         near_push = wide_each(part_load(all_near + j)), partner = wide_each(part_load(image + j));
    EACH(k)
    {
        wide own = wide_spread(image + i + k, WIDES);
        wide near = wide_add(wide_spread(all_near + i + k, WIDES), near_push);
        /* For each h of way to the image. */
        wide each = wide_add(wide_spread(all_pushes + i + k, WIDES), push);
        each = wide_add(each, wide_div(near, wide_sub(one, seen[k])));
        each = wide_mul(wide_mul(each, seen[k]), seen[k]);
        size[k] = wide_add(size[k], each);
        q[k] = wide_mul(wide_mul(two, each), partner);
        other[k] = wide_mul(wide_mul(two, each), own);
        if (gauged) {
            q[k] = wide_add(q[k], wide_mul(is_far(own), wide_sub(virial[k], q[k])));
            other[k] = wide_add(other[k], wide_mul(is_far(partner), wide_sub(virial[k], other[k])));
        }
    }
    add_at(thrust, over_tile(other));
}

#endif
