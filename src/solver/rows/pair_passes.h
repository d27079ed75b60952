/* The pair passes of the rows: density (A) and displacement (B). Included by kernels.c alone, which
 * is compiled once per instruction set.
 *
 * The loops are written in stages over the tile (all differences, then all squares, ...): four
 * independent chains hide the latency of the square root and the division.
 */
#ifndef SKV_ROW_PAIR_PASSES_H
#define SKV_ROW_PAIR_PASSES_H

#include "base/simd.h"
#include "solver/rows/rows_internal.h"

#include <string.h>

/* Keeps r above 0; pairs closer than 1e-6 h have the strength of that distance. */
#define TINY_SQUARED 1e-12f

#define TILE ROW_TILE
/* The pair loops are inlined into each of their variants and unrolled over the tile. The scalar
 * build, which is for checking and not for speed, does without: it would take compilers minutes. */
#if defined(SKV_SIMD_SCALAR)
#define VARIANT static __attribute__((noinline))
#define EACH(k) for (int k = 0; k < TILE; k++)
#else
#define VARIANT V8_INLINE
#define EACH(k) _Pragma("GCC unroll 8") for (int k = 0; k < TILE; k++)
#endif

/* Compile-time variants of the pair loops. SMOOTH: the kernel of base/kernels.h, else the spiky
 * one. WITH_GRADIENT: the density sums up the gradient, and the displacement has the tension that
 * evens it out; both know the smooth kernel's alone. WITH_GAUGE: the displacement sums up the
 * virial as well. */
enum { SMOOTH = 1, WITH_GRADIENT = 2, WITH_VISCOSITY = 4, KEEP_PAIRS = 8, WITH_GAUGE = 16 };

/* Where the four particles of a tile are, each in all lanes. */
typedef struct tile {
    v8 x[TILE], y[TILE];
    int place;                  /* of the first */
    const skv_boundary *beside; /* a thin wall, which may part pairs; null: none is near */
} tile;

/* What the density and the displacement need of them besides. */
typedef struct velocities {
    v8 u[TILE], v[TILE];
} velocities;
typedef struct pushes {
    v8 push[TILE], near_push[TILE], gradient_x[TILE], gradient_y[TILE];
    bool has_gradient; /* that of one of them is not 0 */
} pushes;

/* The sums for the tile's own particles. */
typedef struct density_sums {
    v8 density[TILE], near_density[TILE], gradient_x[TILE], gradient_y[TILE], u[TILE], v[TILE];
} density_sums;
typedef struct move_sums {
    v8 x[TILE], y[TILE], virial[TILE];
} move_sums;

V8_INLINE void add_at(float *p, v8 a)
{
    v8_store(p, v8_add(v8_load(p), a));
}

/* Adds up a tile's contributions to the partners, in the order of the tile. */
V8_INLINE v8 over_tile(const v8 *a)
{
    return v8_add(v8_add(a[0], a[1]), v8_add(a[2], a[3]));
}

/* The boundary if a thin wall is near one of the particles of a tile, else null: most worlds have
 * none, and far from walls `clearance` tells. */
static const skv_boundary *find_thin_wall(const skv_row_particles *p, int i, int end,
                                          const skv_boundary *boundary)
{
    for (int k = i; skv_boundary_has_thin(boundary) && k < i + TILE && k < end; k++) {
        if (p->clearance[k] < 1 && skv_boundary_near_thin(boundary, p->x[k], p->y[k]))
            return boundary;
    }
    return NULL;
}

/* Sets q to 0 for pairs that a thin wall parts: then nothing passes between them. A wall between
 * two particles is no farther from both together than they are from each other; where its distances
 * say so, it need not be looked for. */
static __attribute__((noinline)) void part_pairs(const skv_row_particles *p, int i, int j,
                                                 const skv_boundary *boundary, float *q)
{
    for (int k = 0; k < TILE; k++) {
        float clear = p->clearance[i + k];
        if (clear >= 1)
            continue;
        for (int l = 0; l < ROW_LANES; l++) {
            float *at = &q[ROW_LANES * k + l];
            if (*at > 0 && clear + p->clearance[j + l] < ROW_WALL_SLOPE * (1 - *at) &&
                skv_boundary_occluded(boundary, p->x[i + k], p->y[i + k], clear, p->x[j + l],
                                      p->y[j + l], p->clearance[j + l]))
                *at = 0;
        }
    }
}

/* Differences to eight partners at j, their distance and q. In the first block of a tile the
 * partners before and at particle k itself are masked out: j + lane > i + k. */
VARIANT void measure(const skv_row_particles *p, int j, bool first, const tile *t, v8 *dx, v8 *dy,
                     v8 *r, v8 *q)
{
    const v8 one = v8_set(1), zero = v8_set(0), tiny = v8_set(TINY_SQUARED);
    v8 xj = v8_load(p->x + j), yj = v8_load(p->y + j);
    EACH(k) dx[k] = v8_sub(xj, t->x[k]);
    EACH(k) dy[k] = v8_sub(yj, t->y[k]);
    EACH(k) r[k] = v8_add(v8_mul(dy[k], dy[k]), tiny);
    EACH(k) r[k] = v8_add(v8_mul(dx[k], dx[k]), r[k]);
    EACH(k) r[k] = v8_sqrt(r[k]);
    EACH(k) q[k] = v8_max(v8_sub(one, r[k]), zero);
    if (first) {
        EACH(k) q[k] = k ? v8_and(q[k], v8_mask_from(k)) : q[k];
    }
    if (__builtin_expect(t->beside != NULL, 0)) {
        /* A copy, so that q itself stays in registers. */
        float seen[TILE * ROW_LANES];
        EACH(k) v8_store(seen + ROW_LANES * k, q[k]);
        part_pairs(p, t->place, j, t->beside, seen);
        EACH(k) q[k] = v8_load(seen + ROW_LANES * k);
    }
}

/* The impulse of pairs that approach each other; dx, dy from i to j, in displacement units. */
VARIANT void viscosity(const skv_row_particles *p, int j, const velocities *t, const v8 *dx,
                       const v8 *dy, const v8 *inverse, const v8 *q, v8 sigma, v8 beta,
                       density_sums *sums, const skv_row_sums *to)
{
    const v8 zero = v8_set(0), one = v8_set(1), half = v8_set(0.5f);
    v8 uj = v8_load(p->u + j), vj = v8_load(p->v + j), w[TILE], share[TILE], ix[TILE], iy[TILE];
    EACH(k) w[k] = v8_add(v8_mul(v8_sub(t->u[k], uj), dx[k]), v8_mul(v8_sub(t->v[k], vj), dy[k]));
    EACH(k) w[k] = v8_mul(v8_max(w[k], zero), inverse[k]);
    EACH(k) share[k] = v8_min(v8_mul(q[k], v8_add(sigma, v8_mul(beta, w[k]))), one);
    EACH(k) w[k] = v8_mul(v8_mul(half, share[k]), v8_mul(w[k], inverse[k]));
    EACH(k) ix[k] = v8_mul(w[k], dx[k]);
    EACH(k) iy[k] = v8_mul(w[k], dy[k]);
    EACH(k) sums->u[k] = v8_sub(sums->u[k], ix[k]);
    EACH(k) sums->v[k] = v8_sub(sums->v[k], iy[k]);
    add_at(to->viscous_u + j, over_tile(ix));
    add_at(to->viscous_v + j, over_tile(iy));
}

/* Pass A for a tile and eight partners. */
VARIANT void density_block(const skv_row_particles *p, int j, bool first, unsigned with,
                           const tile *t, const velocities *moving, v8 sigma, v8 beta,
                           density_sums *sums, const skv_row_sums *to, float *keep)
{
    v8 dx[TILE], dy[TILE], r[TILE], q[TILE], q2[TILE], q3[TILE], w[TILE];
    measure(p, j, first, t, dx, dy, r, q);
    if (with & KEEP_PAIRS) {
        EACH(k) v8_store(keep + ROW_LANES * k, q[k]);
    }
    EACH(k) q2[k] = v8_mul(q[k], q[k]);
    EACH(k) q3[k] = v8_mul(q2[k], q[k]);
    if (with & SMOOTH) {
        const v8 three = v8_set(3), four = v8_set(4);
        EACH(k) w[k] = v8_mul(q3[k], v8_sub(four, v8_mul(three, q[k])));
    } else {
        EACH(k) w[k] = q2[k];
    }
    EACH(k) sums->density[k] = v8_add(sums->density[k], w[k]);
    EACH(k) sums->near_density[k] = v8_add(sums->near_density[k], q3[k]);
    add_at(to->density + j, over_tile(w));
    add_at(to->near_density + j, over_tile(q3));
    if (with & WITH_VISCOSITY) {
        const v8 one = v8_set(1);
        v8 inverse[TILE];
        EACH(k) inverse[k] = v8_div(one, r[k]);
        viscosity(p, j, moving, dx, dy, inverse, q, sigma, beta, sums, to);
    }
    if (with & WITH_GRADIENT) {
        EACH(k) dx[k] = v8_mul(dx[k], q2[k]);
        EACH(k) dy[k] = v8_mul(dy[k], q2[k]);
        EACH(k) sums->gradient_x[k] = v8_add(sums->gradient_x[k], dx[k]);
        EACH(k) sums->gradient_y[k] = v8_add(sums->gradient_y[k], dy[k]);
        float *gx = to->gradient_x + j, *gy = to->gradient_y + j;
        v8_store(gx, v8_sub(v8_load(gx), over_tile(dx)));
        v8_store(gy, v8_sub(v8_load(gy), over_tile(dy)));
    }
}

static void zero_row(const skv_rows *s, float *array, int row)
{
    int begin = s->row_start[row], end = skv_row_padded_end(s->row_end[row]);
    memset(array + begin, 0, (size_t)(end - begin) * sizeof *array);
}

static void zero_sums(const skv_rows *s, const skv_row_sums *sums, int row, unsigned with)
{
    zero_row(s, sums->density, row);
    zero_row(s, sums->near_density, row);
    if (with & WITH_GRADIENT) {
        zero_row(s, sums->gradient_x, row);
        zero_row(s, sums->gradient_y, row);
    }
    if (with & WITH_VISCOSITY) {
        zero_row(s, sums->viscous_u, row);
        zero_row(s, sums->viscous_v, row);
    }
}

/* Stores the sums of the tile at i. */
VARIANT void store_densities(const skv_row_sums *to, int i, unsigned with, const density_sums *sums)
{
    const v8 zero = v8_set(0);
    EACH(k)
    {
        float out[4];
        if (with & WITH_GRADIENT)
            v8_sum4(sums->density[k], sums->near_density[k], sums->gradient_x[k],
                    sums->gradient_y[k], out);
        else
            v8_sum4(sums->density[k], sums->near_density[k], zero, zero, out);
        to->density[i + k] = out[0];
        to->near_density[i + k] = out[1];
        if (with & WITH_GRADIENT) {
            to->gradient_x[i + k] = out[2];
            to->gradient_y[i + k] = out[3];
        }
        if (with & WITH_VISCOSITY) {
            v8_sum4(sums->u[k], sums->v[k], zero, zero, out);
            to->viscous_u[i + k] = out[0];
            to->viscous_v[i + k] = out[1];
        }
    }
}

VARIANT void density_row(const skv_rows *s, int row, unsigned with, const skv_row_constants *c,
                         const skv_boundary *boundary, float *keep)
{
    /* Copies: the compiler need not fear that a store changes them. */
    const skv_row_particles local = s->set[s->current], *p = &local;
    const skv_row_sums own = s->own, next = s->next, in_tile = s->tile;
    const v8 sigma = v8_set(c->viscosity_linear), beta = v8_set(c->viscosity_quadratic);
    const int step = TILE * ROW_LANES;
    zero_sums(s, &own, row, with);
    zero_sums(s, &next, row + 1, with);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += TILE) {
        tile t = {.place = i, .beside = find_thin_wall(p, i, end, boundary)};
        velocities moving;
        density_sums sums;
        EACH(k)
        {
            t.x[k] = v8_set(p->x[i + k]);
            t.y[k] = v8_set(p->y[i + k]);
            moving.u[k] = v8_set(p->u[i + k]);
            moving.v[k] = v8_set(p->v[i + k]);
            sums.density[k] = sums.near_density[k] = sums.gradient_x[k] = sums.gradient_y[k] =
                sums.u[k] = sums.v[k] = v8_set(0);
        }
        int own_end = s->own_end[i / TILE], next_end = s->next_end[i / TILE], j = i + 1;
        density_block(p, j, true, with, &t, &moving, sigma, beta, &sums, &own, keep);
        keep += with & KEEP_PAIRS ? step : 0;
        for (j += ROW_LANES; j < own_end; j += ROW_LANES) {
            density_block(p, j, false, with, &t, &moving, sigma, beta, &sums, &own, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        for (j = s->next_begin[i / TILE]; j < next_end; j += ROW_LANES) {
            density_block(p, j, false, with, &t, &moving, sigma, beta, &sums, &next, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        store_densities(&in_tile, i, with, &sums);
    }
}

/* One of the variants in use, with or without room for the pairs. */
VARIANT void density_variant(const skv_rows *s, int row, unsigned with, const skv_row_constants *c,
                             const skv_boundary *b, const skv_row_kept *kept)
{
    if (kept->used >= 0)
        density_row(s, row, with | KEEP_PAIRS, c, b, kept->pairs);
    else
        density_row(s, row, with, c, b, NULL);
}

static void density(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                    const skv_boundary *b, skv_row_kept *kept)
{
    int blocks = s->row_blocks[row];
    /* Pairs without a place are computed again by the displacement: slower, the same bits. */
    kept->used = blocks <= kept->room ? blocks : -1;
    bool viscous = s->viscous && !later;
    if (c->clavet && viscous)
        density_variant(s, row, WITH_VISCOSITY, c, b, kept);
    else if (c->clavet)
        density_variant(s, row, 0, c, b, kept);
    else if (later)
        density_variant(s, row, SMOOTH, c, b, kept);
    else if (viscous)
        density_variant(s, row, SMOOTH | WITH_GRADIENT | WITH_VISCOSITY, c, b, kept);
    else
        density_variant(s, row, SMOOTH | WITH_GRADIENT, c, b, kept);
}

/* What the displacement reads of the partners. */
typedef struct partners {
    const float *push, *near_push, *gradient_x, *gradient_y;
} partners;

/* Whether one of eight partners has a gradient. */
V8_INLINE bool has_gradient_at(const partners *others, int j)
{
    v8 gx = v8_load(others->gradient_x + j), gy = v8_load(others->gradient_y + j);
    return v8_any_below(v8_set(0), v8_add(v8_mul(gx, gx), v8_mul(gy, gy)));
}

/* The tension of a pair: e being the difference of the gradients, d that of the places, q^2 e less
 * 2 (q/r)(e d) d. Leaves the first part in ex, ey and the factor of d in `along`. */
VARIANT void tension(const partners *others, int j, const pushes *t, const v8 *dx, const v8 *dy,
                     const v8 *q2, const v8 *ratio, v8 *ex, v8 *ey, v8 *along)
{
    const v8 two = v8_set(2);
    v8 gx = v8_load(others->gradient_x + j), gy = v8_load(others->gradient_y + j);
    EACH(k) ex[k] = v8_sub(t->gradient_x[k], gx);
    EACH(k) ey[k] = v8_sub(t->gradient_y[k], gy);
    EACH(k) along[k] = v8_add(v8_mul(ex[k], dx[k]), v8_mul(ey[k], dy[k]));
    EACH(k) along[k] = v8_mul(v8_mul(two, ratio[k]), along[k]);
    EACH(k) ex[k] = v8_mul(ex[k], q2[k]);
    EACH(k) ey[k] = v8_mul(ey[k], q2[k]);
}

/* Pass B for a tile and eight partners. Where q is kept, r is 1 - q. */
VARIANT void displacement_block(const skv_row_particles *p, const partners *others, int j,
                                bool first, unsigned with, const tile *t, const pushes *pressed,
                                move_sums *sums, const skv_row_moves *to, const float *keep)
{
    const v8 one = v8_set(1);
    v8 dx[TILE], dy[TILE], r[TILE], q[TILE], ratio[TILE], size[TILE];
    if (with & KEEP_PAIRS) {
        v8 xj = v8_load(p->x + j), yj = v8_load(p->y + j);
        EACH(k) dx[k] = v8_sub(xj, t->x[k]);
        EACH(k) dy[k] = v8_sub(yj, t->y[k]);
        EACH(k) q[k] = v8_load(keep + ROW_LANES * k);
    } else {
        measure(p, j, first, t, dx, dy, r, q);
    }
    EACH(k) r[k] = v8_sub(one, q[k]);
    EACH(k) ratio[k] = v8_div(q[k], r[k]);
    v8 push = v8_load(others->push + j), near_push = v8_load(others->near_push + j);
    EACH(k) size[k] = v8_mul(v8_add(pressed->near_push[k], near_push), q[k]);
    v8 q2[TILE], ex[TILE], ey[TILE], along[TILE];
    EACH(k) q2[k] = v8_mul(q[k], q[k]);
    if (with & SMOOTH) {
        EACH(k) size[k] = v8_mul(size[k], ratio[k]);
        EACH(k) size[k] = v8_add(v8_mul(v8_add(pressed->push[k], push), q2[k]), size[k]);
    } else {
        EACH(k) size[k] = v8_mul(v8_add(v8_add(pressed->push[k], push), size[k]), ratio[k]);
    }
    /* Inside the fluid there is none to be had. */
    bool has_gradient =
        with & WITH_GRADIENT && (pressed->has_gradient || has_gradient_at(others, j));
    if (has_gradient) {
        tension(others, j, pressed, dx, dy, q2, ratio, ex, ey, along);
        EACH(k) size[k] = v8_add(size[k], along[k]);
    }
    if (with & WITH_GAUGE) {
        /* Distance times force. */
        v8 virial[TILE];
        EACH(k) virial[k] = v8_mul(v8_mul(r[k], r[k]), size[k]);
        if (has_gradient) {
            EACH(k) virial[k] = v8_sub(virial[k], v8_mul(ex[k], dx[k]));
            EACH(k) virial[k] = v8_sub(virial[k], v8_mul(ey[k], dy[k]));
        }
        EACH(k) sums->virial[k] = v8_add(sums->virial[k], virial[k]);
        add_at(to->virial + j, over_tile(virial));
    }
    EACH(k) dx[k] = v8_mul(dx[k], size[k]);
    EACH(k) dy[k] = v8_mul(dy[k], size[k]);
    if (has_gradient) {
        EACH(k) dx[k] = v8_sub(dx[k], ex[k]);
        EACH(k) dy[k] = v8_sub(dy[k], ey[k]);
    }
    EACH(k) sums->x[k] = v8_sub(sums->x[k], dx[k]);
    EACH(k) sums->y[k] = v8_sub(sums->y[k], dy[k]);
    add_at(to->x + j, over_tile(dx));
    add_at(to->y + j, over_tile(dy));
}

static void zero_moves(const skv_rows *s, const skv_row_moves *moves, int row, unsigned with)
{
    zero_row(s, moves->x, row);
    zero_row(s, moves->y, row);
    if (with & WITH_GAUGE)
        zero_row(s, moves->virial, row);
}

VARIANT void store_moves(const skv_row_moves *to, int i, unsigned with, const move_sums *sums)
{
    const v8 zero = v8_set(0);
    EACH(k)
    {
        float out[4];
        v8_sum4(sums->x[k], sums->y[k], with & WITH_GAUGE ? sums->virial[k] : zero, zero, out);
        to->x[i + k] = out[0];
        to->y[i + k] = out[1];
        if (with & WITH_GAUGE)
            to->virial[i + k] = out[2];
    }
}

VARIANT void displacement_row(const skv_rows *s, int row, unsigned with,
                              const skv_boundary *boundary, const float *keep)
{
    const skv_row_particles local = s->set[s->current], *p = &local;
    const partners others = {s->push, s->near_push, s->gradient_x, s->gradient_y};
    const skv_row_moves own = s->own_move, next = s->next_move, in_tile = s->tile_move;
    const int step = TILE * ROW_LANES;
    zero_moves(s, &own, row, with);
    zero_moves(s, &next, row + 1, with);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += TILE) {
        tile t = {.place = i};
        if (!(with & KEEP_PAIRS))
            t.beside = find_thin_wall(p, i, end, boundary);
        pushes pressed = {.has_gradient = false};
        move_sums sums;
        const v8 zero = v8_set(0);
        EACH(k)
        {
            t.x[k] = v8_set(p->x[i + k]);
            t.y[k] = v8_set(p->y[i + k]);
            pressed.push[k] = v8_set(others.push[i + k]);
            pressed.near_push[k] = v8_set(others.near_push[i + k]);
            float gx = with & WITH_GRADIENT ? others.gradient_x[i + k] : 0;
            float gy = with & WITH_GRADIENT ? others.gradient_y[i + k] : 0;
            pressed.gradient_x[k] = v8_set(gx);
            pressed.gradient_y[k] = v8_set(gy);
            pressed.has_gradient = pressed.has_gradient || (i + k < end && (gx != 0 || gy != 0));
            sums.x[k] = sums.y[k] = sums.virial[k] = zero;
        }
        int own_end = s->own_end[i / TILE], next_end = s->next_end[i / TILE], j = i + 1;
        displacement_block(p, &others, j, true, with, &t, &pressed, &sums, &own, keep);
        keep += with & KEEP_PAIRS ? step : 0;
        for (j += ROW_LANES; j < own_end; j += ROW_LANES) {
            displacement_block(p, &others, j, false, with, &t, &pressed, &sums, &own, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        for (j = s->next_begin[i / TILE]; j < next_end; j += ROW_LANES) {
            displacement_block(p, &others, j, false, with, &t, &pressed, &sums, &next, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        store_moves(&in_tile, i, with, &sums);
    }
}

VARIANT void displacement_variant(const skv_rows *s, int row, unsigned with, const skv_boundary *b,
                                  const skv_row_kept *kept)
{
    if (kept->used >= 0)
        displacement_row(s, row, with | KEEP_PAIRS, b, kept->pairs);
    else
        displacement_row(s, row, with, b, NULL);
}

static void displacement(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                         const skv_boundary *b, const skv_row_kept *kept)
{
    if (c->clavet && s->gauged)
        displacement_variant(s, row, WITH_GAUGE, b, kept);
    else if (c->clavet)
        displacement_variant(s, row, 0, b, kept);
    else if (later && s->gauged)
        displacement_variant(s, row, SMOOTH | WITH_GAUGE, b, kept);
    else if (later)
        displacement_variant(s, row, SMOOTH, b, kept);
    else if (s->gauged)
        displacement_variant(s, row, SMOOTH | WITH_GRADIENT | WITH_GAUGE, b, kept);
    else
        displacement_variant(s, row, SMOOTH | WITH_GRADIENT, b, kept);
}

#endif
