/* The wall as a line: marching squares on the coverage at one half.
 *
 * Cells lie between four pixel centres; cell (x, y) spans from pixel (x, y) to pixel (x+1, y+1).
 * Where solid pixels touch only at their corners, the cell joins them: a line one pixel wide holds
 * water in every direction.
 */
#ifndef SKV_TERRAIN_CONTOUR_H
#define SKV_TERRAIN_CONTOUR_H

#include "skvalp/terrain.h"

/* A copy of the picture with a rim: solid beyond closed sides, air beyond open ones. */
typedef struct skv_coverage {
    int columns, rows; /* with the rim */
    uint8_t *bytes;
} skv_coverage;

/* A straight piece of wall, in pixels from the rim's lower left pixel centre. */
typedef struct skv_wall_segment {
    float x0, y0, x1, y1;
} skv_wall_segment;

/* Fills the zeroed bytes of a coverage that has the definition's size. */
void skv_coverage_fill(const skv_terrain_def *def, skv_coverage *coverage);

/* Refuses a picture of more than SKV_TERRAIN_MAX_EDGE edges, in one pass over its pixels. */
skv_result skv_coverage_check(const skv_coverage *coverage, skv_error *error);

/* Grey from 128 on is solid; the exact shade only shifts the wall between two pixels. */
static inline bool skv_is_solid(uint8_t byte)
{
    return byte >= 128;
}

/* Where the coverage crosses one half between two pixels of different kind: a fraction of the way
 * from the first to the second, strictly between 0 and 1. */
static inline float skv_crossing(uint8_t from, uint8_t to)
{
    return (127.5f - (float)from) / ((float)to - (float)from);
}

/* Which of the cell's corners are solid: bits 1, 2, 4, 8 counter-clockwise from (x, y). */
unsigned skv_cell_corners(const skv_coverage *coverage, int x, int y);

/* Writes the cell's at most two segments and returns their number. */
int skv_cell_segments(const skv_coverage *coverage, int x, int y, skv_wall_segment segments[2]);

#endif
