/* The kernels of the rows: one source for every instruction set.
 *
 * Compiled several times, each with the flags of one instruction set and SKV_ROW_KERNELS naming the
 * table it defines. Invariant: a lane does the same IEEE operations in the same order in each of
 * them, and sums are added up in a fixed order; so all tables give the same bits.
 *
 * The pair loops are written in stages over the tile (all differences, then all squares, ...): four
 * independent chains hide the latency of the square root and the division.
 */
#include "base/simd.h"
#include "solver/rows/rows_internal.h"

#include <string.h>

/* Keeps r above 0; pairs closer than 1e-6 h have the strength of that distance. */
#define TINY_SQUARED 1e-12f

#define TILE    ROW_TILE
#define EACH(k) _Pragma("GCC unroll 8") for (int k = 0; k < TILE; k++)

/* Compile-time variants of the pair loops. */
enum { WITH_GRADIENT = 1, WITH_VISCOSITY = 2, KEEP_PAIRS = 4 };

/* The four particles of a tile, each in all lanes. */
typedef struct tile {
    v8 x[TILE], y[TILE], u[TILE], v[TILE];
} tile;

/* Sums for the tile's own particles. */
typedef struct tile_sums {
    v8 a[TILE], b[TILE], c[TILE], d[TILE], u[TILE], v[TILE];
} tile_sums;

/* Where sums for the partners go: `own` arrays or `next` arrays. */
typedef struct targets {
    float *a, *b, *c, *d, *u, *v;
} targets;

V8_INLINE void add_at(float *p, v8 a)
{
    v8_store(p, v8_add(v8_load(p), a));
}

/* Adds up a tile's contributions to the partners, in the order of the tile. */
V8_INLINE v8 over_tile(const v8 *a)
{
    return v8_add(v8_add(a[0], a[1]), v8_add(a[2], a[3]));
}

/* Differences to eight partners at j, their distance and q. In the first block of a tile the
 * partners before and at particle k itself are masked out: j + lane > i + k. */
V8_INLINE void measure(const skv_row_particles *p, int j, bool first, const tile *t, v8 *dx, v8 *dy,
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
}

/* The impulse of pairs that approach each other; dx, dy from i to j, in displacement units. */
V8_INLINE void viscosity(const skv_row_particles *p, int j, const tile *t, const v8 *dx,
                         const v8 *dy, const v8 *inverse, const v8 *q, v8 sigma, v8 beta,
                         tile_sums *sums, const targets *to)
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
    add_at(to->u + j, over_tile(ix));
    add_at(to->v + j, over_tile(iy));
}

/* Pass A for a tile and eight partners. */
V8_INLINE void density_block(const skv_row_particles *p, int j, bool first, unsigned with,
                             const tile *t, v8 sigma, v8 beta, tile_sums *sums, const targets *to,
                             float *keep)
{
    v8 dx[TILE], dy[TILE], r[TILE], q[TILE], q2[TILE], q3[TILE];
    measure(p, j, first, t, dx, dy, r, q);
    if (with & KEEP_PAIRS) {
        EACH(k) v8_store(keep + ROW_LANES * k, q[k]);
    }
    EACH(k) q2[k] = v8_mul(q[k], q[k]);
    EACH(k) q3[k] = v8_mul(q2[k], q[k]);
    EACH(k) sums->a[k] = v8_add(sums->a[k], q2[k]);
    EACH(k) sums->b[k] = v8_add(sums->b[k], q3[k]);
    add_at(to->a + j, over_tile(q2));
    add_at(to->b + j, over_tile(q3));
    if (with & WITH_VISCOSITY) {
        const v8 one = v8_set(1);
        v8 inverse[TILE];
        EACH(k) inverse[k] = v8_div(one, r[k]);
        viscosity(p, j, t, dx, dy, inverse, q, sigma, beta, sums, to);
    }
    if (with & WITH_GRADIENT) {
        v8 ratio[TILE];
        EACH(k) ratio[k] = v8_div(q[k], r[k]);
        if (with & KEEP_PAIRS) {
            EACH(k) v8_store(keep + ROW_LANES * (TILE + k), ratio[k]);
        }
        EACH(k) dx[k] = v8_mul(dx[k], ratio[k]);
        EACH(k) dy[k] = v8_mul(dy[k], ratio[k]);
        EACH(k) sums->c[k] = v8_add(sums->c[k], dx[k]);
        EACH(k) sums->d[k] = v8_add(sums->d[k], dy[k]);
        float *c = to->c + j, *d = to->d + j;
        v8_store(c, v8_sub(v8_load(c), over_tile(dx)));
        v8_store(d, v8_sub(v8_load(d), over_tile(dy)));
    }
}

/* The two ranges of partners of each tile: in the own row up to a radius ahead, in the next row
 * within a radius to both sides. */
static int find_ranges(const skv_rows *s, int row)
{
    const int *own = s->cell_start + (size_t)row * (size_t)s->stride, *next = own + s->stride;
    int end = s->row_end[row], blocks = 0;
    for (int i = s->row_start[row]; i < end; i += TILE) {
        int last = i + TILE - 1 < end ? i + TILE - 1 : end - 1;
        int from = s->cell[i] - ROW_CELLS, to = s->cell[last] + ROW_CELLS + 1;
        s->own_end[i / TILE] = own[to];
        s->next_begin[i / TILE] = next[from];
        s->next_end[i / TILE] = next[to];
        int ahead = s->own_end[i / TILE] - (i + 1);
        blocks += 1 + (ahead > ROW_LANES ? (ahead - 1) / ROW_LANES : 0) +
                  (s->next_end[i / TILE] - s->next_begin[i / TILE] + ROW_LANES - 1) / ROW_LANES;
    }
    return blocks;
}

static void zero_row(const skv_rows *s, float *array, int row)
{
    int begin = s->row_start[row], end = skv_row_padded_end(s->row_end[row]);
    memset(array + begin, 0, (size_t)(end - begin) * sizeof *array);
}

static void zero_targets(const skv_rows *s, int row, unsigned with)
{
    int sums = with & WITH_GRADIENT ? 4 : 2;
    for (int a = 0; a < sums; a++) {
        zero_row(s, s->own[a], row);
        zero_row(s, s->next[a], row + 1);
    }
    for (int a = 0; with & WITH_VISCOSITY && a < 2; a++) {
        zero_row(s, s->viscous_own[a], row);
        zero_row(s, s->viscous_next[a], row + 1);
    }
}

V8_INLINE void store_sums(const skv_rows *s, int i, unsigned with, const tile_sums *sums)
{
    const v8 zero = v8_set(0);
    EACH(k)
    {
        float out[4];
        if (with & WITH_GRADIENT)
            v8_sum4(sums->a[k], sums->b[k], sums->c[k], sums->d[k], out);
        else
            v8_sum4(sums->a[k], sums->b[k], zero, zero, out);
        s->sum[0][i + k] = out[0];
        s->sum[1][i + k] = out[1];
        if (with & WITH_GRADIENT) {
            s->sum[2][i + k] = out[2];
            s->sum[3][i + k] = out[3];
        }
        if (with & WITH_VISCOSITY) {
            v8_sum4(sums->u[k], sums->v[k], zero, zero, out);
            s->viscous_sum[0][i + k] = out[0];
            s->viscous_sum[1][i + k] = out[1];
        }
    }
}

V8_INLINE void density_row(const skv_rows *s, int row, unsigned with, const skv_row_constants *c,
                           float *keep)
{
    /* A copy: the compiler need not fear that a store changes it. */
    const skv_row_particles local = s->set[s->current], *p = &local;
    const v8 sigma = v8_set(c->viscosity_linear), beta = v8_set(c->viscosity_quadratic);
    const int step = with & WITH_GRADIENT ? 2 * TILE * ROW_LANES : TILE * ROW_LANES;
    const targets own = {s->own[0], s->own[1],         s->own[2],
                         s->own[3], s->viscous_own[0], s->viscous_own[1]};
    const targets next = {s->next[0], s->next[1],         s->next[2],
                          s->next[3], s->viscous_next[0], s->viscous_next[1]};
    zero_targets(s, row, with);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += TILE) {
        tile t;
        tile_sums sums;
        const v8 zero = v8_set(0);
        EACH(k)
        {
            t.x[k] = v8_set(p->x[i + k]);
            t.y[k] = v8_set(p->y[i + k]);
            t.u[k] = v8_set(p->u[i + k]);
            t.v[k] = v8_set(p->v[i + k]);
            sums.a[k] = sums.b[k] = sums.c[k] = sums.d[k] = sums.u[k] = sums.v[k] = zero;
        }
        int own_end = s->own_end[i / TILE], next_end = s->next_end[i / TILE], j = i + 1;
        density_block(p, j, true, with, &t, sigma, beta, &sums, &own, keep);
        keep += with & KEEP_PAIRS ? step : 0;
        for (j += ROW_LANES; j < own_end; j += ROW_LANES) {
            density_block(p, j, false, with, &t, sigma, beta, &sums, &own, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        for (j = s->next_begin[i / TILE]; j < next_end; j += ROW_LANES) {
            density_block(p, j, false, with, &t, sigma, beta, &sums, &next, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        store_sums(s, i, with, &sums);
    }
}

static void density(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                    skv_row_kept *kept)
{
    int blocks = find_ranges(s, row);
    /* Pairs without a place are computed again by the displacement: slower, the same bits. */
    bool keep = blocks <= kept->room;
    kept->used = keep ? blocks : -1;
    unsigned viscous = s->viscous && !later ? WITH_VISCOSITY : 0;
    if (later || c->clavet) {
        if (viscous)
            keep ? density_row(s, row, WITH_VISCOSITY | KEEP_PAIRS, c, kept->pairs)
                 : density_row(s, row, WITH_VISCOSITY, c, NULL);
        else
            keep ? density_row(s, row, KEEP_PAIRS, c, kept->pairs)
                 : density_row(s, row, 0, c, NULL);
    } else if (viscous) {
        keep ? density_row(s, row, WITH_GRADIENT | WITH_VISCOSITY | KEEP_PAIRS, c, kept->pairs)
             : density_row(s, row, WITH_GRADIENT | WITH_VISCOSITY, c, NULL);
    } else {
        keep ? density_row(s, row, WITH_GRADIENT | KEEP_PAIRS, c, kept->pairs)
             : density_row(s, row, WITH_GRADIENT, c, NULL);
    }
}

/* Pass B for a tile and eight partners. `with` tells how q and q/r are had: WITH_GRADIENT as the
 * first iteration made them, else from q alone, r being 1 - q. */
V8_INLINE void displacement_block(const skv_row_particles *p, const float *pushes,
                                  const float *near_pushes, int j, bool first, unsigned with,
                                  const tile *t, tile_sums *sums, float *to_x, float *to_y,
                                  const float *keep)
{
    v8 dx[TILE], dy[TILE], r[TILE], q[TILE], ratio[TILE], size[TILE];
    if (with & KEEP_PAIRS) {
        v8 xj = v8_load(p->x + j), yj = v8_load(p->y + j);
        EACH(k) dx[k] = v8_sub(xj, t->x[k]);
        EACH(k) dy[k] = v8_sub(yj, t->y[k]);
        EACH(k) q[k] = v8_load(keep + ROW_LANES * k);
    } else {
        measure(p, j, first, t, dx, dy, r, q);
    }
    if ((with & WITH_GRADIENT) && (with & KEEP_PAIRS)) {
        EACH(k) ratio[k] = v8_load(keep + ROW_LANES * (TILE + k));
    } else if (with & WITH_GRADIENT) {
        EACH(k) ratio[k] = v8_div(q[k], r[k]);
    } else {
        const v8 one = v8_set(1);
        EACH(k) r[k] = v8_sub(one, q[k]);
        EACH(k) ratio[k] = v8_div(q[k], r[k]);
    }
    v8 push = v8_load(pushes + j), near_push = v8_load(near_pushes + j);
    /* The tile's u and v hold the P and N of its particles here. */
    EACH(k) size[k] = v8_mul(v8_add(t->v[k], near_push), q[k]);
    EACH(k) size[k] = v8_add(v8_add(t->u[k], push), size[k]);
    EACH(k) size[k] = v8_mul(size[k], ratio[k]);
    EACH(k) dx[k] = v8_mul(dx[k], size[k]);
    EACH(k) dy[k] = v8_mul(dy[k], size[k]);
    EACH(k) sums->a[k] = v8_sub(sums->a[k], dx[k]);
    EACH(k) sums->b[k] = v8_sub(sums->b[k], dy[k]);
    add_at(to_x + j, over_tile(dx));
    add_at(to_y + j, over_tile(dy));
}

V8_INLINE void displacement_row(const skv_rows *s, int row, unsigned with, const float *keep)
{
    const skv_row_particles local = s->set[s->current], *p = &local;
    const float *push = s->push, *near_push = s->near_push;
    float *own_x = s->own[0], *own_y = s->own[1], *next_x = s->next[0], *next_y = s->next[1];
    const int step = with & WITH_GRADIENT ? 2 * TILE * ROW_LANES : TILE * ROW_LANES;
    for (int a = 0; a < 2; a++) {
        zero_row(s, s->own[a], row);
        zero_row(s, s->next[a], row + 1);
    }
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += TILE) {
        tile t;
        tile_sums sums;
        const v8 zero = v8_set(0);
        EACH(k)
        {
            t.x[k] = v8_set(p->x[i + k]);
            t.y[k] = v8_set(p->y[i + k]);
            t.u[k] = v8_set(s->push[i + k]);
            t.v[k] = v8_set(s->near_push[i + k]);
            sums.a[k] = sums.b[k] = zero;
        }
        int own_end = s->own_end[i / TILE], next_end = s->next_end[i / TILE], j = i + 1;
        displacement_block(p, push, near_push, j, true, with, &t, &sums, own_x, own_y, keep);
        keep += with & KEEP_PAIRS ? step : 0;
        for (j += ROW_LANES; j < own_end; j += ROW_LANES) {
            displacement_block(p, push, near_push, j, false, with, &t, &sums, own_x, own_y, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        for (j = s->next_begin[i / TILE]; j < next_end; j += ROW_LANES) {
            displacement_block(p, push, near_push, j, false, with, &t, &sums, next_x, next_y, keep);
            keep += with & KEEP_PAIRS ? step : 0;
        }
        for (int k = 0; k < TILE; k += 2) {
            float out[4];
            v8_sum4(sums.a[k], sums.b[k], sums.a[k + 1], sums.b[k + 1], out);
            s->sum[0][i + k] = out[0];
            s->sum[1][i + k] = out[1];
            s->sum[0][i + k + 1] = out[2];
            s->sum[1][i + k + 1] = out[3];
        }
    }
}

static void displacement(const skv_rows *s, int row, bool later, const skv_row_kept *kept)
{
    if (kept->used >= 0)
        later ? displacement_row(s, row, KEEP_PAIRS, kept->pairs)
              : displacement_row(s, row, WITH_GRADIENT | KEEP_PAIRS, kept->pairs);
    else
        later ? displacement_row(s, row, 0, NULL) : displacement_row(s, row, WITH_GRADIENT, NULL);
}

/* own + next + sum: what a row's particles have collected. */
V8_INLINE v8 collected(const skv_rows *s, int a, int i)
{
    return v8_add(v8_add(v8_load(s->own[a] + i), v8_load(s->next[a] + i)), v8_load(s->sum[a] + i));
}

/* Adds the walls' share to particles near one, and keeps the samples for the update. */
static int sample_walls(const skv_rows *s, int row, bool gradient, const skv_row_boundary *boundary,
                        skv_row_thread *thread)
{
    const skv_row_particles *p = &s->set[s->current];
    int before = thread->near_wall_count;
    bool all = true;
    for (int i = s->row_start[row]; i < s->row_end[row]; i++) {
        if (p->clear[i] >= 1)
            continue;
        skv_row_wall wall;
        p->clear[i] = boundary->walls(boundary->context, p->x[i], p->y[i], &wall);
        s->own[0][i] += wall.density;
        s->own[1][i] += wall.near_density;
        if (gradient) {
            s->own[2][i] -= wall.f1x;
            s->own[3][i] -= wall.f1y;
        }
        all = all && thread->near_wall_count < thread->near_wall_room;
        if (all)
            thread->near_walls[thread->near_wall_count++] = (skv_near_wall){i, wall};
    }
    return all ? thread->near_wall_count - before : -1;
}

static void pressure_calibrated(const skv_rows *s, int row, bool later, const skv_row_constants *c)
{
    const v8 zero = v8_set(0), rest = v8_set(c->rest_density), floor = v8_set(c->gradient_floor);
    const v8 share = v8_set(c->cohesion_share), push = v8_set(c->push_scale);
    const v8 near_push = v8_set(c->near_push_scale);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 density = collected(s, 0, i), near_density = collected(s, 1, i), squared;
        if (later) {
            /* The gradient of the first iteration serves: it hardly changes, and its sums are a
             * third of the pass. */
            squared = v8_load(s->gradient_squared + i);
        } else {
            v8 gx = collected(s, 2, i), gy = collected(s, 3, i);
            squared = v8_add(v8_mul(gx, gx), v8_mul(gy, gy));
            v8_store(s->gradient_squared + i, squared);
        }
        v8 response = v8_max(v8_add(density, squared), floor);
        v8 excess = v8_sub(density, rest);
        excess = v8_add(v8_max(excess, zero), v8_mul(v8_min(excess, zero), share));
        v8_store(s->push + i, v8_div(v8_mul(push, excess), response));
        v8_store(s->near_push + i, v8_div(v8_mul(near_push, near_density), response));
    }
}

static void pressure_clavet(const skv_rows *s, int row, const skv_row_constants *c)
{
    const v8 one = v8_set(1), rest = v8_set(c->rest_density), limit = v8_set(c->push_limit);
    const v8 push = v8_set(c->push_scale), near_push = v8_set(c->near_push_scale);
    const v8 tiny = v8_set(1e-30f);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 density = collected(s, 0, i);
        v8 n = v8_mul(near_push, collected(s, 1, i));
        v8 strength = v8_max(v8_mul(density, n), tiny);
        v8 scale = v8_min(v8_div(limit, strength), one);
        v8_store(s->push + i, v8_mul(scale, v8_mul(push, v8_sub(density, rest))));
        v8_store(s->near_push + i, v8_mul(scale, n));
    }
}

static int pressure(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                    const skv_row_boundary *boundary, skv_row_thread *thread)
{
    int walls = sample_walls(s, row, !later && !c->clavet, boundary, thread);
    if (c->clavet)
        pressure_clavet(s, row, c);
    else
        pressure_calibrated(s, row, later, c);
    return walls;
}

/* Gauge pressure, summed over the iterations. */
static void gauge(const skv_rows *s, int row, int iteration, const skv_row_constants *c)
{
    const v8 a = v8_set(c->pressure_scale), b = v8_set(c->near_pressure_scale), zero = v8_set(0);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 p = v8_add(v8_mul(a, v8_load(s->push + i)), v8_mul(b, v8_load(s->near_push + i)));
        v8_store(s->pressure + i, v8_add(iteration ? v8_load(s->pressure + i) : zero, p));
    }
}

/* Moves one particle whose way may meet a wall, and changes its velocity by the way it has made. */
static void move_carefully(const skv_rows *s, int i, float dx, float dy,
                           const skv_row_boundary *boundary)
{
    const skv_row_particles *p = &s->set[s->current];
    float made = boundary->move(boundary->context, &p->x[i], &p->y[i], dx, dy, &p->clear[i]);
    p->u[i] += made * dx;
    p->v[i] += made * dy;
}

/* Friction along the wall and push out of it, Algorithm 7. */
static void touch_walls(const skv_rows *s, int row, const skv_row_constants *c,
                        const skv_row_boundary *boundary)
{
    const skv_row_particles *p = &s->set[s->current];
    for (int i = s->row_start[row]; i < s->row_end[row]; i++) {
        if (p->clear[i] >= c->contact_distance)
            continue;
        float nx, ny;
        float depth =
            boundary->contact(boundary->context, p->x[i], p->y[i], &nx, &ny, &p->clear[i]);
        if (!(depth > 0))
            continue;
        /* u, v already hold the whole displacement of the substep. */
        float slide = p->v[i] * nx - p->u[i] * ny;
        float rub = c->friction * slide, push = c->softness * depth;
        move_carefully(s, i, push * nx + rub * ny, push * ny - rub * nx, boundary);
    }
}

V8_INLINE void add_push(const skv_rows *s, int i, const skv_row_wall *wall)
{
    s->own[0][i] += s->push[i] * wall->f1x + s->near_push[i] * wall->f2x;
    s->own[1][i] += s->push[i] * wall->f1y + s->near_push[i] * wall->f2y;
}

/* Adds the walls' push to a row's displacement, from the samples of the pressure pass; where those
 * found no place (count -1) they are taken again. */
static void add_wall_push(const skv_rows *s, int row, const skv_row_boundary *boundary,
                          const skv_near_wall *walls, int count)
{
    const skv_row_particles *p = &s->set[s->current];
    for (int w = 0; w < count; w++)
        add_push(s, walls[w].particle, &walls[w].wall);
    for (int i = s->row_start[row]; count < 0 && i < s->row_end[row]; i++) {
        skv_row_wall wall;
        if (p->clear[i] >= 1)
            continue;
        boundary->walls(boundary->context, p->x[i], p->y[i], &wall);
        add_push(s, i, &wall);
    }
}

/* The displacement that a row's eight particles at i have collected. */
V8_INLINE void collected_move(const skv_rows *s, int i, bool viscous, v8 *dx, v8 *dy)
{
    *dx = collected(s, 0, i);
    *dy = collected(s, 1, i);
    if (viscous) {
        *dx = v8_add(*dx,
                     v8_add(v8_add(v8_load(s->viscous_own[0] + i), v8_load(s->viscous_next[0] + i)),
                            v8_load(s->viscous_sum[0] + i)));
        *dy = v8_add(*dy,
                     v8_add(v8_add(v8_load(s->viscous_own[1] + i), v8_load(s->viscous_next[1] + i)),
                            v8_load(s->viscous_sum[1] + i)));
    }
}

/* Moves the eight particles at i; those whose way may meet a wall one by one. With `speed` the move
 * is a correction and changes the velocity; without, it is the advance. */
V8_INLINE void move_eight(const skv_rows *s, int i, int end, v8 dx, v8 dy, bool speed,
                          const skv_row_constants *c, const skv_row_boundary *boundary)
{
    const skv_row_particles *p = &s->set[s->current];
    v8 length = v8_sqrt(v8_add(v8_mul(dx, dx), v8_mul(dy, dy)));
    v8 clear = v8_sub(v8_load(p->clear + i), v8_mul(v8_set(ROW_WALL_SLOPE), length));
    if (!v8_any_below(clear, v8_set(c->wall_clearance))) {
        v8_store(p->clear + i, clear);
        v8_store(p->x + i, v8_add(v8_load(p->x + i), dx));
        v8_store(p->y + i, v8_add(v8_load(p->y + i), dy));
        if (speed) {
            v8_store(p->u + i, v8_add(v8_load(p->u + i), dx));
            v8_store(p->v + i, v8_add(v8_load(p->v + i), dy));
        }
        return;
    }
    float move_x[ROW_LANES], move_y[ROW_LANES], left[ROW_LANES];
    v8_store(left, clear);
    v8_store(move_x, dx);
    v8_store(move_y, dy);
    for (int l = 0; l < ROW_LANES && i + l < end; l++) {
        int k = i + l;
        float made = 1;
        if (left[l] < c->wall_clearance) {
            made = boundary->move(boundary->context, &p->x[k], &p->y[k], move_x[l], move_y[l],
                                  &p->clear[k]);
        } else {
            p->clear[k] = left[l];
            p->x[k] += move_x[l];
            p->y[k] += move_y[l];
        }
        /* What a wall has cut off the advance leaves the velocity; a correction enters it as far as
         * it was made. */
        float share = speed ? made : made - 1;
        p->u[k] += share * move_x[l];
        p->v[k] += share * move_y[l];
    }
}

static void update(const skv_rows *s, int row, int iteration, const skv_row_constants *c,
                   const skv_row_boundary *boundary, const skv_near_wall *walls, int wall_count)
{
    if (s->gauged)
        gauge(s, row, iteration, c);
    if (wall_count)
        add_wall_push(s, row, boundary, walls, wall_count);
    bool viscous = s->viscous && iteration == 0;
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 dx, dy;
        collected_move(s, i, viscous, &dx, &dy);
        move_eight(s, i, end, dx, dy, true, c, boundary);
    }
    if (iteration == c->iterations - 1)
        touch_walls(s, row, c, boundary);
}

/* A finger's pull on one particle, Algorithm 2 and section 3.5; the same as in forces.c. */
static void pull_towards(const skv_row_particles *p, int i, const skv_row_pull *pull)
{
    float rx = (pull->x - p->x[i]) * pull->inv_radius, ry = (pull->y - p->y[i]) * pull->inv_radius;
    float share = 1 - (rx * rx + ry * ry);
    if (!(share > 0))
        return;
    float fade = share * share, pulled = pull->attraction * fade * (32.0f / 9.0f);
    float slow = pull->friction * fade, carry = pull->follow * fade;
    p->u[i] += pulled * rx - slow * p->u[i] + carry * (pull->vx - p->u[i]);
    p->v[i] += pulled * ry - slow * p->v[i] + carry * (pull->vy - p->v[i]);
}

static void advance(const skv_rows *s, int row, const skv_row_constants *c,
                    const skv_row_boundary *boundary)
{
    const skv_row_particles *p = &s->set[s->current];
    const v8 gx = v8_set(c->gravity_x), gy = v8_set(c->gravity_y), one = v8_set(1);
    const v8 limit = v8_set(c->max_speed), tiny = v8_set(TINY_SQUARED);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8_store(p->u + i, v8_add(v8_load(p->u + i), gx));
        v8_store(p->v + i, v8_add(v8_load(p->v + i), gy));
    }
    for (int f = 0; f < c->pull_count; f++)
        for (int i = s->row_start[row]; i < end; i++)
            pull_towards(p, i, &c->pulls[f]);
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 u = v8_load(p->u + i), v = v8_load(p->v + i);
        v8 speed = v8_sqrt(v8_max(v8_add(v8_mul(u, u), v8_mul(v, v)), tiny));
        v8 scale = v8_min(v8_div(limit, speed), one);
        u = v8_mul(u, scale);
        v = v8_mul(v, scale);
        v8_store(p->u + i, u);
        v8_store(p->v + i, v);
        move_eight(s, i, end, u, v, false, c, boundary);
    }
}

const skv_row_kernels SKV_ROW_KERNELS = {
    V8_NAME, advance, density, pressure, displacement, update,
};
