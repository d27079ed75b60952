/* Updating wall maps: after an edit of the terrain the blocks near it are built anew.
 *
 * A block's sums depend on the solid shares of cells within h; where it is shaded they depend on
 * how far rays see. So three things make a sample another one: walls that have changed within h of
 * it, a thin wall's mark that has come or gone, and near a thin wall distances that have changed
 * within sight. Images depend besides on the blocks around theirs. Invariant: whatever can fail is
 * done first; then nothing fails, and every block is what it would be if the map were made for the
 * terrain.
 */
#include "base/assert.h"
#include "base/memory.h"
#include "terrain/wall_build.h"

#include <math.h>
#include <string.h>

enum { BLOCK = SKV_WALL_BLOCK, SAMPLES = SKV_WALL_SAMPLES };

typedef struct update {
    skv_wall_builder b;
    const skv_terrain *before;
    const skv_squares *changed; /* of the picture */
    skv_squares seen;           /* where distances have changed, as far as rays tell them apart */
    double sight;               /* how far rays go, pixels, with what interpolation mixes in */
    skv_thin_walls *former, *found; /* thin walls before, and now; null: not looked for */
    skv_shadow_rays rays;
    size_t *blocks; /* those to be looked at: their places in the index ... */
    int32_t *was;   /* ... and what stood there */
    int count;
    size_t *images; /* places of the blocks whose images are made anew; null: there are none */
    int image_count;
} update;

/* Finds squares in which a distance has changed. Rays go on by 0.9 of a distance until they have
 * gone a radius, so what is farther than that does not matter; two pixels for interpolation. */
static skv_result find_seen(update *u, skv_error *error)
{
    const skv_terrain *old = u->before, *new = u->b.terrain;
    const float far = (float)(1.2 * u->b.map->radius + 2 * (double)new->pixel_size);
    skv_squares reached;
    skv_result result = skv_squares_spread(u->changed, SKV_TERRAIN_REACH + 2, &reached, error);
    for (int y = 0; y < new->rows &&result == SKV_OK; y++) {
        for (int x = 0; x < new->columns; x++) {
            if (!skv_squares_meet(&reached, x, y, x, y)) {
                x |= SKV_SQUARE - 1;
                continue;
            }
            size_t at = (size_t)y * (size_t)new->columns + (size_t)x;
            if (skv_clamp(old->field[at], -far, far) != skv_clamp(new->field[at], -far, far))
                skv_squares_add(&u->seen, x, y);
        }
    }
    skv_squares_destroy(&reached);
    return result;
}

/* Whether a set has a square within `reach` pixels of the cells from (x0, y0) to (x1, y1). */
static bool is_near(const update *u, const skv_squares *set, int x0, int y0, int x1, int y1,
                    double reach)
{
    const double cell = u->b.cell;
    const double shift = (0.5 - SKV_WALL_MARGIN) * cell + SKV_TERRAIN_RIM - 0.5;
    return skv_squares_meet(set, x0 * cell + shift - reach, y0 * cell + shift - reach,
                            x1 * cell + shift + reach, y1 * cell + shift + reach);
}

/* Whether solid shares of the cells around block (x, y) may have changed: those of cells that a
 * wall passes through. */
static bool is_reshaped(const update *u, int x, int y)
{
    int x0 = x * BLOCK - SKV_WALL_REACH, y0 = y * BLOCK - SKV_WALL_REACH;
    return is_near(u, u->changed, x0, y0, x0 + SKV_WALL_WINDOW, y0 + SKV_WALL_WINDOW,
                   (double)skv_wall_clear_distance(u->b.cell) + 4);
}

static bool is_marked(const skv_thin_walls *thin, float x, float y)
{
    return thin && thin->any && skv_near_thin_wall(thin, x, y);
}

/* Whether a mark of a thin wall has come or gone at a sample of block (x, y). */
static bool is_remarked(const update *u, int x, int y)
{
    if (!u->found || !(u->found->any || u->former->any))
        return false;
    for (int j = 0; j < SAMPLES; j++) {
        for (int i = 0; i < SAMPLES; i++) {
            float sx = skv_wall_sample_place(u->b.map, x * BLOCK + i);
            float sy = skv_wall_sample_place(u->b.map, y * BLOCK + j);
            if (is_marked(u->former, sx, sy) != is_marked(u->found, sx, sy))
                return true;
        }
    }
    return false;
}

/* Whether rays of samples of block (x, y) may see another thing. */
static bool is_reseen(const update *u, int x, int y)
{
    return u->found && u->found->any &&
           is_near(u, &u->seen, x * BLOCK, y * BLOCK, x * BLOCK + BLOCK, y * BLOCK + BLOCK,
                   u->sight);
}

/* Lists the blocks that may change, and makes room for those that a wall may be near now. */
static skv_result list_blocks(update *u, skv_error *error)
{
    skv_wall_map *map = u->b.map;
    size_t needed = map->count;
    for (int y = 0; y < map->rows; y++) {
        for (int x = 0; x < map->columns; x++) {
            size_t at = (size_t)y * (size_t)map->columns + (size_t)x;
            if (!is_reshaped(u, x, y) &&
                (map->index[at] < 0 || !(is_reseen(u, x, y) || is_remarked(u, x, y))))
                continue;
            u->blocks[u->count++] = at;
            needed += map->index[at] < 0;
        }
    }
    if (needed <= map->room)
        return SKV_OK;
    size_t more = needed + map->room / 2, most = SKV_WALL_MOST_BLOCKS;
    return skv_wall_reserve_blocks(map, more > most && needed <= most ? most : more, error);
}

/* Lists the blocks whose images may change: those listed and all beside them. Images reach a radius
 * and three cells beyond their block, which is less than a block. What is so near and has changed,
 * be it a share, a distance, a sight or a mark, has made the block a listed one that it lies in. */
static void list_images(update *u)
{
    const size_t columns = (size_t)u->b.map->columns, rows = (size_t)u->b.map->rows;
    for (int k = 0; k < u->count; k++) {
        size_t column = u->blocks[k] % columns, row = u->blocks[k] / columns;
        for (size_t y = row > 0 ? row - 1 : 0; y <= row + 1 && y < rows; y++) {
            for (size_t x = column > 0 ? column - 1 : 0; x <= column + 1 && x < columns; x++)
                u->images[y * columns + x] = 1;
        }
    }
    /* From marks to a list, in place: this never overtakes the marks. */
    for (size_t at = 0; at < columns * rows; at++) {
        if (u->images[at])
            u->images[u->image_count++] = at;
    }
}

/* All that can fail. */
static skv_result prepare(update *u, skv_error *error)
{
    const skv_wall_map *map = u->b.map;
    const skv_terrain *terrain = u->b.terrain;
    size_t blocks = (size_t)map->columns * (size_t)map->rows;
    u->blocks = skv_calloc(blocks, sizeof *u->blocks);
    u->was = skv_calloc(blocks, sizeof *u->was);
    skv_result result = SKV_OK;
    if (map->images)
        u->images = skv_calloc(blocks, sizeof *u->images);
    if (!u->blocks || !u->was || (map->images && !u->images))
        result = skv_fail(error, SKV_ERROR_MEMORY, "walls: no memory for %zu blocks", blocks);
    if (result == SKV_OK && u->former)
        result = skv_thin_walls_create(terrain, (float)map->radius, u->former, u->changed,
                                       &u->found, error);
    if (result == SKV_OK)
        result = skv_squares_create(terrain->columns, terrain->rows, &u->seen, error);
    if (result == SKV_OK && u->found && u->found->any)
        result = find_seen(u, error);
    if (result == SKV_OK)
        result = list_blocks(u, error);
    if (result == SKV_OK && u->images)
        list_images(u);
    return result;
}

/* Gives the listed blocks their new places. */
static void place_blocks(update *u)
{
    skv_wall_map *map = u->b.map;
    for (int k = 0; k < u->count; k++) {
        size_t at = u->blocks[k], columns = (size_t)map->columns;
        int32_t was = map->index[at];
        int kind = skv_wall_sort_block(&u->b, (int)(at % columns), (int)(at / columns));
        u->was[k] = was;
        if (kind != 0) {
            map->index[at] = kind;
            if (was >= 0)
                map->spare[map->spare_count++] = was;
        } else if (was < 0) {
            map->index[at] =
                map->spare_count > 0 ? map->spare[--map->spare_count] : (int32_t)map->count++;
        }
    }
}

/* Shades block (x, y) where that is needed; elsewhere `old`, if there is one, holds what is still
 * right. */
static void shade_block(const update *u, int x, int y, const skv_wall_block *old,
                        skv_wall_block *made)
{
    const skv_wall_map *map = u->b.map;
    const skv_terrain *terrain = u->b.terrain;
    for (int j = 0; j < SAMPLES; j++) {
        for (int i = 0; i < SAMPLES; i++) {
            int column = x * BLOCK + i, row = y * BLOCK + j;
            float sx = skv_wall_sample_place(map, column), sy = skv_wall_sample_place(map, row);
            if (!skv_wall_is_shaded(map->thin, terrain, sx, sy))
                continue;
            double sights[SKV_SHADOW_RAYS];
            bool stays = old && is_marked(u->former, sx, sy) &&
                         !is_near(u, &u->seen, column, row, column, row, u->sight);
            if (stays)
                memcpy(made->samples[j][i], old->samples[j][i], sizeof made->samples[j][i]);
            else
                skv_wall_shade_sample(map, terrain, &u->rays, sx, sy, sights, made->samples[j][i]);
        }
    }
}

static void build_blocks(int begin, int end, void *context)
{
    const update *u = context;
    const skv_wall_map *map = u->b.map;
    for (int k = begin; k < end; k++) {
        int x = (int)(u->blocks[k] % (size_t)map->columns);
        int y = (int)(u->blocks[k] / (size_t)map->columns);
        int32_t number = map->index[u->blocks[k]];
        if (number < 0)
            continue;
        skv_wall_block *block = &map->blocks[number];
        const skv_wall_block old = *block;
        bool known = u->was[k] >= 0;
        if (!known || is_reshaped(u, x, y) || is_remarked(u, x, y))
            skv_wall_build_block(&u->b, x, y, block);
        if (map->thin)
            shade_block(u, x, y, known ? &old : NULL, block);
    }
}

skv_result skv_wall_map_update(skv_wall_map *map, const skv_terrain *before,
                               const skv_terrain *terrain, const skv_squares *changed,
                               skv_pool *pool, skv_error *error)
{
    SKV_ASSERT_OR(map && before && terrain && changed, SKV_ERROR_VALUE);
    update u = {
        .b = skv_wall_builder_of(map, terrain, map->radius),
        .before = before,
        .changed = changed,
        .sight = map->radius * (double)terrain->per_metre + 3,
        .former = map->found,
    };
    skv_result result = prepare(&u, error);
    if (result == SKV_OK) {
        place_blocks(&u);
        skv_shadow_rays_make(&u.rays);
        if (u.found)
            skv_wall_take_found(map, u.found, &u.rays);
        skv_pool_run(pool, u.count, build_blocks, &u);
        if (map->images)
            skv_wall_build_images(&u.b, u.images, u.image_count, pool);
        skv_thin_walls_destroy(u.former);
    } else {
        skv_thin_walls_destroy(u.found);
    }
    skv_squares_destroy(&u.seen);
    skv_free(u.blocks);
    skv_free(u.was);
    skv_free(u.images);
    return result;
}
