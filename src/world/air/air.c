/* Air that pushes: which pieces of it there are, what each holds, and what they do to the fluid.
 *
 * Before each substep the particles' areas are put into a grid (air/grid.c). What is left of the
 * room of cells is air. Cells that are more than half air hang together in pieces (air/pieces.c),
 * which are followed from substep to substep by the volume that they share: so what a piece holds
 * is shared out when it parts, added up when pieces meet, and gone when they meet the atmosphere.
 *
 * A piece of pressure p is pushed by -p dV as its volume V changes. V is a sum over cells of a
 * function of how much of each is fluid, so that a particle gets -p times the slope of V as it
 * moves: no energy is won or lost by where the grid lies.
 *
 * Invariant: all sums run over particles and cells in their order, on one thread. Where a world has
 * no air, none of this is asked.
 */
#include "world/air/air.h"

#include "base/exact.h"
#include "world/bodies/bodies.h"

#include <math.h>
#include <string.h>

/* The volume of a cell that is all air would otherwise be this. */
#define AIR_NORM (1 - (SKV_AIR_FROM + SKV_AIR_WHOLE) / 2)

/* Substeps: so far ahead air looks, since the fluid answers a push late. With 0 a bell of 3000
 * particles swings for ever, with 1 it does so for 15 s, with 2 for 6. */
#define AHEAD 2

/* m^2, in cells: what is smaller is no pocket. */
#define LEAST_POCKET 1.0

float skv_air_part(float share)
{
    return skv_clamp((share - SKV_AIR_FROM) / (SKV_AIR_WHOLE - SKV_AIR_FROM), 0, 1);
}

/* Of a cell's room what counts as air: the integral of that over the share. */
static float held(float share)
{
    const float from = share - SKV_AIR_FROM, whole = SKV_AIR_WHOLE - SKV_AIR_FROM;
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
    skv_air_smooth(air, air->push, air->fluid, false, 0, air->rows - 1);
    for (int c = 0; c < air->cells; c++) {
        const float least = 0.1f; /* what has less room is wall */
        float room = air->open_room[c];
        air->share[c] = 0;
        if (room > least)
            air->share[c] = air->fluid[c] == 0 ? 1 : skv_maxf(1 - air->fluid[c] / room, 0);
        air->held[c] = room * held(air->share[c]);
    }
}

/* ---- Pieces ---------------------------------------------------------------------------------- */

/* The volume of air in a cell, m^2. */
static double volume_in(const skv_air *air, int cell)
{
    return (double)(air->cell * air->cell) * (double)air->held[cell];
}

/* Adds a row's cells to the pieces. Beyond the sides of the world there is air if they are open. */
static void measure_row(skv_air *air, int row)
{
    const double y = (double)skv_air_middle(air, row);
    const bool beyond = y < 0 || row >= air->rows - SKV_AIR_RIM;
    for (int column = 0; column < air->columns; column++) {
        int c = row * air->columns + column;
        if (!air->label[c])
            continue;
        skv_piece *piece = &air->piece[air->label[c]];
        double volume = volume_in(air, c), x = (double)skv_air_middle(air, column);
        piece->volume += volume;
        piece->x += volume * x;
        piece->y += volume * y;
        if (air->before[c] == SKV_ATMOSPHERE)
            piece->was_outside += volume;
        else
            air->left[air->before[c]] += volume;
        piece->outside |= beyond || x < 0 || column >= air->columns - SKV_AIR_RIM;
        piece->low = piece->cells++ ? piece->low : row;
        piece->high = row;
    }
}

/* Measures the pieces, and how much of what was air before is still. */
static void measure_pieces(skv_air *air)
{
    memset(air->piece, 0, (size_t)air->labels * sizeof *air->piece);
    memset(air->left, 0, sizeof air->left);
    for (int row = 0; row < air->rows; row++)
        measure_row(air, row);
}

/* Gives each piece what pockets held where it lies now. */
static void hand_on(skv_air *air)
{
    for (int c = 0; c < air->cells; c++) {
        int before = air->before[c];
        if (before < SKV_FIRST_POCKET || !air->label[c] || !(air->left[before] > 0))
            continue;
        air->piece[air->label[c]].amount +=
            air->amount[before] * (volume_in(air, c) / air->left[before]);
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

/* ---- Bodies ---------------------------------------------------------------------------------- */

/* The face of a piece that body k has, among those from `first` on; null: there is no room. */
static skv_body_face *face_of(skv_bodies *b, int first, int label, int k)
{
    for (int i = first; i < b->faces; i++)
        if (b->face[i].label == label)
            return &b->face[i];
    if (b->faces == SKV_MOST_FACES)
        return NULL;
    skv_body_face *f = &b->face[b->faces++];
    *f = (skv_body_face){.label = label, .body = k};
    return f;
}

/* Finds what a body faces. What lies before a piece of its rim is asked three quarters of a cell
 * away, where air is that is not cut by the body. */
static void find_faces_of(const skv_air *air, skv_bodies *b, int body)
{
    const skv_rigid *r = &b->body[body];
    const double away = 0.75 * (double)air->cell;
    const double about_x = r->pinned ? r->pin_x : r->x, about_y = r->pinned ? r->pin_y : r->y;
    const int first = b->faces;
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
        skv_body_face *f = air->label[c] ? face_of(b, first, air->label[c], body) : NULL;
        if (!f)
            continue;
        double part = (double)skv_air_part(air->share[c]);
        f->x -= part * along_y;
        f->y += part * along_x;
        f->turn += part * ((x - about_x) * along_x + (y - about_y) * along_y);
    }
}

/* Finds what faces what, and by how much bodies will change volumes in a substep. */
static void find_faces(const skv_world *world, skv_air *air, double dt)
{
    skv_bodies *b = world->bodies;
    if (!b)
        return;
    b->faces = 0;
    for (int k = 0; k < b->count; k++)
        find_faces_of(air, b, k);
    for (int i = 0; i < b->faces; i++) {
        const skv_body_face *f = &b->face[i];
        const skv_rigid *r = &b->body[f->body];
        skv_motion speed = {r->vx, r->vy, r->spin};
        air->piece[f->label].bodies += !r->fixed || r->held;
        air->piece[f->label].coming += dt * skv_face_rate(f, r, speed);
    }
}

/* By how much the pressure of a pocket falls for each m^2 that it grows. */
static double slope_of(const skv_air *air, const skv_piece *piece)
{
    return (double)air->pressure * piece->amount / (piece->volume * piece->volume);
}

/* Air presses on the sides of bodies that face it. The more a body yields, the less: with n bodies
 * at one pocket no more than n times as much as for each alone. */
static void push_bodies(skv_bodies *b, const skv_air *air, double dt)
{
    for (int i = 0; i < b->faces; i++) {
        skv_body_face *f = &b->face[i];
        skv_rigid *r = &b->body[f->body];
        const skv_piece *piece = &air->piece[f->label];
        double push = dt * piece->push;
        f->stiffness = piece->yields ? dt * dt * piece->bodies * slope_of(air, piece) : 0;
        r->owed.x += push * f->x;
        r->owed.y += push * f->y;
        r->owed.moment += push * skv_face_moment(f, r);
    }
}

/* ---- Pushes ---------------------------------------------------------------------------------- */

/* What air pushes: the pressures of pieces, all lifted alike, and none of a hole. A substep bears
 * no more than what moves a particle by its spacing. */
static void find_pushes(const skv_world *world, skv_air *air, double dt, bool at_once)
{
    double per_substep = (double)world->fluid.spacing / dt;
    double most = (double)world->fluid.density * per_substep * per_substep;
    double least = 0;
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        skv_piece *piece = &air->piece[k];
        piece->yields = skv_air_is_pocket(air, piece);
        if (piece->yields)
            piece->push = skv_air_pressure_of(air, piece) - slope_of(air, piece) * piece->coming;
        least = skv_min(least, piece->push);
    }
    air->wanted_lift = -least;
    skv_air_find_lift(world, air, at_once ? 0 : dt);
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        skv_piece *piece = &air->piece[k];
        if (piece->outside || piece->yields)
            piece->push += air->lift;
        piece->push = skv_min(skv_max(piece->push, 0), most);
    }
}

/* Puts pushes into the cells from which fluid feels them: in the rows of what pushes, and the two
 * on each side of them. */
static void spread_pushes(skv_air *air)
{
    int first = air->rows, last = -1;
    for (int k = SKV_FIRST_POCKET; k < air->labels; k++) {
        const skv_piece *piece = &air->piece[k];
        if (!(piece->push > 0))
            continue;
        first = piece->low < first ? piece->low : first;
        last = piece->high > last ? piece->high : last;
    }
    air->pushes = last >= 0;
    if (!air->pushes)
        return;
    const int above[2] = {last + 1 < air->rows ? last + 1 : last,
                          last + 2 < air->rows ? last + 2 : air->rows - 1};
    const int below[2] = {first > 0 ? first - 1 : 0, first > 1 ? first - 2 : 0};
    for (int c = below[1] * air->columns; c < (above[1] + 1) * air->columns; c++) {
        double push = air->label[c] ? air->piece[air->label[c]].push : 0;
        air->fluid[c] = push > 0 ? (float)push * skv_air_part(air->share[c]) / AIR_NORM : 0;
    }
    memset(air->push, 0, (size_t)air->cells * sizeof *air->push);
    skv_air_smooth(air, air->fluid, air->push, true, below[0], above[0]);
}

void skv_air_push_one(const skv_world *world, int particle, float dt, float *vx, float *vy)
{
    const skv_state *s = &world->state;
    const skv_air *air = world->air;
    const float ahead = AHEAD * dt, scale = -dt / (world->fluid.density * air->cell);
    float slope_x, slope_y;
    if (!air->pushes ||
        !skv_air_slope(world, air, air->push, s->x[particle] + ahead * s->vx[particle],
                       s->y[particle] + ahead * s->vy[particle], &slope_x, &slope_y))
        return;
    float each = s->several ? scale / s->mass[particle] : scale;
    *vx += each * slope_x;
    *vy += each * slope_y;
}

static void push_fluid(skv_world *world, const skv_air *air, float dt, bool partial)
{
    skv_state *s = &world->state;
    for (int i = 0; air->pushes && i < s->count; i++)
        if (!partial || s->part[i] == SKV_MOVES)
            skv_air_push_one(world, i, dt, &s->vx[i], &s->vy[i]);
}

/* Finds what air pushes in a substep of `dt`; lifted `at_once`, if no time passes. */
static void find_air(const skv_world *world, skv_air *air, float dt, bool at_once)
{
    at_once |= !air->begun;
    skv_air_survey(world, air);
    find_shares(world, air, AHEAD * dt);
    skv_air_find_pieces(air);
    follow_pieces(world, air);
    find_faces(world, air, at_once ? 0 : (double)dt);
    find_pushes(world, air, (double)dt, at_once);
    spread_pushes(air);
}

void skv_air_push(skv_world *world, float dt, bool partial)
{
    if (!world->air)
        return;
    find_air(world, world->air, dt, false);
    push_fluid(world, world->air, dt, partial);
    if (world->bodies)
        push_bodies(world->bodies, world->air, (double)dt);
}

void skv_air_hold(skv_world *world, float dt)
{
    if (!world->air)
        return;
    find_air(world, world->air, dt, true);
    push_fluid(world, world->air, dt, false);
}

void skv_air_gauge(skv_world *world, bool partial)
{
    const skv_air *air = world->air;
    skv_state *s = &world->state;
    for (int i = 0; air && air->lift != 0 && i < s->count; i++) {
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
