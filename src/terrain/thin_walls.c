/* Finding thin walls: from every pixel beside a wall straight through it.
 *
 * The middles of the ways that soon come out again are marked on a grid of an eighth of the radius.
 * Where walls end freely the marks are taken away: sight changes there as one passes the end, and
 * pairs that are cut by it would drive a whirl. Then every place within the radius of a mark that
 * is left is marked. Invariant: the grid is finer than the gaps that fluid flows through.
 */
#include "terrain/thin_walls.h"

#include "base/memory.h"
#include "terrain/sample.h"

#include <math.h>
#include <string.h>

/* In cells, which are an eighth of the radius: a radius; how far a mark spreads; how far a wall
 * must go on to both sides of a mark, or its end is near; how far along the wall an end takes marks
 * away. */
enum { RADIUS = 8, SPREAD = RADIUS + 2, AROUND = 2 * RADIUS, CLEARED = 6 * RADIUS };
enum { MARGIN = AROUND + SPREAD };
_Static_assert((int)MARGIN == (int)SKV_THIN_MARGIN, "the marks begin where the header says");

/* A wall is thin up to this share of the radius. */
#define THIN 0.6

/* The shortest step through a wall, in pixels: finer than the thinnest wall that holds water. */
#define STEP 0.25

/* The way through the wall from pixel (x, y), which lies beside it: the middle of its part in the
 * solid, in grid coordinates; false if that is longer than `longest` pixels. */
static bool find_middle(const skv_terrain *terrain, int x, int y, double longest, double *mx,
                        double *my)
{
    float sx, sy;
    skv_grid_slope(terrain, (float)x, (float)y, &sx, &sy);
    double length = sqrt((double)sx * (double)sx + (double)sy * (double)sy);
    if (!(length > 1e-3 * (double)terrain->pixel_size))
        return false;
    double ux = -(double)sx / length, uy = -(double)sy / length, entry = -1;
    for (double t = 0; t <= longest + 2;) {
        double d = (double)skv_grid_distance(terrain, (float)(x + t * ux), (float)(y + t * uy));
        d *= (double)terrain->per_metre;
        if (entry < 0 && d < 0)
            entry = t;
        if (entry >= 0 && d > 0) {
            *mx = x + 0.5 * (entry + t) * ux;
            *my = y + 0.5 * (entry + t) * uy;
            return t - entry <= longest;
        }
        double bound = 0.7 * fabs(d);
        t += bound > STEP ? bound : STEP;
    }
    return false;
}

/* Marks the cell of a point in metres; true if it is on the grid. */
static bool mark(const skv_thin_walls *thin, uint8_t *marks, double x, double y)
{
    double column = floor(x * (double)thin->per_metre) + MARGIN;
    double row = floor(y * (double)thin->per_metre) + MARGIN;
    if (column < 0 || row < 0 || column >= thin->columns || row >= thin->rows)
        return false;
    marks[(size_t)row * (size_t)thin->columns + (size_t)column] = 1;
    return true;
}

/* Marks the middles of all thin walls; false if there are none. */
static bool mark_middles(const skv_thin_walls *thin, const skv_terrain *terrain, double radius,
                         uint8_t *marks)
{
    const double shift = (double)SKV_TERRAIN_RIM - 0.5, pixel = (double)terrain->pixel_size;
    bool any = false;
    for (int y = 1; y < terrain->rows - 2; y++) {
        const float *row = terrain->field + (size_t)y * (size_t)terrain->columns;
        for (int x = 1; x < terrain->columns - 2; x++) {
            double mx, my;
            if (row[x] > 0 && row[x] <= terrain->pixel_size &&
                find_middle(terrain, x, y, radius / pixel, &mx, &my))
                any = mark(thin, marks, (mx - shift) * pixel, (my - shift) * pixel) || any;
        }
    }
    return any;
}

/* What finding needs besides the result: cells as marks, and as solid. */
typedef struct search {
    const skv_thin_walls *thin;
    uint8_t *middles;  /* 1: a middle */
    uint8_t *solid;    /* 1: the wall passes through */
    int *queue;        /* cells reached from free ends ... */
    uint8_t *distance; /* ... in so many steps + 1; 0: not reached */
} search;

static size_t cell_at(const skv_thin_walls *thin, int x, int y)
{
    return (size_t)y * (size_t)thin->columns + (size_t)x;
}

static void find_solid(const search *s, const skv_terrain *terrain)
{
    const skv_thin_walls *thin = s->thin;
    float side = 1 / thin->per_metre;
    for (int y = 0; y < thin->rows; y++) {
        float gy = skv_to_grid(terrain, ((float)(y - MARGIN) + 0.5f) * side);
        for (int x = 0; x < thin->columns; x++) {
            float gx = skv_to_grid(terrain, ((float)(x - MARGIN) + 0.5f) * side);
            /* A line passes the middles of a chain of cells by no more than half a side. */
            s->solid[cell_at(thin, x, y)] = s->middles[cell_at(thin, x, y)] ||
                                            skv_grid_distance(terrain, gx, gy) <= 0.5f * side;
        }
    }
}

/* The cells around one, as far as they are solid and hang together with it. */
enum { WINDOW = 2 * AROUND + 1 };
typedef bool window[WINDOW][WINDOW];

static void reach_from_middle(const search *s, int x, int y, window reached)
{
    int stack[WINDOW * WINDOW], top = 0;
    memset(reached, 0, sizeof(window));
    reached[AROUND][AROUND] = true;
    stack[top++] = AROUND * WINDOW + AROUND;
    while (top > 0) {
        int at = stack[--top];
        for (int k = 0; k < 9; k++) {
            int i = at % WINDOW + k % 3 - 1, j = at / WINDOW + k / 3 - 1;
            if (i < 0 || j < 0 || i >= WINDOW || j >= WINDOW || reached[j][i] ||
                !s->solid[cell_at(s->thin, x + i - AROUND, y + j - AROUND)])
                continue;
            reached[j][i] = true;
            stack[top++] = j * WINDOW + i;
        }
    }
}

/* Cell `k` of the window's border, counted around. */
static void border_cell(int k, int *x, int *y)
{
    const int side = 2 * AROUND;
    int along = k % side, edge = k / side % 4;
    *x = edge == 0 ? along : edge == 1 ? side : edge == 2 ? side - along : 0;
    *y = edge == 0 ? 0 : edge == 1 ? along : edge == 2 ? side : side - along;
}

/* How a wall goes on past a marked cell. */
typedef enum course {
    GOES_ON,   /* to two sides */
    UPPER_END, /* it ends nearby, and comes from below: usually in the air */
    OTHER_END  /* it ends nearby otherwise, or is no more than a spot */
} course;

static course follow(const search *s, int x, int y)
{
    window reached;
    reach_from_middle(s, x, y, reached);
    int ways = 0, across = 0, up = 0;
    for (int k = 0; k < 8 * AROUND; k++) {
        int i, j, next_i, next_j;
        border_cell(k, &i, &j);
        border_cell(k + 1, &next_i, &next_j);
        ways += reached[j][i] && !reached[next_j][next_i];
        across += reached[j][i] ? i - AROUND : 0;
        up += reached[j][i] ? j - AROUND : 0;
    }
    if (ways >= 2)
        return GOES_ON;
    return ways == 1 && up < -(across < 0 ? -across : across) ? UPPER_END : OTHER_END;
}

/* Takes away the marks near free ends of walls. */
static void clear_ends(const search *s)
{
    const skv_thin_walls *thin = s->thin;
    int count = 0;
    for (int y = AROUND; y < thin->rows - AROUND; y++) {
        for (int x = AROUND; x < thin->columns - AROUND; x++) {
            size_t at = cell_at(thin, x, y);
            course there = s->middles[at] ? follow(s, x, y) : GOES_ON;
            if (there == GOES_ON)
                continue;
            s->distance[at] = there == UPPER_END ? CLEARED + 1 : 1;
            s->queue[count++] = (int)at;
        }
    }
    /* The upper ends' marks alone go away; from the others on it spreads. */
    for (int next = 0; next < count; next++) {
        int at = s->queue[next];
        s->middles[at] = 0;
        if (s->distance[at] > CLEARED)
            continue;
        for (int k = 0; k < 9; k++) {
            int x = at % thin->columns + k % 3 - 1, y = at / thin->columns + k / 3 - 1;
            if (x < 0 || y < 0 || x >= thin->columns || y >= thin->rows)
                continue;
            size_t to = cell_at(thin, x, y);
            if (!s->solid[to] || s->distance[to])
                continue;
            s->distance[to] = (uint8_t)(s->distance[at] + 1);
            s->queue[count++] = (int)to;
        }
    }
}

/* Marks all cells within the radius of the middles that are left; false if there are none. */
static bool spread(const search *s)
{
    const skv_thin_walls *thin = s->thin;
    bool any = false;
    for (int y = SPREAD; y < thin->rows - SPREAD; y++) {
        for (int x = SPREAD; x < thin->columns - SPREAD; x++) {
            if (!s->middles[cell_at(thin, x, y)])
                continue;
            any = true;
            for (int dy = -SPREAD; dy <= SPREAD; dy++) {
                for (int dx = -SPREAD; dx <= SPREAD; dx++) {
                    if (dx * dx + dy * dy <= SPREAD * SPREAD)
                        thin->marks[cell_at(thin, x + dx, y + dy)] = 1;
                }
            }
        }
    }
    return any;
}

static skv_result find_walls(const search *s, const skv_terrain *terrain, double radius, bool *any,
                             size_t cells, skv_error *error)
{
    *any = mark_middles(s->thin, terrain, THIN * radius, s->middles);
    if (!*any)
        return SKV_OK;
    search more = *s;
    more.solid = skv_calloc(cells, 1);
    more.distance = skv_calloc(cells, 1);
    more.queue = skv_calloc(cells, sizeof *more.queue);
    skv_result result = SKV_OK;
    if (more.solid && more.distance && more.queue) {
        find_solid(&more, terrain);
        clear_ends(&more);
        *any = spread(&more);
    } else {
        result = skv_fail(error, SKV_ERROR_MEMORY,
                          "walls: no memory for %zu cells; a wider spacing needs fewer", cells);
    }
    skv_free(more.solid);
    skv_free(more.distance);
    skv_free(more.queue);
    return result;
}

skv_result skv_thin_walls_create(const skv_terrain *terrain, float radius, skv_thin_walls **out,
                                 skv_error *error)
{
    *out = NULL;
    double per_metre = RADIUS / (double)radius;
    double columns = ceil((double)skv_terrain_width(terrain) * per_metre) + 2 * MARGIN;
    double rows = ceil((double)skv_terrain_height(terrain) * per_metre) + 2 * MARGIN;
    if (columns * rows > INT32_MAX)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "thin walls: a radius of %g m is too small for this world", (double)radius);
    size_t cells = (size_t)columns * (size_t)rows;
    skv_thin_walls *thin = skv_calloc(1, sizeof *thin);
    uint8_t *middles = skv_calloc(cells, 1), *marks = skv_calloc(cells, 1);
    bool any = false;
    skv_result result = SKV_OK;
    if (thin && middles && marks) {
        *thin = (skv_thin_walls){(float)per_metre, (int)columns, (int)rows, marks};
        search s = {.thin = thin, .middles = middles};
        result = find_walls(&s, terrain, (double)radius, &any, cells, error);
    } else {
        result = skv_fail(error, SKV_ERROR_MEMORY,
                          "walls: no memory for %zu cells; a wider spacing needs fewer", cells);
    }
    skv_free(middles);
    if (result == SKV_OK && any) {
        *out = thin;
        return SKV_OK;
    }
    skv_free(marks);
    skv_free(thin);
    return result;
}

void skv_thin_walls_destroy(skv_thin_walls *thin)
{
    if (!thin)
        return;
    skv_free(thin->marks);
    skv_free(thin);
}
