/* Channels: the narrowest places on the widest ways from vessel to vessel.
 *
 * Cells of a quarter of a spacing are taken up one by one, those farthest from walls first. Cells
 * that touch grow together; where two of these groups meet, both of which are wide somewhere, the
 * cell between them is the narrowest place of the widest way from one to the other.
 *
 * Invariant: a thin wall between two cells looks like a channel of two cells at most, and so narrow
 * a channel is none.
 */
#include "scene/channels.h"

#include <math.h>

#include "base/exact.h"
#include "base/memory.h"

#define CELL      0.25    /* spacings */
#define MOST      1000000 /* cells: above that they are larger */
#define VESSEL    5.0     /* spacings: as wide is a vessel somewhere */
#define BUCKETS   1024    /* of distances, in which cells are sorted */
#define DIAGONAL  1.41421356f
#define FAR_SHARE 0.99 /* of the terrain's reach: from there on distances are counted by cells */

/* A group of cells, as its first one has it. */
typedef struct group {
    int parent;
    float distance; /* of this cell to the nearest wall, m; below 0: solid */
    float widest;   /* of all cells of the group */
    float top;      /* the highest water in it, against gravity, m; -infinity: none */
} group;

typedef struct joint {
    int cell;
    float distance;
} joint;

typedef struct grid {
    const skv_scene *scene;
    int columns, rows;
    float size;   /* of a cell, m */
    float ux, uy; /* upwards */
    group *cells;
    int *order; /* cells of the free region, farthest from walls first */
    int free;
    joint *joints; /* of vessels */
    int joint_count;
} grid;

static int root_of(grid *g, int cell)
{
    while (g->cells[cell].parent != cell) {
        g->cells[cell].parent = g->cells[g->cells[cell].parent].parent;
        cell = g->cells[cell].parent;
    }
    return cell;
}

static float cell_x(const grid *g, int cell)
{
    return ((float)(cell % g->columns) + 0.5f) * g->size;
}

static float cell_y(const grid *g, int cell)
{
    int row = cell / g->columns;
    return ((float)row + 0.5f) * g->size;
}

static float height_of(const grid *g, int cell)
{
    return g->ux * cell_x(g, cell) + g->uy * cell_y(g, cell);
}

/* ---- Distances ------------------------------------------------------------------------------- */

/* As far as the cell at (column, row), and the way from there. */
static void come_from(grid *g, int cell, int column, int row, float way)
{
    if (column < 0 || row < 0 || column >= g->columns || row >= g->rows)
        return;
    float distance = g->cells[row * g->columns + column].distance + way * g->size;
    if (distance < g->cells[cell].distance)
        g->cells[cell].distance = distance;
}

/* How far the terrain's distances tell. */
static float reach_of(const grid *g)
{
    return (float)(FAR_SHARE * SKV_TERRAIN_REACH * g->scene->pixel_size);
}

/* The terrain's distances; beyond its reach, those from cell to cell. */
static void find_distances(grid *g)
{
    const skv_terrain *terrain = g->scene->terrain;
    float reach = reach_of(g);
    int count = g->columns * g->rows;
    for (int i = 0; i < count; i++) {
        float distance = skv_terrain_distance(terrain, cell_x(g, i), cell_y(g, i));
        g->cells[i].distance = distance < reach ? distance : INFINITY;
    }
    for (int way = 1; way >= -1; way -= 2) {
        for (int k = 0; k < count; k++) {
            int i = way > 0 ? k : count - 1 - k, column = i % g->columns, row = i / g->columns;
            come_from(g, i, column - way, row, 1);
            come_from(g, i, column, row - way, 1);
            come_from(g, i, column - way, row - way, DIAGONAL);
            come_from(g, i, column + way, row - way, DIAGONAL);
        }
    }
}

/* ---- Groups ---------------------------------------------------------------------------------- */

static void begin_groups(grid *g)
{
    skv_water water = g->scene->water; /* the callback's user pointer is not constant */
    for (int i = 0; i < g->columns * g->rows; i++) {
        group *own = &g->cells[i];
        own->parent = -1;
        own->widest = own->distance;
        bool wet = own->distance > 0 && skv_water_inside(cell_x(g, i), cell_y(g, i), &water);
        own->top = wet ? height_of(g, i) : -INFINITY;
    }
    for (int e = 0; e < g->scene->emitter_count; e++) {
        int column = (int)(g->scene->emitters[e].x / g->size);
        int row = (int)(g->scene->emitters[e].y / g->size);
        if (column >= 0 && row >= 0 && column < g->columns && row < g->rows)
            g->cells[row * g->columns + column].top = INFINITY;
    }
}

/* The bucket of a cell: 0 is farthest from walls. */
static int bucket_of(const grid *g, int cell, float narrow)
{
    float share = g->cells[cell].distance / narrow;
    return share >= 1 ? 0 : BUCKETS - 1 - (int)(share * (BUCKETS - 1));
}

/* Sorts the free cells; those at least `narrow` from walls come first, in any order. */
static void sort_cells(grid *g, float narrow)
{
    int begin[BUCKETS + 1] = {0};
    int count = g->columns * g->rows;
    for (int i = 0; i < count; i++)
        if (g->cells[i].distance > 0)
            begin[bucket_of(g, i, narrow) + 1]++;
    for (int b = 0; b < BUCKETS; b++)
        begin[b + 1] += begin[b];
    g->free = begin[BUCKETS];
    for (int i = 0; i < count; i++)
        if (g->cells[i].distance > 0)
            g->order[begin[bucket_of(g, i, narrow)]++] = i;
}

/* Lets the group of a cell grow together with that of the cell beside it, if that is taken up.
 * `narrow` and `vessel` are distances from walls. */
static void join(grid *g, int cell, int beside, float narrow, float vessel)
{
    if (g->cells[beside].parent < 0)
        return;
    int a = root_of(g, cell), b = root_of(g, beside);
    if (a == b)
        return;
    group *to = &g->cells[a], *from = &g->cells[b];
    float distance = g->cells[cell].distance;
    if (distance < narrow && to->widest >= vessel && from->widest >= vessel)
        g->joints[g->joint_count++] = (joint){cell, distance};
    from->parent = a;
    to->widest = skv_maxf(to->widest, from->widest);
    to->top = skv_maxf(to->top, from->top);
}

static void join_all(grid *g, float narrow, float vessel)
{
    for (int k = 0; k < g->free; k++) {
        int i = g->order[k], column = i % g->columns, row = i / g->columns;
        g->cells[i].parent = i;
        if (column > 0)
            join(g, i, i - 1, narrow, vessel);
        if (column + 1 < g->columns)
            join(g, i, i + 1, narrow, vessel);
        if (row > 0)
            join(g, i, i - g->columns, narrow, vessel);
        if (row + 1 < g->rows)
            join(g, i, i + g->columns, narrow, vessel);
    }
}

/* ---- Channels -------------------------------------------------------------------------------- */

/* The width of a channel that goes through a cell: across its middle, from two places on either
 * side of it, for between two pixels the distances themselves tell a pixel less. */
static float width_at(const grid *g, int cell)
{
    enum { STEPS = 8 };
    static const float to_x[] = {1, 0.7071068f, 0, -0.7071068f},
                       to_y[] = {0, 0.7071068f, 1, 0.7071068f};
    const skv_terrain *terrain = g->scene->terrain;
    float most = -INFINITY, least = INFINITY, x = 0, y = 0,
          aside = 1.5f * (float)g->scene->pixel_size;
    for (int k = 0; k < (STEPS + 1) * (STEPS + 1); k++) {
        int row = k / (STEPS + 1), column = k % (STEPS + 1);
        float at_x = cell_x(g, cell) + ((float)column / STEPS - 0.5f) * g->size;
        float at_y = cell_y(g, cell) + ((float)row / STEPS - 0.5f) * g->size;
        float distance = skv_terrain_distance(terrain, at_x, at_y);
        if (distance <= most)
            continue;
        most = distance;
        x = at_x;
        y = at_y;
    }
    if (most >= reach_of(g))
        return 2 * g->cells[cell].distance +
               0.5f * g->size; /* a cell lies somewhere in the middle */
    for (int k = 0; k < 4; k++) {
        float dx = aside * to_x[k], dy = aside * to_y[k];
        least = skv_minf(least, skv_terrain_distance(terrain, x + dx, y + dy) +
                                    skv_terrain_distance(terrain, x - dx, y - dy));
    }
    return least + 2 * aside;
}

/* The width of the narrowest channel that is no thin wall, if it is less than `narrow`, and that
 * water comes to: it stands higher in the same free region. Else 0. */
static float narrowest(grid *g, float narrow)
{
    float least = narrow;
    for (int k = 0; k < g->joint_count; k++) {
        const joint *j = &g->joints[k];
        bool wet = g->cells[root_of(g, j->cell)].top > height_of(g, j->cell);
        if (wet && j->distance > g->size)
            least = skv_minf(least, width_at(g, j->cell));
    }
    return least < narrow ? least : 0;
}

double skv_scene_narrow_channel(const skv_scene *scene)
{
    const skv_world_def *def = &scene->def;
    float gravity = sqrtf(def->gravity_x * def->gravity_x + def->gravity_y * def->gravity_y);
    if (!(gravity > 0) || (scene->solid_count == 0 && scene->paint == NULL))
        return 0; /* there are no levels, or no walls between */
    double s = (double)def->fluid.spacing, width = scene->width * scene->pixel_size,
           height = scene->height * scene->pixel_size;
    double size = skv_max(skv_max(CELL * s, scene->pixel_size), sqrt(width * height / MOST));
    grid g = {.scene = scene,
              .columns = (int)(width / size),
              .rows = (int)(height / size),
              .size = (float)size,
              .ux = -def->gravity_x / gravity,
              .uy = -def->gravity_y / gravity};
    size_t count = (size_t)g.columns * (size_t)g.rows;
    g.cells = skv_calloc(count + 1, sizeof *g.cells);
    g.order = skv_calloc(count + 1, sizeof *g.order);
    g.joints = skv_calloc(count + 1, sizeof *g.joints);
    float found = 0, narrow = (float)(SKV_CHANNEL_NARROW * s);
    if (g.cells != NULL && g.order != NULL && g.joints != NULL) {
        find_distances(&g);
        begin_groups(&g);
        sort_cells(&g, 0.5f * narrow);
        join_all(&g, 0.5f * narrow, (float)(VESSEL / 2 * s));
        found = narrowest(&g, narrow);
    }
    skv_free(g.cells);
    skv_free(g.order);
    skv_free(g.joints);
    return (double)found;
}
