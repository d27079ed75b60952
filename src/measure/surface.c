/* The surface of the fluid as lines: the contour of fill on a grid, piece by piece, joined.
 *
 * A grid of nodes covers the world. Nodes beside or just inside a wall take the fill of the free
 * place before it, so that the contour runs straight into the wall; there it is cut off, or, for
 * closed lines, the distance to the wall joins in as a second bound. Invariant: pieces meet on grid
 * edges, at most one begins and one ends on an edge, so following them from edge to edge gives
 * every line once.
 */
#include "base/arrays.h"
#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "measure/contour.h"
#include "measure/survey.h"

#include <math.h>
#include <string.h>

enum { SURFACE_COOKIE = 0x5355, GRID_MAX = 4096, NONE = -1, WALL_ROUNDS = 3 };

/* How deep in a wall nodes take part, in steps: those of cells that the wall's face crosses. */
#define DEEPEST 1.5
/* Nodes nearer to a wall ask so far from it instead, in h: close to the corner of two walls the
 * share of solid, and with it the fill, is wrong. */
#define BESIDE 0.3

/* A piece within a cell: the grid edges on which it begins and ends, NONE where a wall cuts it. */
typedef struct piece {
    skv_point a, b;
    int from, to;
    bool taken;
} piece;

typedef struct line {
    int first, count;
    bool closed;
} line;

struct skv_surface {
    skv_grid grid;
    void *grid_block;
    int grid_room; /* nodes */
    float *value;  /* of nodes: fill less the level; NaN: not known */
    /* By grid edge: the piece that begins there and whether one ends there. Edge 2 n goes from node
     * n to the right, 2 n + 1 upwards. */
    int *begins;
    uint8_t *ends;

    void *line_block;
    int piece_room, piece_count;
    piece *pieces;
    skv_point *points; /* line after line */
    line *lines;
    int point_count, line_count;
};

skv_surface_def skv_default_surface_def(void)
{
    return (skv_surface_def){.level = 0.5, .cookie = SKV_COOKIE(SURFACE_COOKIE, skv_surface_def)};
}

void skv_surface_def_init(skv_surface_def *def, size_t size)
{
    const skv_surface_def standard = skv_default_surface_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

skv_result skv_surface_create(skv_surface **surface, skv_error *error)
{
    SKV_ASSERT_OR(surface, SKV_ERROR_VALUE);
    *surface = skv_calloc(1, sizeof **surface);
    return *surface ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a surface");
}

void skv_surface_destroy(skv_surface *surface)
{
    if (!surface)
        return;
    skv_free(surface->grid_block);
    skv_free(surface->line_block);
    skv_free(surface);
}

/* A step beyond the world on every side, so that closed lines can pass there. */
static skv_result reserve_grid(skv_surface *f, const skv_survey *survey, double step,
                               skv_error *error)
{
    double width = (double)skv_terrain_width(survey->terrain);
    double height = (double)skv_terrain_height(survey->terrain);
    double columns = ceil(width / step) + 3, rows = ceil(height / step) + 3;
    if (!(step > 0) || columns > GRID_MAX || rows > GRID_MAX)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "surface: a step of %g m gives a grid of more than %d columns or rows",
                        step, GRID_MAX);
    f->grid = (skv_grid){-step, -step, step, (int)columns, (int)rows};
    int nodes = f->grid.columns * f->grid.rows;
    if (nodes <= f->grid_room)
        return SKV_OK;
    const skv_array arrays[] = {SKV_ARRAY(f->value, (size_t)nodes, 0),
                                SKV_ARRAY(f->begins, 2 * (size_t)nodes, 0),
                                SKV_ARRAY(f->ends, 2 * (size_t)nodes, 0)};
    if (!skv_arrays_grow(&f->grid_block, arrays, 3))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a surface of %d nodes", nodes);
    f->grid_room = nodes;
    return SKV_OK;
}

/* The fill at a node, less the level. */
static double value_at(const skv_survey *survey, double step, const skv_surface_def *def, double x,
                       double y)
{
    double d = (double)skv_terrain_distance(survey->terrain, (float)x, (float)y);
    double outline = d / survey->h;
    if (d < -DEEPEST * step)
        return def->closed ? outline : (double)NAN;
    double out = BESIDE * survey->h - d;
    if (out > 0) {
        float nx, ny;
        skv_terrain_normal(survey->terrain, (float)x, (float)y, &nx, &ny);
        x += out * (double)nx;
        y += out * (double)ny;
    }
    double value = skv_survey_fill(survey, x, y) - def->level;
    return def->closed && outline < value ? outline : value;
}

static void read_nodes(skv_surface *f, const skv_survey *survey, const skv_surface_def *def)
{
    const skv_grid *g = &f->grid;
    for (int row = 0; row < g->rows; row++) {
        for (int column = 0; column < g->columns; column++) {
            double value =
                value_at(survey, g->step, def, g->x + column * g->step, g->y + row * g->step);
            bool rim = column == 0 || row == 0 || column == g->columns - 1 || row == g->rows - 1;
            if (rim && def->closed && value > -1e-3)
                value = -1e-3; /* beyond an open side, too, closed lines close */
            f->value[row * g->columns + column] = (float)value;
        }
    }
}

static int edge_of(const skv_grid *grid, int column, int row, int edge)
{
    int node = (row + (edge == 2)) * grid->columns + column + (edge == 1);
    return 2 * node + edge % 2;
}

/* Cuts off what of a piece lies in solid; false if all of it does. */
static bool cut_at_wall(piece *p, const skv_terrain *terrain)
{
    float a = skv_terrain_distance(terrain, p->a.x, p->a.y);
    float b = skv_terrain_distance(terrain, p->b.x, p->b.y);
    if (a < 0 && b < 0)
        return false;
    if (a >= 0 && b >= 0)
        return true;
    /* More than once: the distance bends between the centres of pixels. */
    skv_point from = p->a, to = p->b, at = from;
    float before = a, after = b;
    for (int round = 0; round < WALL_ROUNDS; round++) {
        float share = before / (before - after);
        at = (skv_point){from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
        float here = skv_terrain_distance(terrain, at.x, at.y);
        if ((here < 0) == (before < 0)) {
            from = at;
            before = here;
        } else {
            to = at;
            after = here;
        }
    }
    if (a < 0) {
        p->a = at;
        p->from = NONE;
    } else {
        p->b = at;
        p->to = NONE;
    }
    return true;
}

/* Finds the pieces, cell by cell; keeps those for which there is room, and counts all. */
static int find_pieces(skv_surface *f, const skv_terrain *cut)
{
    int found = 0;
    for (int row = 0; row + 1 < f->grid.rows; row++) {
        for (int column = 0; column + 1 < f->grid.columns; column++) {
            skv_contour_cell cell = skv_contour_cell_at(&f->grid, f->value, 0, column, row);
            skv_contour_piece ends[2];
            int count = skv_contour_pieces(&cell, ends);
            for (int i = 0; i < count; i++) {
                piece p = {.a = skv_contour_crossing(&cell, ends[i].from),
                           .b = skv_contour_crossing(&cell, ends[i].to),
                           .from = edge_of(&f->grid, column, row, ends[i].from),
                           .to = edge_of(&f->grid, column, row, ends[i].to)};
                if (cut && !cut_at_wall(&p, cut))
                    continue;
                if (found < f->piece_room)
                    f->pieces[found] = p;
                found++;
            }
        }
    }
    return found;
}

/* Finds all pieces, making room for them if there is not enough. */
static skv_result take_pieces(skv_surface *f, const skv_terrain *cut, skv_error *error)
{
    f->piece_count = find_pieces(f, cut);
    if (f->piece_count <= f->piece_room)
        return SKV_OK;
    int room = f->piece_count + f->piece_count / 2;
    const skv_array arrays[] = {SKV_ARRAY(f->pieces, (size_t)room, 0),
                                SKV_ARRAY(f->points, 2 * (size_t)room, 0),
                                SKV_ARRAY(f->lines, (size_t)room, 0)};
    if (!skv_arrays_grow(&f->line_block, arrays, 3))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a surface of %d pieces", room);
    f->piece_room = room;
    f->piece_count = find_pieces(f, cut);
    return SKV_OK;
}

/* Follows the pieces from one on, until there is none or it is one of the line's own. */
static void follow(skv_surface *f, int first)
{
    line *l = &f->lines[f->line_count++];
    *l = (line){.first = f->point_count};
    int at = first;
    for (;;) {
        piece *p = &f->pieces[at];
        p->taken = true;
        f->points[f->point_count++] = p->a;
        at = p->to == NONE ? NONE : f->begins[p->to];
        if (at == NONE) {
            f->points[f->point_count++] = p->b;
            break;
        }
        if (f->pieces[at].taken) {
            l->closed = true;
            break;
        }
    }
    l->count = f->point_count - l->first;
}

static void join_pieces(skv_surface *f)
{
    size_t edges = 2 * (size_t)f->grid.columns * (size_t)f->grid.rows;
    for (size_t e = 0; e < edges; e++)
        f->begins[e] = NONE;
    memset(f->ends, 0, edges);
    for (int i = 0; i < f->piece_count; i++) {
        if (f->pieces[i].from != NONE)
            f->begins[f->pieces[i].from] = i;
        if (f->pieces[i].to != NONE)
            f->ends[f->pieces[i].to] = 1;
    }
    /* Lines that end somewhere first: from their beginnings. What is left goes round. */
    for (int i = 0; i < f->piece_count; i++)
        if (f->pieces[i].from == NONE || !f->ends[f->pieces[i].from])
            follow(f, i);
    for (int i = 0; i < f->piece_count; i++)
        if (!f->pieces[i].taken)
            follow(f, i);
}

skv_result skv_surface_find(skv_surface *surface, const skv_survey *survey,
                            const skv_surface_def *def, skv_error *error)
{
    SKV_ASSERT_OR(surface && survey, SKV_ERROR_VALUE);
    skv_surface_def plain = skv_default_surface_def();
    def = def ? def : &plain;
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &plain, sizeof plain), SKV_ERROR_VALUE);
    surface->piece_count = surface->point_count = surface->line_count = 0;
    if (!(def->step >= 0) || !(def->level >= 0.05 && def->level <= 0.95))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "surface: step %g m, level %g; allowed are 0 or more, and 0.05..0.95",
                        def->step, def->level);
    if (!survey->terrain)
        return SKV_OK; /* it has not looked yet */
    double step = def->step > 0 ? def->step : survey->spacing;
    skv_result result = reserve_grid(surface, survey, step, error);
    if (result != SKV_OK)
        return result;
    read_nodes(surface, survey, def);
    result = take_pieces(surface, def->closed ? NULL : survey->terrain, error);
    if (result == SKV_OK)
        join_pieces(surface);
    else
        surface->piece_count = 0;
    return result;
}

int skv_surface_line_count(const skv_surface *surface)
{
    SKV_ASSERT_OR(surface, 0);
    return surface->line_count;
}

const skv_point *skv_surface_line(const skv_surface *surface, int at, int *count, bool *closed)
{
    SKV_ASSERT_OR(surface && count, NULL);
    *count = 0;
    if (at < 0 || at >= surface->line_count)
        return NULL;
    const line *l = &surface->lines[at];
    *count = l->count;
    if (closed)
        *closed = l->closed;
    return surface->points + l->first;
}
