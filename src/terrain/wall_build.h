/* Building wall maps: what making one anew and updating one share. */
#ifndef SKV_TERRAIN_WALL_BUILD_H
#define SKV_TERRAIN_WALL_BUILD_H

#include "terrain/sample.h"
#include "terrain/wall_map.h"
#include "terrain/wall_shadow.h"

/* Cells a block side needs for its convolution. */
#define SKV_WALL_WINDOW (SKV_WALL_SAMPLES + 2 * SKV_WALL_REACH)

/* What building needs. */
typedef struct skv_wall_builder {
    skv_wall_map *map;
    const skv_terrain *terrain;
    double cell; /* a cell's side in pixels */
} skv_wall_builder;

static inline skv_wall_builder skv_wall_builder_of(skv_wall_map *map, const skv_terrain *terrain,
                                                   double radius)
{
    return (skv_wall_builder){map, terrain,
                              radius / ((double)terrain->pixel_size * SKV_WALL_REACH)};
}

/* Beyond this distance from its middle, in pixels, no wall passes through a square. Half a pixel
 * for what interpolation between pixel centres may smooth away. */
static inline float skv_wall_clear_distance(double side)
{
    return (float)(0.7072 * side + 0.5);
}

/* What becomes of block (x, y): SKV_WALL_AIR, SKV_WALL_SOLID, or 0 where a wall is near. */
int skv_wall_sort_block(const skv_wall_builder *b, int x, int y);

/* The solid share of cell (x, y). */
float skv_wall_solid_share(const skv_wall_builder *b, int x, int y);

/* Fills block (x, y), but for what stands beside thin walls. */
void skv_wall_build_block(const skv_wall_builder *b, int x, int y, skv_wall_block *made);

/* Makes room for so many blocks; nothing changes on failure. */
skv_result skv_wall_reserve_blocks(skv_wall_map *map, size_t room, skv_error *error);

/* Makes the images of the blocks at these places of the index, those of them that are stored, from
 * what all blocks hold. Their distances are written first, those of others are taken as they are.
 */
void skv_wall_build_images(const skv_wall_builder *b, const size_t *blocks, int count,
                           skv_pool *pool);

/* Takes over what has been found of thin walls, for a map that holds nothing of the kind. */
void skv_wall_take_found(skv_wall_map *map, skv_thin_walls *found, const skv_shadow_rays *rays);

/* A sample's place, in metres, by its cell. */
static inline float skv_wall_sample_place(const skv_wall_map *map, int cell)
{
    return (float)((cell + 0.5 - SKV_WALL_MARGIN) * (map->radius / SKV_WALL_REACH));
}

/* True where a sample stands for what a point cannot see: in the air near a thin wall. `thin` may
 * be null. */
static inline bool skv_wall_is_shaded(const skv_thin_walls *thin, const skv_terrain *terrain,
                                      float x, float y)
{
    return thin && skv_near_thin_wall(thin, x, y) && skv_distance_at(terrain, x, y) > 0;
}

/* Finds how far such a sample, at a place in metres, sees along each ray, in pixels, and writes
 * what it is if `values` is not null. */
void skv_wall_shade_sample(const skv_wall_map *map, const skv_terrain *terrain,
                           const skv_shadow_rays *rays, float x, float y,
                           double sights[SKV_SHADOW_RAYS], float *values);

#endif
