/* What the pair passes do where particles have weights (solver/wall_weight.h). Included by
 * pair_passes.h alone. Invariant: a part of the partners is weighed as a whole, so where nobody has
 * a weight other than 1 the sums are those without weights, to the last bit.
 *
 * These are functions of their own, once for all variants of the loops, and take copies of what the
 * loops hold in registers.
 */
#ifndef SKV_ROW_PAIR_WEIGHTS_H
#define SKV_ROW_PAIR_WEIGHTS_H

#include "solver/rows/tiles.h"
#include "solver/wall_weight.h"

/* Whether one of the partners in a range has a weight other than 1. */
static __attribute__((noinline)) bool has_weight(const float *weight, int begin, int end)
{
    const v8 one = v8_set(1), zero = v8_set(0);
    bool any = false;
    for (int j = begin; j < end && !any; j += ROW_LANES) {
        v8 more = v8_sub(v8_load(weight + j), one);
        any = v8_any_below(zero, v8_mul(more, more));
    }
    return any;
}

/* Whether a tile is to be computed with weights. Farther than two radii from walls neither it nor
 * who feels it has any, but `clearance` is a lower bound only. */
static __attribute__((noinline)) bool is_weighted(const skv_rows *s, int i)
{
    const float *clearance = s->set[s->current].clearance + i;
    bool near = false;
    for (int k = 0; k < TILE; k++)
        near = near || clearance[k] < 1 + ROW_WALL_SLOPE;
    /* The very blocks that the loops compute: the first is there even if it has no partner, and
     * what lies behind the last partner may have come near since the sort. */
    int own_end = s->own_end[i / TILE] > i + 1 ? s->own_end[i / TILE] : i + 2;
    return near && (s->weight[i] != 1 || has_weight(s->weight, i + 1, own_end) ||
                    has_weight(s->weight, s->next_begin[i / TILE], s->next_end[i / TILE]));
}

/* Weighs a tile's kernels W and q^3 with a part of its partners: adds the partners' sums and leaves
 * the tile's own. Once for all variants, and with copies, so that theirs stay in registers. */
static __attribute__((noinline)) void weigh_kernels(const float *weights, int i, int j,
                                                    wide kernel[2][WIDES], float *density,
                                                    float *near_density)
{
    wide partner = wide_each(part_load(weights + j)), own, theirs[2][WIDES];
    EACH(k)
    {
        own = wide_spread(weights + i + k, WIDES);
        theirs[0][k] = wide_mul(own, kernel[0][k]);
        theirs[1][k] = wide_mul(own, kernel[1][k]);
        kernel[0][k] = wide_mul(partner, kernel[0][k]);
        kernel[1][k] = wide_mul(partner, kernel[1][k]);
    }
    add_at(density, over_tile(theirs[0]));
    add_at(near_density, over_tile(theirs[1]));
}

/* skv_bulk_share of as many weights. */
VARIANT wide bulk_share(wide weight)
{
    wide more = wide_mul(wide_set(SKV_BULK_STEEPNESS), wide_sub(weight, wide_set(1)));
    return wide_max(wide_sub(wide_set(1), wide_mul(more, more)), wide_set(0));
}

/* Weighs the pushes of a tile's pairs. */
static __attribute__((noinline)) void weigh_pushes(const float *weights, int i, int j,
                                                   wide size[WIDES])
{
    wide partner = wide_each(part_load(weights + j));
    EACH(k) size[k] = wide_mul(size[k], wide_mul(wide_spread(weights + i + k, WIDES), partner));
}

/* The pairs' part of the swell, see wall_weight.h: the partner's P W + 4 N q^3, weighted. Adds the
 * partners' and leaves the tile's in the place of q. Where the gauge pressure is wanted, particles
 * of the bulk get the virial instead. */
static __attribute__((noinline)) void add_swell(bool gauged, const float *all_pushes,
                                                const float *all_near, const float *weights, int i,
                                                int j, wide q[WIDES], const wide *virial,
                                                float *swell)
{
    const wide three = wide_set(3), four = wide_set(SKV_NEAR_SWELL);
    wide push = wide_each(part_load(all_pushes + j)),
         near_push = wide_each(part_load(all_near + j)), weight = wide_each(part_load(weights + j)),
         other[WIDES];
    EACH(k)
    {
        wide here = wide_spread(weights + i + k, WIDES);
        wide n = wide_mul(wide_mul(q[k], q[k]), q[k]);
        wide w = wide_mul(n, wide_sub(four, wide_mul(three, q[k])));
        n = wide_mul(four, n);
        q[k] = wide_mul(weight, wide_add(wide_mul(push, w), wide_mul(near_push, n)));
        other[k] = wide_mul(here, wide_add(wide_mul(wide_spread(all_pushes + i + k, WIDES), w),
                                           wide_mul(wide_spread(all_near + i + k, WIDES), n)));
        if (gauged) {
            q[k] = wide_add(q[k], wide_mul(bulk_share(here), wide_sub(virial[k], q[k])));
            wide more = wide_mul(bulk_share(weight), wide_sub(virial[k], other[k]));
            other[k] = wide_add(other[k], more);
        }
    }
    add_at(swell, over_tile(other));
}

#endif
