/* The displacement, pass B of the rows. Included by kernels.c alone. Invariant: of a tile's pairs
 * it computes the same blocks as the density, so that it finds the q that this has kept.
 */
#ifndef SKV_ROW_PAIR_DISPLACEMENT_H
#define SKV_ROW_PAIR_DISPLACEMENT_H

#include "solver/rows/pair_density.h"

/* Keeps the sum of two drags above 0. */
#define LEAST_DRAG 1e-30f

/* What the displacement reads of the partners. */
typedef struct partners {
    const float *lambda, *near_lambda, *gradient_x, *gradient_y;
    float scale;       /* of tension */
    float sigma, beta; /* of viscosity */
} partners;

/* The tension of a pair: e being the difference of the gradients, d that of the places, q^2 e less
 * 2 (q/r)(e d) d. Leaves the first part in ex, ey and the factor of d in `along`. */
VARIANT void tension(const partners *others, int j, const pushes *t, const wide *dx, const wide *dy,
                     const wide *q2, const wide *ratio, wide *ex, wide *ey, wide *along)
{
    const wide scale = wide_set(others->scale), twice = wide_set(2 * others->scale);
    wide gx = wide_each(part_load(others->gradient_x + j)),
         gy = wide_each(part_load(others->gradient_y + j));
    EACH(k) ex[k] = wide_sub(t->gradient_x[k], gx);
    EACH(k) ey[k] = wide_sub(t->gradient_y[k], gy);
    EACH(k) along[k] = wide_add(wide_mul(ex[k], dx[k]), wide_mul(ey[k], dy[k]));
    EACH(k) along[k] = wide_mul(wide_mul(twice, ratio[k]), along[k]);
    EACH(k) ex[k] = wide_mul(ex[k], wide_mul(scale, q2[k]));
    EACH(k) ey[k] = wide_mul(ey[k], wide_mul(scale, q2[k]));
}

/* The share of their approach that viscosity takes of a tile's pairs with eight partners from j on,
 * of particles with masses; `share` comes as the quadratic part. Drags count in their harmonic
 * mean, 0 if one is 0 and exactly what both are if they are alike; the rest, and the bound of both,
 * by the lighter one's mass. Rare, so once for all. */
static __attribute__((noinline)) void share_of_masses(const skv_row_particles *p, int own, int j,
                                                      wide share[WIDES])
{
    const wide bound = wide_set(SKV_MOST_VISCOUS), least = wide_set(LEAST_DRAG);
    wide their_drag = wide_each(part_load(p->drag + j)),
         their_lightness = wide_each(part_load(p->lightness + j));
    for (int k = 0; k < WIDES; k++) {
        wide drag = wide_spread(p->drag + own + k, WIDES);
        wide low = wide_min(drag, their_drag), high = wide_max(drag, their_drag);
        wide mean = wide_div(wide_add(high, high), wide_max(wide_add(high, low), least));
        wide lighter = wide_max(wide_spread(p->lightness + own + k, WIDES), their_lightness);
        wide linear = wide_mul(wide_mul(low, mean), lighter);
        share[k] = wide_div(wide_min(wide_add(linear, share[k]), bound), lighter);
    }
}

/* Adds the impulse of pairs that approach each other to their displacement, which is dx, dy times
 * size: from i to j, in displacement units, with masses times that of the first fluid. */
VARIANT void viscosity(const skv_row_particles *p, const partners *others, int own, int j,
                       unsigned with, const pushes *t, const wide *dx, const wide *dy,
                       const wide *inverse, const wide *q, wide *size)
{
    const wide zero = wide_set(0), half = wide_set(0.5f), most = wide_set(SKV_MOST_VISCOUS);
    wide uj = wide_each(part_load(p->u + j)), vj = wide_each(part_load(p->v + j));
    wide sigma = wide_set(others->sigma), beta = wide_set(others->beta);
    wide w[WIDES], share[WIDES];
    EACH(k)
    w[k] = wide_add(wide_mul(wide_sub(t->u[k], uj), dx[k]), wide_mul(wide_sub(t->v[k], vj), dy[k]));
    EACH(k) w[k] = wide_mul(wide_max(w[k], zero), inverse[k]);
    EACH(k) share[k] = wide_mul(beta, w[k]);
    if (with & WITH_MASSES)
        share_of_masses(p, own, j, share);
    else
        EACH(k) share[k] = wide_min(wide_add(sigma, share[k]), most);
    EACH(k) share[k] = wide_mul(q[k], share[k]);
    EACH(k) w[k] = wide_mul(wide_mul(half, share[k]), wide_mul(w[k], inverse[k]));
    EACH(k) size[k] = wide_add(size[k], w[k]);
}

/* Pass B for a tile and a part of eight partners, some of which have images. Where q is kept, r is
 * 1 - q. */
VARIANT void displacement_part(const skv_row_particles *p, const partners *others, int j,
                               bool first, unsigned with, bool imaged, const tile *t,
                               const pushes *pressed, move_sums *sums, const skv_row_moves *to,
                               const float *keep)
{
    const wide one = wide_set(1);
    wide dx[WIDES], dy[WIDES], r[WIDES], q[WIDES], inverse[WIDES], ratio[WIDES], size[WIDES];
    if (with & KEEP_PAIRS) {
        wide xj = wide_each(part_load(p->x + j)), yj = wide_each(part_load(p->y + j));
        EACH(k) dx[k] = wide_sub(xj, t->x[k]);
        EACH(k) dy[k] = wide_sub(yj, t->y[k]);
        EACH(k) q[k] = wide_load(keep + WIDE_LEN * k);
    } else {
        measure(p, j, first, t, dx, dy, r, q);
    }
    EACH(k) r[k] = wide_sub(one, q[k]);
    /* The one division of a pair, for everything. */
    EACH(k) inverse[k] = wide_div(one, r[k]);
    EACH(k) ratio[k] = wide_mul(q[k], inverse[k]);
    wide lambda = wide_each(part_load(others->lambda + j)),
         near_lambda = wide_each(part_load(others->near_lambda + j));
    wide q2[WIDES], ex[WIDES] = {0}, ey[WIDES] = {0}, along[WIDES];
    EACH(k) q2[k] = wide_mul(q[k], q[k]);
    EACH(k) size[k] = wide_add(pressed->near_lambda[k], near_lambda);
    EACH(k) size[k] = wide_mul(size[k], with & SMOOTH ? inverse[k] : q[k]);
    EACH(k) size[k] = wide_add(wide_add(pressed->lambda[k], lambda), size[k]);
    EACH(k) size[k] = wide_mul(size[k], with & SMOOTH ? q2[k] : ratio[k]);
    if (with & WITH_GRADIENT) {
        tension(others, j, pressed, dx, dy, q2, ratio, ex, ey, along);
        EACH(k) size[k] = wide_add(size[k], along[k]);
    }
    wide virial[WIDES] = {0};
    if (with & WITH_GAUGE) {
        /* Distance times force. */
        EACH(k) virial[k] = wide_mul(wide_mul(r[k], r[k]), size[k]);
        if (with & WITH_GRADIENT) {
            EACH(k) virial[k] = wide_sub(virial[k], wide_mul(ex[k], dx[k]));
            EACH(k) virial[k] = wide_sub(virial[k], wide_mul(ey[k], dy[k]));
        }
    }
    if (imaged) {
        wide outward[WIDES];
        add_image_pushes(with & WITH_GAUGE, pressed, lambda, near_lambda, t, j, q, virial, size,
                         outward, to->outward + j);
        EACH(k) sums->outward[k] = wide_add(sums->outward[k], outward[k]);
    } else if (with & WITH_GAUGE) {
        EACH(k) sums->outward[k] = wide_add(sums->outward[k], virial[k]);
        add_at(to->outward + j, over_tile(virial));
    }
    if (with & WITH_VISCOSITY)
        viscosity(p, others, t->place, j, with, pressed, dx, dy, inverse, q, size);
    EACH(k) dx[k] = wide_mul(dx[k], size[k]);
    EACH(k) dy[k] = wide_mul(dy[k], size[k]);
    if (with & WITH_GRADIENT) {
        EACH(k) dx[k] = wide_sub(dx[k], ex[k]);
        EACH(k) dy[k] = wide_sub(dy[k], ey[k]);
    }
    EACH(k) sums->x[k] = wide_sub(sums->x[k], dx[k]);
    EACH(k) sums->y[k] = wide_sub(sums->y[k], dy[k]);
    add_at(to->x + j, over_tile(dx));
    add_at(to->y + j, over_tile(dy));
}

/* The same for all eight. */
VARIANT void displacement_block(const skv_row_particles *p, const partners *others, int j,
                                bool first, unsigned with, const tile *t, float reach,
                                const pushes *pressed, move_sums *sums, const skv_row_moves *to,
                                const float *keep)
{
    /* The gauge wants the virial of who is far from walls as well. */
    const bool imaged = with & WITH_IMAGES && (with & WITH_GAUGE || within_reach(t, j, reach));
    EACH_PART(n)
    displacement_part(p, others, j + n * PART_LEN, first && n == 0, with, imaged, t, pressed,
                      &sums[n], to, with & KEEP_PAIRS ? keep + n * PART_PAIRS : NULL);
}

static void zero_moves(const skv_rows *s, const skv_row_moves *moves, int row, bool outward)
{
    zero_row(s, moves->x, row);
    zero_row(s, moves->y, row);
    if (outward)
        zero_row(s, moves->outward, row);
}

VARIANT void sum_moves(tile_sums *to, const move_sums *sums)
{
    const move_sums *last = &sums[PARTS - 1];
    sum_lanes(to->sum[0], sums->x, last->x);
    sum_lanes(to->sum[1], sums->y, last->y);
    if (to->more)
        sum_lanes(to->sum[2], sums->outward, last->outward);
}

VARIANT void add_moves(const skv_row_moves *to, const tile_sums *late)
{
    int i = late->place;
    add_tile(to->x + i, late->sum[0]);
    add_tile(to->y + i, late->sum[1]);
    if (late->more)
        add_tile(to->outward + i, late->sum[2]);
}

/* Pass B for a tile and all its partners. Returns where the next tile's pairs are kept. */
VARIANT const float *displacement_tile(const skv_rows *s, const skv_row_particles *p,
                                       const partners *others, bool apart, unsigned with,
                                       const tile *t, tile_sums *late, const float *keep)
{
    const skv_row_moves own = s->own_move, next = s->next_move;
    const int i = t->place, step = with & KEEP_PAIRS ? TILE * ROW_LANES : 0;
    const float reach = with & WITH_IMAGES ? image_reach(t) : 0;
    pushes pressed;
    move_sums sums[PARTS];
    EACH(k)
    {
        pressed.lambda[k] = wide_spread(others->lambda + i + k, WIDES);
        pressed.near_lambda[k] = wide_spread(others->near_lambda + i + k, WIDES);
        EACH_PART(n) sums[n].x[k] = sums[n].y[k] = sums[n].outward[k] = wide_set(0);
        pressed.u[k] = pressed.v[k] = wide_set(0);
        pressed.gradient_x[k] = pressed.gradient_y[k] = wide_set(0);
        if (with & WITH_VISCOSITY) {
            pressed.u[k] = wide_spread(p->u + i + k, WIDES);
            pressed.v[k] = wide_spread(p->v + i + k, WIDES);
        }
        if (with & WITH_GRADIENT) {
            pressed.gradient_x[k] = wide_spread(others->gradient_x + i + k, WIDES);
            pressed.gradient_y[k] = wide_spread(others->gradient_y + i + k, WIDES);
        }
    }
    skv_row_moves to = own;
    int j = i + 1, last = s->own_end[i / TILE];
    if (apart) {
        displacement_block(p, others, j, true, with, t, reach, &pressed, sums, &to, keep);
        keep += step;
        j += ROW_LANES;
    }
    bool first = !apart;
    for (bool in_own = true;; in_own = false) {
        for (; first || j < last; j += ROW_LANES, keep += step, first = false)
            displacement_block(p, others, j, first, with, t, reach, &pressed, sums, &to, keep);
        if (!in_own)
            break;
        j = s->next_begin[i / TILE];
        last = s->next_end[i / TILE];
        to = next;
    }
    if (late->place >= 0)
        add_moves(&own, late);
    late->place = i;
    late->more = with & (WITH_GAUGE | WITH_IMAGES);
    sum_moves(late, sums);
    return keep;
}

/* As density_any_tile. */
static __attribute__((noinline)) const float *
displacement_any_tile(const skv_rows *s, const skv_row_particles *p, const partners *others,
                      unsigned with, const tile *t, tile_sums *late, const float *keep)
{
#if FULL_VARIANTS
    if (with == (SMOOTH | KEEP_PAIRS | WITH_IMAGES))
        return displacement_tile(s, p, others, true, SMOOTH | KEEP_PAIRS | WITH_IMAGES, t, late,
                                 keep);
    if (with == (SMOOTH | KEEP_PAIRS | WITH_IMAGES | WITH_GRADIENT))
        return displacement_tile(s, p, others, true,
                                 SMOOTH | KEEP_PAIRS | WITH_IMAGES | WITH_GRADIENT, t, late, keep);
#endif
    return displacement_tile(s, p, others, FULL_VARIANTS, with, t, late, keep);
}

/* As density_row; of a rare variant no loop is known. */
VARIANT void displacement_row(const skv_rows *s, int row, unsigned with, bool known, bool images,
                              bool graded, const skv_constants *c, const skv_boundary *boundary,
                              const float *keep)
{
    const skv_row_particles local = s->set[s->current], *p = &local;
    const partners others = {
        s->lambda,        s->near_lambda,      s->gradient_x,         s->gradient_y,
        c->tension_scale, c->viscosity_linear, c->viscosity_quadratic};
    const skv_row_moves own = s->own_move, next = s->next_move;
    const unsigned plain = with & ~WITH_GRADIENT;
    const bool kept = keep != NULL, outward = with & WITH_GAUGE || images;
    zero_moves(s, &own, row, outward);
    zero_moves(s, &next, row + 1, outward);
    int begin = s->row_start[row], end = s->row_end[row];
    tile_sums late = {.place = -1};
    for (int i = begin; i < end; i += TILE) {
        tile t;
        place_tile(&t, s, p, i, c, kept ? NULL : find_thin_wall(p, i, end, c, boundary));
        bool imaged = images && meets_images(s, i, with & WITH_GAUGE);
        bool meets = with & WITH_GRADIENT && graded && may_have_gradient(s, row, i);
        unsigned any =
            (meets ? with : plain) | (kept ? KEEP_PAIRS : 0u) | (imaged ? WITH_IMAGES : 0u);
        if (!known || !kept || imaged || (meets && !FULL_VARIANTS))
            keep = displacement_any_tile(s, p, &others, any, &t, &late, keep);
        else if (meets)
            keep = displacement_tile(s, p, &others, true, with | KEEP_PAIRS, &t, &late, keep);
        else
            keep = displacement_tile(s, p, &others, true, plain | KEEP_PAIRS, &t, &late, keep);
    }
    if (late.place >= 0)
        add_moves(&own, &late);
}

static void displacement(const skv_rows *s, int row, bool later, const skv_constants *c,
                         const skv_boundary *b, const skv_row_kept *kept)
{
    bool viscous = !later && (skv_is_viscous(c) || s->various);
    const unsigned calibrated = SMOOTH | WITH_GRADIENT;
    const float *keep = kept->used >= 0 ? kept->pairs : NULL;
    unsigned with = (c->clavet ? 0u : calibrated) | (viscous ? WITH_VISCOSITY : 0u) |
                    (s->gauged ? WITH_GAUGE : 0u) |
                    (viscous && skv_is_massive(s) ? WITH_MASSES : 0u);
    /* What most substeps are made of has loops of its own. */
    if (with == calibrated)
        displacement_row(s, row, calibrated, true, c->images, !later, c, b, keep);
    else if (with == 0)
        displacement_row(s, row, 0, true, false, false, c, b, keep);
#if FULL_VARIANTS
    else if (with == WITH_VISCOSITY)
        displacement_row(s, row, WITH_VISCOSITY, true, false, false, c, b, keep);
    else if (with == (calibrated | WITH_GAUGE))
        displacement_row(s, row, calibrated | WITH_GAUGE, true, c->images, !later, c, b, keep);
    else if (with == (WITH_VISCOSITY | WITH_GAUGE))
        displacement_row(s, row, WITH_VISCOSITY | WITH_GAUGE, true, false, false, c, b, keep);
    else if (with == WITH_GAUGE)
        displacement_row(s, row, WITH_GAUGE, true, false, false, c, b, keep);
#endif
    else
        displacement_row(s, row, with, false, c->images, !later, c, b, keep);
}

#endif
