/* The grid on which air is found: square cells of one spacing, two of them beyond each side of the
 * world.
 *
 * What lies somewhere has a share of the nine cells around, by the quadratic B-spline. Where a wall
 * parts one of them from its own cell, that one's share falls to the cell before the wall: so
 * nothing passes walls, all shares are 1 together, and what is free has no weight that changes as
 * it moves. The room that there is for fluid is shared out in the same way, so the fluid at rest
 * fills cells beside walls as it does others.
 *
 * Invariant: all of it follows from the terrain, the bodies' poses and the spacing.
 */
#include "world/air/air.h"

#include "base/exact.h"
#include "terrain/sample.h"
#include "world/bodies/bodies.h"

#include <math.h>
#include <string.h>

/* In cells: from here on no wall passes through a cell; its corners are at 0.71. */
#define CUT_BELOW 0.75f
/* And its links need no look: the next middle is 1 away, and a distance may be off by a pixel. */
#define FREE_FROM 1.42f

/* ---- Walls ----------------------------------------------------------------------------------- */

static float distance_at(const skv_world *world, const skv_air *air, float x, float y)
{
    float distance = skv_distance_at(world->terrain, x, y);
    return air->with_bodies ? skv_minf(distance, skv_bodies_distance(world, x, y)) : distance;
}

/* Whether a wall or a body lies on the straight way from a place to the middle of a cell. */
static bool is_parted(const skv_world *world, const skv_air *air, float x0, float y0, int cell)
{
    enum { LOOKS = 4 }; /* a body is no thinner than a spacing */
    const skv_terrain *t = world->terrain;
    float x1 = skv_air_middle(air, cell % air->columns);
    float y1 = skv_air_middle(air, cell / air->columns);
    if (skv_grid_occluded(t, skv_to_grid(t, x0), skv_to_grid(t, y0), 0, skv_to_grid(t, x1),
                          skv_to_grid(t, y1), air->clear[cell]))
        return true;
    for (int k = 0; air->with_bodies && k <= LOOKS; k++) {
        float way = (float)k / LOOKS;
        if (!(skv_bodies_distance(world, x0 + way * (x1 - x0), y0 + way * (y1 - y0)) > 0))
            return true;
    }
    return false;
}

static int keep_inside(int k, int count)
{
    return k < 1 ? 1 : k > count - 2 ? count - 2 : k;
}

/* In cells from the grid's lower left corner. */
static float along(const skv_air *air, float position, int count)
{
    return skv_clamp(position / air->cell + SKV_AIR_RIM, 1, (float)count - 1.001f);
}

int skv_air_cell_at(const skv_air *air, float x, float y)
{
    int column = keep_inside((int)along(air, x, air->columns), air->columns);
    return keep_inside((int)along(air, y, air->rows), air->rows) * air->columns + column;
}

/* Finds what a cell is. */
static void look_at(const skv_world *world, const skv_air *air, int column, int row)
{
    static const int steps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    float x = skv_air_middle(air, column), y = skv_air_middle(air, row);
    float distance = distance_at(world, air, x, y) / air->cell;
    unsigned is = distance < CUT_BELOW ? SKV_CELL_CUT : 0;
    if (!(distance > 0))
        is |= SKV_CELL_SOLID;
    for (int k = 0; distance > 0 && k < 4; k++) {
        int c = column + steps[k][0], r = row + steps[k][1];
        bool there = c >= 0 && r >= 0 && c < air->columns && r < air->rows;
        if (there && (distance > FREE_FROM || !is_parted(world, air, x, y, r * air->columns + c)))
            is |= 1u << k;
    }
    air->walls[row * air->columns + column] = (uint8_t)is;
}

/* Finds which cells are clear. */
static void find_clear(const skv_air *air)
{
    for (int row = 1; row < air->rows - 1; row++) {
        for (int c = row * air->columns + 1; c < (row + 1) * air->columns - 1; c++) {
            unsigned all = SKV_CELL_LINKED;
            for (int k = -air->columns; k <= air->columns; k += air->columns)
                all &= air->walls[c + k - 1] & air->walls[c + k] & air->walls[c + k + 1];
            bool clear = all == SKV_CELL_LINKED && !(air->walls[c] & SKV_CELL_CUT);
            air->walls[c] =
                (uint8_t)((air->walls[c] & ~SKV_CELL_CLEAR) | (clear ? SKV_CELL_CLEAR : 0));
        }
    }
}

/* ---- Spots ----------------------------------------------------------------------------------- */

/* Where something lies: its cell, and how far from that one's middle, in cells. */
typedef struct cell_spot {
    int cell;
    float x, y;
} cell_spot;

/* The spot of what a wall parts from the middle of its cell: in the nearest cell around that is
 * not, where that one begins. */
static bool find_before_wall(const skv_world *world, const skv_air *air, float x, float y,
                             cell_spot *spot)
{
    float least = INFINITY, from_x = spot->x, from_y = spot->y;
    const int column = spot->cell % air->columns, row = spot->cell / air->columns;
    for (int k = 0; k < 9; k++) {
        int across = k % 3 - 1, up = k / 3 - 1, c = column + across, r = row + up;
        float dx = from_x - (float)across, dy = from_y - (float)up, square = dx * dx + dy * dy;
        bool there = keep_inside(c, air->columns) == c && keep_inside(r, air->rows) == r;
        if (!there || !(square < least) || air->walls[r * air->columns + c] & SKV_CELL_SOLID ||
            is_parted(world, air, x, y, r * air->columns + c))
            continue;
        least = square;
        spot->cell = r * air->columns + c;
        spot->x = skv_clamp(dx, -0.5f, 0.5f);
        spot->y = skv_clamp(dy, -0.5f, 0.5f);
    }
    return least < INFINITY;
}

/* False: there is none, between walls. */
static inline bool find_spot(const skv_world *world, const skv_air *air, float x, float y,
                             cell_spot *spot)
{
    float u = along(air, x, air->columns), v = along(air, y, air->rows);
    int column = keep_inside((int)u, air->columns), row = keep_inside((int)v, air->rows);
    spot->cell = row * air->columns + column;
    spot->x = u - (float)column - 0.5f;
    spot->y = v - (float)row - 0.5f;
    unsigned is = air->walls[spot->cell];
    if (!(is & SKV_CELL_CUT))
        return true;
    bool hidden = is & SKV_CELL_SOLID || is_parted(world, air, x, y, spot->cell);
    return !hidden || find_before_wall(world, air, x, y, spot);
}

/* Names the nine cells around one: those that a wall parts from it are the ones before that. */
static void name_cells(const skv_air *air, int cell, int name[9])
{
    static const int sides[4] = {3, 5, 1, 7}, corners[4] = {0, 2, 6, 8};
    for (int k = 0; k < 9; k++)
        name[k] = cell + (k / 3 - 1) * air->columns + k % 3 - 1;
    if (air->walls[cell] & SKV_CELL_CLEAR)
        return;
    for (int side = 0; side < 4; side++)
        if (!skv_air_is_linked(air, cell, side))
            name[sides[side]] = cell;
    for (int k = 0; k < 4; k++) {
        int across = k % 2, up = 2 + k / 2; /* the sides on its way */
        int beside = name[sides[across]], over = name[sides[up]];
        bool seen = (beside != cell && skv_air_is_linked(air, beside, up)) ||
                    (over != cell && skv_air_is_linked(air, over, across));
        if (!seen)
            name[corners[k]] = beside != cell ? beside : over;
    }
}

static inline void weigh(float at, float weight[3])
{
    weight[0] = 0.5f * (0.5f - at) * (0.5f - at);
    weight[1] = 0.75f - at * at;
    weight[2] = 0.5f * (0.5f + at) * (0.5f + at);
}

void skv_air_deposit(const skv_world *world, const skv_air *air, float x, float y, float amount,
                     float *to)
{
    cell_spot at;
    if (!find_spot(world, air, x, y, &at))
        return;
    int name[9];
    float across[3], up[3];
    weigh(at.x, across);
    weigh(at.y, up);
    if (air->walls[at.cell] & SKV_CELL_CLEAR) {
        float *row = to + at.cell - air->columns - 1;
        for (int k = 0; k < 3; k++, row += air->columns) {
            row[0] += amount * (across[0] * up[k]);
            row[1] += amount * (across[1] * up[k]);
            row[2] += amount * (across[2] * up[k]);
        }
        return;
    }
    name_cells(air, at.cell, name);
    for (int k = 0; k < 9; k++)
        to[name[k]] += amount * (across[k % 3] * up[k / 3]);
}

/* Whether nothing is around a cell. */
static inline bool is_bare(const float *of, int cell, int columns)
{
    const float *low = of + cell - columns, *here = of + cell, *high = of + cell + columns;
    return low[-1] == 0 && low[0] == 0 && low[1] == 0 && here[-1] == 0 && here[0] == 0 &&
           here[1] == 0 && high[-1] == 0 && high[0] == 0 && high[1] == 0;
}

/* Whether (x, y) is beside a wall, where spots are dear, and nothing is around the cells of which
 * one is its own. */
static bool is_far(const skv_air *air, const float *of, float x, float y)
{
    const int cell = skv_air_cell_at(air, x, y);
    if (!(air->walls[cell] & SKV_CELL_CUT))
        return false;
    for (int k = 0; k < 9; k++) {
        int column = keep_inside(cell % air->columns + k % 3 - 1, air->columns);
        int row = keep_inside(cell / air->columns + k / 3 - 1, air->rows);
        if (!is_bare(of, row * air->columns + column, air->columns))
            return false;
    }
    return true;
}

bool skv_air_slope(const skv_world *world, const skv_air *air, const float *of, float x, float y,
                   float *slope_x, float *slope_y)
{
    cell_spot at;
    if (is_far(air, of, x, y) || !find_spot(world, air, x, y, &at) ||
        is_bare(of, at.cell, air->columns))
        return false;
    int name[9];
    float across[3], up[3];
    name_cells(air, at.cell, name);
    weigh(at.x, across);
    weigh(at.y, up);
    const float by_x[3] = {at.x - 0.5f, -2 * at.x, at.x + 0.5f};
    const float by_y[3] = {at.y - 0.5f, -2 * at.y, at.y + 0.5f};
    *slope_x = *slope_y = 0;
    for (int k = 0; k < 9; k++) {
        *slope_x += of[name[k]] * (by_x[k % 3] * up[k / 3]);
        *slope_y += of[name[k]] * (across[k % 3] * by_y[k / 3]);
    }
    return true;
}

/* ---- Room ------------------------------------------------------------------------------------ */

/* The body that is nearest to a place, and how far its side is. */
static int find_nearest(const skv_world *world, float x, float y, float *distance)
{
    int nearest = -1;
    *distance = INFINITY;
    for (int k = 0; k < world->bodies->count; k++) {
        float away = skv_body_distance(world, k, x, y);
        if (!(away < *distance))
            continue;
        *distance = away;
        nearest = k;
    }
    return nearest;
}

/* How much of a square of so long sides, whose middle is at (x, y), is open, its walls taken for
 * flat. What a body leaves open has its middle so far from the body's side, to which (x, y) goes:
 * were it deposited from where it is not, it would be lost behind that side, and the room of a
 * pocket would not change evenly as the body moves. */
static float find_open(const skv_world *world, const skv_air *air, float side, float *x, float *y)
{
    float distance = skv_distance_at(world->terrain, *x, *y), away = INFINITY, nx, ny;
    int nearest = air->with_bodies ? find_nearest(world, *x, *y, &away) : -1;
    float open = skv_clamp(0.5f + skv_minf(distance, away) / side, 0, 1);
    if (!(away < distance) || !(open > 0 && open < 1))
        return open;
    const skv_solid *s = &world->bodies->solids.solid[nearest];
    float lx = *x, ly = *y;
    skv_solid_enter(s, &s->now, &lx, &ly);
    skv_normal_at(s->shape->terrain, lx, ly, &nx, &ny);
    skv_solid_turn(&s->now, &nx, &ny);
    *x += (1 - open) / 2 * side * nx;
    *y += (1 - open) / 2 * side * ny;
    return open;
}

/* Adds the room that a cell has, `times` over, to those around it: that of its quarters. */
static void add_room(const skv_world *world, const skv_air *air, int column, int row, float times)
{
    const float side = 0.5f * air->cell;
    for (int k = 0; k < 4; k++) {
        float across = k & 1 ? 0.5f : -0.5f, up = k & 2 ? 0.5f : -0.5f;
        float x = skv_air_middle(air, column) + across * side;
        float y = skv_air_middle(air, row) + up * side;
        float open = find_open(world, air, side, &x, &y);
        if (open > 0)
            skv_air_deposit(world, air, x, y, times * 0.25f * open, air->room);
    }
}

static void survey_terrain(const skv_world *world, skv_air *air)
{
    air->with_bodies = false;
    for (int c = 0; c < air->cells; c++)
        air->clear[c] = skv_distance_at(world->terrain, skv_air_middle(air, c % air->columns),
                                        skv_air_middle(air, c / air->columns));
    for (int row = 0; row < air->rows; row++)
        for (int column = 0; column < air->columns; column++)
            look_at(world, air, column, row);
    find_clear(air);
    memset(air->room, 0, (size_t)air->cells * sizeof *air->room);
    for (int row = 0; row < air->rows; row++)
        for (int column = 0; column < air->columns; column++)
            add_room(world, air, column, row, 1);
    memcpy(air->bare_walls, air->walls, (size_t)air->cells);
    memcpy(air->bare_room, air->room, (size_t)air->cells * sizeof *air->room);
    skv_air_smooth(air, air->room, air->open_room, false, 0, air->rows - 1);
}

/* Marks the cells that a body may change. */
static void mark_around(const skv_air *air, const skv_rigid *body)
{
    const float reach = (float)body->shape->outline.reach + (SKV_AIR_RIM + 0.5f) * air->cell;
    const float x = (float)body->x, y = (float)body->y;
    int low = skv_air_cell_at(air, x - reach, y - reach);
    int high = skv_air_cell_at(air, x + reach, y + reach);
    for (int row = low / air->columns; row <= high / air->columns; row++)
        for (int column = low % air->columns; column <= high % air->columns; column++)
            air->walls[row * air->columns + column] |= SKV_CELL_BODY;
}

/* What is near bodies is found anew: the room that the terrain alone leaves there goes, and what
 * they leave, too, comes. */
static void survey_bodies(const skv_world *world, skv_air *air)
{
    memcpy(air->walls, air->bare_walls, (size_t)air->cells);
    memcpy(air->room, air->bare_room, (size_t)air->cells * sizeof *air->room);
    air->with_bodies = false;
    for (int k = 0; k < world->bodies->count; k++)
        mark_around(air, &world->bodies->body[k]);
    for (int c = 0; c < air->cells; c++)
        if (air->walls[c] & SKV_CELL_BODY)
            add_room(world, air, c % air->columns, c / air->columns, -1);
    air->with_bodies = world->bodies->count > 0;
    for (int c = 0; c < air->cells; c++) {
        if (!(air->walls[c] & SKV_CELL_BODY))
            continue;
        look_at(world, air, c % air->columns, c / air->columns);
        air->walls[c] |= SKV_CELL_BODY;
    }
    find_clear(air);
    for (int c = 0; c < air->cells; c++)
        if (air->walls[c] & SKV_CELL_BODY)
            add_room(world, air, c % air->columns, c / air->columns, 1);
    skv_air_smooth(air, air->room, air->open_room, false, 0, air->rows - 1);
}

void skv_air_survey(const skv_world *world, skv_air *air)
{
    if (!air->surveyed || air->terrain != world->terrain->hash)
        survey_terrain(world, air);
    air->surveyed = true;
    air->terrain = world->terrain->hash;
    if (air->with_bodies || skv_world_has_bodies(world))
        survey_bodies(world, air);
}

/* ---- Smoothing ------------------------------------------------------------------------------- */

/* Of some rows, along the axis of a side and the next. What is clear has both. */
static void smooth_along(const skv_air *air, const float *from, float *to, int side, int first,
                         int last)
{
    const int step = side == 0 ? 1 : air->columns;
    for (int c = first * air->columns; c < (last + 1) * air->columns; c++) {
        float below, above;
        if (air->walls[c] & SKV_CELL_CLEAR) {
            below = from[c - step];
            above = from[c + step];
        } else {
            below = skv_air_is_linked(air, c, side) ? from[c - step] : from[c];
            above = skv_air_is_linked(air, c, side + 1) ? from[c + step] : from[c];
        }
        to[c] = 0.5f * from[c] + 0.25f * (below + above);
    }
}

void skv_air_smooth(const skv_air *air, const float *from, float *to, bool back, int first,
                    int last)
{
    int low = first > 0 ? first - 1 : 0, high = last < air->rows - 1 ? last + 1 : last;
    if (back) {
        smooth_along(air, from, air->work, 2, first, last);
        smooth_along(air, air->work, to, 0, first, last);
    } else {
        smooth_along(air, from, air->work, 0, low, high);
        smooth_along(air, air->work, to, 2, first, last);
    }
}
