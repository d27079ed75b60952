/* Distance to the contour, exactly: the least over all of its segments within reach.
 *
 * The picture is cut into large squares; for each the segments within reach are gathered, and the
 * square is halved again and again. To a part of it only those segments can be nearest that are no
 * farther from its middle than the nearest one and the part's diagonal; the others are left out
 * before it is halved. Invariant: a distance is the least of the same numbers whichever squares are
 * filled, so a part filled anew equals the whole.
 */
#include "terrain/distance.h"

#include "base/arrays.h"
#include "base/exact.h"
#include "base/memory.h"
#include "terrain/terrain.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    REACH = SKV_TERRAIN_REACH,
    LARGEST = 64, /* pixels a side of the squares that segments are gathered for ... */
    SMALLEST = 4, /* ... and of those whose pixels are looked at one by one */
    AROUND = LARGEST + 2 * (REACH + 1)
};

/* Pixels that segments are kept beyond need, for rounding. */
#define SLACK 0.01f

/* Segments: where each begins, the way to its end, and its squared distance from a middle. */
typedef struct segments {
    float *x, *y, *ux, *uy, *square;
} segments;

typedef struct transform {
    const skv_coverage *coverage;
    const skv_squares *wanted;
    float pixel_size;
    float *field;
    segments gathered; /* room for two a cell */
} transform;

/* The squared distance from a point to a segment that begins (px, py) before it. */
static inline float squared_distance(float px, float py, float ux, float uy)
{
    float along = px * ux + py * uy, square = ux * ux + uy * uy;
    /* A segment may be shorter than float can tell; then its start serves. */
    float t = skv_maxf(skv_minf(along / skv_maxf(square, FLT_MIN), 1), 0);
    float dx = px - t * ux, dy = py - t * uy;
    return dx * dx + dy * dy;
}

/* The top bits, which tell solid from air, of eight pixels. */
static uint64_t solid_bits(const uint8_t *pixels)
{
    uint64_t eight;
    memcpy(&eight, pixels, sizeof eight);
    return eight & 0x8080808080808080u;
}

/* Adds the segments of a cell to the first `count`; returns their number. */
static int gather_cell(const transform *t, int x, int y, int count)
{
    const segments *g = &t->gathered;
    skv_wall_segment found[2];
    int more = skv_cell_segments(t->coverage, x, y, found);
    for (int i = 0; i < more; i++, count++) {
        g->x[count] = found[i].x0;
        g->y[count] = found[i].y0;
        g->ux[count] = found[i].x1 - found[i].x0;
        g->uy[count] = found[i].y1 - found[i].y0;
    }
    return count;
}

/* Gathers the segments of the cells from (x0, y0) to before (x1, y1); returns their number. */
static int gather(const transform *t, int x0, int y0, int x1, int y1)
{
    const skv_coverage *c = t->coverage;
    int count = 0;
    for (int y = y0; y < y1; y++) {
        const uint8_t *low = c->bytes + (size_t)y * (size_t)c->columns, *high = low + c->columns;
        for (int x = x0; x < x1;) {
            /* Eight pixels of two rows hold seven cells. */
            if (x + 7 <= x1) {
                uint64_t bits = solid_bits(low + x);
                if (bits == solid_bits(high + x) && (bits == 0 || bits == 0x8080808080808080u)) {
                    x += 7;
                    continue;
                }
            }
            count = gather_cell(t, x, y, count);
            x++;
        }
    }
    return count;
}

static inline void swap(float *a, float *b)
{
    float kept = *a;
    *a = *b;
    *b = kept;
}

/* Writes how far the first `count` segments are from a point, and returns the least of it, squared;
 * FLT_MAX if there are none. */
static float measure(const transform *t, int count, float x, float y)
{
    const segments *g = &t->gathered;
    const float *gx = g->x, *gy = g->y, *ux = g->ux, *uy = g->uy;
    float *restrict square = g->square;
    for (int i = 0; i < count; i++)
        square[i] = squared_distance(x - gx[i], y - gy[i], ux[i], uy[i]);
    /* Several at a time, as each comparison waits for the one before. */
    float least[4] = {FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX};
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int l = 0; l < 4; l++)
            least[l] = skv_minf(square[i + l], least[l]);
    for (; i < count; i++)
        least[0] = skv_minf(square[i], least[0]);
    return skv_minf(skv_minf(least[0], least[1]), skv_minf(least[2], least[3]));
}

/* Moves those of the first `count` segments to the front that may be nearest to a pixel of a square
 * with this middle, of which no pixel is farther from it than `half`; returns their number. */
static int keep_near(const transform *t, int count, float x, float y, float half)
{
    const segments *g = &t->gathered;
    float least = sqrtf(measure(t, count, x, y));
    float limit = skv_minf(least + half, REACH) + half + SLACK, square = limit * limit;
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (g->square[i] > square)
            continue;
        swap(&g->x[i], &g->x[kept]);
        swap(&g->y[i], &g->y[kept]);
        swap(&g->ux[i], &g->ux[kept]);
        swap(&g->uy[i], &g->uy[kept]);
        kept++;
    }
    return kept;
}

static void fill_pixel(const transform *t, int count, int x, int y)
{
    float distance = sqrtf(skv_minf(measure(t, count, (float)x, (float)y), REACH * REACH));
    size_t at = (size_t)y * (size_t)t->coverage->columns + (size_t)x;
    t->field[at] =
        distance * (skv_is_solid(t->coverage->bytes[at]) ? -t->pixel_size : t->pixel_size);
}

/* Fills a square from the first `count` segments, which hold all that may be nearest. */
static void fill_square(const transform *t, int count, int x0, int y0, int side)
{
    const skv_coverage *c = t->coverage;
    int x1 = x0 + side - 1, y1 = y0 + side - 1;
    if (x0 >= c->columns || y0 >= c->rows ||
        (t->wanted && !skv_squares_meet(t->wanted, x0, y0, x1, y1)))
        return;
    float middle = 0.5f * (float)(side - 1);
    int kept = keep_near(t, count, (float)x0 + middle, (float)y0 + middle, 1.41422f * middle);
    if (kept > 0 && side > SMALLEST) {
        int half = side / 2;
        for (int k = 0; k < 4; k++)
            fill_square(t, kept, x0 + k % 2 * half, y0 + k / 2 * half, half);
        return;
    }
    for (int y = y0; y <= y1 && y < c->rows; y++)
        for (int x = x0; x <= x1 && x < c->columns; x++)
            fill_pixel(t, kept, x, y);
}

static int at_least(int a, int least)
{
    return a > least ? a : least;
}

static int at_most(int a, int most)
{
    return a < most ? a : most;
}

skv_result skv_distance_fill(const skv_coverage *coverage, float pixel_size,
                             const skv_squares *wanted, float *field, skv_error *error)
{
    const size_t room = 2 * (size_t)AROUND * (size_t)AROUND;
    transform t = {
        .coverage = coverage,
        .wanted = wanted,
        .pixel_size = pixel_size,
        .field = field,
    };
    segments *g = &t.gathered;
    void *block = NULL;
    const skv_array arrays[] = {SKV_ARRAY(g->x, room, 0), SKV_ARRAY(g->y, room, 0),
                                SKV_ARRAY(g->ux, room, 0), SKV_ARRAY(g->uy, room, 0),
                                SKV_ARRAY(g->square, room, 0)};
    if (!skv_arrays_grow(&block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "terrain: no memory for distances");
    for (int y = 0; y < coverage->rows; y += LARGEST) {
        for (int x = 0; x < coverage->columns; x += LARGEST) {
            if (wanted && !skv_squares_meet(wanted, x, y, x + LARGEST - 1, y + LARGEST - 1))
                continue;
            int count = gather(&t, at_least(x - REACH - 1, 0), at_least(y - REACH - 1, 0),
                               at_most(x + LARGEST + REACH + 1, coverage->columns - 1),
                               at_most(y + LARGEST + REACH + 1, coverage->rows - 1));
            fill_square(&t, count, x, y, LARGEST);
        }
    }
    skv_free(block);
    return SKV_OK;
}
