/* Tiles of the pair passes: four particles that are computed beside each other, what is known of
 * them and the sums that they collect; and the variants of the loops over them. Included by
 * the headers of the pair passes alone. Invariant: sums over a tile, and over lanes, are added up
 * in the order of the particles.
 */
#ifndef SKV_ROW_TILES_H
#define SKV_ROW_TILES_H

#include "base/simd_wide.h"
#include "solver/rows/rows_internal.h"

#define TILE ROW_TILE
/* A tile's particles lie in so many `wide`s: particle k in number k % WIDES, part k / WIDES. */
#define WIDES    (TILE / WIDE_PARTS)
#define WIDE_LEN (WIDE_PARTS * PART_LEN)
/* Pairs of a tile with a part of its partners. */
#define PART_PAIRS (TILE * PART_LEN)
/* The pair loops are inlined into each of their variants and unrolled over the tile. The scalar
 * build, which is for checking and not for speed, does without: it would take compilers minutes. */
#if defined(SKV_SIMD_SCALAR)
#define VARIANT         static __attribute__((noinline))
#define EACH(k)         for (int k = 0; k < WIDES; k++)
#define EACH_PART(n)    for (int n = 0; n < PARTS; n++)
#define EACH_OF_TILE(k) for (int k = 0; k < TILE; k++)
#else
#define VARIANT         V8_INLINE
#define EACH(k)         _Pragma("GCC unroll 8") for (int k = 0; k < WIDES; k++)
#define EACH_PART(n)    _Pragma("GCC unroll 2") for (int n = 0; n < PARTS; n++)
#define EACH_OF_TILE(k) _Pragma("GCC unroll 4") for (int k = 0; k < TILE; k++)
#endif

/* Compile-time variants of the pair loops. SMOOTH: the kernel of model/kernel.h, else the spiky
 * one. WITH_GRADIENT: the density sums up the gradient, and the displacement has the tension that
 * evens it out; both know the smooth kernel's alone. WITH_VISCOSITY: the displacement has that of
 * pairs that approach. WITH_GAUGE: it sums up what the gauge pressure follows from as well: the
 * virial. WITH_IMAGES: walls act by images, and beside them it sums up what these push outward.
 * WITH_MASSES: the density sums up the lightness of the partners, too, and viscosity is that of
 * both particles of a pair. */
enum {
    SMOOTH = 1,
    WITH_GRADIENT = 2,
    WITH_VISCOSITY = 4,
    KEEP_PAIRS = 8,
    WITH_GAUGE = 16,
    WITH_IMAGES = 32,
    WITH_MASSES = 64
};

/* Whether all that substeps are often made of has loops of its own. In the page the rarer part of
 * it makes do with one function that looks while it runs, and with calls, which makes it smaller.
 */
#if defined(__wasm__) || defined(SKV_SIMD_SCALAR)
#define FULL_VARIANTS 0
#define RARE          static __attribute__((noinline))
#else
#define FULL_VARIANTS 1
#define RARE          VARIANT
#endif

/* Where the four particles of a tile are, each in all lanes. */
typedef struct tile {
    wide x[WIDES], y[WIDES];
    float pair_lag, lag_rise;   /* of skv_constants */
    int place;                  /* of the first */
    const skv_boundary *beside; /* a thin wall, which may part pairs; null: none is near */
    const float *images;        /* of all particles, by place */
} tile;

/* What the density needs of them besides: how far it looks ahead of its own particles' places, and
 * of those of all, by place; with masses how light they are. */
typedef struct look {
    wide x[WIDES], y[WIDES], lightness[WIDES];
    const float *all_x, *all_y, *all_lightness;
} look;

/* Whether one of flags from..to is set. The last is looked at first: most often it tells. */
V8_INLINE bool any_between(const bool *flag, int from, int to)
{
    if (flag[to])
        return true;
    while (from < to && !flag[from])
        from++;
    return from < to;
}

/* Whether a tile or one of its partners has a flag, which `size` places share: of all that lie in
 * the very blocks that the loops compute. The first is there even if it has no partner, and what
 * lies behind the last partner may have come near since the sort. */
static __attribute__((noinline)) bool any_flag(const skv_rows *s, int i, const bool *flag, int size)
{
    int own_end = s->own_end[i / TILE] > i + 1 ? s->own_end[i / TILE] : i + 2;
    int next_begin = s->next_begin[i / TILE], next_end = s->next_end[i / TILE];
    return any_between(flag, i / size, (own_end + ROW_LANES - 2) / size) ||
           (next_begin < next_end &&
            any_between(flag, next_begin / size, (next_end + ROW_LANES - 2) / size));
}

/* What the displacement needs of them besides. */
typedef struct pushes {
    wide lambda[WIDES], near_lambda[WIDES], gradient_x[WIDES], gradient_y[WIDES];
    wide u[WIDES], v[WIDES];
} pushes;

/* The sums for the tile's own particles, over the same part of all partners. */
typedef struct density_sums {
    wide density[WIDES], near_density[WIDES], gradient_x[WIDES], gradient_y[WIDES];
    wide lightness[WIDES];
} density_sums;
typedef struct move_sums {
    wide x[WIDES], y[WIDES], outward[WIDES];
} move_sums;

V8_INLINE void add_at(float *p, eight_part a)
{
    part_store(p, part_add(part_load(p), a));
}

/* Adds up a tile's contributions to the partners, in the order of the tile. */
V8_INLINE eight_part over_tile(const wide *a)
{
    wide first = wide_add(a[0], a[1]);
    eight_part second =
        WIDE_PARTS == 2 ? wide_part(first, 1) : wide_part(wide_add(a[2 % WIDES], a[3 % WIDES]), 0);
    return part_add(wide_part(first, 0), second);
}

/* Particle k's eight lanes of a quantity, of its first and its last part. */
V8_INLINE v8 lanes_of(const wide *first, const wide *last, int k)
{
    return eight_of(wide_part(first[k % WIDES], k / WIDES), wide_part(last[k % WIDES], k / WIDES));
}

/* The same added up, for each of the tile's particles in their order. */
V8_INLINE void sum_lanes(float to[TILE], const wide *first, const wide *last)
{
    v8_sum4(lanes_of(first, last, 0), lanes_of(first, last, 1), lanes_of(first, last, 2),
            lanes_of(first, last, 3), to);
}

/* What a tile's particles have collected, to be added to what they have collected as partners of
 * the tiles before; no later tile of the row adds to that. It is added a tile later, when what was
 * stored there has left the processor: a load that waited for it cost 3 to 5 %. */
typedef struct tile_sums {
    int place;    /* of the tile's first particle; -1: there is none yet */
    bool more;    /* than two sums: gradients, or the displacement's outward or virial */
    bool massive; /* there is the last one, of lightness */
    float sum[ROW_SUMS][TILE];
} tile_sums;

V8_INLINE void add_tile(float *to, const float sum[TILE])
{
    EACH_OF_TILE(k) to[k] += sum[k];
}

#endif
