/* Air that pushes: which pieces of it there are, what each holds, and what they do to the fluid.
 *
 * Before each substep the particles' areas are put into a grid (air_grid.c). What is left of the
 * room of cells is air. Cells that are more than half air hang together in pieces, which are
 * followed from substep to substep by the volume that they share: so what a piece holds is shared
 * out when it parts, added up when pieces meet, and gone when they meet the atmosphere.
 *
 * A piece of pressure p is pushed by -p dV as its volume V changes. V is a sum over cells of a
 * function of how much of each is fluid, so that a particle gets -p times the slope of V as it
 * moves: no energy is won or lost by where the grid lies.
 *
 * Invariant: all sums run over particles and cells in their order, on one thread. Where a world has
 * no air, none of this is asked.
 */
#include "world/air.h"

#include "base/exact.h"
#include "world/bodies.h"

#include <math.h>
#include <string.h>

/* Shares of air from which on a cell counts as some, and counts wholly. Fluid at rest has 0.05 at
 * most; a particle alone leaves 0.81 of its own cell. Between them the push rises evenly. */
#define AIR_FROM  0.1f
#define AIR_WHOLE 0.8f

/* The volume of a cell that is all air would otherwise be this. */
#define AIR_NORM (1 - (AIR_FROM + AIR_WHOLE) / 2)

/* Cells of a piece are more than half air. */
#define HALF 0.5f

/* Substeps: so far ahead air looks, since the fluid answers a push late. With 0 a bell of 3000
 * particles swings for ever, with 1 it does so for 15 s, with 2 for 6. */
#define AHEAD 2

/* m^2, in cells: what is smaller is no pocket. */
#define LEAST_POCKET 1.0

float skv_air_part(float share)
{
    return skv_clamp((share - AIR_FROM) / (AIR_WHOLE - AIR_FROM), 0, 1);
}

/* Of a cell's room what counts as air: the integral of that over the share. */
static float held(float share)
{
    const float from = share - AIR_FROM, whole = AIR_WHOLE - AIR_FROM;
    if (!(from > 0))
        return 0;
    return (from < whole ? from * from / (2 * whole) : from - whole / 2) / AIR_NORM;
}

/* ---- Shares ---------------------------------------------------------------------------------- */

/* Puts the particles into the grid where they will be in `ahead`, and finds the share of air of
 * each cell. */
static void find_shares(const skv_world *world, skv_air *air, float ahead)
{
    const skv_state *s = &world->state;
    const float per_cell = world->fluid.spacing / air->cell, each = per_cell * per_cell;
    memset(air->push, 0, (size_t)air->cells * sizeof *air->push);
    for (int i = 0; i < s->count; i++)
        skv_air_deposit(world, air, s->x[i] + ahead * s->vx[i], s->y[i] + ahead * s->vy[i], each,
                        air->push);
    skv_air_smooth(air, air->push, air->fluid, false);
    for (int c = 0; c < air->cells; c++) {
        const float least = 0.1f; /* what has less room is wall */
        float room = air->open_room[c];
        air->share[c] = room > least ? skv_maxf(1 - air->fluid[c] / room, 0) : 0;
    }
}

/* ---- Pieces ---------------------------------------------------------------------------------- */

static bool may_join(const skv_air *air, int cell, float least)
{
    return air->label[cell] == SKV_NO_AIR && !(air->walls[cell] & SKV_CELL_SOLID) &&
           air->share[cell] > least;
}

/* Labels what is linked to the cells of the queue from `first` to `end`, and queues it. */
static int join_around(skv_air *air, int first, int end, int used, float least)
{
    for (int at = first; at < end; at++) {
        int cell = air->queue[at];
        for (int side = 0; side < 4; side++) {
            if (!skv_air_is_linked(air, cell, side))
                continue;
            int next = skv_air_beside(air, cell, side);
            if (!may_join(air, next, least))
                continue;
            air->label[next] = air->label[cell];
            air->queue[used++] = next;
        }
    }
    return used;
}

/* Labels all pieces, from the top of the grid: first where there is more air than not, then what
 * belongs to their edges, which are two cells wide. */
static void find_pieces(skv_air *air)
{
    enum { EDGE = 2 };
    memset(air->label, 0, (size_t)air->cells * sizeof *air->label);
    int used = 0, labels = SKV_FIRST_POCKET;
    for (int c = air->cells - 1; c >= 0 && labels < SKV_AIR_LABELS; c--) {
        if (!may_join(air, c, HALF))
            continue;
        int first = used;
        air->label[c] = (uint16_t)labels++;
        air->queue[used++] = c;
        for (int end = used; first < end; end = used) {
            used = join_around(air, first, end, used, HALF);
            first = end;
        }
    }
    for (int ring = 0, first = 0; ring < EDGE; ring++) {
        int end = used;
        used = join_around(air, first, end, used, AIR_FROM);
        first = end;
    }
    air->labels = labels;
}

/* The volume of air in a cell, m^2. */
static double volume_in(const skv_air *air, int cell)
{
    return (double)(air->cell * air->cell) *
           (double)(air->open_room[cell] * held(air->share[cell]));
}

/* Whether a cell lies beyond a side of the world, where there is air if it is open. */
static bool is_beyond(const skv_air *air, int column, int row)
{
    float x = skv_air_middle(air, column), y = skv_air_middle(air, row);
    return x < 0 || y < 0 || column >= air->columns - SKV_AIR_RIM || row >= air->rows - SKV_AIR_RIM;
}

/* Measures the pieces, and how much of what was air before is still. */
static void measure_pieces(skv_air *air)
{
    memset(air->piece, 0, (size_t)air->labels * sizeof *air->piece);
    memset(air->left, 0, sizeof air->left);
    for (int c = 0; c < air->cells; c++) {
        if (!air->label[c])
            continue;
        skv_piece *piece = &air->piece[air->label[c]];
        double volume = volume_in(air, c);
        int column = c % air->columns, row = c / air->columns;
        piece->volume += volume;
        piece->x += volume * (double)skv_air_middle(air, column);
        piece->y += volume * (double)skv_air_middle(air, row);
        air->left[air->before[c]] += volume;
        piece->outside |= is_beyond(air, column, row);
    }
}

/* Gives each piece what was held where it lies now. */
static void hand_on(skv_air *air)
{
    for (int c = 0; c < air->cells; c++) {
        int before = air->before[c];
        if (!air->label[c] || before == SKV_NO_AIR)
            continue;
        skv_piece *piece = &air->piece[air->label[c]];
        double volume = volume_in(air, c);
        if (before == SKV_ATMOSPHERE)
            piece->was_outside += volume;
        else if (air->left[before] > 0)
            piece->amount += air->amount[before] * (volume / air->left[before]);
    }
}

/* In a closed world the atmosphere is what most of it has become, and at first the largest piece.
 */
static void choose_atmosphere(const skv_world *world, skv_air *air)
{
    int most = 0;
    double volume = 0;
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        double of_it = air->begun ? air->piece[k].was_outside : air->piece[k].volume;
        if (of_it > volume) {
            volume = of_it;
            most = k;
        }
    }
    if (most && skv_terrain_open_sides(world->terrain) == 0)
        air->piece[most].outside = true;
}

/* What pieces hold. What was the atmosphere's goes on with its pressure. */
static void follow_pieces(const skv_world *world, skv_air *air)
{
    measure_pieces(air);
    if (air->begun)
        hand_on(air);
    choose_atmosphere(world, air);
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        skv_piece *piece = &air->piece[k];
        piece->amount = air->begun ? piece->amount + piece->was_outside : piece->volume;
        air->amount[k] = piece->outside ? 0 : piece->amount;
    }
    for (int c = 0; c < air->cells; c++) {
        int label = air->label[c];
        air->before[c] = (uint16_t)(label && air->piece[label].outside ? SKV_ATMOSPHERE : label);
    }
    air->begun = true;
}

/* ---- Pushing --------------------------------------------------------------------------------- */

/* A hole that opened in the fluid holds nothing. */
bool skv_air_is_pocket(const skv_air *air, const skv_piece *piece)
{
    return !piece->outside && piece->amount > 0 &&
           piece->volume > LEAST_POCKET * (double)(air->cell * air->cell);
}

double skv_air_pressure_of(const skv_air *air, const skv_piece *piece)
{
    return (double)air->pressure * (piece->amount / piece->volume - 1);
}

/* What air pushes: the pressures of pieces, all lifted alike, and none of a hole. A substep bears
 * no more than what moves a particle by its spacing. */
static void find_pushes(const skv_world *world, skv_air *air, double dt, bool at_once)
{
    double per_substep = (double)world->fluid.spacing / dt;
    double most = (double)world->fluid.density * per_substep * per_substep;
    double least = 0;
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++)
        if (skv_air_is_pocket(air, &air->piece[k]))
            least = skv_min(least, skv_air_pressure_of(air, &air->piece[k]));
    air->wanted_lift = -least;
    skv_air_find_lift(world, air, at_once ? 0 : dt);
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        skv_piece *piece = &air->piece[k];
        if (piece->outside)
            piece->push = air->lift;
        else if (skv_air_is_pocket(air, piece))
            piece->push = air->lift + skv_air_pressure_of(air, piece);
        piece->push = skv_min(skv_max(piece->push, 0), most);
    }
}

static void spread_pushes(skv_air *air)
{
    for (int c = 0; c < air->cells; c++) {
        double push = air->label[c] ? air->piece[air->label[c]].push : 0;
        air->fluid[c] = (float)push * skv_air_part(air->share[c]) / AIR_NORM;
    }
    skv_air_smooth(air, air->fluid, air->push, true);
}

static void push_fluid(skv_world *world, const skv_air *air, float dt, bool partial)
{
    skv_state *s = &world->state;
    const float *masses = s->several ? s->mass : NULL;
    const float scale = -dt / (world->fluid.density * air->cell);
    for (int i = 0; i < s->count; i++) {
        float x = s->x[i] + AHEAD * dt * s->vx[i], y = s->y[i] + AHEAD * dt * s->vy[i], slope_x,
              slope_y;
        if ((partial && s->part[i] != SKV_MOVES) ||
            !skv_air_slope(world, air, air->push, x, y, &slope_x, &slope_y))
            continue;
        float each = masses ? scale / masses[i] : scale;
        s->vx[i] += each * slope_x;
        s->vy[i] += each * slope_y;
    }
}

/* Air presses on the sides of bodies that face it. What it presses on one of its pieces is asked
 * three quarters of a cell away, where air is that is not cut by the body. */
static void push_body(const skv_air *air, skv_rigid *r, double dt)
{
    const double away = 0.75 * (double)air->cell;
    for (int k = 0; k < r->shape->rims; k++) {
        double x0, y0, x1, y1;
        skv_rigid_rim(r, k, &x0, &y0);
        skv_rigid_rim(r, (k + 1) % r->shape->rims, &x1, &y1);
        double along_x = x1 - x0, along_y = y1 - y0;
        double length = sqrt(along_x * along_x + along_y * along_y);
        double x = (x0 + x1) / 2, y = (y0 + y1) / 2;
        if (!(length > 0))
            continue;
        int c = skv_air_cell_at(air, (float)(x + away * along_y / length),
                                (float)(y - away * along_x / length));
        if (!air->label[c])
            continue;
        double push = dt * air->piece[air->label[c]].push * (double)skv_air_part(air->share[c]);
        skv_rigid_press(r, -push * along_y, push * along_x, x, y);
    }
}

/* Finds what air pushes in a substep of `dt`; lifted `at_once`, if no time passes. */
static void find_air(const skv_world *world, skv_air *air, float dt, bool at_once)
{
    at_once |= !air->begun;
    skv_air_survey(world, air);
    find_shares(world, air, AHEAD * dt);
    find_pieces(air);
    follow_pieces(world, air);
    find_pushes(world, air, (double)dt, at_once);
    spread_pushes(air);
}

void skv_air_push(skv_world *world, float dt, bool partial)
{
    find_air(world, world->air, dt, false);
    push_fluid(world, world->air, dt, partial);
    for (int k = 0; k < skv_world_has_bodies(world); k++)
        push_body(world->air, &world->bodies->body[k], (double)dt);
}

void skv_air_hold(skv_world *world, float dt)
{
    find_air(world, world->air, dt, true);
    push_fluid(world, world->air, dt, false);
}

void skv_air_gauge(skv_world *world, bool partial)
{
    const skv_air *air = world->air;
    skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++) {
        if (partial && s->part[i] != SKV_MOVES)
            continue;
        int c = skv_air_cell_at(air, s->x[i], s->y[i]);
        float part = air->label[c] ? skv_air_part(air->share[c]) : 0;
        s->pressure[i] -= (1 - part) * (float)air->lift;
    }
}

bool skv_air_stirs(const skv_world *world, int particle)
{
    const skv_air *air = world->air;
    if (air->lift != air->wanted_lift || !air->begun)
        return true;
    int middle = skv_air_cell_at(air, world->state.x[particle], world->state.y[particle]);
    for (int k = 0; k < 9; k++)
        if (air->before[middle + (k / 3 - 1) * air->columns + k % 3 - 1] >= SKV_FIRST_POCKET)
            return true;
    return false;
}
