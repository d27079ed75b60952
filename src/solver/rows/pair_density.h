/* The density, pass A of the rows, and what both pair passes do with a pair. Included by kernels.c
 * alone, which is compiled once per instruction set. Invariant: a pair's sums for both of its
 * particles are the same products.
 *
 * The loops are written in stages over the tile (all differences, then all squares, ...): four
 * independent chains hide the latency of the square root and the division.
 */
#ifndef SKV_ROW_PAIR_DENSITY_H
#define SKV_ROW_PAIR_DENSITY_H

#include "solver/rows/pair_images.h"

#include <string.h>

/* Keeps r above 0; pairs closer than 1e-6 h have the strength of that distance. */
#define TINY_SQUARED 1e-12f

/* A lower bound of the distance to the nearest wall from where a particle's pairs are taken. */
V8_INLINE float pair_clearance(const skv_row_particles *p, int i, float pair_lag, float lag_rise)
{
    float lag = lag_of_one(p, i, pair_lag, lag_rise);
    float way = sqrtf(p->u[i] * p->u[i] + p->v[i] * p->v[i]);
    return p->clearance[i] - ROW_WALL_SLOPE * lag * way;
}

/* The boundary if a thin wall is near one of the particles of a tile, else null: most worlds have
 * none, and far from walls `clearance` tells. */
static const skv_boundary *find_thin_wall(const skv_row_particles *p, int i, int end,
                                          const skv_constants *c, const skv_boundary *boundary)
{
    for (int k = i; skv_boundary_has_thin(boundary) && k < i + TILE && k < end; k++) {
        if (pair_clearance(p, k, c->pair_lag, c->lag_rise) < 1 &&
            skv_boundary_near_thin(boundary, p->x[k], p->y[k]))
            return boundary;
    }
    return NULL;
}

/* One by one: an initializer, which sets all to 0 first, cost 4 %. */
VARIANT void place_tile(tile *t, const skv_rows *s, const skv_row_particles *p, int i,
                        const skv_constants *c, const skv_boundary *beside)
{
    t->pair_lag = c->pair_lag;
    t->lag_rise = c->lag_rise;
    t->place = i;
    t->beside = beside;
    t->images = s->image;
    EACH(k)
    {
        t->x[k] = wide_spread(p->x + i + k, WIDES);
        t->y[k] = wide_spread(p->y + i + k, WIDES);
    }
}

/* Sets q to 0 for pairs that a thin wall parts: then nothing passes between them. A wall between
 * two particles is no farther from both together than they are from each other; where its distances
 * say so, it need not be looked for. */
static __attribute__((noinline)) void part_pairs(const skv_row_particles *p, const tile *t, int j,
                                                 float *q)
{
    const skv_boundary *boundary = t->beside;
    const int i = t->place;
    for (int k = 0; k < TILE; k++) {
        float clear = pair_clearance(p, i + k, t->pair_lag, t->lag_rise);
        float *seen = q + PART_LEN * (k % WIDES * WIDE_PARTS + k / WIDES);
        if (clear >= 1)
            continue;
        for (int l = 0; l < PART_LEN; l++) {
            float *at = &seen[l];
            if (!(*at > 0))
                continue;
            float beyond = pair_clearance(p, j + l, t->pair_lag, t->lag_rise);
            if (clear + beyond < ROW_WALL_SLOPE * (1 - *at) &&
                skv_boundary_occluded(boundary, p->x[i + k], p->y[i + k], clear, p->x[j + l],
                                      p->y[j + l], beyond))
                *at = 0;
        }
    }
}

/* Differences to a part of the partners, at j, their distance and q. At the beginning of a tile's
 * first block the partners before and at particle k itself are masked out: j + lane > i + k. */
VARIANT void measure(const skv_row_particles *p, int j, bool first, const tile *t, wide *dx,
                     wide *dy, wide *r, wide *q)
{
    const wide one = wide_set(1), zero = wide_set(0), tiny = wide_set(TINY_SQUARED);
    wide xj = wide_each(part_load(p->x + j)), yj = wide_each(part_load(p->y + j));
    EACH(k) dx[k] = wide_sub(xj, t->x[k]);
    EACH(k) dy[k] = wide_sub(yj, t->y[k]);
    EACH(k) r[k] = wide_add(wide_mul(dy[k], dy[k]), tiny);
    EACH(k) r[k] = wide_add(wide_mul(dx[k], dx[k]), r[k]);
    EACH(k) r[k] = wide_sqrt(r[k]);
    EACH(k) q[k] = wide_max(wide_sub(one, r[k]), zero);
    if (first) {
        EACH(k) q[k] = k == 0 && WIDE_PARTS == 1 ? q[k] : wide_and(q[k], wide_mask_from(k, WIDES));
    }
    if (__builtin_expect(t->beside != NULL, 0)) {
        /* A copy, so that q itself stays in registers. */
        float seen[PART_PAIRS];
        const tile thin = {.place = t->place,
                           .beside = t->beside,
                           .pair_lag = t->pair_lag,
                           .lag_rise = t->lag_rise};
        EACH(k) wide_store(seen + WIDE_LEN * k, q[k]);
        part_pairs(p, &thin, j, seen);
        EACH(k) q[k] = wide_load(seen + WIDE_LEN * k);
    }
}

/* What makes the density of pairs that of where their particles are, to first order: from q^4 it
 * becomes q^4 + q^2 ahead, for W falls by 12 q^2 for each r dr, and a third of that is left. */
VARIANT void look_ahead(int j, const look *own, const wide *dx, const wide *dy, wide *ahead)
{
    wide x[WIDES], y[WIDES];
    wide xj = wide_each(part_load(own->all_x + j)), yj = wide_each(part_load(own->all_y + j));
    EACH(k) x[k] = wide_mul(dx[k], wide_sub(xj, own->x[k]));
    EACH(k) y[k] = wide_mul(dy[k], wide_sub(yj, own->y[k]));
    EACH(k) ahead[k] = wide_add(x[k], y[k]);
}

/* Pass A for a tile and a part of eight partners, some of which have images. */
VARIANT void density_part(const skv_row_particles *p, int j, bool first, unsigned with, bool imaged,
                          const tile *t, const look *own, density_sums *sums,
                          const skv_row_sums *to, float *keep)
{
    wide dx[WIDES], dy[WIDES], r[WIDES], q[WIDES], q2[WIDES], q3[WIDES], w[WIDES];
    wide ahead[WIDES] = {0};
    measure(p, j, first, t, dx, dy, r, q);
    if (with & KEEP_PAIRS) {
        EACH(k) wide_store(keep + WIDE_LEN * k, q[k]);
    }
    EACH(k) q2[k] = wide_mul(q[k], q[k]);
    EACH(k) q3[k] = wide_mul(q2[k], q[k]);
    /* W = 4 q^3 - 3 q^4 is put together when all is summed up: two operations a pair less. */
    EACH(k) w[k] = q2[k];
    if (with & SMOOTH) {
        look_ahead(j, own, dx, dy, ahead);
        EACH(k) w[k] = wide_mul(q2[k], wide_add(q2[k], ahead[k]));
    }
    if (imaged)
        add_image_kernels(t, j, q, ahead, w, q3);
    EACH(k) sums->density[k] = wide_add(sums->density[k], w[k]);
    EACH(k) sums->near_density[k] = wide_add(sums->near_density[k], q3[k]);
    add_at(to->density + j, over_tile(w));
    add_at(to->near_density + j, over_tile(q3));
    if (with & WITH_MASSES) {
        wide theirs = wide_each(part_load(own->all_lightness + j));
        EACH(k) sums->lightness[k] = wide_add(sums->lightness[k], wide_mul(q3[k], theirs));
        EACH(k) q3[k] = wide_mul(q3[k], own->lightness[k]);
        add_at(to->lightness + j, over_tile(q3));
    }
    if (with & WITH_GRADIENT) {
        EACH(k) dx[k] = wide_mul(dx[k], q2[k]);
        EACH(k) dy[k] = wide_mul(dy[k], q2[k]);
        EACH(k) sums->gradient_x[k] = wide_add(sums->gradient_x[k], dx[k]);
        EACH(k) sums->gradient_y[k] = wide_add(sums->gradient_y[k], dy[k]);
        float *gx = to->gradient_x + j, *gy = to->gradient_y + j;
        part_store(gx, part_sub(part_load(gx), over_tile(dx)));
        part_store(gy, part_sub(part_load(gy), over_tile(dy)));
    }
}

/* The same for all eight, though the last may lie beyond the tile's partners: those were found by
 * the sort, and what has moved since may be near. A half left out there gave other bits than an
 * eight does. */
VARIANT void density_block(const skv_row_particles *p, int j, bool first, unsigned with,
                           const tile *t, const look *own, float reach, density_sums *sums,
                           const skv_row_sums *to, float *keep)
{
    const bool imaged = with & WITH_IMAGES && within_reach(t, j, reach);
    EACH_PART(n)
    density_part(p, j + n * PART_LEN, first && n == 0, with, imaged, t, own, &sums[n], to,
                 with & KEEP_PAIRS ? keep + n * PART_PAIRS : NULL);
}

static void zero_row(const skv_rows *s, float *array, int row)
{
    int begin = s->row_start[row], end = skv_row_padded_end(s->row_end[row]);
    memset(array + begin, 0, (size_t)(end - begin) * sizeof *array);
}

static void zero_sums(const skv_rows *s, const skv_row_sums *sums, int row, bool graded)
{
    zero_row(s, sums->density, row);
    zero_row(s, sums->near_density, row);
    if (skv_is_massive(s))
        zero_row(s, sums->lightness, row);
    if (graded) {
        zero_row(s, sums->gradient_x, row);
        zero_row(s, sums->gradient_y, row);
    }
}

VARIANT void sum_densities(tile_sums *to, const density_sums *sums)
{
    const density_sums *last = &sums[PARTS - 1];
    sum_lanes(to->sum[0], sums->density, last->density);
    sum_lanes(to->sum[1], sums->near_density, last->near_density);
    if (to->more) {
        sum_lanes(to->sum[2], sums->gradient_x, last->gradient_x);
        sum_lanes(to->sum[3], sums->gradient_y, last->gradient_y);
    }
    if (to->massive)
        sum_lanes(to->sum[4], sums->lightness, last->lightness);
}

VARIANT void add_densities(const skv_row_sums *to, const tile_sums *late)
{
    int i = late->place;
    add_tile(to->density + i, late->sum[0]);
    add_tile(to->near_density + i, late->sum[1]);
    if (late->more) {
        add_tile(to->gradient_x + i, late->sum[2]);
        add_tile(to->gradient_y + i, late->sum[3]);
    }
    if (late->massive)
        add_tile(to->lightness + i, late->sum[4]);
}

/* Whether one of a tile's particles or of its partners may have a gradient. Most rows know by where
 * their first and their last such eights are. */
V8_INLINE bool may_have_gradient(const skv_rows *s, int row, int i)
{
    const int t = i / TILE, eight = i / ROW_LANES;
    bool own = (s->own_end[t] + ROW_LANES) / ROW_LANES >= s->graded_begin[row] &&
               eight < s->graded_end[row];
    bool next = (s->next_end[t] + ROW_LANES) / ROW_LANES >= s->graded_begin[row + 1] &&
                s->next_begin[t] / ROW_LANES < s->graded_end[row + 1];
    return (own || next) && any_flag(s, i, s->graded, ROW_LANES);
}

/* Pass A for a tile and all its partners. Returns where the next tile's pairs are to be kept. The
 * first block, which masks, has code of its own if it is `apart`. */
VARIANT float *density_tile(const skv_rows *s, const skv_row_particles *p, bool apart,
                            unsigned with, const tile *t, tile_sums *late, float *keep)
{
    const skv_row_sums own = s->own, next = s->next;
    const int i = t->place, step = with & KEEP_PAIRS ? TILE * ROW_LANES : 0;
    const float reach = with & WITH_IMAGES ? image_reach(t) : 0;
    density_sums sums[PARTS];
    look ahead;
    ahead.all_x = s->ahead_x;
    ahead.all_y = s->ahead_y;
    ahead.all_lightness = p->lightness;
    EACH(k)
    {
        ahead.x[k] = wide_spread(ahead.all_x + i + k, WIDES);
        ahead.y[k] = wide_spread(ahead.all_y + i + k, WIDES);
        if (with & WITH_MASSES)
            ahead.lightness[k] = wide_spread(ahead.all_lightness + i + k, WIDES);
        EACH_PART(n)
        sums[n].density[k] = sums[n].near_density[k] = sums[n].gradient_x[k] =
            sums[n].gradient_y[k] = sums[n].lightness[k] = wide_set(0);
    }
    /* First the partners in the own row, then those in the next: one loop for both, which is
     * unrolled once. */
    skv_row_sums to = own;
    int j = i + 1, last = s->own_end[i / TILE];
    if (apart) {
        density_block(p, j, true, with, t, &ahead, reach, sums, &to, keep);
        keep += step;
        j += ROW_LANES;
    }
    bool first = !apart;
    for (bool in_own = true;; in_own = false) {
        for (; first || j < last; j += ROW_LANES, keep += step, first = false)
            density_block(p, j, first, with, t, &ahead, reach, sums, &to, keep);
        if (!in_own)
            break;
        j = s->next_begin[i / TILE];
        last = s->next_end[i / TILE];
        to = next;
    }
    if (late->place >= 0)
        add_densities(&own, late);
    late->place = i;
    late->more = with & WITH_GRADIENT;
    late->massive = with & WITH_MASSES;
    sum_densities(late, sums);
    return keep;
}

/* The same for what is rare, as in the crowds of a splash or beside walls that act by images: one
 * function for all variants, which looks while it runs. */
static __attribute__((noinline)) float *density_any_tile(const skv_rows *s,
                                                         const skv_row_particles *p, unsigned with,
                                                         const tile *t, tile_sums *late,
                                                         float *keep)
{
#if FULL_VARIANTS
    if (with == (SMOOTH | KEEP_PAIRS | WITH_IMAGES))
        return density_tile(s, p, true, SMOOTH | KEEP_PAIRS | WITH_IMAGES, t, late, keep);
    if (with == (SMOOTH | KEEP_PAIRS | WITH_IMAGES | WITH_GRADIENT))
        return density_tile(s, p, true, SMOOTH | KEEP_PAIRS | WITH_IMAGES | WITH_GRADIENT, t, late,
                            keep);
#endif
    return density_tile(s, p, FULL_VARIANTS, FULL_VARIANTS ? with & ~WITH_MASSES : with, t, late,
                        keep);
}

/* The same with masses. */
static __attribute__((noinline)) float *density_massive_tile(const skv_rows *s,
                                                             const skv_row_particles *p,
                                                             unsigned with, const tile *t,
                                                             tile_sums *late, float *keep)
{
#if FULL_VARIANTS
    if (with == (SMOOTH | KEEP_PAIRS))
        return density_tile(s, p, true, SMOOTH | KEEP_PAIRS | WITH_MASSES, t, late, keep);
    return density_tile(s, p, true, with | WITH_MASSES, t, late, keep);
#else
    return density_any_tile(s, p, with | WITH_MASSES, t, late, keep);
#endif
}

/* Tiles that meet no gradient leave it out: where `with` is known to the compiler in loops of their
 * own, which the second iteration shares, for it has `graded` false. Without a place to keep pairs,
 * as in the crowds of a splash, no loop but that for all is taken. */
VARIANT void density_row(const skv_rows *s, int row, unsigned with, bool known, bool images,
                         bool graded, const skv_constants *c, const skv_boundary *boundary,
                         float *keep)
{
    /* Copies: the compiler need not fear that a store changes them. */
    const skv_row_particles local = s->set[s->current], *p = &local;
    const skv_row_sums own = s->own, next = s->next;
    const unsigned plain = with & ~WITH_GRADIENT;
    const bool kept = keep != NULL;
    zero_sums(s, &own, row, graded);
    zero_sums(s, &next, row + 1, graded);
    int begin = s->row_start[row], end = s->row_end[row];
    tile_sums late = {.place = -1};
    for (int i = begin; i < end; i += TILE) {
        tile t;
        place_tile(&t, s, p, i, c, find_thin_wall(p, i, end, c, boundary));
        bool imaged = images && meets_images(s, i, false);
        bool meets = with & WITH_GRADIENT && graded && may_have_gradient(s, row, i);
        unsigned any =
            (meets ? with : plain) | (kept ? KEEP_PAIRS : 0u) | (imaged ? WITH_IMAGES : 0u);
        if (with & WITH_MASSES)
            keep = density_massive_tile(s, p, any, &t, &late, keep);
        else if (!known || !kept || imaged || (meets && !FULL_VARIANTS))
            keep = density_any_tile(s, p, any, &t, &late, keep);
        else if (meets)
            keep = density_tile(s, p, true, with | KEEP_PAIRS, &t, &late, keep);
        else
            keep = density_tile(s, p, true, plain | KEEP_PAIRS, &t, &late, keep);
    }
    if (late.place >= 0)
        add_densities(&own, &late);
}

static void density(const skv_rows *s, int row, bool later, const skv_constants *c,
                    const skv_boundary *b, skv_row_kept *kept)
{
    int blocks = s->row_blocks[row];
    /* Pairs without a place are computed again by the displacement: slower, the same bits. */
    kept->used = blocks <= kept->room ? blocks : -1;
    float *keep = kept->used >= 0 ? kept->pairs : NULL;
    const unsigned calibrated = SMOOTH | WITH_GRADIENT;
    unsigned with = (c->clavet ? 0u : calibrated) | (skv_is_massive(s) ? WITH_MASSES : 0u);
    if (with == calibrated)
        density_row(s, row, calibrated, true, c->images, !later, c, b, keep);
    else if (with == 0)
        density_row(s, row, 0, true, false, false, c, b, keep);
    else
        density_row(s, row, with, false, c->images, !c->clavet && !later, c, b, keep);
}

#endif
