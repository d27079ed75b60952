/* Distance to the contour by propagating the nearest cell.
 *
 * Every pixel holds the contour cell that is nearest so far and the exact distance to its
 * segments. Two sweeps over the picture (up, then down; each row also from left to right and from
 * right to left) offer each pixel its eight neighbours' cells: a vector distance transform, in
 * time proportional to the pixels. Invariant: a held distance is the distance to real segments, so
 * it is never too small, and neighbours' distances differ by at most their spacing.
 */
#include "terrain/distance.h"

#include "base/exact.h"
#include "base/memory.h"
#include "terrain/terrain.h"

#include <float.h>
#include <math.h>

/* No segment of a cell is nearer than the cell's centre less half the cell's diagonal. */
#define HALF_DIAGONAL 0.70711f

#define NO_CELL UINT32_MAX

typedef struct transform {
    const skv_coverage *coverage;
    float *field;      /* pixels, unsigned while the sweeps run */
    uint32_t *nearest; /* cell y << 16 | cell x */
} transform;

static float squared_distance(const skv_wall_segment *s, float x, float y)
{
    float ux = s->x1 - s->x0, uy = s->y1 - s->y0;
    float px = x - s->x0, py = y - s->y0;
    float along = px * ux + py * uy, square = ux * ux + uy * uy;
    /* A segment may be shorter than float can tell; then its start serves. */
    float t = along <= 0 || square <= 0 ? 0 : along >= square ? 1 : along / square;
    float dx = px - t * ux, dy = py - t * uy;
    return dx * dx + dy * dy;
}

/* Offers pixel (x, y), element `at`, the contour of `cell`. */
static inline void offer(const transform *t, size_t at, int x, int y, uint32_t cell)
{
    if (cell == t->nearest[at] || cell == NO_CELL)
        return;
    int cx = (int)(cell & 0xffff), cy = (int)(cell >> 16);
    float ex = (float)(x - cx) - 0.5f, ey = (float)(y - cy) - 0.5f;
    float bound = t->field[at] + HALF_DIAGONAL;
    if (ex * ex + ey * ey >= bound * bound)
        return;
    skv_wall_segment segments[2];
    int count = skv_cell_segments(t->coverage, cx, cy, segments);
    float square = squared_distance(&segments[0], (float)x, (float)y);
    if (count == 2)
        square = skv_minf(square, squared_distance(&segments[1], (float)x, (float)y));
    float distance = sqrtf(square);
    if (distance < t->field[at]) {
        t->field[at] = distance;
        t->nearest[at] = cell;
    }
}

/* Gives every contour cell to the pixels at its corners. Returns whether there is any. */
static bool seed(const transform *t)
{
    int columns = t->coverage->columns, rows = t->coverage->rows;
    size_t pixels = (size_t)columns * (size_t)rows;
    for (size_t i = 0; i < pixels; i++) {
        t->field[i] = FLT_MAX;
        t->nearest[i] = NO_CELL;
    }
    bool any = false;
    for (int y = 0; y + 1 < rows; y++) {
        for (int x = 0; x + 1 < columns; x++) {
            unsigned corners = skv_cell_corners(t->coverage, x, y);
            if (corners == 0 || corners == 15)
                continue;
            any = true;
            uint32_t cell = (uint32_t)y << 16 | (uint32_t)x;
            size_t at = (size_t)y * (size_t)columns + (size_t)x;
            offer(t, at, x, y, cell);
            offer(t, at + 1, x + 1, y, cell);
            offer(t, at + (size_t)columns, x, y + 1, cell);
            offer(t, at + (size_t)columns + 1, x + 1, y + 1, cell);
        }
    }
    return any;
}

/* Offers row y what row `from` beside it holds, then passes offers along the row, both ways. */
static void sweep_row(const transform *t, int y, int from)
{
    int columns = t->coverage->columns;
    size_t row = (size_t)y * (size_t)columns, beside = (size_t)from * (size_t)columns;
    for (int x = 0; x < columns; x++) {
        size_t at = row + (size_t)x, next = beside + (size_t)x;
        offer(t, at, x, y, t->nearest[next]);
        if (x + 1 < columns)
            offer(t, at, x, y, t->nearest[next + 1]);
        if (x > 0) {
            offer(t, at, x, y, t->nearest[next - 1]);
            offer(t, at, x, y, t->nearest[at - 1]);
        }
    }
    for (int x = columns - 2; x >= 0; x--)
        offer(t, row + (size_t)x, x, y, t->nearest[row + (size_t)x + 1]);
}

skv_result skv_distance_transform(const skv_coverage *coverage, float pixel_size, float *field,
                                  skv_error *error)
{
    size_t pixels = (size_t)coverage->columns * (size_t)coverage->rows;
    transform t = {coverage, field, skv_calloc(pixels, sizeof(uint32_t))};
    if (!t.nearest)
        return skv_fail(error, SKV_ERROR_MEMORY, "terrain: no memory for %d x %d distances",
                        coverage->columns, coverage->rows);
    if (seed(&t)) {
        for (int y = 1; y < coverage->rows; y++)
            sweep_row(&t, y, y - 1);
        for (int y = coverage->rows - 2; y >= 0; y--)
            sweep_row(&t, y, y + 1);
    } else {
        int unreached = coverage->columns + coverage->rows - 4 * SKV_TERRAIN_RIM;
        for (size_t i = 0; i < pixels; i++)
            field[i] = (float)unreached;
    }
    for (size_t i = 0; i < pixels; i++)
        field[i] *= skv_is_solid(coverage->bytes[i]) ? -pixel_size : pixel_size;
    skv_free(t.nearest);
    return SKV_OK;
}
