/* Wall density maps: what the solid adds to the density sums of a particle near it.
 *
 * For a smoothing radius h and a rest spacing s, with n0 = 1/s^2 and q = 1 - r/h, integrated over
 * the solid around a point: R = n0 * int W, Rn = n0 * int q^3, and the vectors
 * F1 = -(h/gain) grad R and F2 = -(h/3) grad Rn, which are n0 * int F r^ and n0 * int q^2 r^ with
 * r^ pointing away from the solid; W, F and gain are those of the pressure's kernel. R and F1 carry
 * its weight for walls. Stored on a grid of about h/10 and sampled bilinearly; bilinear samples of
 * central differences drive creeping flow, so the vectors are stored, not derived.
 *
 * Walls may also be met by images (terrain/image_distance.h): then a second set of blocks holds the
 * image distance D and its gradient, and what the residual volume has of R and F1.
 */
#ifndef SKV_TERRAIN_WALL_MAP_H
#define SKV_TERRAIN_WALL_MAP_H

#include "base/pool.h"
#include "terrain/thin_walls.h"
#include "terrain/wall_kernel.h"

enum {
    SKV_WALL_BLOCK = 16,                   /* cells a block side, ... */
    SKV_WALL_SAMPLES = SKV_WALL_BLOCK + 1, /* and samples, with the neighbours' first ones */
    SKV_WALL_MARGIN = SKV_WALL_REACH + 2,  /* cells around the picture: h, and two for sampling, so
                                              that everything outside them is uniform */
    SKV_WALL_AIR = -1,
    SKV_WALL_SOLID = -2, /* blocks that are not stored */
    SKV_WALL_FLAT_STEPS = 8,
    SKV_WALL_MOST_BLOCKS = 32768 /* that are stored: 14 kB each with its images, 450 MB, and up to
                                    half a millisecond each to make */
};

/* Nearer to a thin wall than so many cells samples are not mixed; a table serves instead. */
#define SKV_WALL_KEEP_OFF 1.5

/* What a block of images holds, in the order of skv_image_sample. */
enum { SKV_IMAGE_DISTANCE, SKV_IMAGE_NX, SKV_IMAGE_NY, SKV_IMAGE_R, SKV_IMAGE_F1X, SKV_IMAGE_F1Y };

typedef struct skv_wall_block {
    float samples[SKV_WALL_SAMPLES][SKV_WALL_SAMPLES][SKV_WALL_MAPS];
} skv_wall_block;

/* Plain data, so that whoever needs a sample in the middle of a loop can read it in place. */
typedef struct skv_wall_map {
    double radius; /* m */
    skv_kernel pressure;
    double density;    /* particles in a square radius */
    float per_metre;   /* cells a metre */
    int columns, rows; /* blocks */
    int32_t *index;    /* columns * rows: a stored block, or one of those that are not */
    skv_wall_block *blocks;
    skv_wall_block *images; /* of the same numbers; null: they have not been asked for */
    size_t count, room;     /* blocks numbered so far, and that there is memory for */
    int32_t *spare;         /* numbers that were given back */
    size_t spare_count;
    skv_wall_kernel kernel;
    const skv_thin_walls *thin; /* null: there are none */
    skv_thin_walls *found;      /* what is known of them; null: they have not been looked for */
    /* R, Rn, F1 and F2 beside a flat wall, from touching it to KEEP_OFF, against those there. */
    float flat[SKV_WALL_FLAT_STEPS + 1][4];
} skv_wall_map;

/* The six values at one point; all zero farther than h from any wall. */
typedef struct skv_wall_sample {
    float r, rn;    /* R, Rn: dimensionless */
    float f1x, f1y; /* F1: dimensionless */
    float f2x, f2y; /* F2: dimensionless */
} skv_wall_sample;

/* What images need at one point. */
typedef struct skv_image_sample {
    float distance; /* D, in h: 1 farther than h from any wall, 0 deep inside solid */
    float nx, ny;   /* h grad D: about a unit vector out of the wall */
    float r;        /* R less what images give in a uniform fluid: dimensionless */
    float f1x, f1y; /* F1 likewise */
} skv_image_sample;

/* Fails as making a map would if walls are so long, or h so small, that there were too many blocks;
 * costs next to nothing. `terrain` is only read during the call. */
skv_result skv_wall_map_check(const skv_terrain *terrain, float radius, skv_error *error);

/* Builds the maps of a terrain for one h, s and kernel. `terrain` is only read during the call. */
skv_result skv_wall_map_create(const skv_terrain *terrain, float radius, float spacing,
                               skv_kernel pressure, skv_pool *pool, skv_wall_map **map,
                               skv_error *error);
void skv_wall_map_destroy(skv_wall_map *map);

/* Finds the thin walls of the map's terrain. Near them the sums then run over everything that a
 * point cannot see, the fluid behind the wall included: pairs are cut there, so the wall must stand
 * for all that they would have given. Once for a map; on failure it stays as it was. */
skv_result skv_wall_map_shade(skv_wall_map *map, const skv_terrain *terrain, skv_pool *pool,
                              skv_error *error);

/* Adds what images need to a map for the smooth kernel, after shading. Once for a map; on failure
 * it stays as it was. */
skv_result skv_wall_map_add_images(skv_wall_map *map, const skv_terrain *terrain, skv_pool *pool,
                                   skv_error *error);

/* Makes a map, what is known of thin walls, and its images if it has them, those of another terrain
 * of the same size, whose picture differs in the squares `changed` alone: bit for bit what they
 * would be if they were made for it. On failure nothing has changed. */
skv_result skv_wall_map_update(skv_wall_map *map, const skv_terrain *before,
                               const skv_terrain *terrain, const skv_squares *changed,
                               skv_pool *pool, skv_error *error);

/* Bytes held, for reports. */
size_t skv_wall_map_bytes(const skv_wall_map *map);

/* True if a thin wall may be within h of a point: there alone pairs must be asked whether they see
 * each other. */
static inline bool skv_wall_map_near_thin(const skv_wall_map *map, float x, float y)
{
    return map->thin && skv_near_thin_wall(map->thin, x, y);
}

/* The sample left of or below a coordinate, kept inside the map. NaN ends at 0. */
static inline float skv_wall_keep_inside(float g, int blocks)
{
    float high = (float)(blocks * SKV_WALL_BLOCK);
    g = g > 0 ? g : 0;
    return g < high ? g : high;
}

/* Where a point lies between a block's samples: beyond sample (i, j) by (u, v), each 0..1. */
typedef struct skv_wall_place {
    int i, j;
    float u, v;
} skv_wall_place;

/* Finds a point's block, and the place there if it is stored. Any finite point. */
static inline int32_t skv_wall_find(const skv_wall_map *map, float x, float y,
                                    skv_wall_place *place)
{
    float gx = skv_wall_keep_inside(x * map->per_metre + (SKV_WALL_MARGIN - 0.5f), map->columns);
    float gy = skv_wall_keep_inside(y * map->per_metre + (SKV_WALL_MARGIN - 0.5f), map->rows);
    int i = (int)gx, j = (int)gy;
    i -= i == map->columns * SKV_WALL_BLOCK;
    j -= j == map->rows * SKV_WALL_BLOCK;
    unsigned column = (unsigned)i / SKV_WALL_BLOCK, row = (unsigned)j / SKV_WALL_BLOCK;
    int32_t number = map->index[(size_t)row * (size_t)map->columns + (size_t)column];
    if (number < 0)
        return number;
    *place = (skv_wall_place){(int)((unsigned)i % SKV_WALL_BLOCK),
                              (int)((unsigned)j % SKV_WALL_BLOCK), gx - (float)i, gy - (float)j};
    return number;
}

/* True only if no wall is within h of a point. Any finite point. */
static inline bool skv_wall_map_is_clear(const skv_wall_map *map, float x, float y)
{
    skv_wall_place place;
    return skv_wall_find(map, x, y, &place) == SKV_WALL_AIR;
}

/* A block's values there, bilinear. */
static inline void skv_wall_mix(const skv_wall_block *b, const skv_wall_place *place,
                                float values[SKV_WALL_MAPS])
{
    const int i = place->i, j = place->j;
    const float *low0 = b->samples[j][i], *low1 = b->samples[j][i + 1];
    const float *high0 = b->samples[j + 1][i], *high1 = b->samples[j + 1][i + 1];
    for (int k = 0; k < SKV_WALL_MAPS; k++) {
        float low = low0[k] + place->u * (low1[k] - low0[k]);
        float high = high0[k] + place->u * (high1[k] - high0[k]);
        values[k] = low + place->v * (high - low);
    }
}

/* Samples the maps. Returns false, with zeros, where no wall is within h. Any finite point. */
static inline bool skv_wall_map_sample(const skv_wall_map *map, float x, float y,
                                       skv_wall_sample *sample)
{
    *sample = (skv_wall_sample){0};
    skv_wall_place place;
    int32_t number = skv_wall_find(map, x, y, &place);
    if (number == SKV_WALL_AIR)
        return false;
    if (number < 0) {
        sample->r = map->kernel.full[SKV_WALL_R];
        sample->rn = map->kernel.full[SKV_WALL_RN];
        return true;
    }
    float values[SKV_WALL_MAPS];
    skv_wall_mix(&map->blocks[number], &place, values);
    *sample = (skv_wall_sample){
        .r = values[SKV_WALL_R],
        .rn = values[SKV_WALL_RN],
        .f1x = values[SKV_WALL_F1X],
        .f1y = values[SKV_WALL_F1Y],
        .f2x = values[SKV_WALL_F2X],
        .f2y = values[SKV_WALL_F2Y],
    };
    return values[SKV_WALL_R] > 0;
}

/* Samples the maps near a thin wall, for a point at `distance` from a wall with the normal (nx,
 * ny). Samples on the other side of the wall must not be mixed in, so nearer than one and a half
 * cells the sums are those at that distance, scaled as beside a flat wall. */
static inline bool skv_wall_map_sample_beside(const skv_wall_map *map, float x, float y,
                                              float distance, float nx, float ny,
                                              skv_wall_sample *sample)
{
    float cells = distance * map->per_metre, missing = (float)SKV_WALL_KEEP_OFF - cells;
    if (!(missing > 0))
        return skv_wall_map_sample(map, x, y, sample);
    float shift = missing / map->per_metre;
    bool any = skv_wall_map_sample(map, x + shift * nx, y + shift * ny, sample);
    float place = cells > 0 ? cells * (float)(SKV_WALL_FLAT_STEPS / SKV_WALL_KEEP_OFF) : 0;
    int i = place < SKV_WALL_FLAT_STEPS - 1 ? (int)place : SKV_WALL_FLAT_STEPS - 1;
    float ratio[4], part = place - (float)i;
    for (int k = 0; k < 4; k++)
        ratio[k] = map->flat[i][k] + part * (map->flat[i + 1][k] - map->flat[i][k]);
    sample->r *= ratio[0];
    sample->rn *= ratio[1];
    sample->f1x *= ratio[2];
    sample->f1y *= ratio[2];
    sample->f2x *= ratio[3];
    sample->f2y *= ratio[3];
    return any;
}

/* Samples the images of a map that has them. Any finite point. */
static inline void skv_wall_map_sample_image(const skv_wall_map *map, float x, float y,
                                             skv_image_sample *image)
{
    skv_wall_place place;
    int32_t number = skv_wall_find(map, x, y, &place);
    if (number < 0) {
        *image = (skv_image_sample){.distance = number == SKV_WALL_AIR ? 1 : 0};
        return;
    }
    float values[SKV_WALL_MAPS];
    skv_wall_mix(&map->images[number], &place, values);
    *image = (skv_image_sample){
        .distance = values[SKV_IMAGE_DISTANCE],
        .nx = values[SKV_IMAGE_NX],
        .ny = values[SKV_IMAGE_NY],
        .r = values[SKV_IMAGE_R],
        .f1x = values[SKV_IMAGE_F1X],
        .f1y = values[SKV_IMAGE_F1Y],
    };
}

/* The same near a thin wall, for a point at `distance` from a wall with the normal (nx, ny): nearer
 * than one and a half cells as at that distance, but for D, which is less by the way there. */
static inline void skv_wall_map_sample_image_beside(const skv_wall_map *map, float x, float y,
                                                    float distance, float nx, float ny,
                                                    skv_image_sample *image)
{
    float missing = (float)SKV_WALL_KEEP_OFF - distance * map->per_metre;
    missing = missing > 0 ? missing : 0;
    float shift = missing / map->per_metre;
    skv_wall_map_sample_image(map, x + shift * nx, y + shift * ny, image);
    float left = image->distance - missing / SKV_WALL_REACH;
    image->distance = left > 0 ? left : 0;
}

#endif
