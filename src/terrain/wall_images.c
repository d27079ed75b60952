/* Images: the distances at which walls mirror a particle, and what is left of the wall sums when
 * the images of a uniform fluid are taken off.
 *
 * Beside a flat wall little is left. In corners, at edges and behind thin walls images lie wrong; a
 * sample's rest is its R less the sum of the images' W over the map's own cells, each as far as it
 * is free. Next to a wall and inside it sums would be of no use, yet sampling touches samples
 * there, so these hold the rest of a place a little off the wall, without the push across it.
 * Invariant: what a block's images are depends on the blocks around it alone, and on walls, marks
 * and sights as far as a radius and three cells.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "base/simd.h"
#include "terrain/image_distance.h"
#include "terrain/wall_build.h"

#include <math.h>
#include <string.h>

enum {
    BLOCK = SKV_WALL_BLOCK,
    SAMPLES = SKV_WALL_SAMPLES,
    REACH = SKV_WALL_REACH,
    RAYS = SKV_SHADOW_RAYS,
    QUARTER = RAYS / 4, /* of a turn */
    LANES = 8,
    SPAN = 2 * REACH + 2, /* cells a side that a place between samples may have within h ... */
    WIDTH = 24,           /* ... and in a row, rounded up for whole vectors */
    SHIFT = 3,            /* cells, at most, to the place off the wall */
    LOW = REACH + SHIFT,  /* cells of a window before the block's first sample */
    ROWS = SAMPLES + SHIFT - 1 + SPAN - 1 + SHIFT,
    COLUMNS = 48
};

/* In cells: how near to a wall the rest is taken as it is, and how deep in the solid there is one.
 */
#define OFF_WALL 0.5f
#define DEEPEST  2.5f

/* The cells around a block. */
typedef struct window {
    float distance[ROWS][COLUMNS]; /* D */
    float free[ROWS][COLUMNS];     /* the free shares */
    float least[ROWS];             /* of the D of each row's cells that are not solid */
} window;

/* Where a cell lies for the rays of a place: behind which ray, how far on to the next, and how far
 * away, in cells. */
typedef struct bearing {
    int ray;
    float part, way;
} bearing;

typedef struct images {
    skv_wall_builder b;
    skv_image_law law, seen_law; /* for sums over cells, and along rays */
    skv_shadow_rays rays;
    bearing bearings[SPAN][WIDTH]; /* of samples */
    const size_t *blocks;
    bool measured; /* all of their distances */
} images;

/* A place whose rest is wanted: beyond a sample of the block by less than a cell. */
typedef struct place {
    int column, row;
    float u, v;
    float x, y;     /* m */
    float image[3]; /* D and its gradient, as in a block of images */
    float wall[SKV_WALL_MAPS];
    const float *nearness; /* of what it sees along its rays, which alone counts; null: all does */
} place;

/* D and its gradient, by R and F1. */
static void find_distance(const images *m, bool seen, const float *wall, float *image)
{
    const double full = (double)m->b.map->kernel.full[SKV_WALL_R];
    const skv_image_law *law = seen ? &m->seen_law : &m->law;
    double slope, d = skv_image_distance(law, (double)wall[SKV_WALL_R] / full, &slope);
    double gain = slope * SKV_SMOOTH_GAIN / full;
    image[SKV_IMAGE_DISTANCE] = (float)d;
    image[SKV_IMAGE_NX] = (float)(gain * (double)wall[SKV_WALL_F1X]);
    image[SKV_IMAGE_NY] = (float)(gain * (double)wall[SKV_WALL_F1Y]);
}

/* The same inside a thin wall, whose R is that of the wall alone while what lies before it takes
 * all behind its face for solid: as behind a flat wall's face. */
static void find_depth(const images *m, float x, float y, float *values)
{
    float nx, ny, depth = -skv_normal_at(m->b.terrain, x, y, &nx, &ny) * m->b.map->per_metre;
    double fall, slope;
    depth = skv_clamp(depth, 0, DEEPEST);
    double share = 1 - skv_image_share(&m->seen_law, (double)(depth / REACH), &fall);
    values[SKV_IMAGE_DISTANCE] = (float)skv_image_distance(&m->seen_law, share, &slope);
    values[SKV_IMAGE_NX] = (float)(slope * fall) * nx;
    values[SKV_IMAGE_NY] = (float)(slope * fall) * ny;
}

/* Writes the distances of block (x, y). */
static void measure_block(const images *m, int x, int y, int32_t number)
{
    const skv_wall_map *map = m->b.map;
    for (int j = 0; j < SAMPLES; j++) {
        for (int i = 0; i < SAMPLES; i++) {
            const float *wall = map->blocks[number].samples[j][i];
            float *image = map->images[number].samples[j][i];
            float sx = skv_wall_sample_place(map, x * BLOCK + i);
            float sy = skv_wall_sample_place(map, y * BLOCK + j);
            bool seen = skv_wall_map_near_thin(map, sx, sy);
            if (seen && !(skv_distance_at(m->b.terrain, sx, sy) > 0))
                find_depth(m, sx, sy, image);
            else
                find_distance(m, seen, wall, image);
        }
    }
}

/* The block along one axis that has a cell, and the cell's place there; beyond the map it is as at
 * its rim. */
static int block_of(int cell, int blocks, int *inside)
{
    cell = cell > 0 ? cell : 0;
    cell = cell < blocks * BLOCK ? cell : blocks * BLOCK;
    int block = cell / BLOCK < blocks ? cell / BLOCK : blocks - 1;
    *inside = cell - block * BLOCK;
    return block;
}

/* Collects the cells around block (x, y). */
static void fill_window(const images *m, int x, int y, window *w)
{
    const skv_wall_map *map = m->b.map;
    memset(w, 0, sizeof *w);
    for (int j = 0; j < ROWS; j++) {
        int row = y * BLOCK + j - LOW, inside_y;
        const int32_t *index =
            map->index + (size_t)block_of(row, map->rows, &inside_y) * (size_t)map->columns;
        w->least[j] = 1;
        for (int i = 0; i < ROWS; i++) {
            int column = x * BLOCK + i - LOW, inside_x;
            int32_t number = index[block_of(column, map->columns, &inside_x)];
            if (number == SKV_WALL_SOLID)
                continue;
            w->distance[j][i] = 1;
            w->free[j][i] = 1;
            if (number == SKV_WALL_AIR)
                continue;
            w->distance[j][i] = map->images[number].samples[inside_y][inside_x][SKV_IMAGE_DISTANCE];
            w->free[j][i] = 1 - skv_wall_solid_share(&m->b, column, row);
            if (w->free[j][i] > 0)
                w->least[j] = skv_minf(w->least[j], w->distance[j][i]);
        }
    }
}

/* The ray behind a direction, and how far on it lies to the next: 0..1. */
static int find_ray(const skv_shadow_rays *rays, double x, double y, double *part)
{
    double sum = fabs(x) + fabs(y), turn = sum > 0 ? y / sum : 0;
    /* In quarters, about. */
    turn = x < 0 ? 2 - turn : y < 0 ? 4 + turn : turn;
    int a = (int)(turn * QUARTER) % RAYS, b;
    while (rays->x[a] * y - rays->y[a] * x < 0)
        a = (a + RAYS - 1) % RAYS;
    for (;; a = b) {
        b = (a + 1) % RAYS;
        double past = rays->x[a] * y - rays->y[a] * x, missing = x * rays->y[b] - y * rays->x[b];
        if (missing > 0 || !(past > 0)) {
            *part = past > 0 ? past / (past + missing) : 0;
            return a;
        }
    }
}

static bearing take_bearing(const skv_shadow_rays *rays, double x, double y)
{
    double part;
    int ray = find_ray(rays, x, y, &part);
    return (bearing){ray, (float)part, (float)sqrt(x * x + y * y)};
}

/* The reciprocals of a place's sights, which beside a flat wall change evenly from ray to ray, and
 * its wall sums if `values` is not null. */
static void look_around(const images *m, const place *p, float nearness[RAYS + 1], float *values)
{
    const double least = 0.01; /* of a cell: a reciprocal is to be had */
    double sights[RAYS];
    skv_wall_shade_sample(m->b.map, m->b.terrain, &m->rays, p->x, p->y, sights, values);
    for (int i = 0; i < RAYS; i++)
        nearness[i] = (float)(1 / skv_max(sights[i] / m->b.cell, least));
    nearness[RAYS] = nearness[0];
}

/* Finds the free shares of LANES cells from cell (i, j) on, of those that a place sees; 0 where
 * r'^2, the square, tells that they are not felt. */
static void see_cells(const images *m, const place *p, int i, int j, const float *free,
                      const float square[LANES], float seen[LANES])
{
    for (int lane = 0; lane < LANES; lane++, i++) {
        seen[lane] = 0;
        if (!(free[lane] > 0) || square[lane] >= 1)
            continue;
        bearing at = m->bearings[j][i];
        if (p->u != 0 || p->v != 0)
            at = take_bearing(&m->rays, i - REACH - (double)p->u, j - REACH - (double)p->v);
        const float *ray = p->nearness + at.ray;
        float sight = 1 / (ray[0] + at.part * (ray[1] - ray[0]));
        seen[lane] = skv_minf(free[lane], skv_maxf(0.5f + sight - at.way, 0));
    }
}

/* What images give in a uniform fluid: sums over cells. */
typedef struct sums {
    float density[LANES];
    float x[LANES], y[LANES], mirror[LANES]; /* of pushes: along r, and across the mirror */
} sums;

/* Adds LANES cells from cell (i, j) on, if one of them is felt; `x` and `y` are the ways there, in
 * radii. The push F over r' is q^2. */
static void add_cells(const images *m, const window *w, const place *p, int i, int j,
                      const float *x, float y, sums *s)
{
    const float *distance = &w->distance[p->row + SHIFT + j][p->column + SHIFT + i];
    const float *free = &w->free[p->row + SHIFT + j][p->column + SHIFT + i];
    const v8 zero = v8_set(0), one = v8_set(1);
    float square[LANES], seen[LANES], q[LANES], near = 4 * p->image[SKV_IMAGE_DISTANCE];
    for (int lane = 0; lane < LANES; lane++)
        square[lane] = x[lane] * x[lane] + y * y + near * distance[lane];
    v8 squares = v8_load(square);
    if (!v8_any_below(squares, one) || !v8_any_below(zero, v8_load(free)))
        return;
    if (p->nearness) {
        see_cells(m, p, i, j, free, square, seen);
        free = seen;
    }
    v8_store(q, v8_max(v8_sub(one, v8_sqrt(squares)), zero));
    /* Unrolled before it is made vectors of, it would become none. */
    _Pragma("GCC unroll 1") for (int lane = 0; lane < LANES; lane++)
    {
        float push = free[lane] * (q[lane] * q[lane]);
        s->density[lane] += push * (q[lane] * (SKV_SMOOTH_CUBES - SKV_SMOOTH_QUARTICS * q[lane]));
        s->x[lane] -= push * x[lane];
        s->y[lane] -= push * y;
        s->mirror[lane] += push * distance[lane];
    }
}

static float total(const float lanes[LANES])
{
    float sum = 0;
    for (int lane = 0; lane < LANES; lane++)
        sum += lanes[lane];
    return sum;
}

/* Writes what is left of the wall sums at a place. */
static void find_rest(const images *m, const window *w, const place *p, float *image)
{
    const float cell = 1.0f / REACH;
    float x[WIDTH];
    for (int i = 0; i < WIDTH; i++)
        x[i] = ((float)(i - REACH) - p->u) * cell;
    sums s = {0};
    for (int j = 0; j < SPAN; j++) {
        float y = ((float)(j - REACH) - p->v) * cell;
        bool felt = y * y + 4 * p->image[SKV_IMAGE_DISTANCE] * w->least[p->row + SHIFT + j] < 1;
        for (int i = 0; felt && i < WIDTH; i += LANES)
            add_cells(m, w, p, i, j, x + i, y, &s);
    }
    float each = (float)m->b.map->density * (cell * cell), mirror = 2 * total(s.mirror);
    image[SKV_IMAGE_R] = p->wall[SKV_WALL_R] - each * total(s.density);
    image[SKV_IMAGE_F1X] =
        p->wall[SKV_WALL_F1X] - each * (total(s.x) + mirror * p->image[SKV_IMAGE_NX]);
    image[SKV_IMAGE_F1Y] =
        p->wall[SKV_WALL_F1Y] - each * (total(s.y) + mirror * p->image[SKV_IMAGE_NY]);
}

/* Moves a place that is `missing` cells too near to a wall, or behind its face, away from it. */
static void keep_off(const images *m, float missing, float nx, float ny, place *p)
{
    const skv_wall_map *map = m->b.map;
    const float most = SHIFT;
    float shift = missing / map->per_metre;
    p->x += shift * nx;
    p->y += shift * ny;
    float u = skv_clamp(missing * nx, -most, most), v = skv_clamp(missing * ny, -most, most);
    /* Rounded down: the cell that is left of the place and below. */
    int i = (int)(u + most) - SHIFT, j = (int)(v + most) - SHIFT;
    i = i < SHIFT ? i : SHIFT - 1;
    j = j < SHIFT ? j : SHIFT - 1;
    p->column += i;
    p->row += j;
    p->u = u - (float)i;
    p->v = v - (float)j;
}

/* Writes the rest of sample (i, j) of a block at (x, y). */
static void finish_sample(const images *m, const window *w, int x, int y, int i, int j,
                          const float *wall, float *image)
{
    const skv_wall_map *map = m->b.map;
    image[SKV_IMAGE_R] = image[SKV_IMAGE_F1X] = image[SKV_IMAGE_F1Y] = 0;
    if (!(wall[SKV_WALL_R] > 0))
        return;
    place p = {
        .column = i,
        .row = j,
        .x = skv_wall_sample_place(map, x * BLOCK + i),
        .y = skv_wall_sample_place(map, y * BLOCK + j),
    };
    memcpy(p.image, image, sizeof p.image);
    memcpy(p.wall, wall, sizeof p.wall);
    float nx, ny, off = skv_normal_at(m->b.terrain, p.x, p.y, &nx, &ny) * map->per_metre;
    if (off < -DEEPEST)
        return;
    bool kept_off = off < OFF_WALL;
    if (kept_off)
        keep_off(m, OFF_WALL - off, nx, ny, &p);
    float nearness[RAYS + 1];
    if (skv_wall_map_near_thin(map, p.x, p.y)) {
        look_around(m, &p, nearness, kept_off ? p.wall : NULL);
        p.nearness = nearness;
    } else if (kept_off) {
        skv_wall_sample found;
        _Static_assert(sizeof found == sizeof p.wall &&
                           offsetof(skv_wall_sample, f1x) == SKV_WALL_F1X * sizeof *p.wall,
                       "a sample lies as the maps do");
        skv_wall_map_sample(map, p.x, p.y, &found);
        memcpy(p.wall, &found, sizeof p.wall);
    }
    if (kept_off)
        find_distance(m, p.nearness != NULL, p.wall, p.image);
    find_rest(m, w, &p, image);
    if (kept_off) {
        /* R is the same up to the wall, so across it has no slope: a push there would be none of an
         * energy, and what is pressed into a corner would be heated by it. */
        float across = image[SKV_IMAGE_F1X] * nx + image[SKV_IMAGE_F1Y] * ny;
        image[SKV_IMAGE_F1X] -= across * nx;
        image[SKV_IMAGE_F1Y] -= across * ny;
    }
}

/* Writes the rests of block (x, y). */
static void finish_block(const images *m, int x, int y, int32_t number)
{
    const skv_wall_map *map = m->b.map;
    window w;
    fill_window(m, x, y, &w);
    for (int j = 0; j < SAMPLES; j++) {
        for (int i = 0; i < SAMPLES; i++)
            finish_sample(m, &w, x, y, i, j, map->blocks[number].samples[j][i],
                          map->images[number].samples[j][i]);
    }
}

static void build_blocks(int begin, int end, void *context)
{
    const images *m = context;
    const skv_wall_map *map = m->b.map;
    for (int k = begin; k < end; k++) {
        size_t at = m->blocks[k], columns = (size_t)map->columns;
        int32_t number = map->index[at];
        if (number >= 0)
            (m->measured ? finish_block : measure_block)(m, (int)(at % columns),
                                                         (int)(at / columns), number);
    }
}

void skv_wall_build_images(const skv_wall_builder *b, const size_t *blocks, int count,
                           skv_pool *pool)
{
    images m = {.b = *b, .blocks = blocks};
    skv_image_law_make(true, &m.law);
    skv_image_law_make(false, &m.seen_law);
    if (b->map->thin) {
        skv_shadow_rays_make(&m.rays);
        for (int j = 0; j < SPAN; j++)
            for (int i = 0; i < WIDTH; i++)
                m.bearings[j][i] = take_bearing(&m.rays, i - REACH, j - REACH);
    }
    /* All distances first: rests ask the neighbours for theirs. */
    skv_pool_run(pool, count, build_blocks, &m);
    m.measured = true;
    skv_pool_run(pool, count, build_blocks, &m);
}

skv_result skv_wall_map_add_images(skv_wall_map *map, const skv_terrain *terrain, skv_pool *pool,
                                   skv_error *error)
{
    SKV_ASSERT_OR(map && terrain && !map->images && map->pressure == SKV_KERNEL_SMOOTH,
                  SKV_ERROR_VALUE);
    skv_wall_block *made = skv_calloc(map->room, sizeof *made);
    size_t *blocks = skv_calloc(map->count, sizeof *blocks);
    if (!made || !blocks) {
        skv_free(made);
        skv_free(blocks);
        return skv_fail(error, SKV_ERROR_MEMORY, "walls: no memory for the images of %zu blocks",
                        map->count);
    }
    int count = 0;
    for (size_t at = 0; at < (size_t)map->columns * (size_t)map->rows; at++) {
        if (map->index[at] >= 0)
            blocks[count++] = at;
    }
    map->images = made;
    skv_wall_builder b = skv_wall_builder_of(map, terrain, map->radius);
    skv_wall_build_images(&b, blocks, count, pool);
    skv_free(blocks);
    return SKV_OK;
}
