/* How fluid lies: regions of it in square cells, along gravity and across it.
 *
 * Cells are so large that each one inside a fresh lattice holds a particle. Those that touch, with
 * no wall between, are a region; those of it above each other are a column. What is beside a cell
 * of it is fluid, a wall or air; bodies are walls. A region rests if there is no air below or
 * beside it, all the air above it is at one level, and no fluid of it stands higher, below a roof.
 * It also rests below a surface that is drawn uneven, by more than particles can hide, but nowhere
 * steep.
 *
 * Invariant: cells, and what is found of them, follow from the particles and their order alone.
 */
#include "calm/regions.h"

#include "base/exact.h"
#include "base/memory.h"
#include "world/bodies/bodies.h"
#include "world/fluids.h"

#include <math.h>

#define CELL_SIZE  1.5f /* spacings */
#define WALL_REACH 4.0f /* spacings: from one cell's particle to the next one's */
#define AIR        4.0f /* spacings: through a cell, another, and a row that is missing at a wall */
#define ONE_LEVEL  3.0f /* spacings: two cells */
#define EVEN       1.0f /* spacings: what particles can't show of a drawn surface */
#define DRAWN_STEP 0.125f /* spacings: in which it is looked for */

/* Beside a cell: above, below, and to either side. */
enum { ABOVE, BELOW, SIDES = 2, NEIGHBOURS = 4 };
static const int column_step[NEIGHBOURS] = {0, 0, -1, 1};
static const int row_step[NEIGHBOURS] = {1, -1, 0, 0};

typedef struct cell {
    int column, row;        /* across gravity, and against it */
    int particle;           /* one of its */
    int highest;            /* of its particles */
    int count;              /* of them */
    int next;               /* in the same slot, as in `head` */
    int region;             /* -1 at first */
    unsigned air;           /* a bit for each side with air beside it */
    float high, low;        /* its particles, along gravity; then the column's highest and lowest */
    int beside[NEIGHBOURS]; /* numbers of the cells that its fluid touches, from 1; 0: none */
    int top;                /* number of its column's highest cell */
    float mass;             /* of its particles, if not all weigh as much: the sum, then the mean */
    bool carried;           /* its column is */
    bool measured;
} cell;

typedef struct region {
    float top; /* its highest particle, along gravity; a roof may keep it from the air */
    float highest, lowest;    /* its free surface, along gravity */
    float lowest_side;        /* the lowest place with air beside it */
    bool falls;               /* there is air below some of it */
    bool mixed;               /* it is not layered by density */
    int first, end;           /* columns; some of its cells are in each between */
    skv_drawn_surface *drawn; /* null: it is even */
} region;

typedef struct regions {
    const skv_world *world;
    float ux, uy;  /* upwards: against gravity */
    float size;    /* of a cell, m */
    unsigned mask; /* of the table's slots, a power of two less one */
    int *head;     /* by slot: number of the last cell put there, from 1; 0: none */
    cell *cells;
    int cell_count;
    int *cell_of; /* by particle */
    region *regions;
    int *stack;          /* cells whose neighbours have to be looked at */
    const float *masses; /* by particle, over the first fluid's; null: all 1 */
} regions;

static float along(const regions *b, int particle)
{
    const skv_state *s = &b->world->state;
    return s->x[particle] * b->ux + s->y[particle] * b->uy;
}

static float across(const regions *b, int particle)
{
    const skv_state *s = &b->world->state;
    return s->x[particle] * b->uy - s->y[particle] * b->ux;
}

/* Whether particles have masses of their own. */
static bool has_masses(const regions *b)
{
#ifdef SKV_WITHOUT_FLUIDS
    (void)b;
    return false;
#else
    return b->masses;
#endif
}

static float mass_of(const regions *b, int particle)
{
    return has_masses(b) ? b->masses[particle] : 1;
}

static int cell_number(const regions *b, float place)
{
    return (int)floorf(place / b->size);
}

/* ---- Cells ----------------------------------------------------------------------------------- */

static int *slot_of(const regions *b, int column, int row)
{
    /* Cells in a row are neighbours here, too, and mostly asked for one after the other. */
    unsigned key = (unsigned)column + (unsigned)row * 0x9e3779b1u;
    return &b->head[key & b->mask];
}

/* The cell there; null if it is empty. */
static cell *find(const regions *b, int column, int row)
{
    int number = *slot_of(b, column, row);
    while (number) {
        cell *c = &b->cells[number - 1];
        if (c->column == column && c->row == row)
            return c;
        number = c->next;
    }
    return NULL;
}

static cell *cell_of(const regions *b, int particle)
{
    return &b->cells[b->cell_of[particle]];
}

static void put_into_cells(regions *b)
{
    for (int i = 0; i < b->world->state.count; i++) {
        float height = along(b, i);
        int column = cell_number(b, across(b, i)), row = cell_number(b, height);
        cell *c = find(b, column, row);
        if (c) {
            if (height > c->high)
                c->highest = i;
            c->high = skv_maxf(c->high, height);
            c->low = skv_minf(c->low, height);
            c->mass += mass_of(b, i);
            c->count++;
            b->cell_of[i] = (int)(c - b->cells);
            continue;
        }
        int *slot = slot_of(b, column, row);
        b->cells[b->cell_count] = (cell){.column = column,
                                         .row = row,
                                         .particle = i,
                                         .highest = i,
                                         .next = *slot,
                                         .region = -1,
                                         .high = height,
                                         .low = height,
                                         .mass = mass_of(b, i),
                                         .count = 1};
        b->cell_of[i] = b->cell_count;
        *slot = ++b->cell_count;
    }
    for (int c = 0; has_masses(b) && c < b->cell_count; c++)
        b->cells[c].mass /= (float)b->cells[c].count;
}

/* A lower bound of how far a place is from walls and bodies, below 0 in one. */
static float clearance_of(const regions *b, float x, float y)
{
    return skv_minf(skv_terrain_distance(b->world->terrain, x, y),
                    skv_bodies_distance(b->world, x, y));
}

/* Whether a wall or a body stands between two places. A body is no thinner than a spacing. */
static bool is_walled(const regions *b, float x0, float y0, float x1, float y1)
{
    float dx = x1 - x0, dy = y1 - y0, way = sqrtf(dx * dx + dy * dy);
    float least = 0.5f * b->world->fluid.spacing, gone = 0;
    if (skv_terrain_sweep(b->world->terrain, x0, y0, x1, y1, 0) < 1)
        return true;
    while (gone < way) {
        float share = gone / way;
        float distance = skv_bodies_distance(b->world, x0 + share * dx, y0 + share * dy);
        if (distance <= 0)
            return true;
        gone += skv_maxf(distance, least);
    }
    return false;
}

/* Whether no wall stands between the fluid of two cells. Round the corner of a wall that cuts one
 * of them, its first particle may not see what its highest does. */
static bool touch(const regions *b, const cell *a, const cell *c)
{
    const skv_state *s = &b->world->state;
    const int from[2] = {a->particle, a->highest}, to[2] = {c->particle, c->highest};
    if (clearance_of(b, s->x[from[0]], s->y[from[0]]) > WALL_REACH * b->world->fluid.spacing)
        return true;
    for (int k = 0; k < 4; k++) {
        int p = from[k / 2], q = to[k % 2];
        if (!is_walled(b, s->x[p], s->y[p], s->x[q], s->y[q]))
            return true;
    }
    return false;
}

/* Looks for the cell at a side of another with fluid that touches its fluid. A cell that is cut by
 * a wall or by the surface may be empty inside the fluid: then one beside it. Its number, or 0. */
static int find_beside(const regions *b, const cell *c, int side)
{
    static const int aside[] = {0, -1, 1};
    for (int k = 0; k < 3; k++) {
        int column = c->column + (side < SIDES ? aside[k] : column_step[side]);
        int row = c->row + (side < SIDES ? row_step[side] : aside[k]);
        cell *other = find(b, column, row);
        if (other && touch(b, c, other))
            return (int)(other - b->cells) + 1;
    }
    return 0;
}

static void connect_cells(const regions *b)
{
    for (cell *c = b->cells; c < b->cells + b->cell_count; c++)
        for (int side = 0; side < NEIGHBOURS; side++)
            c->beside[side] = find_beside(b, c, side);
}

/* The cell at a side of another with fluid that touches its fluid; null if there is none. */
static cell *connected(const regions *b, const cell *c, int side)
{
    return c->beside[side] ? &b->cells[c->beside[side] - 1] : NULL;
}

/* Whether there is air at a side of a particle, with no wall before it, if no fluid is there. */
static bool is_free(const regions *b, int particle, int side)
{
    const skv_state *s = &b->world->state;
    float reach = AIR * b->world->fluid.spacing, x = s->x[particle], y = s->y[particle];
    float up = reach * (float)row_step[side], aside = reach * (float)column_step[side];
    float to_x = x + up * b->ux + aside * b->uy, to_y = y + up * b->uy - aside * b->ux;
    return !is_walled(b, x, y, to_x, to_y);
}

/* Looks for air beside every cell, from each of its particles: a hole in a wall may be narrower
 * than a cell. */
static void look_for_air(const regions *b)
{
    for (int i = 0; i < b->world->state.count; i++) {
        cell *c = cell_of(b, i);
        for (int side = 0; side < NEIGHBOURS; side++)
            if (!(c->air & 1u << side) && !connected(b, c, side) && is_free(b, i, side))
                c->air |= 1u << side;
    }
}

/* ---- Regions --------------------------------------------------------------------------------- */

static void note_air(region *whole, const cell *c, int side)
{
    if (side == ABOVE) {
        whole->highest = skv_maxf(whole->highest, c->high);
        whole->lowest = skv_minf(whole->lowest, c->high);
    } else if (side == BELOW) {
        whole->falls = true;
    } else {
        whole->lowest_side = skv_minf(whole->lowest_side, c->high);
    }
}

/* Finds all cells of a region from one of them. */
static void spread(regions *b, cell *first, int number)
{
    region *whole = &b->regions[number];
    *whole = (region){.top = -INFINITY,
                      .highest = -INFINITY,
                      .lowest = INFINITY,
                      .lowest_side = INFINITY,
                      .first = first->column,
                      .end = first->column + 1};
    first->region = number;
    int waiting = 0;
    b->stack[waiting++] = (int)(first - b->cells);
    while (waiting) {
        const cell *c = &b->cells[b->stack[--waiting]];
        whole->top = skv_maxf(whole->top, c->high);
        whole->first = c->column < whole->first ? c->column : whole->first;
        whole->end = c->column >= whole->end ? c->column + 1 : whole->end;
        for (int side = 0; side < NEIGHBOURS; side++) {
            cell *beside = connected(b, c, side);
            if (!beside) {
                if (c->air & 1u << side)
                    note_air(whole, c, side);
            } else if (beside->region < 0) {
                beside->region = number;
                b->stack[waiting++] = (int)(beside - b->cells);
            }
        }
    }
}

static bool is_level(const regions *b, const region *whole)
{
    float step = ONE_LEVEL * b->world->fluid.spacing;
    return !whole->falls && !whole->mixed && !(whole->top - whole->lowest > step) &&
           !(whole->top - whole->lowest_side > step);
}

/* Measures the column below a cell that nothing of it is above. */
static void measure_column(const regions *b, cell *top)
{
    float high = top->high, low = top->low;
    const cell *last = top;
    for (const cell *c = top; c; c = connected(b, c, BELOW)) {
        low = c->low;
        last = c;
    }
    bool carried = !(last->air & 1u << BELOW);
    for (cell *c = top; c; c = connected(b, c, BELOW)) {
        c->high = high;
        c->low = low;
        c->top = (int)(top - b->cells);
        c->carried = carried;
        c->measured = true;
    }
}

/* A cell that no column goes through is as the one above it. */
static void measure_like_above(const regions *b, cell *c)
{
    const cell *above = c;
    for (int i = 0; above && !above->measured && i < b->cell_count; i++)
        above = connected(b, above, ABOVE);
    if (above && above->measured) {
        c->high = above->high;
        c->low = skv_minf(above->low, c->low);
        c->top = above->top;
        c->carried = above->carried;
    }
}

static void measure_columns(const regions *b)
{
    for (int c = 0; c < b->cell_count; c++)
        if (!connected(b, &b->cells[c], ABOVE))
            measure_column(b, &b->cells[c]);
    for (int c = 0; c < b->cell_count; c++)
        if (!b->cells[c].measured)
            measure_like_above(b, &b->cells[c]);
}

/* ---- Drawn surfaces -------------------------------------------------------------------------- */

/* Notes the height up to which fluid is drawn above a particle. Where it is drawn on beyond a
 * step, as above a cell that a corner cuts, there is no surface. */
static void note_drawn_height(const regions *b, const skv_drawing *drawing,
                              const skv_drawn_surface *surface, int column, int particle)
{
    const skv_state *s = &b->world->state;
    float step = DRAWN_STEP * b->world->fluid.spacing, most = ONE_LEVEL * b->world->fluid.spacing;
    float up = 0;
    while (drawing->inside(s->x[particle] + (up + step) * b->ux,
                           s->y[particle] + (up + step) * b->uy, drawing->user)) {
        up += step;
        if (!(up + step < most))
            return;
    }
    skv_drawn_note(surface, column, across(b, particle), along(b, particle) + up);
}

/* Whether there is air straight above a cell, though there may be fluid aside. */
static bool is_open_above(const regions *b, const cell *c)
{
    return c->air & 1u << ABOVE ||
           (!find(b, c->column, c->row + 1) && is_free(b, c->highest, ABOVE));
}

/* Whether a region rests below its drawn surface: where that is uneven but not steep, as that of a
 * dam is; and below roofs only if its particles are level. */
static bool rests_below(const regions *b, const region *whole, const skv_drawn_surface *drawn)
{
    if (!skv_drawn_is_uneven(drawn, EVEN * b->world->fluid.spacing))
        return false;
    return is_level(b, whole) || (!whole->falls && !whole->mixed && skv_drawn_is_gentle(drawn));
}

/* Finds the surfaces of regions. A region's columns follow one another, for its cells touch: all
 * regions together have no more columns than cells. */
static void find_drawn_surfaces(const regions *b, const skv_drawing *drawing, int count,
                                const skv_lies *lies)
{
    skv_drawn_place *places = lies->places;
    for (int r = 0; r < count; r++) {
        const region *whole = &b->regions[r];
        lies->surfaces[r] =
            (skv_drawn_surface){b->size, whole->first, whole->end - whole->first, places};
        places += lies->surfaces[r].count;
    }
    for (const cell *c = b->cells; c < b->cells + b->cell_count; c++)
        if (is_open_above(b, c))
            note_drawn_height(b, drawing, &lies->surfaces[c->region], c->column, c->highest);
    for (int r = 0; r < count; r++)
        if (rests_below(b, &b->regions[r], &lies->surfaces[r])) {
            skv_drawn_bridge(&lies->surfaces[r]);
            b->regions[r].drawn = &lies->surfaces[r];
        }
}

/* ---- Layers ---------------------------------------------------------------------------------- */

/* From where to where a fluid reaches in a region, along gravity. */
typedef struct band {
    float lowest, highest;
} band;

/* Whether of two bands, where both are, the lighter fluid's is the upper one, but for a step. */
static bool is_above(const band *lighter, const band *heavier, float step)
{
    return lighter->lowest > heavier->highest - step;
}

static bool is_layered(const skv_world *world, const band bands[SKV_MAX_FLUIDS])
{
    const skv_liquid *fluids = world->liquids;
    for (int i = 0; i < world->fluid_count; i++)
        for (int k = 0; k < world->fluid_count; k++)
            if (fluids[i].density < fluids[k].density &&
                !is_above(&bands[i], &bands[k], ONE_LEVEL * world->fluid.spacing))
                return false;
    return true;
}

/* Finds out which regions are mixed: fluids that are not layered are going to flow, however level
 * their surface is. False if memory is out. */
static bool look_for_layers(const regions *b, int count)
{
    const skv_world *world = b->world;
    int fluids = world->fluid_count;
    if (!has_masses(b))
        return true;
    band *bands = skv_calloc((size_t)count * (size_t)fluids, sizeof *bands);
    if (!bands)
        return false;
    for (int k = 0; k < count * fluids; k++)
        bands[k] = (band){INFINITY, -INFINITY};
    for (int i = 0; i < world->state.count; i++) {
        band *own = &bands[cell_of(b, i)->region * fluids + skv_fluid_of(&world->state, i)];
        float height = along(b, i);
        own->lowest = skv_minf(own->lowest, height);
        own->highest = skv_maxf(own->highest, height);
    }
    for (int r = 0; r < count; r++)
        b->regions[r].mixed = !is_layered(world, &bands[r * fluids]);
    skv_free(bands);
    return true;
}

/* The integral of pressure over own density from the bottom of a column up to a height, over
 * gravity, m^2, and what it is at that height, m. Goes down from cell to cell: each is of one mass.
 */
static float find_burden(const regions *b, const cell *top, float level, float bottom, float height,
                         float *depth)
{
    float burden = 0, pressed = 0, from = level;
    for (const cell *c = top, *below; c; c = below) {
        below = connected(b, c, BELOW);
        float to = skv_minf(below ? (float)c->row * b->size : bottom, from), thick = from - to;
        if (height > to) {
            float end = skv_minf(height, from), above = from - end;
            if (end == height)
                *depth = pressed / c->mass + above;
            burden += pressed / c->mass * (end - to) + 0.5f * (thick * thick - above * above);
        }
        pressed += c->mass * thick;
        from = to;
    }
    return burden;
}

/* ---- Particles ------------------------------------------------------------------------------- */

static void judge(const regions *b, skv_lies *lies)
{
    double sum = 0;
    float half = 0.5f * b->world->fluid.spacing;
    for (int i = 0; i < b->world->state.count; i++) {
        const cell *c = cell_of(b, i);
        const region *whole = &b->regions[c->region];
        bool resting = whole->drawn || is_level(b, whole);
        lies->lie[i] = (uint8_t)(resting ? SKV_RESTS : c->carried ? SKV_LEANS : SKV_HANGS);
        /* Below a roof the level outside counts. */
        float level = (resting && whole->highest > c->high ? whole->highest : c->high) + half;
        float slope;
        lies->drawn[i] = whole->drawn;
        if (whole->drawn)
            skv_drawn_look(whole->drawn, across(b, i), &level, &slope);
        float whole_depth = level - (c->low - half), depth = level - along(b, i);
        float weight = 0.5f * (whole_depth * whole_depth - depth * depth);
        if (has_masses(b))
            weight = find_burden(b, &b->cells[c->top], level, c->low - half, along(b, i), &depth);
        lies->weight[i] = lies->lie[i] == SKV_HANGS ? 0 : skv_maxf(weight, 0);
        sum += (double)depth;
    }
    lies->depth = sum / b->world->state.count;
}

/* False if memory is out. */
static bool find_lies(regions *b, const skv_drawing *drawing, skv_lies *lies)
{
    int count = 0;
    put_into_cells(b);
    connect_cells(b);
    look_for_air(b);
    for (int c = 0; c < b->cell_count; c++)
        if (b->cells[c].region < 0)
            spread(b, &b->cells[c], count++);
    if (!look_for_layers(b, count))
        return false;
    if (drawing->inside)
        find_drawn_surfaces(b, drawing, count, lies);
    measure_columns(b);
    judge(b, lies);
    return true;
}

skv_result skv_world_find_lies(const skv_world *world, const skv_drawing *drawing, skv_lies *lies,
                               skv_error *error)
{
    size_t most = (size_t)world->state.count;
    float g = sqrtf(world->gravity_x * world->gravity_x + world->gravity_y * world->gravity_y);
    *lies = (skv_lies){.lie = skv_calloc(most, sizeof *lies->lie), /* SKV_HANGS */
                       .weight = skv_calloc(most, sizeof *lies->weight),
                       .drawn = skv_calloc(most, sizeof *lies->drawn),
                       .surfaces = skv_calloc(most, sizeof *lies->surfaces),
                       .places = skv_calloc(most, sizeof *lies->places)};
    bool enough = lies->lie && lies->weight && lies->drawn && lies->surfaces && lies->places;
    if (enough && !(g > 0))
        return SKV_OK;
    lies->ux = -world->gravity_x / g;
    lies->uy = -world->gravity_y / g;
    regions b = {.world = world,
                 .masses = skv_world_masses(world),
                 .ux = lies->ux,
                 .uy = lies->uy,
                 .size = CELL_SIZE * world->fluid.spacing,
                 .mask = 1023};
    while (b.mask < (unsigned)most)
        b.mask = 2 * b.mask + 1;
    b.head = skv_calloc((size_t)b.mask + 1, sizeof *b.head);
    b.cells = skv_calloc(most, sizeof *b.cells);
    b.regions = skv_calloc(most, sizeof *b.regions);
    b.stack = skv_calloc(most, sizeof *b.stack);
    b.cell_of = skv_calloc(most, sizeof *b.cell_of);
    enough = enough && b.head && b.cells && b.regions && b.stack && b.cell_of;
    if (enough)
        enough = find_lies(&b, drawing, lies);
    skv_free(b.head);
    skv_free(b.cells);
    skv_free(b.regions);
    skv_free(b.stack);
    skv_free(b.cell_of);
    return enough ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for settling");
}

void skv_lies_destroy(skv_lies *lies)
{
    skv_free(lies->lie);
    skv_free(lies->weight);
    skv_free((void *)lies->drawn);
    skv_free(lies->surfaces);
    skv_free(lies->places);
}
