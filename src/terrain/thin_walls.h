/* Where walls are so thin that fluid would reach across them.
 *
 * A wall is thin where the way through it along its normal is shorter than 0.6 smoothing radii and
 * the way around it is long. Edges and corners of thick walls are not thin, however short a way
 * cuts them off, nor are the last two radii before an upper end and the last eight before any
 * other free end: under water an end must not part what flows round it.
 */
#ifndef SKV_TERRAIN_THIN_WALLS_H
#define SKV_TERRAIN_THIN_WALLS_H

#include "skvalp/terrain.h"
#include "terrain/squares.h"

/* Cells around the world, on its grid of an eighth of the radius. */
enum { SKV_THIN_MARGIN = 26 };

typedef struct skv_thin_walls {
    float per_metre; /* cells a metre */
    int columns, rows;
    uint8_t *marks; /* columns * rows: 1 where a thin wall is within the radius */
    bool any;       /* a cell is marked */
    uint8_t *found; /* columns * rows: what else is known of the cells, for finding them anew */
} skv_thin_walls;

/* Finds a terrain's thin walls. With `before`, those of a terrain of the same size whose picture
 * differs in the squares `changed` alone, what stays is taken from there: the result is the same.
 * `terrain` and `before` are only read during the call. */
skv_result skv_thin_walls_create(const skv_terrain *terrain, float radius,
                                 const skv_thin_walls *before, const skv_squares *changed,
                                 skv_thin_walls **thin, skv_error *error);
void skv_thin_walls_destroy(skv_thin_walls *thin);

/* True if a thin wall may be within the radius of a point, in m; false where none is within one and
 * a half radii. Any point. */
static inline bool skv_near_thin_wall(const skv_thin_walls *thin, float x, float y)
{
    const float margin = SKV_THIN_MARGIN;
    /* Written so that a NaN ends at 0. */
    float column = x * thin->per_metre + margin, row = y * thin->per_metre + margin;
    column = column > 0 ? column : 0;
    row = row > 0 ? row : 0;
    if (column >= (float)thin->columns || row >= (float)thin->rows)
        return false;
    return thin->marks[(size_t)row * (size_t)thin->columns + (size_t)column];
}

#endif
