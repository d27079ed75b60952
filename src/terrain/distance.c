/* Distance to the contour, exactly: the least over all of its segments within reach.
 *
 * The picture is cut into large squares. Of each, and of what is within reach around it, a set of
 * bits tells the cells that hold segments. A pixel beside such a cell is nearest to a segment in
 * one of the twelve cells around it. Any other pixel is nearest to an open cell: the disc around
 * the pixel that touches the nearest point holds no segment, and the last 1.42 pixels of it before
 * that point hold a whole cell, which is at most two cells from there. So cells without an empty
 * one so near are left out, and cost is linear in pixels however dense walls are.
 *
 * Where walls are near, each pixel looks through the rows of bits, the nearest first. Where they
 * are far, the segments within reach of a small square are gathered, and it is halved again and
 * again: to a part of it only those can be nearest that are no farther from its middle than the
 * nearest one and the part's diagonal. Invariant: a distance is the least of the same numbers
 * whichever squares are filled and whichever way they are looked for, so a part filled anew equals
 * the whole.
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
    LARGE = 64,   /* pixels a side of the squares that bits are read for, ... */
    MIDDLE = 16,  /* ... of those that segments are gathered for ... */
    SMALLEST = 4, /* ... and of those whose pixels are looked at one by one */
    NEAR = 12,    /* pixels: no farther from a wall than that a middle square ... */
    FEW = 256,    /* ... gathers so many segments; where there are more, each pixel looks around */
    WORDS = 3,    /* of a row of cells: the large square's, and one on either side */
    BELOW = REACH + 1,
    ROWS = LARGE + 2 * BELOW
};
_Static_assert(BELOW < LARGE, "a word holds all cells within reach to one side");

/* A row of cells, from the left. */
typedef struct bits {
    uint64_t word[WORDS];
} bits;

/* A segment: where it begins, and the way to its end. */
typedef struct segment {
    float x, y, ux, uy;
} segment;

/* Many of them, with their squared distances from a middle. */
typedef struct segments {
    float *x, *y, *ux, *uy, *square;
} segments;

typedef struct transform {
    const skv_coverage *coverage;
    const skv_squares *wanted;
    float pixel_size;
    float *field;
    int x0, y0;          /* the large square's lower left pixel */
    bits cells[ROWS];    /* that hold segments, from row y0 - BELOW on */
    bits open[ROWS];     /* those of them that have an empty one near */
    bits known[ROWS];    /* those whose segments have been found */
    segment (*found)[2]; /* ROWS * WORDS * LARGE: of each cell, of one segment twice */
    segments gathered;   /* room for two a cell within a word of a middle */
    uint64_t steps;      /* rows and segments looked at so far */
} transform;

/* How far along a segment that begins (px, py) before a point its nearest place lies: 0 to 1. */
static inline float share_along(float px, float py, float ux, float uy)
{
    float along = px * ux + py * uy, square = ux * ux + uy * uy;
    /* A segment may be shorter than float can tell; then its start serves. */
    return skv_maxf(skv_minf(along / skv_maxf(square, FLT_MIN), 1), 0);
}

/* The squared distance of the point from the segment's place at this share. */
static inline float square_beyond(float px, float py, float ux, float uy, float share)
{
    float dx = px - share * ux, dy = py - share * uy;
    return dx * dx + dy * dy;
}

static inline float squared_distance(float px, float py, float ux, float uy)
{
    return square_beyond(px, py, ux, uy, share_along(px, py, ux, uy));
}

/* ---- Cells ----------------------------------------------------------------------------------- */

/* The bits so many places farther on, 1 or 2; `more` comes in at the end. */
static inline bits from_right(const bits *b, unsigned places, uint64_t more)
{
    bits moved;
    for (int k = 0; k < WORDS; k++)
        moved.word[k] = b->word[k] >> places | (k + 1 < WORDS ? b->word[k + 1] : more)
                                                   << (64 - places);
    return moved;
}

/* The same the other way. */
static inline bits from_left(const bits *b, unsigned places, uint64_t more)
{
    bits moved;
    for (int k = 0; k < WORDS; k++)
        moved.word[k] = b->word[k] << places | (k > 0 ? b->word[k - 1] : more) >> (64 - places);
    return moved;
}

/* Which of 64 pixels are solid: their top bits, eight at a time. */
static uint64_t solid_word(const uint8_t *pixels)
{
    uint64_t word = 0;
    for (int k = 0; k < 8; k++) {
        uint64_t eight;
        memcpy(&eight, pixels + 8 * k, sizeof eight);
        eight = (eight >> 7 & 0x0101010101010101u) * 0x0102040810204080u >> 56;
        word |= eight << 8 * k;
    }
    return word;
}

/* Which pixels of a row are solid; those beyond the picture are none. */
static bits solid_row(const transform *t, int y)
{
    const skv_coverage *c = t->coverage;
    const uint8_t *row = c->bytes + (size_t)y * (size_t)c->columns;
    bits solid = {0};
    for (int k = 0; k < WORDS; k++) {
        int x = t->x0 + (k - 1) * LARGE;
        if (x >= 0 && x + LARGE <= c->columns) {
            solid.word[k] = solid_word(row + x);
            continue;
        }
        for (int i = 0; i < LARGE; i++) {
            if (x + i >= 0 && x + i < c->columns)
                solid.word[k] |= (uint64_t)skv_is_solid(row[x + i]) << i;
        }
    }
    return solid;
}

/* The cells of a row that lie in the picture and are known with their right sides. */
static bits cells_there(const transform *t)
{
    bits there = {0};
    for (int i = 0; i < WORDS * LARGE - 1; i++) {
        int x = t->x0 - LARGE + i;
        there.word[i / LARGE] |= (uint64_t)(x >= 0 && x < t->coverage->columns - 1) << i % LARGE;
    }
    return there;
}

/* Finds the cells that hold segments; false if there are none. */
static bool find_cells(transform *t)
{
    const bits there = cells_there(t), none = {0};
    int last = t->coverage->rows - 1, y = t->y0 - BELOW;
    bool any = false;
    bits low = y >= 0 && y <= last ? solid_row(t, y) : none;
    for (int j = 0; j < ROWS; j++, y++) {
        bits high = y + 1 >= 0 && y + 1 <= last ? solid_row(t, y + 1) : none;
        bits low_right = from_right(&low, 1, 0), high_right = from_right(&high, 1, 0);
        for (int k = 0; k < WORDS; k++) {
            uint64_t some = low.word[k] | low_right.word[k] | high.word[k] | high_right.word[k];
            uint64_t all = low.word[k] & low_right.word[k] & high.word[k] & high_right.word[k];
            uint64_t cells = y >= 0 && y < last ? some & ~all & there.word[k] : 0;
            t->cells[j].word[k] = cells;
            any = any || cells;
        }
        low = high;
    }
    return any;
}

/* Finds those with an empty one at most two away; what is beyond counts as empty. */
static void find_open(transform *t)
{
    bits wide[ROWS + 4];
    memset(wide, 0xff, sizeof wide);
    for (int j = 0; j < ROWS; j++) {
        bits empty;
        for (int k = 0; k < WORDS; k++)
            empty.word[k] = ~t->cells[j].word[k];
        for (unsigned places = 1; places <= 2; places++) {
            bits left = from_left(&empty, places, UINT64_MAX);
            bits right = from_right(&empty, places, UINT64_MAX);
            for (int k = 0; k < WORDS; k++)
                wide[j + 2].word[k] = (places == 1 ? empty.word[k] : wide[j + 2].word[k]) |
                                      left.word[k] | right.word[k];
        }
    }
    for (int j = 0; j < ROWS; j++) {
        for (int k = 0; k < WORDS; k++)
            t->open[j].word[k] =
                t->cells[j].word[k] & (wide[j].word[k] | wide[j + 1].word[k] | wide[j + 2].word[k] |
                                       wide[j + 3].word[k] | wide[j + 4].word[k]);
    }
}

/* The segments of the cell at a bit of a row. */
static inline const segment *segments_of(transform *t, int row, int bit)
{
    segment *made = t->found[row * WORDS * LARGE + bit];
    uint64_t *known = &t->known[row].word[bit / LARGE], mask = (uint64_t)1 << bit % LARGE;
    if (*known & mask)
        return made;
    *known |= mask;
    skv_wall_segment found[2];
    int count = skv_cell_segments(t->coverage, t->x0 - LARGE + bit, t->y0 - BELOW + row, found);
    for (int i = 0; i < 2; i++) {
        const skv_wall_segment *s = &found[i < count ? i : 0];
        made[i] = (segment){s->x0, s->y0, s->x1 - s->x0, s->y1 - s->y0};
    }
    return made;
}

/* ---- Looking around -------------------------------------------------------------------------- */

/* What a look around a pixel finds. */
typedef struct look {
    transform *t;
    float x, y;
    float square; /* of the least distance so far, or how far to gather */
    int count;    /* of those gathered; negative: it looks for the least distance */
    int most;     /* gathered, or a few more */
} look;

static inline void look_at(look *l, int row, int bit)
{
    const segment *s = segments_of(l->t, row, bit);
    l->t->steps += 2;
    if (l->count < 0) {
        for (int i = 0; i < 2; i++)
            l->square = skv_minf(l->square,
                                 squared_distance(l->x - s[i].x, l->y - s[i].y, s[i].ux, s[i].uy));
        return;
    }
    const segments *g = &l->t->gathered;
    int more = s[1].x == s[0].x && s[1].y == s[0].y ? 1 : 2;
    for (int i = 0; i < more; i++, l->count++) {
        g->x[l->count] = s[i].x;
        g->y[l->count] = s[i].y;
        g->ux[l->count] = s[i].ux;
        g->uy[l->count] = s[i].uy;
    }
}

/* Whether a cell may hold what is looked for: one so many cells away in both directions. */
static inline bool may_hold(const look *l, int x, int y)
{
    return (float)(x * x + y * y) <= l->square * (1 + 1e-5f) + 1e-5f;
}

/* Looks at the cells around pixel (x, y) of the large square, the nearest rows first. A pixel is
 * its upper right cell's lower left corner. */
static inline void look_around(look *l, const bits *cells, int x, int y)
{
    for (int m = 0; may_hold(l, 0, m) && l->count < l->most; m++) {
        for (int side = 0; side < 2; side++) {
            int row = BELOW + (side ? y - 1 - m : y + m);
            if (row < 0 || row >= ROWS)
                continue;
            const uint64_t *word = cells[row].word;
            l->t->steps++;
            uint64_t left = word[0] >> x | word[1] << 1 << (63 - x);
            uint64_t right = word[1] >> x | word[2] << 1 << (63 - x);
            for (; right; right &= right - 1) {
                int k = __builtin_ctzll(right);
                if (!may_hold(l, k, m))
                    break;
                look_at(l, row, LARGE + x + k);
            }
            while (left) {
                int k = __builtin_clzll(left);
                if (!may_hold(l, k, m))
                    break;
                look_at(l, row, LARGE - 1 + x - k);
                left &= ~((uint64_t)1 << 63 >> k);
            }
        }
    }
}

/* Whether a cell beside pixel (x, y) of the large square holds a segment. */
static bool is_beside(const transform *t, int x, int y)
{
    const bits *low = &t->cells[BELOW + y - 1], *high = low + 1;
    uint64_t left =
        x > 0 ? (low->word[1] | high->word[1]) >> (x - 1) : (low->word[0] | high->word[0]) >> 63;
    return (left | (low->word[1] | high->word[1]) >> x) & 1;
}

/* The squared distance of pixel (x, y) of the large square, at most REACH squared. */
static float search(transform *t, int x, int y)
{
    look l = {t, (float)(t->x0 + x), (float)(t->y0 + y), REACH * REACH, -1, 0};
    look_around(&l, is_beside(t, x, y) ? t->cells : t->open, x, y);
    return l.square;
}

/* ---- Squares --------------------------------------------------------------------------------- */

static inline void swap(float *a, float *b)
{
    float kept = *a;
    *a = *b;
    *b = kept;
}

/* Writes how far the first `count` segments are from a point, and returns the least of it, squared;
 * FLT_MAX if there are none. In two loops: in one, compilers split the second step by how the first
 * was clamped, which takes twice as long. */
static float measure(transform *t, int count, float x, float y)
{
    t->steps += (uint64_t)count;
    const segments *g = &t->gathered;
    const float *gx = g->x, *gy = g->y, *ux = g->ux, *uy = g->uy;
    float *restrict square = g->square;
    for (int i = 0; i < count; i++)
        square[i] = share_along(x - gx[i], y - gy[i], ux[i], uy[i]);
    for (int i = 0; i < count; i++)
        square[i] = square_beyond(x - gx[i], y - gy[i], ux[i], uy[i], square[i]);
    /* Several at a time, as each comparison waits for the one before. */
    float a = FLT_MAX, b = FLT_MAX, c = FLT_MAX, d = FLT_MAX;
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        a = skv_minf(square[i], a);
        b = skv_minf(square[i + 1], b);
        c = skv_minf(square[i + 2], c);
        d = skv_minf(square[i + 3], d);
    }
    for (; i < count; i++)
        a = skv_minf(square[i], a);
    return skv_minf(skv_minf(a, b), skv_minf(c, d));
}

/* Moves those of the first `count` segments to the front that may be nearest to a pixel of a square
 * with this middle, of which no pixel is farther from it than `half`; returns their number. */
static int keep_near(transform *t, int count, float x, float y, float half)
{
    const segments *g = &t->gathered;
    float least = sqrtf(measure(t, count, x, y));
    float limit = skv_minf(least + half, REACH) + half + SKV_PIXEL_SLACK, square = limit * limit;
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

static bool is_wanted(const transform *t, int x, int y, int side)
{
    return x < t->coverage->columns && y < t->coverage->rows &&
           (!t->wanted || skv_squares_meet(t->wanted, x, y, x + side - 1, y + side - 1));
}

static void set_pixel(const transform *t, int x, int y, float square)
{
    float distance = sqrtf(skv_minf(square, REACH * REACH));
    size_t at = (size_t)y * (size_t)t->coverage->columns + (size_t)x;
    t->field[at] =
        distance * (skv_is_solid(t->coverage->bytes[at]) ? -t->pixel_size : t->pixel_size);
}

/* Fills a square whose pixels look for themselves; or, with a `count` of at least 0, from so many
 * segments, which hold all that may be nearest to those that are not beside one. */
static void fill_pixels(transform *t, int count, int x0, int y0, int side)
{
    const skv_coverage *c = t->coverage;
    for (int y = y0; y < y0 + side && y < c->rows; y++) {
        for (int x = x0; x < x0 + side && x < c->columns; x++) {
            bool looks = count < 0 || is_beside(t, x - t->x0, y - t->y0);
            set_pixel(t, x, y,
                      looks ? search(t, x - t->x0, y - t->y0)
                            : measure(t, count, (float)x, (float)y));
        }
    }
}

/* Fills a square from the first `count` segments. */
static void fill_square(transform *t, int count, int x0, int y0, int side)
{
    if (!is_wanted(t, x0, y0, side))
        return;
    float middle = 0.5f * (float)(side - 1);
    int kept = keep_near(t, count, (float)x0 + middle, (float)y0 + middle, 1.41422f * middle);
    if (kept == 0 || side <= SMALLEST) {
        fill_pixels(t, kept, x0, y0, side);
        return;
    }
    int half = side / 2;
    for (int k = 0; k < 4; k++)
        fill_square(t, kept, x0 + k % 2 * half, y0 + k / 2 * half, half);
}

/* The same from what is around it, of which `any` tells that there is something. */
static void fill_middle(transform *t, bool any, int x0, int y0)
{
    if (!is_wanted(t, x0, y0, MIDDLE))
        return;
    if (!any) {
        fill_square(t, 0, x0, y0, MIDDLE);
        return;
    }
    const float half = 1.41422f * MIDDLE / 2;
    int x = x0 - t->x0 + MIDDLE / 2, y = y0 - t->y0 + MIDDLE / 2;
    float least = sqrtf(search(t, x, y));
    float limit = skv_minf(least + half, REACH) + half + SKV_PIXEL_SLACK;
    look l = {t, 0, 0, limit * limit, 0, least <= NEAR ? FEW : INT32_MAX};
    look_around(&l, t->open, x, y);
    if (l.count < l.most) {
        fill_square(t, l.count, x0, y0, MIDDLE);
        return;
    }
    for (int k = 0; k < 4; k++) {
        int px = x0 + k % 2 * SKV_SQUARE, py = y0 + k / 2 * SKV_SQUARE;
        if (is_wanted(t, px, py, SKV_SQUARE))
            fill_pixels(t, -1, px, py, SKV_SQUARE);
    }
}

static void fill_large(transform *t, int x0, int y0)
{
    t->x0 = x0;
    t->y0 = y0;
    bool any = find_cells(t);
    if (any) {
        find_open(t);
        memset(t->known, 0, sizeof t->known);
    }
    for (int y = y0; y < y0 + LARGE; y += MIDDLE) {
        for (int x = x0; x < x0 + LARGE; x += MIDDLE)
            fill_middle(t, any, x, y);
    }
}

skv_result skv_distance_fill(const skv_coverage *coverage, float pixel_size,
                             const skv_squares *wanted, float *field, uint64_t *steps,
                             skv_error *error)
{
    const size_t cells = (size_t)ROWS * WORDS * LARGE, room = 2 * (size_t)ROWS * 2 * LARGE;
    transform *t = NULL;
    segment(*found)[2] = NULL;
    segments g = {0};
    const skv_array arrays[] = {SKV_ARRAY(t, 1, 0),          SKV_ARRAY(found, cells, 0),
                                SKV_ARRAY(g.x, room, 0),     SKV_ARRAY(g.y, room, 0),
                                SKV_ARRAY(g.ux, room, 0),    SKV_ARRAY(g.uy, room, 0),
                                SKV_ARRAY(g.square, room, 0)};
    void *block = NULL;
    if (!skv_arrays_grow(&block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "terrain: no memory for distances");
    t->coverage = coverage;
    t->wanted = wanted;
    t->pixel_size = pixel_size;
    t->field = field;
    t->found = found;
    t->gathered = g;
    for (int y = 0; y < coverage->rows; y += LARGE) {
        for (int x = 0; x < coverage->columns; x += LARGE) {
            if (is_wanted(t, x, y, LARGE))
                fill_large(t, x, y);
        }
    }
    if (steps)
        *steps = t->steps;
    skv_free(block);
    return SKV_OK;
}
