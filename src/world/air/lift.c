/* What lifts all pressures, because the fluid bears no pull.
 *
 * Water that stands higher than the surface on which the atmosphere presses, as at the top of a
 * siphon, and pockets thinner than the atmosphere, ask for pressures below it. The fluid knows none
 * below 0. So wherever such are asked for all air pushes that much more, the atmosphere too, and
 * what is read of pressures is that much less (skv_air_gauge). The atmosphere's own pressure is the
 * most that it can be lifted by: a siphon higher than that breaks.
 *
 * The water's part of it is estimated from above: by what is linked to the surface and lies below a
 * roof. Where nothing asks, nothing is lifted: pressures that all of the fluid bears make it denser
 * and its lattice stiffer.
 *
 * Invariant: the lift changes slowly, or what it compresses would swing.
 */
#include "world/air/air.h"

#include "base/exact.h"

#include <math.h>

/* Of the atmosphere's pressure each second, upwards and downwards: in a tenth of a second all of
 * it, while a siphon that sets in speeds up by 0.1 g/s at most; and in two. */
#define RISE 10.0
#define FALL 0.5

/* A cell with less air is fluid that touches a roof. */
#define FULL 0.3f

/* What a flood has found of some fluid: heights against gravity. */
typedef struct stretch {
    double roof, surface; /* the highest roof above it, the lowest surface to the atmosphere */
} stretch;

typedef struct upwards {
    double x, y; /* unit vector against gravity */
    int side;    /* that is nearest to it */
} upwards;

static bool is_fluid(const skv_air *air, int cell)
{
    return !(air->walls[cell] & SKV_CELL_SOLID) && air->label[cell] == SKV_NO_AIR;
}

static bool touches_roof(const skv_air *air, int cell, const upwards *up)
{
    return !skv_air_is_linked(air, cell, up->side) && air->share[cell] < FULL;
}

static double height_of(const skv_air *air, int cell, const upwards *up)
{
    return up->x * (double)skv_air_middle(air, cell % air->columns) +
           up->y * (double)skv_air_middle(air, cell / air->columns);
}

/* Floods the fluid that is linked to a cell. The label 1 stands for what has been. */
static stretch flood(skv_air *air, int cell, const upwards *up)
{
    stretch found = {-INFINITY, INFINITY};
    int used = 0;
    air->scratch[used++] = cell;
    air->label[cell] = SKV_ATMOSPHERE;
    for (int at = 0; at < used; at++) {
        int here = air->scratch[at];
        if (touches_roof(air, here, up))
            found.roof = skv_max(found.roof, height_of(air, here, up));
        for (int side = 0; side < 4; side++) {
            if (!skv_air_is_linked(air, here, side))
                continue;
            int next = skv_air_beside(air, here, side);
            if (air->label[next] && air->piece[air->label[next]].outside)
                found.surface = skv_min(found.surface, height_of(air, here, up));
            if (!is_fluid(air, next))
                continue;
            air->label[next] = SKV_ATMOSPHERE;
            air->scratch[used++] = next;
        }
    }
    return found;
}

/* How high fluid below a roof stands above a surface that it is linked to, m. */
static double find_height(skv_air *air, const upwards *up)
{
    double most = 0;
    for (int c = 0; c < air->cells; c++) {
        if (air->walls[c] & SKV_CELL_CLEAR || !is_fluid(air, c) || !touches_roof(air, c, up))
            continue;
        stretch found = flood(air, c, up);
        most = skv_max(most, found.roof - found.surface);
    }
    for (int c = 0; c < air->cells; c++)
        if (air->label[c] == SKV_ATMOSPHERE)
            air->label[c] = SKV_NO_AIR;
    return most;
}

void skv_air_find_lift(const skv_world *world, skv_air *air, double dt)
{
    double gx = (double)world->gravity_x, gy = (double)world->gravity_y;
    double gravity = sqrt(gx * gx + gy * gy), most = (double)air->pressure;
    if (gravity > 0) {
        bool upright = gy * gy >= gx * gx;
        const upwards up = {-gx / gravity, -gy / gravity, upright ? 2 + (gy < 0) : (gx < 0)};
        double pull = (double)world->fluid.density * gravity * find_height(air, &up);
        air->wanted_lift = skv_max(air->wanted_lift, pull);
    }
    air->wanted_lift = skv_min(air->wanted_lift, most);
    double change = air->wanted_lift - air->lift;
    if (dt > 0)
        change = skv_min(skv_max(change, -FALL * most * dt), RISE * most * dt);
    air->lift += change;
}
