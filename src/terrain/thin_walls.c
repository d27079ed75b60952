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

/* The most cells around a world: three bytes each, 800 MB. The most that have a thin wall's middle,
 * and the most near one, beside which samples take some 20 us each: 10 s. */
#define MOST_CELLS 268435456.0
#define MOST_NEAR  524288

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

/* What is known of a cell. */
enum {
    MIDDLE = 1,    /* a thin wall's middle lies in it ... */
    UPPER_END = 2, /* ... near where the wall ends, and comes from below: usually in the air; ... */
    OTHER_END = 4, /* ... or ends otherwise, or is no more than a spot */
    SOLID = 8      /* the wall passes through */
};

/* What finding needs besides the result. */
typedef struct search {
    const skv_terrain *terrain;
    skv_thin_walls *thin;
    double longest;           /* the way through a thin wall, pixels */
    const skv_squares *redo;  /* where cells are found anew; null: everywhere */
    skv_square_bounds within; /* the box around it, or the whole picture */
    int *queue;               /* cells reached from free ends ... */
    uint8_t *distance;        /* ... in so many steps + 1; 0: not reached */
} search;

static size_t cell_at(const skv_thin_walls *thin, int x, int y)
{
    return (size_t)y * (size_t)thin->columns + (size_t)x;
}

/* The middle of a cell in grid coordinates. */
static float middle_of(const search *s, int cell)
{
    return skv_to_grid(s->terrain, ((float)(cell - MARGIN) + 0.5f) * (1 / s->thin->per_metre));
}

/* True if a cell, or pixels that reach into it, may be other than before. */
static bool is_redone(const search *s, float gx, float gy, double reach)
{
    return !s->redo || skv_squares_meet(s->redo, (double)gx - reach, (double)gy - reach,
                                        (double)gx + reach, (double)gy + reach);
}

/* Notes the cell of a point in metres, if it is on the grid, as a middle. */
static void note_middle(const skv_thin_walls *thin, double x, double y)
{
    double column = floor(x * (double)thin->per_metre) + MARGIN;
    double row = floor(y * (double)thin->per_metre) + MARGIN;
    if (column >= 0 && row >= 0 && column < thin->columns && row < thin->rows)
        thin->found[(size_t)row * (size_t)thin->columns + (size_t)column] |= MIDDLE;
}

/* Notes the middles of all thin walls; those of walls that stay are found again. */
static void find_middles(const search *s)
{
    const skv_terrain *terrain = s->terrain;
    const double shift = (double)SKV_TERRAIN_RIM - 0.5, pixel = (double)terrain->pixel_size;
    double reach = s->longest + 4;
    int around = (int)reach + 1;
    int x0 = s->within.x0 - around, x1 = s->within.x1 + around;
    int y0 = s->within.y0 - around, y1 = s->within.y1 + around;
    x0 = x0 > 1 ? x0 : 1;
    y0 = y0 > 1 ? y0 : 1;
    x1 = x1 < terrain->columns - 2 ? x1 : terrain->columns - 2;
    y1 = y1 < terrain->rows - 2 ? y1 : terrain->rows - 2;
    for (int y = y0; y < y1; y++) {
        const float *row = terrain->field + (size_t)y * (size_t)terrain->columns;
        for (int x = x0; x < x1; x++) {
            double mx, my;
            if (row[x] > 0 && row[x] <= terrain->pixel_size &&
                is_redone(s, (float)x, (float)y, reach) &&
                find_middle(terrain, x, y, s->longest, &mx, &my))
                note_middle(s->thin, (mx - shift) * pixel, (my - shift) * pixel);
        }
    }
}

/* The cells along a side whose middles lie from pixel `low` to before `high` of `pixels`: from
 * *first to before *end. What lies outside of the picture is near its edge. */
static void cells_between(const search *s, int cells, int low, int high, int pixels, int *first,
                          int *end)
{
    *first = 0;
    *end = cells;
    while (low > 0 && *first < cells && middle_of(s, *first) < (float)low)
        ++*first;
    while (high < pixels && *end > *first && middle_of(s, *end - 1) >= (float)high)
        --*end;
}

/* Finds out which cells a wall passes through, and forgets what else was known of them. */
static void find_solid(const search *s)
{
    const skv_thin_walls *thin = s->thin;
    const skv_terrain *terrain = s->terrain;
    float side = 1 / thin->per_metre;
    int x0, y0, x1, y1;
    cells_between(s, thin->columns, s->within.x0, s->within.x1, terrain->columns, &x0, &x1);
    cells_between(s, thin->rows, s->within.y0, s->within.y1, terrain->rows, &y0, &y1);
    for (int y = y0; y < y1; y++) {
        float gy = middle_of(s, y), air_to = -INFINITY;
        for (int x = x0; x < x1; x++) {
            float gx = middle_of(s, x);
            if (!is_redone(s, gx, gy, 0))
                continue;
            /* A line passes the middles of a chain of cells by no more than half a side. */
            float room = gx <= air_to ? side : skv_grid_distance(terrain, gx, gy) - 0.5f * side;
            thin->found[cell_at(thin, x, y)] = room <= 0 ? SOLID : 0;
            /* Along a row distances fall by at most the way. */
            if (gx > air_to)
                air_to = gx + room * terrain->per_metre - SKV_PIXEL_SLACK;
        }
    }
}

/* A middle counts as solid, however thin the wall. */
static bool is_solid(const skv_thin_walls *thin, size_t at)
{
    return thin->found[at] & (SOLID | MIDDLE);
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
                !is_solid(s->thin, cell_at(s->thin, x + i - AROUND, y + j - AROUND)))
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

/* Whether the wall goes on to two sides of a middle, 0, or how it ends nearby. */
static uint8_t follow(const search *s, int x, int y)
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
        return 0;
    return ways == 1 && up < -(across < 0 ? -across : across) ? UPPER_END : OTHER_END;
}

static void find_ends(const search *s)
{
    const skv_thin_walls *thin = s->thin;
    double reach = (AROUND + 1) * (double)s->terrain->per_metre / (double)thin->per_metre;
    for (int y = AROUND; y < thin->rows - AROUND; y++) {
        for (int x = AROUND; x < thin->columns - AROUND; x++) {
            uint8_t *found = &thin->found[cell_at(thin, x, y)];
            if ((*found & MIDDLE) && is_redone(s, middle_of(s, x), middle_of(s, y), reach))
                *found = (uint8_t)((*found & (MIDDLE | SOLID)) | follow(s, x, y));
        }
    }
}

/* Reaches from the free ends along the walls: what is reached is no thin wall's middle any more. */
static void clear_ends(const search *s)
{
    const skv_thin_walls *thin = s->thin;
    int count = 0;
    for (int y = AROUND; y < thin->rows - AROUND; y++) {
        for (int x = AROUND; x < thin->columns - AROUND; x++) {
            size_t at = cell_at(thin, x, y);
            if (!(thin->found[at] & (UPPER_END | OTHER_END)))
                continue;
            s->distance[at] = thin->found[at] & UPPER_END ? CLEARED + 1 : 1;
            s->queue[count++] = (int)at;
        }
    }
    /* The upper ends' middles alone go away; from the others on it spreads. */
    for (int next = 0; next < count; next++) {
        int at = s->queue[next];
        if (s->distance[at] > CLEARED)
            continue;
        for (int k = 0; k < 9; k++) {
            int x = at % thin->columns + k % 3 - 1, y = at / thin->columns + k / 3 - 1;
            if (x < 0 || y < 0 || x >= thin->columns || y >= thin->rows)
                continue;
            size_t to = cell_at(thin, x, y);
            if (!is_solid(thin, to) || s->distance[to])
                continue;
            s->distance[to] = (uint8_t)(s->distance[at] + 1);
            s->queue[count++] = (int)to;
        }
    }
}

/* Marks all cells within the radius of the middles that are left; ends after too many. Returns
 * their number. */
static int spread(const search *s)
{
    skv_thin_walls *thin = s->thin;
    int count = 0;
    for (int y = SPREAD; y < thin->rows - SPREAD && count <= MOST_NEAR; y++) {
        for (int x = SPREAD; x < thin->columns - SPREAD; x++) {
            size_t at = cell_at(thin, x, y);
            if (!(thin->found[at] & MIDDLE) || s->distance[at])
                continue;
            thin->any = true;
            for (int dy = -SPREAD; dy <= SPREAD; dy++) {
                for (int dx = -SPREAD; dx <= SPREAD; dx++) {
                    uint8_t *mark = &thin->marks[cell_at(thin, x + dx, y + dy)];
                    if (dx * dx + dy * dy > SPREAD * SPREAD || *mark)
                        continue;
                    *mark = 1;
                    count++;
                }
            }
        }
    }
    return count;
}

/* How far, in pixels, from where the picture has changed middles may be other ones: those that lie
 * on a way through the wall that has changed itself, or has begun or ended within its length. Where
 * the wall's surface is farther away, distances are so large that the way is too long. */
static double reach_of_change(double longest)
{
    return 3.5 * longest + 12;
}

static skv_result fail_many(const search *s, skv_error *error)
{
    return skv_fail(
        error, SKV_ERROR_LIMIT,
        "its thin walls are too long for a fluid with a radius of %.3g mm; choose fewer "
        "particles or a wider spacing, or make them thicker or shorter",
        1000.0 * RADIUS / (double)s->thin->per_metre);
}

static skv_result find_walls(search *s, size_t cells, skv_error *error)
{
    size_t middles = 0, solid = 0;
    find_solid(s);
    find_middles(s);
    for (size_t i = 0; i < cells; i++) {
        middles += (s->thin->found[i] & MIDDLE) != 0;
        solid += is_solid(s->thin, i);
    }
    if (middles == 0)
        return SKV_OK;
    if (middles > MOST_NEAR)
        return fail_many(s, error);
    find_ends(s);
    s->distance = skv_calloc(cells, 1);
    s->queue = skv_calloc(solid, sizeof *s->queue); /* each is reached once */
    skv_result result = SKV_OK;
    if (s->distance && s->queue) {
        clear_ends(s);
        if (spread(s) > MOST_NEAR)
            result = fail_many(s, error);
    } else {
        result = skv_fail(error, SKV_ERROR_MEMORY,
                          "walls: no memory for %zu cells; a wider spacing needs fewer", cells);
    }
    skv_free(s->distance);
    skv_free(s->queue);
    return result;
}

/* The empty result, with what was known before. */
static skv_thin_walls *allocate(double per_metre, double columns, double rows,
                                const skv_thin_walls *before)
{
    size_t cells = (size_t)columns * (size_t)rows;
    skv_thin_walls *thin = skv_calloc(1, sizeof *thin);
    if (!thin)
        return NULL;
    *thin = (skv_thin_walls){
        .per_metre = (float)per_metre,
        .columns = (int)columns,
        .rows = (int)rows,
        .marks = skv_calloc(cells, 1),
        .found = skv_calloc(cells, 1),
    };
    if (!thin->marks || !thin->found) {
        skv_thin_walls_destroy(thin);
        return NULL;
    }
    if (before)
        memcpy(thin->found, before->found, cells);
    return thin;
}

skv_result skv_thin_walls_create(const skv_terrain *terrain, float radius,
                                 const skv_thin_walls *before, const skv_squares *changed,
                                 skv_thin_walls **out, skv_error *error)
{
    *out = NULL;
    double per_metre = RADIUS / (double)radius;
    double columns = ceil((double)skv_terrain_width(terrain) * per_metre) + 2 * MARGIN;
    double rows = ceil((double)skv_terrain_height(terrain) * per_metre) + 2 * MARGIN;
    if (columns * rows > MOST_CELLS)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "its fluid with a radius of %.3g mm is too fine for a world of %g x %g m; "
                        "choose fewer particles or a wider spacing",
                        1000 * (double)radius, (double)skv_terrain_width(terrain),
                        (double)skv_terrain_height(terrain));
    search s = {.terrain = terrain,
                .longest = THIN * (double)radius / (double)terrain->pixel_size,
                .within = {0, 0, terrain->columns, terrain->rows}};
    skv_squares redo = {0};
    skv_result result = SKV_OK;
    if (before) {
        result = skv_squares_spread(changed, reach_of_change(s.longest), &redo, error);
        if (result != SKV_OK)
            return result;
        s.redo = &redo;
        s.within = skv_squares_bounds(&redo);
    }
    size_t cells = (size_t)columns * (size_t)rows;
    s.thin = allocate(per_metre, columns, rows, before);
    if (s.thin)
        result = find_walls(&s, cells, error);
    else
        result = skv_fail(error, SKV_ERROR_MEMORY,
                          "walls: no memory for %zu cells; a wider spacing needs fewer", cells);
    skv_squares_destroy(&redo);
    if (result == SKV_OK)
        *out = s.thin;
    else
        skv_thin_walls_destroy(s.thin);
    return result;
}

void skv_thin_walls_destroy(skv_thin_walls *thin)
{
    if (!thin)
        return;
    skv_free(thin->marks);
    skv_free(thin->found);
    skv_free(thin);
}
