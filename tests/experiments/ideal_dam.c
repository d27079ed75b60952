/* A column's surface, from the wall to the floor, and its front.
 *
 * Invariant: what is added to the column, the radius of its upper edge, and what is taken away, the
 * film at the front, vanish with the elements or are thinner than the lowest height that is read.
 */
#include "ideal_dam.h"
#include "mirrored_flow.h"

#include <math.h>

#define PI 3.14159265358979323846

static double wanted_length(double height)
{
    return fmin(0.1, 0.005 + 0.3 * height);
}

/* Takes away the film at the front, where it is thinner than an element. */
static void cut(ideal_surface *d)
{
    double film = 0.005;
    int last = d->count - 1, i = last - 1;
    while (i > 4 && d->y[i] < film)
        i--;
    double end = d->x[i] + 2 * d->y[i];
    if (i >= last - 2 || d->x[last] < end)
        return;
    double share = (end - d->x[i - 1]) / (d->x[i] - d->x[i - 1]);
    d->x[i + 1] = end;
    d->y[i + 1] = 0;
    d->potential[i + 1] = d->potential[i - 1] + share * (d->potential[i] - d->potential[i - 1]);
    d->count = i + 2;
}

static const ideal_liquid column = {
    .flow = quarter_flow, .wanted_length = wanted_length, .cut = cut};

void ideal_dam_begin(ideal_surface *dam, double height, double fineness)
{
    enum { SIDE = 200, EDGE = 40 };
    double radius = 0.2 / fineness;
    *dam = (ideal_surface){.liquid = &column, .fineness = fineness, .count = 2 * SIDE + EDGE + 1};
    for (int i = 0; i < SIDE; i++) {
        dam->x[i] = (1 - radius) * i / SIDE;
        dam->y[i] = height;
        dam->x[SIDE + EDGE + 1 + i] = 1;
        dam->y[SIDE + EDGE + 1 + i] = (height - radius) * (SIDE - 1 - i) / SIDE;
    }
    for (int i = 0; i <= EDGE; i++) {
        dam->x[SIDE + i] = 1 - radius + radius * sin(PI / 2 * i / EDGE);
        dam->y[SIDE + i] = height - radius + radius * cos(PI / 2 * i / EDGE);
    }
    ideal_surface_spread(dam);
}

double ideal_dam_front(const ideal_surface *dam, double height)
{
    double front = 0;
    for (int i = 0; i + 1 < dam->count; i++) {
        double above = dam->y[i] - height, below = height - dam->y[i + 1];
        if (above * below >= 0 && above + below != 0)
            front = fmax(front, dam->x[i] + (dam->x[i + 1] - dam->x[i]) * above / (above + below));
    }
    return front;
}
