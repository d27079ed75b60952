/* Wall density maps: solid share of the map's cells, convolved with the kernels, in sparse blocks.
 *
 * The map's cells are a tenth of h wide whatever the pixels are; a cell's solid share is the mean
 * over points a pixel apart of what the signed distance says, so a flat grey wall is as solid as a
 * white one. Samples sit in the cells' middles. Only blocks that have a wall within h are stored,
 * each with the first samples of its neighbours, so that sampling needs one block. Invariant: a
 * block not stored is uniform: all its samples are 0, or all are those deep inside solid.
 */
#include "terrain/wall_build.h"

#include "base/assert.h"
#include "base/memory.h"
#include "terrain/sample.h"

#include <math.h>
#include <string.h>

/* Cells a block side needs for its convolution, rounded up for whole vectors. */
#define WINDOW     SKV_WALL_WINDOW
#define LANES      4
#define ROW_LENGTH (WINDOW + LANES)

enum {
    BLOCK = SKV_WALL_BLOCK,
    SAMPLES = SKV_WALL_SAMPLES,
    MARGIN = SKV_WALL_MARGIN,
    FLAT_STEPS = SKV_WALL_FLAT_STEPS
};

/* The solid shares of the cells around a block. */
typedef struct window {
    float share[WINDOW][ROW_LENGTH];
    float least[WINDOW];   /* of each row */
    uint64_t some[WINDOW]; /* bits: of each row the cells that are not air */
} window;

/* Distance in pixels at a point given in cells. */
static float distance_at(const skv_wall_builder *b, double x, double y)
{
    const double shift = (double)SKV_TERRAIN_RIM - 0.5;
    float gx = (float)((x - MARGIN) * b->cell + shift);
    float gy = (float)((y - MARGIN) * b->cell + shift);
    return skv_grid_distance(b->terrain, gx, gy) * b->terrain->per_metre;
}

/* The solid share of a small square at this distance, both in pixels. What rounding leaves of
 * nothing or takes from everything is dropped, so that uniform rows are recognised. */
static float solid_share_at(float distance, float side)
{
    const float least = 1e-5f;
    float share = 0.5f - distance / side;
    return share <= least ? 0 : share >= 1 - least ? 1 : share;
}

float skv_wall_solid_share(const skv_wall_builder *b, int x, int y)
{
    float middle = distance_at(b, x + 0.5, y + 0.5), clear = skv_wall_clear_distance(b->cell);
    if (middle >= clear)
        return 0;
    if (middle <= -clear)
        return 1;
    int parts = (int)ceil(b->cell);
    if (parts == 1)
        return solid_share_at(middle, (float)b->cell);
    double step = 1.0 / parts;
    float side = (float)(b->cell * step), sum = 0;
    for (int j = 0; j < parts; j++) {
        for (int i = 0; i < parts; i++)
            sum += solid_share_at(distance_at(b, x + (i + 0.5) * step, y + (j + 0.5) * step), side);
    }
    return sum / (float)(parts * parts);
}

/* Sorts a square of cells: SKV_WALL_AIR, SKV_WALL_SOLID, or 0 where a wall may pass through it.
 * Halves the square until it is about a cell wide. */
static int sort_square(const skv_wall_builder *b, double x, double y, double side)
{
    float middle = distance_at(b, x + 0.5 * side, y + 0.5 * side);
    float clear = skv_wall_clear_distance(side * b->cell);
    if (middle >= clear)
        return SKV_WALL_AIR;
    if (middle <= -clear)
        return SKV_WALL_SOLID;
    if (side < 2)
        return 0;
    double half = 0.5 * side;
    int kind = sort_square(b, x, y, half);
    if (kind == 0 || sort_square(b, x + half, y, half) != kind ||
        sort_square(b, x, y + half, half) != kind ||
        sort_square(b, x + half, y + half, half) != kind)
        return 0;
    return kind;
}

/* Fills the window of a block; `kept` is how many columns it holds already. */
static void fill_window(const skv_wall_builder *b, int x0, int y0, int kept, window *w)
{
    for (int y = 0; y < WINDOW; y++) {
        float least = 1;
        uint64_t some = 0;
        for (int x = 0; x < WINDOW; x++) {
            if (x >= kept)
                w->share[y][x] = skv_wall_solid_share(b, x0 + x, y0 + y);
            float share = w->share[y][x];
            least = share < least ? share : least;
            some |= (uint64_t)(share > 0) << x;
        }
        for (int x = WINDOW; x < ROW_LENGTH; x++)
            w->share[y][x] = 0;
        w->least[y] = least;
        w->some[y] = some;
    }
}

/* Adds one row of cells, weighed by one row of the kernel, to LANES samples beside each other, of
 * which the first is in line with cell `at`. The kernel's even weights meet sums of the cells to
 * the left and right of a sample, its odd ones differences; those of air add nothing. */
static void add_row(const window *w, int row, int at, const float weight[][SKV_WALL_MAPS],
                    int half_width, float sums[SKV_WALL_MAPS][LANES])
{
    const uint64_t each = (1 << LANES) - 1, some = w->some[row];
    const float *cells = w->share[row] + at;
    for (int lane = 0; lane < LANES; lane++) {
        sums[SKV_WALL_R][lane] += weight[0][SKV_WALL_R] * cells[lane];
        sums[SKV_WALL_RN][lane] += weight[0][SKV_WALL_RN] * cells[lane];
        sums[SKV_WALL_F1Y][lane] += weight[0][SKV_WALL_F1Y] * cells[lane];
        sums[SKV_WALL_F2Y][lane] += weight[0][SKV_WALL_F2Y] * cells[lane];
    }
    for (int x = 1; x <= half_width; x++) {
        const float *v = weight[x];
        if (!((some >> (at + x) | some >> (at - x)) & each))
            continue;
        for (int lane = 0; lane < LANES; lane++) {
            float sum = cells[lane + x] + cells[lane - x];
            float difference = cells[lane + x] - cells[lane - x];
            sums[SKV_WALL_R][lane] += v[SKV_WALL_R] * sum;
            sums[SKV_WALL_RN][lane] += v[SKV_WALL_RN] * sum;
            sums[SKV_WALL_F1X][lane] += v[SKV_WALL_F1X] * difference;
            sums[SKV_WALL_F1Y][lane] += v[SKV_WALL_F1Y] * sum;
            sums[SKV_WALL_F2X][lane] += v[SKV_WALL_F2X] * difference;
            sums[SKV_WALL_F2Y][lane] += v[SKV_WALL_F2Y] * sum;
        }
    }
}

/* Convolves a block; air is left out, rows of solid are constants. */
static void fill_block(const skv_wall_kernel *kernel, const window *w, skv_wall_block *made)
{
    for (int y = 0; y < SAMPLES; y++) {
        for (int x0 = 0; x0 < SAMPLES; x0 += LANES) {
            float sums[SKV_WALL_MAPS][LANES] = {0};
            for (int j = 0; j < SKV_WALL_SPAN; j++) {
                int row = y + j;
                if (!w->some[row])
                    continue;
                if (w->least[row] < 1) {
                    add_row(w, row, x0 + SKV_WALL_REACH, kernel->weight[j], kernel->half_width[j],
                            sums);
                    continue;
                }
                for (int k = 0; k < SKV_WALL_MAPS; k++) {
                    for (int lane = 0; lane < LANES; lane++)
                        sums[k][lane] += kernel->row_sum[j][k];
                }
            }
            for (int lane = 0; lane < LANES && x0 + lane < SAMPLES; lane++) {
                for (int k = 0; k < SKV_WALL_MAPS; k++)
                    made->samples[y][x0 + lane][k] = sums[k][lane];
            }
        }
    }
}

int skv_wall_sort_block(const skv_wall_builder *b, int x, int y)
{
    return sort_square(b, x * BLOCK - SKV_WALL_REACH, y * BLOCK - SKV_WALL_REACH, WINDOW);
}

/* Numbers the blocks that a wall is near. */
static void sort_blocks(const skv_wall_builder *b)
{
    skv_wall_map *map = b->map;
    int32_t count = 0;
    for (int y = 0; y < map->rows; y++) {
        for (int x = 0; x < map->columns; x++) {
            int kind = skv_wall_sort_block(b, x, y);
            map->index[(size_t)y * (size_t)map->columns + (size_t)x] = kind ? kind : count++;
        }
    }
    map->count = (size_t)count;
}

static void build_block(const skv_wall_builder *b, int x, int y, int kept, window *w,
                        skv_wall_block *made)
{
    fill_window(b, x * BLOCK - SKV_WALL_REACH, y * BLOCK - SKV_WALL_REACH, kept, w);
    fill_block(&b->map->kernel, w, made);
}

void skv_wall_build_block(const skv_wall_builder *b, int x, int y, skv_wall_block *made)
{
    window w;
    build_block(b, x, y, 0, &w, made);
}

/* Leaves those of a window's columns that the block to the right of it needs, too; says how many.
 */
static int keep_columns(window *w)
{
    for (int y = 0; y < WINDOW; y++)
        memmove(w->share[y], w->share[y] + BLOCK, (WINDOW - BLOCK) * sizeof w->share[y][0]);
    return WINDOW - BLOCK;
}

/* Those of some rows. */
static void build_blocks(int begin, int end, void *context)
{
    const skv_wall_builder *b = context;
    const skv_wall_map *map = b->map;
    window w;
    for (int y = begin; y < end; y++) {
        int kept = 0;
        for (int x = 0; x < map->columns; x++) {
            int32_t number = map->index[(size_t)y * (size_t)map->columns + (size_t)x];
            if (number >= 0)
                build_block(b, x, y, kept, &w, &map->blocks[number]);
            kept = number >= 0 ? keep_columns(&w) : 0;
        }
    }
}

static skv_result fail_many(double h, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_LIMIT,
                    "its walls are too fine for a fluid with a radius of %.3g mm: they take more "
                    "than %d blocks; choose fewer particles or a wider spacing, or shorter walls",
                    1000 * h, SKV_WALL_MOST_BLOCKS);
}

skv_result skv_wall_reserve_blocks(skv_wall_map *map, size_t room, skv_error *error)
{
    if (room <= map->room && map->blocks)
        return SKV_OK;
    if (room > SKV_WALL_MOST_BLOCKS)
        return fail_many(map->radius, error);
    skv_wall_block *blocks = skv_calloc(room, sizeof *blocks);
    skv_wall_block *images = map->images ? skv_calloc(room, sizeof *images) : NULL;
    int32_t *spare = skv_calloc(room, sizeof *spare);
    if (!blocks || !spare || (map->images && !images)) {
        skv_free(blocks);
        skv_free(images);
        skv_free(spare);
        return skv_fail(error, SKV_ERROR_MEMORY,
                        "walls: no memory for %zu blocks; a wider spacing needs fewer", room);
    }
    if (map->blocks)
        memcpy(blocks, map->blocks, map->count * sizeof *blocks);
    if (images)
        memcpy(images, map->images, map->count * sizeof *images);
    if (map->spare)
        memcpy(spare, map->spare, map->spare_count * sizeof *spare);
    skv_free(map->blocks);
    skv_free(map->images);
    skv_free(map->spare);
    map->blocks = blocks;
    map->images = images;
    map->spare = spare;
    map->room = room;
    return SKV_OK;
}

/* Writes how many blocks a map has along its sides. */
static skv_result count_along(const skv_wall_builder *b, double h, int *columns, int *rows,
                              skv_error *error)
{
    const skv_terrain *terrain = b->terrain;
    double along_x = ceil((ceil(terrain->width / b->cell) + 2 * MARGIN) / BLOCK);
    double along_y = ceil((ceil(terrain->height / b->cell) + 2 * MARGIN) / BLOCK);
    if (along_x * along_y > INT32_MAX)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "wall map: a radius of %g m is too small for a world of %g x %g m", h,
                        (double)skv_terrain_width(terrain), (double)skv_terrain_height(terrain));
    *columns = (int)along_x;
    *rows = (int)along_y;
    return SKV_OK;
}

skv_result skv_wall_map_check(const skv_terrain *terrain, float radius, skv_error *error)
{
    const skv_wall_builder b = skv_wall_builder_of(NULL, terrain, (double)radius);
    int columns = 0, rows = 0, count = 0;
    skv_result result = count_along(&b, (double)radius, &columns, &rows, error);
    for (int y = 0; result == SKV_OK && y < rows; y++) {
        for (int x = 0; x < columns; x++)
            count += skv_wall_sort_block(&b, x, y) == 0;
        if (count > SKV_WALL_MOST_BLOCKS)
            result = fail_many((double)radius, error);
    }
    return result;
}

skv_result skv_wall_map_create(const skv_terrain *terrain, float radius, float spacing,
                               skv_kernel pressure, skv_pool *pool, skv_wall_map **map,
                               skv_error *error)
{
    SKV_ASSERT_OR(map, SKV_ERROR_VALUE);
    *map = NULL;
    SKV_ASSERT_OR(terrain, SKV_ERROR_VALUE);
    double h = (double)radius, s = (double)spacing;
    if (!(h > 0 && h <= 1e6 && s > 0 && s <= h))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "wall map: radius %g m and spacing %g m; 0 < spacing <= radius is needed",
                        h, s);
    skv_wall_builder b = skv_wall_builder_of(NULL, terrain, h);
    int columns, rows;
    skv_result result = count_along(&b, h, &columns, &rows, error);
    if (result != SKV_OK)
        return result;
    skv_wall_map *made = skv_calloc(1, sizeof *made);
    int32_t *index = skv_calloc((size_t)columns * (size_t)rows, sizeof *index);
    if (!made || !index) {
        skv_free(made);
        skv_free(index);
        return skv_fail(error, SKV_ERROR_MEMORY,
                        "walls: no memory for %d x %d blocks; a wider spacing needs fewer", columns,
                        rows);
    }
    *made = (skv_wall_map){
        .radius = h,
        .pressure = pressure,
        .density = h / s * (h / s),
        .per_metre = (float)(SKV_WALL_REACH / h),
        .columns = columns,
        .rows = rows,
        .index = index,
    };
    b.map = made;
    skv_wall_kernel_make(pressure, made->density, &made->kernel);
    sort_blocks(&b);
    result = skv_wall_reserve_blocks(made, made->count, error);
    if (result != SKV_OK) {
        skv_wall_map_destroy(made);
        return result;
    }
    skv_pool_run(pool, rows, build_blocks, &b);
    *map = made;
    return SKV_OK;
}

void skv_wall_map_destroy(skv_wall_map *map)
{
    if (!map)
        return;
    skv_thin_walls_destroy(map->found);
    skv_free(map->index);
    skv_free(map->blocks);
    skv_free(map->images);
    skv_free(map->spare);
    skv_free(map);
}

size_t skv_wall_map_bytes(const skv_wall_map *map)
{
    SKV_ASSERT_OR(map, 0);
    size_t block = sizeof *map->blocks + (map->images ? sizeof *map->images : 0);
    return sizeof *map + (size_t)map->columns * (size_t)map->rows * sizeof *map->index +
           map->room * (block + sizeof *map->spare);
}

/* The table for points too near to a thin wall. */
static void tabulate_flat(skv_wall_map *map, const skv_shadow_rays *rays)
{
    float at[FLAT_STEPS + 1][SKV_WALL_MAPS];
    const int maps[4] = {SKV_WALL_R, SKV_WALL_RN, SKV_WALL_F1X, SKV_WALL_F2X};
    for (int i = 0; i <= FLAT_STEPS; i++)
        skv_shadow_of_plane(rays, map->pressure,
                            SKV_WALL_KEEP_OFF / SKV_WALL_REACH * i / FLAT_STEPS, map->density,
                            at[i]);
    for (int i = 0; i <= FLAT_STEPS; i++) {
        for (int k = 0; k < 4; k++)
            map->flat[i][k] = at[i][maps[k]] / at[FLAT_STEPS][maps[k]];
    }
}

void skv_wall_take_found(skv_wall_map *map, skv_thin_walls *found, const skv_shadow_rays *rays)
{
    map->found = found;
    map->thin = found->any ? found : NULL;
    if (map->thin)
        tabulate_flat(map, rays);
}

void skv_wall_shade_sample(const skv_wall_map *map, const skv_terrain *terrain,
                           const skv_shadow_rays *rays, float x, float y,
                           double sights[SKV_SHADOW_RAYS], float *values)
{
    skv_shadow_at(rays, map->pressure, terrain, skv_to_grid(terrain, x), skv_to_grid(terrain, y),
                  map->radius * (double)terrain->per_metre, map->density, sights, values);
}

/* What shading needs. */
typedef struct shading {
    const skv_wall_map *map;
    const skv_terrain *terrain;
    skv_shadow_rays rays;
} shading;

/* Replaces the samples of block (x, y) that lie in the air near a thin wall. */
static void shade_block(const shading *s, int x, int y, skv_wall_block *b)
{
    for (int j = 0; j < SAMPLES; j++) {
        for (int i = 0; i < SAMPLES; i++) {
            float sx = skv_wall_sample_place(s->map, x * BLOCK + i),
                  sy = skv_wall_sample_place(s->map, y * BLOCK + j);
            double sights[SKV_SHADOW_RAYS];
            if (skv_wall_is_shaded(s->map->thin, s->terrain, sx, sy))
                skv_wall_shade_sample(s->map, s->terrain, &s->rays, sx, sy, sights,
                                      b->samples[j][i]);
        }
    }
}

/* The same for all blocks of some rows. */
static void shade_blocks(int begin, int end, void *context)
{
    const shading *s = context;
    for (int y = begin; y < end; y++) {
        for (int x = 0; x < s->map->columns; x++) {
            int32_t number = s->map->index[(size_t)y * (size_t)s->map->columns + (size_t)x];
            if (number >= 0)
                shade_block(s, x, y, &s->map->blocks[number]);
        }
    }
}

skv_result skv_wall_map_shade(skv_wall_map *map, const skv_terrain *terrain, skv_pool *pool,
                              skv_error *error)
{
    SKV_ASSERT_OR(map && terrain && !map->found && !map->images, SKV_ERROR_VALUE);
    skv_thin_walls *found;
    skv_result result =
        skv_thin_walls_create(terrain, (float)map->radius, NULL, NULL, &found, error);
    if (result != SKV_OK)
        return result;
    shading s = {.map = map, .terrain = terrain};
    skv_shadow_rays_make(&s.rays);
    skv_wall_take_found(map, found, &s.rays);
    if (map->thin)
        skv_pool_run(pool, map->rows, shade_blocks, &s);
    return SKV_OK;
}
