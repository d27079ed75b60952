/* A world cut into square tiles of 2 h, which sleep and load look at. Invariant: every place has a
 * tile; what lies outside belongs to the border's. */
#ifndef SKV_WORLD_TILING_H
#define SKV_WORLD_TILING_H

#define SKV_TILE_SIZE 2.0f /* h */

typedef struct skv_tiling {
    int columns, rows;
    float per_metre; /* tiles */
} skv_tiling;

static inline skv_tiling skv_make_tiling(float h, float width, float height)
{
    float per_metre = 1 / (SKV_TILE_SIZE * h);
    return (skv_tiling){(int)(width * per_metre) + 1, (int)(height * per_metre) + 1, per_metre};
}

/* A coordinate's column or row, of `tiles`. The comparisons catch a NaN. */
static inline int skv_tile_at(float position, float per_metre, int tiles)
{
    float place = position * per_metre;
    if (!(place > 0))
        return 0;
    return place < (float)tiles ? (int)place : tiles - 1;
}

/* The number of a place's tile, row by row. */
static inline int skv_tile_number(const skv_tiling *tiling, float x, float y)
{
    return skv_tile_at(y, tiling->per_metre, tiling->rows) * tiling->columns +
           skv_tile_at(x, tiling->per_metre, tiling->columns);
}

static inline int skv_tile_count(const skv_tiling *tiling)
{
    return tiling->columns * tiling->rows;
}

#endif
