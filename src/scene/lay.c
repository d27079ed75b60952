/* Laying fluid: each of so many particles gets its share of the area that is drawn.
 *
 * Lines are drawn through the fluid, and each is cut into stretches where walls, bodies and the
 * fluid's own edges cross it. The lines of a row of particles, a row being as high as the hexagonal
 * lattice's, make a band, and what hangs together of it is a part. A part holds as many particles
 * as its area has room for. What remains of one is carried on to the part above: so each vessel
 * gets its own mass, however narrow it is. Within a part the particles divide the area from left to
 * right evenly, and begin a quarter or three quarters of a particle after the wall, as fits the row
 * below.
 *
 * Invariant: the places depend on water, terrain, spacing and number alone. They are as many as
 * were asked for, and none is in solid.
 */
#include "scene/lay.h"

#include "base/exact.h"
#include "base/memory.h"
#include "scene/paint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lines through all of the fluid when it is measured: two a pixel, so that the floor's height is
 * known to a quarter of one, within limits that keep a few pixels exact and many quick. */
enum { LEAST_LINES = 1000, MOST_LINES = 4000 };
/* Beside walls a line takes two looks a pixel: 4000 lines of 2000 pixels take a fifth of a second.
 */
#define MOST_LOOKS 16e6
/* At least so many lines a band, so that a slanted wall is seen in each. */
enum { BAND_LINES = 9 };
/* A shape is looked for in so many steps of the fluid's width. */
#define STEPS 512
/* Halvings of a step to find an edge in: to less than a thousandth of a pixel. */
enum { HALVINGS = 10 };
/* Shift of each particle, in spacings: a perfect lattice would stand like a crystal. */
#define JITTER 0.02f

/* A piece of a line, with fluid at both ends. */
typedef struct stretch {
    float x0, x1;
    int line; /* of the band, from the bottom */
    int part; /* the first stretch of the part */
} stretch;

/* Which fluid is looked for: a number of the scene's, what is painted as oil, or whichever. */
enum { PAINTED_OIL = SKV_MAX_FLUIDS, FLUIDS, ANY = -1 };

/* What looks for fluid along lines. */
typedef struct scanner {
    skv_water water; /* a copy: its callback's user pointer is not constant */
    const skv_terrain *terrain;
    int fluid;     /* looked for; ANY: whichever */
    float step;    /* of the search, m */
    stretch *list; /* those of the lines at hand */
    int count, capacity;
    bool out_of_memory;
} scanner;

static scanner make_scanner(const skv_water *water, const skv_terrain *terrain, int fluid)
{
    float pixel = skv_terrain_pixel_size(terrain), step = (water->x1 - water->x0) / STEPS;
    return (scanner){.water = *water,
                     .terrain = terrain,
                     .fluid = fluid,
                     .step = water->paint ? skv_minf(step, pixel) : step};
}

/* ---- Lines ----------------------------------------------------------------------------------- */

static int fluid_at(const skv_water *water, float x, float y)
{
    const skv_shape *shape = skv_water_shape_at(water, x, y);
    return shape ? shape->fluid : skv_water_is_oil(water, x, y) ? PAINTED_OIL : 0;
}

static bool is_drawn(scanner *scan, float x, float y)
{
    return skv_water_inside(x, y, &scan->water) && !skv_water_is_covered(&scan->water, x, y) &&
           (scan->fluid == ANY || fluid_at(&scan->water, x, y) == scan->fluid);
}

/* Whether there is fluid, and how far at least the next edge of a wall is along the line; less than
 * 0 in a wall. */
static bool is_wet(scanner *scan, float x, float y, float *room)
{
    /* A sampled distance falls by at most sqrt(2) a pixel. */
    *room = 0.7f * skv_terrain_distance(scan->terrain, x, y);
    return *room > 0 && is_drawn(scan, x, y);
}

/* The same so far along the line. Where walls are more than two steps away they need not be asked:
 * the next step will be a whole one, whatever they say. */
static bool is_wet_after(scanner *scan, float way, float x, float y, float *room)
{
    float left = fabsf(*room) - way;
    if (!(left > scan->step))
        return is_wet(scan, x, y, room);
    *room = *room < 0 ? -left : left;
    return *room > 0 && is_drawn(scan, x, y);
}

/* The wet side of the edge between two points, of which one is dry. */
static float find_edge(scanner *scan, float wet, float dry, float y)
{
    for (int i = 0; i < HALVINGS; i++) {
        float middle = 0.5f * (wet + dry), room;
        if (is_wet(scan, middle, y, &room))
            wet = middle;
        else
            dry = middle;
    }
    return wet;
}

static void note_stretch(scanner *scan, float x0, float x1, int line)
{
    if (scan->count == scan->capacity) {
        int capacity = scan->capacity ? 2 * scan->capacity : 256;
        stretch *list = skv_malloc((size_t)capacity, sizeof *list);
        if (!list) {
            scan->out_of_memory = true;
            return;
        }
        if (scan->count)
            memcpy(list, scan->list, (size_t)scan->count * sizeof *list);
        skv_free(scan->list);
        scan->list = list;
        scan->capacity = capacity;
    }
    scan->list[scan->count] = (stretch){x0, x1, line, scan->count};
    scan->count++;
}

/* Notes the stretches of a line, from left to right. */
static void scan_line(scanner *scan, float y, int line)
{
    float least = 0.5f * skv_terrain_pixel_size(scan->terrain), end = scan->water.x1;
    float x = scan->water.x0, start = x, room;
    bool wet = is_wet(scan, x, y, &room);
    while (x < end) {
        float way = skv_minf(scan->step, skv_maxf(fabsf(room), least));
        float next = skv_minf(x + way, end);
        bool next_wet = is_wet_after(scan, way, next, y, &room);
        if (next_wet && !wet)
            start = find_edge(scan, next, x, y);
        else if (wet && !next_wet)
            note_stretch(scan, start, find_edge(scan, x, next, y), line);
        wet = next_wet;
        x = next;
    }
    if (wet)
        note_stretch(scan, start, end, line);
}

/* The lines that can be had, for all of the fluid. */
static double most_lines(const scanner *scan)
{
    double width = (double)scan->water.x1 - (double)scan->water.x0;
    double looks = 2 * width / (double)skv_terrain_pixel_size(scan->terrain);
    return skv_max(LEAST_LINES, skv_min(MOST_LOOKS / skv_max(looks, 1), MOST_LINES));
}

/* The length of all stretches together. */
static double sum_lengths(const scanner *scan)
{
    double sum = 0;
    for (int i = 0; i < scan->count; i++)
        sum += (double)scan->list[i].x1 - (double)scan->list[i].x0;
    return sum;
}

/* Sets the water's area, and where it begins and ends, to those of the fluid looked for. */
static void measure(scanner *scan)
{
    skv_water *water = &scan->water;
    double y0 = (double)water->y0, height = (double)water->y1 - y0;
    double lines = 2 * height / (double)skv_terrain_pixel_size(scan->terrain);
    int count = (int)skv_max(LEAST_LINES, skv_min(ceil(lines), most_lines(scan)));
    double row = height / count;
    water->area = 0;
    water->low = water->y1;
    water->high = water->y0;
    for (int i = 0; i < count && height > 0; i++) {
        scan->count = 0;
        scan_line(scan, (float)(y0 + (i + 0.5) * row), i);
        water->area += row * sum_lengths(scan);
        if (scan->count) {
            water->low = skv_minf(water->low, (float)(y0 + i * row));
            water->high = (float)(y0 + (i + 1) * row);
        }
    }
}

static skv_result fail_memory(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the fluid");
}

skv_result skv_lay_measure(skv_water *water, const skv_terrain *terrain, skv_error *error)
{
    scanner scan = make_scanner(water, terrain, ANY);
    measure(&scan);
    *water = scan.water;
    skv_free(scan.list);
    return scan.out_of_memory ? fail_memory(error) : SKV_OK;
}

/* ---- Parts ----------------------------------------------------------------------------------- */

/* How fluid is cut into bands. */
typedef struct cut {
    double low, apart; /* m: the lowest line's lower side, and from line to line */
    int bands, lines;  /* of a band */
    int last;          /* the last band that holds fluid */
    double quota;      /* stretches' length for each particle, m */
} cut;

static int part_of(stretch *list, int i)
{
    while (list[i].part != i) {
        list[i].part = list[list[i].part].part;
        i = list[i].part;
    }
    return i;
}

static void scan_band(scanner *scan, const cut *c, int band)
{
    scan->count = 0;
    for (int k = 0; k < c->lines; k++)
        scan_line(scan, (float)(c->low + ((double)band * c->lines + k + 0.5) * c->apart), k);
}

/* Joins the stretches of a band that touch. */
static void find_parts(scanner *scan)
{
    stretch *s = scan->list;
    for (int i = 0, below = 0; i < scan->count; i++) {
        while (below < i && (s[below].line < s[i].line - 1 ||
                             (s[below].line == s[i].line - 1 && s[below].x1 <= s[i].x0)))
            below++;
        for (int k = below; k < i && s[k].line == s[i].line - 1 && s[k].x0 < s[i].x1; k++) {
            int a = part_of(s, k), b = part_of(s, i);
            s[a < b ? b : a].part = a < b ? a : b;
        }
    }
    for (int i = 0; i < scan->count; i++)
        s[i].part = part_of(s, i);
}

/* ---- Laying ---------------------------------------------------------------------------------- */

/* Where a stretch begins or ends. */
typedef struct edge {
    float x;
    int stretch, part;
} edge;

/* What a stretch of a band's highest line hands to whatever lies above it. */
typedef struct handed {
    float x0, x1;
    double remainder; /* particles */
    int count;        /* of its part's particles */
} handed;

typedef struct laying {
    scanner scan;
    cut c;
    float spacing;
    edge *edges;  /* of a band, part by part, from left to right */
    double *room; /* of a part, at its first stretch: particles */
    int *counts; /* of a part, likewise: its particles; before it is laid, those of the one below */
    int *crossed;  /* of each line of a band: the stretch that is being passed; -1: none */
    handed *below; /* what the last band hands on */
    int below_count;
    double pool;      /* what nothing lay above, for the next part: particles */
    float *row_below; /* the last band's particles, from left to right */
    int row_below_count;
    float *x, *y; /* count places */
    int count, laid;
} laying;

static int compare_edges(const void *a, const void *b)
{
    const edge *p = a, *q = b;
    if (p->part != q->part)
        return p->part < q->part ? -1 : 1;
    if (p->x < q->x || q->x < p->x)
        return p->x < q->x ? -1 : 1;
    return p->stretch < q->stretch ? -1 : p->stretch > q->stretch;
}

static float height_of(const laying *w, int band, double line)
{
    return (float)(w->c.low + ((double)band * w->c.lines + line + 0.5) * w->c.apart);
}

/* Puts a particle where the lines at x have their middle; where that is solid, on one of them. */
static void put(laying *w, int band, float x, int lines)
{
    int middle[2] = {-1, -1};
    for (int k = 0, seen = 0; k < w->c.lines && middle[1] < 0; k++)
        if (w->crossed[k] >= 0) {
            middle[0] = seen == (lines - 1) / 2 ? k : middle[0];
            middle[1] = seen == lines / 2 ? k : middle[1];
            seen++;
        }
    float own = height_of(w, band, middle[0]);
    float y = middle[1] - middle[0] > 1 ? own : height_of(w, band, 0.5 * (middle[0] + middle[1]));
    uint32_t id = (uint32_t)w->laid;
    const float places[4][2] = {{x + w->spacing * (skv_scatter(2 * id) * JITTER),
                                 y + w->spacing * (skv_scatter(2 * id + 1) * JITTER)},
                                {x, y},
                                {x, own},
                                {w->scan.list[w->crossed[middle[0]]].x0, own}};
    int chosen = 0;
    float room;
    while (chosen < 3 && !is_wet(&w->scan, places[chosen][0], places[chosen][1], &room))
        chosen++;
    w->x[w->laid] = places[chosen][0];
    w->y[w->laid] = places[chosen][1];
    w->laid++;
}

/* The part whose edges these are. */
typedef struct parcel {
    const edge *edges;
    int edge_count;
    double length; /* of its stretches, m */
    int count;     /* of particles */
} parcel;

/* Lays a part's particles, the first of them after so much of its share. */
static void lay_from(laying *w, int band, const parcel *p, double first)
{
    const edge *e = p->edges;
    double passed = 0, share = p->length / p->count;
    for (int i = 0, k = 0, lines = 0; k + 1 < p->edge_count && i < p->count; k++) {
        int line = w->scan.list[e[k].stretch].line;
        bool begins = w->crossed[line] != e[k].stretch;
        w->crossed[line] = begins ? e[k].stretch : -1;
        lines += begins ? 1 : -1;
        double way = lines * ((double)e[k + 1].x - (double)e[k].x);
        for (; i < p->count && (i + first) * share < passed + way; i++)
            put(w, band, e[k].x + (float)(((i + first) * share - passed) / lines), lines);
        passed += way;
    }
    for (int k = 0; k < w->c.lines; k++)
        w->crossed[k] = -1;
}

/* How far along the row the particles laid last are from those of the row below, m in all. */
static double gaps_below(const laying *w, int from)
{
    double sum = 0;
    for (int i = from, k = 0; i < w->laid; i++) {
        while (k < w->row_below_count && w->row_below[k] < w->x[i])
            k++;
        float after = k < w->row_below_count ? w->row_below[k] - w->x[i] : w->spacing;
        float before = k > 0 ? w->x[i] - w->row_below[k - 1] : w->spacing;
        sum += (double)skv_minf(w->spacing, skv_minf(after, before));
    }
    return sum;
}

/* Lays a part so that its particles stand above the gaps of those below. */
static void lay_part(laying *w, int band, const parcel *p)
{
    int from = w->laid;
    double first = band % 2 ? 0.75 : 0.25;
    lay_from(w, band, p, 1 - first);
    double other = gaps_below(w, from);
    w->laid = from;
    lay_from(w, band, p, first);
    if (other > gaps_below(w, from)) {
        w->laid = from;
        lay_from(w, band, p, 1 - first);
    }
}

/* Takes what the band below hands on, to the part above each, or else to the pool. */
static void take_over(laying *w)
{
    const stretch *s = w->scan.list;
    int i = 0;
    for (int k = 0; k < w->below_count; k++) {
        const handed *h = &w->below[k];
        while (i < w->scan.count && s[i].line == 0 && s[i].x1 <= h->x0)
            i++;
        if (i < w->scan.count && s[i].line == 0 && s[i].x0 < h->x1) {
            w->room[s[i].part] += h->remainder;
            w->counts[s[i].part] = h->count;
        } else
            w->pool += h->remainder;
    }
}

/* Hands on what remains: by the first stretch of a part on the highest line, or else to the pool.
 */
static void hand_on(laying *w)
{
    const stretch *s = w->scan.list;
    w->below_count = 0;
    for (int i = 0; i < w->scan.count; i++)
        if (s[i].line == w->c.lines - 1) {
            w->below[w->below_count++] =
                (handed){s[i].x0, s[i].x1, w->room[s[i].part], w->counts[s[i].part]};
            w->room[s[i].part] = 0;
        }
    for (int i = 0; i < w->scan.count; i++)
        w->pool += s[i].part == i ? w->room[i] : 0;
}

static int compare_places(const void *a, const void *b)
{
    float p = *(const float *)a, q = *(const float *)b;
    return p < q ? -1 : p > q;
}

static void note_row(laying *w, int from)
{
    w->row_below_count = w->laid - from;
    if (w->row_below_count == 0)
        return;
    memcpy(w->row_below, w->x + from, (size_t)w->row_below_count * sizeof *w->row_below);
    qsort(w->row_below, (size_t)w->row_below_count, sizeof *w->row_below, compare_places);
}

/* How many particles a part gets. As many as the part below has make a lattice with it. Fluids laid
 * apart keep them while that is off by a particle at most, for heavy fluid over light is not put in
 * order by settling, and sinks farther the less order there is; a pool is as calm without. The last
 * band leaves no remainder. */
static int count_for(const laying *w, int band, int part, double room)
{
    double count = floor(room + 0.5);
    if (w->scan.fluid != ANY && band != w->c.last && w->counts[part] > 0 &&
        fabs(room - w->counts[part]) <= 1)
        count = w->counts[part];
    return (int)skv_max(0, skv_min(count, w->count - w->laid));
}

/* Lays the part whose edges begin at `from`; returns where those of the next one do. */
static int lay_next(laying *w, int band, int from)
{
    int part = w->edges[from].part, to = from;
    double length = 0;
    for (; to < 2 * w->scan.count && w->edges[to].part == part; to++) {
        const stretch *own = &w->scan.list[w->edges[to].stretch];
        length += 0.5 * ((double)own->x1 - (double)own->x0);
    }
    double room = length / w->c.quota + w->room[part] + w->pool;
    int count = count_for(w, band, part, room);
    if (count > 0)
        lay_part(w, band, &(parcel){w->edges + from, to - from, length, count});
    /* In the last band nothing lies above: the last part of all takes what remains. */
    w->pool = band == w->c.last ? room - count : 0;
    w->room[part] = band == w->c.last ? 0 : room - count;
    w->counts[part] = count;
    return to;
}

static void lay_band(laying *w, int band)
{
    scan_band(&w->scan, &w->c, band);
    if (w->scan.out_of_memory)
        return;
    find_parts(&w->scan);
    const stretch *s = w->scan.list;
    for (int i = 0; i < w->scan.count; i++) {
        w->room[i] = 0;
        w->counts[i] = 0;
        w->edges[2 * i] = (edge){s[i].x0, i, s[i].part};
        w->edges[2 * i + 1] = (edge){s[i].x1, i, s[i].part};
    }
    take_over(w);
    qsort(w->edges, 2 * (size_t)w->scan.count, sizeof *w->edges, compare_edges);
    int laid = w->laid;
    for (int from = 0; from < 2 * w->scan.count;)
        from = lay_next(w, band, from);
    hand_on(w);
    note_row(w, laid);
}

/* Cuts the fluid into bands of whole lines, as high as the lattice's rows, and finds each
 * particle's quota. */
static void make_cut(laying *w)
{
    const skv_water *water = &w->scan.water;
    double height = (double)water->high - (double)water->low;
    double row = (double)w->spacing * sqrt(sqrt(3.0) / 2);
    cut *c = &w->c;
    c->low = (double)water->low;
    c->bands = (int)skv_max(1, floor(height / row + 0.5));
    double fine = 2 * height / c->bands / (double)skv_terrain_pixel_size(w->scan.terrain);
    fine = skv_min(ceil(fine), most_lines(&w->scan) / c->bands);
    c->lines = (int)skv_max(BAND_LINES, fine);
    c->apart = height / c->bands / c->lines;
    double length = 0;
    for (int i = 0; i < c->bands; i++) {
        scan_band(&w->scan, c, i);
        c->last = w->scan.count ? i : c->last;
        length += sum_lengths(&w->scan);
    }
    c->quota = length / (w->count - w->laid);
}

static skv_result lay_cut(laying *w, skv_error *error)
{
    size_t most = (size_t)w->scan.capacity;
    w->edges = skv_malloc(2 * most, sizeof *w->edges);
    w->room = skv_malloc(most, sizeof *w->room);
    w->counts = skv_malloc(most, sizeof *w->counts);
    w->below = skv_malloc(most, sizeof *w->below);
    w->row_below = skv_malloc((size_t)(w->count - w->laid), sizeof *w->row_below);
    w->crossed = skv_malloc((size_t)w->c.lines, sizeof *w->crossed);
    bool complete = w->edges && w->room && w->counts && w->below && w->row_below && w->crossed;
    for (int k = 0; complete && k < w->c.lines; k++)
        w->crossed[k] = -1;
    for (int i = 0; complete && i < w->c.bands; i++)
        lay_band(w, i);
    skv_free(w->crossed);
    skv_free(w->row_below);
    skv_free(w->below);
    skv_free(w->counts);
    skv_free(w->room);
    skv_free(w->edges);
    return complete ? SKV_OK : fail_memory(error);
}

/* Lays `count` particles of the fluid looked for after those that are laid, and is done with the
 * scanner. */
static skv_result lay_fluid(laying *w, const scanner *scan, int count, skv_error *error)
{
    w->scan = *scan;
    w->c = (cut){0};
    w->count = w->laid + count;
    w->below_count = w->row_below_count = 0;
    w->pool = 0;
    skv_result result = SKV_OK;
    if (count > 0) {
        make_cut(w);
        result = w->scan.out_of_memory ? fail_memory(error)
                 : !(w->c.quota > 0)   ? skv_fail(error, SKV_ERROR_VALUE,
                                                  "water: is too thin for particles; draw more of it")
                                       : lay_cut(w, error);
    }
    skv_free(w->scan.list);
    return result;
}

/* Each fluid has rows of its own, so that it has its own mass, and the lower edge of one is no
 * row's middle. */
static skv_result lay_apart(laying *w, const skv_water *water, const skv_terrain *terrain,
                            int count, skv_error *error)
{
    scanner own[FLUIDS];
    double total = 0, passed = 0;
    int last = 0;
    for (int fluid = 0; fluid < FLUIDS; fluid++) {
        own[fluid] = make_scanner(water, terrain, fluid);
        measure(&own[fluid]);
        total += own[fluid].water.area;
        last = own[fluid].water.area > 0 ? fluid : last;
    }
    skv_result result = SKV_OK;
    for (int fluid = 0; fluid < FLUIDS; fluid++) {
        passed += own[fluid].water.area;
        int until = fluid < last ? (int)floor(passed / total * count + 0.5) : count;
        if (result == SKV_OK)
            result = lay_fluid(w, &own[fluid], until - w->laid, error);
        else
            skv_free(own[fluid].list);
    }
    return result;
}

static bool has_several_fluids(const skv_water *water)
{
    size_t pixels = (size_t)water->width * (size_t)water->height;
    for (size_t i = 0; water->paint && i < pixels; i++)
        if (water->paint[i] == SKV_PAINT_OIL)
            return true;
    bool plain = water->paint || water->level > 0;
    int first = plain || water->shape_count == 0 ? 0 : water->shapes[0].fluid;
    for (int i = 0; i < water->shape_count; i++)
        if (water->shapes[i].fluid != first)
            return true;
    return false;
}

skv_result skv_lay(const skv_water *water, const skv_terrain *terrain, float spacing, int count,
                   float *x, float *y, skv_error *error)
{
    laying w = {.spacing = spacing, .x = x, .y = y};
    if (has_several_fluids(water))
        return lay_apart(&w, water, terrain, count, error);
    scanner scan = make_scanner(water, terrain, ANY);
    return lay_fluid(&w, &scan, count, error);
}
