/* A tank's surface, from one wall to the other, and the liquid's centre.
 *
 * Invariant: an element is as long as a small share of the depth under it, or of the tank.
 */
#include "ideal_tank.h"
#include "mirrored_flow.h"

#include <math.h>

static double wanted_length(double height)
{
    return fmin(0.025, 0.25 * height);
}

static const ideal_liquid pool = {
    .ends_on_wall = true, .flow = tank_flow, .wanted_length = wanted_length};

void ideal_tank_begin(ideal_surface *tank, double depth, double slope, double fineness)
{
    enum { PIECES = 400 };
    *tank = (ideal_surface){.liquid = &pool, .fineness = fineness, .count = PIECES + 1};
    for (int i = 0; i <= PIECES; i++) {
        tank->x[i] = (double)i / PIECES;
        tank->y[i] = depth + slope * (tank->x[i] - 0.5);
    }
    ideal_surface_spread(tank);
}

double ideal_tank_centre(const ideal_surface *tank)
{
    double area = 0, moment = 0;
    for (int i = 0; i + 1 < tank->count; i++) {
        double x0 = tank->x[i], x1 = tank->x[i + 1], y0 = tank->y[i], y1 = tank->y[i + 1];
        area += (x1 - x0) * (y0 + y1) / 2;
        moment += (x1 - x0) * (x0 * (2 * y0 + y1) + x1 * (y0 + 2 * y1)) / 6;
    }
    return moment / area;
}
