/* The dam break of an ideal liquid: a surface that moves with the potential flow under it.
 *
 * Mixed Eulerian and Lagrangian: at any time the flow is that of the surface's potential (boundary
 * elements); vertices move with it and their potential changes by Bernoulli, with the method of
 * Runge and Kutta of fourth order. Along the surface everything is a cubic spline of the vertices'
 * number, and goes on behind wall and floor as its image there. Invariant: vertex 0 is on the wall,
 * the last one on the floor.
 *
 * Everything small is a share of the elements and vanishes with them: the radius of the column's
 * upper edge, the film at the front that is cut off, and a filter against what turns its sign from
 * vertex to vertex (Longuet-Higgins and Cokelet 1976), which nothing else would hold down.
 */
#include "ideal_dam.h"
#include "quarter_flow.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

enum {
    RENEWAL = 4, /* steps from one renewal of the vertices to the next */
    MOST_ELEMENTS = DAM_VERTICES / 2
};

/* ---- Splines --------------------------------------------------------------------------------- */

/* Second derivatives of three splines through the vertices. */
typedef struct bends {
    double x[DAM_VERTICES], y[DAM_VERTICES], potential[DAM_VERTICES];
} bends;

/* Writes the second derivatives of the cubic spline through values at 0, 1, ... An end whose image
 * turns the sign has none. */
static void bend(int count, const double *value, bool turns_first, bool turns_last, double *second)
{
    static double factor[DAM_VERTICES];
    int last = count - 1;
    factor[0] = turns_first ? 0 : 0.5;
    second[0] = turns_first ? 0 : 3 * (value[1] - value[0]);
    for (int i = 1; i < last; i++) {
        factor[i] = 1 / (4 - factor[i - 1]);
        second[i] = (6 * (value[i - 1] - 2 * value[i] + value[i + 1]) - second[i - 1]) * factor[i];
    }
    second[last] = turns_last ? 0
                              : (12 * (value[last - 1] - value[last]) - 2 * second[last - 1]) /
                                    (4 - 2 * factor[last - 1]);
    for (int i = last - 1; i >= 0; i--)
        second[i] -= factor[i] * second[i + 1];
}

static void bend_all(const ideal_dam *d, bends *b)
{
    bend(d->count, d->x, true, false, b->x);
    bend(d->count, d->y, false, true, b->y);
    bend(d->count, d->potential, false, false, b->potential);
}

static double slope(int count, const double *value, const double *second, int i)
{
    if (i == count - 1)
        return value[i] - value[i - 1] + (second[i - 1] + 2 * second[i]) / 6;
    return value[i + 1] - value[i] - (2 * second[i] + second[i + 1]) / 6;
}

/* Between vertices i and i + 1. */
static double between(const double *value, const double *second, int i, double share)
{
    double rest = 1 - share;
    return rest * value[i] + share * value[i + 1] +
           ((rest * rest - 1) * rest * second[i] + (share * share - 1) * share * second[i + 1]) / 6;
}

/* ---- The flow -------------------------------------------------------------------------------- */

/* The speed through a vertex, of fourth order from those through the middles of n elements. */
static double at_vertex(const double *middle, int n, int i)
{
    double near = 0, far = 0;
    for (int side = -1; side <= 1; side += 2) {
        int first = i + (side < 0 ? -1 : 0), second = first + side;
        /* Past the ends the images, which have the same speeds. */
        first = first < 0 ? -1 - first : first >= n ? 2 * n - 1 - first : first;
        second = second < 0 ? -1 - second : second >= n ? 2 * n - 1 - second : second;
        near += middle[first];
        far += middle[second];
    }
    return (9 * near - far) / 16;
}

bool ideal_dam_velocity(const ideal_dam *dam, double *u, double *v)
{
    static double through[DAM_VERTICES];
    static bends b;
    int count = dam->count;
    if (!quarter_flow(count, dam->x, dam->y, dam->potential, through))
        return false;
    bend_all(dam, &b);
    for (int i = 0; i < count; i++) {
        double tx = slope(count, dam->x, b.x, i), ty = slope(count, dam->y, b.y, i);
        double square = tx * tx + ty * ty, length = sqrt(square);
        double along = slope(count, dam->potential, b.potential, i) / square;
        double out = at_vertex(through, count - 1, i) / length;
        u[i] = along * tx - out * ty;
        v[i] = along * ty + out * tx;
    }
    u[0] = 0;
    v[count - 1] = 0;
    return true;
}

/* ---- Vertices -------------------------------------------------------------------------------- */

/* How long an element may be at a height above the floor. */
static double wanted_length(const ideal_dam *d, double height)
{
    return fmin(0.1, 0.005 + 0.3 * height) / d->fineness;
}

/* Takes away the film at the front, where it is thinner than an element. */
static void cut(ideal_dam *d)
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

/* Takes out of a sequence what turns its sign from vertex to vertex. */
static void filter(int count, double *value, double sign_first, double sign_last)
{
    static double old[DAM_VERTICES + 4];
    int last = count + 1; /* the values are old[2] to old[last] */
    memcpy(old + 2, value, (size_t)count * sizeof *old);
    for (int k = 1; k <= 2; k++) {
        old[2 - k] = sign_first * old[2 + k];
        old[last + k] = sign_last * old[last - k];
    }
    for (int i = 0; i < count; i++)
        value[i] = (4 * (old[i + 1] + old[i + 3]) + 10 * old[i + 2] - old[i] - old[i + 4]) / 16;
}

/* Spreads the vertices along the surface as densely as is wanted. */
static bool spread(ideal_dam *d)
{
    static ideal_dam old;
    static bends b;
    static double sum[DAM_VERTICES];
    old = *d;
    bend_all(&old, &b);
    int last = old.count - 1;
    sum[0] = 0;
    for (int i = 1; i <= last; i++)
        sum[i] = sum[i - 1] + hypot(old.x[i] - old.x[i - 1], old.y[i] - old.y[i - 1]) /
                                  wanted_length(d, (old.y[i] + old.y[i - 1]) / 2);
    if (!(sum[last] < MOST_ELEMENTS))
        return false;
    int elements = (int)ceil(sum[last]);
    for (int k = 1, i = 0; k < elements; k++) {
        double wanted = sum[last] * k / elements;
        while (sum[i + 1] < wanted)
            i++;
        double share = (wanted - sum[i]) / (sum[i + 1] - sum[i]);
        d->x[k] = between(old.x, b.x, i, share);
        d->y[k] = between(old.y, b.y, i, share);
        d->potential[k] = between(old.potential, b.potential, i, share);
    }
    d->x[elements] = old.x[last];
    d->y[elements] = 0;
    d->potential[elements] = old.potential[last];
    d->count = elements + 1;
    return true;
}

static bool renew(ideal_dam *d)
{
    cut(d);
    filter(d->count, d->x, -1, 1);
    filter(d->count, d->y, 1, -1);
    filter(d->count, d->potential, 1, 1);
    d->x[0] = d->y[d->count - 1] = 0;
    return spread(d);
}

void ideal_dam_begin(ideal_dam *dam, double height, double fineness)
{
    enum { SIDE = 200, EDGE = 40 };
    double radius = 0.2 / fineness;
    *dam = (ideal_dam){.fineness = fineness, .count = 2 * SIDE + EDGE + 1};
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
    spread(dam);
}

/* ---- Time ------------------------------------------------------------------------------------ */

/* How fast a state changes. */
typedef struct change {
    double x[DAM_VERTICES], y[DAM_VERTICES], potential[DAM_VERTICES];
} change;

static bool change_of(const ideal_dam *d, change *c)
{
    if (!ideal_dam_velocity(d, c->x, c->y))
        return false;
    for (int i = 0; i < d->count; i++)
        c->potential[i] = (c->x[i] * c->x[i] + c->y[i] * c->y[i]) / 2 - d->y[i];
    return true;
}

static void add(ideal_dam *d, const change *c, double dt)
{
    for (int i = 0; i < d->count; i++) {
        d->x[i] += dt * c->x[i];
        d->y[i] += dt * c->y[i];
        d->potential[i] += dt * c->potential[i];
    }
}

/* A step that waves as short as an element, and its stretching, allow. */
static double longest_step(const ideal_dam *d, const change *c)
{
    double dt = 1;
    for (int i = 0; i + 1 < d->count; i++) {
        double length = hypot(d->x[i + 1] - d->x[i], d->y[i + 1] - d->y[i]);
        double stretch = hypot(c->x[i + 1] - c->x[i], c->y[i + 1] - c->y[i]);
        dt = fmin(dt, 0.15 * fmin(sqrt(length), length / (stretch + 1e-9)));
    }
    return dt;
}

static bool step(ideal_dam *d, double until)
{
    static const double share[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    static ideal_dam begin, at;
    static change c;
    begin = *d;
    double dt = 0;
    for (int stage = 0; stage < 4; stage++) {
        at = begin;
        add(&at, &c, share[stage] * dt);
        if (!change_of(&at, &c))
            return false;
        if (stage == 0)
            dt = fmin(longest_step(d, &c), until - d->time);
        add(d, &c, weight[stage] * dt / 6);
    }
    d->time += dt;
    d->steps++;
    return d->steps % RENEWAL != 0 || renew(d);
}

bool ideal_dam_run(ideal_dam *dam, double time)
{
    while (dam->time < time - 1e-12)
        if (!step(dam, time))
            return false;
    return true;
}

/* ---- Readings -------------------------------------------------------------------------------- */

double ideal_dam_front(const ideal_dam *dam, double height)
{
    double front = 0;
    for (int i = 0; i + 1 < dam->count; i++) {
        double above = dam->y[i] - height, below = height - dam->y[i + 1];
        if (above * below >= 0 && above + below != 0)
            front = fmax(front, dam->x[i] + (dam->x[i + 1] - dam->x[i]) * above / (above + below));
    }
    return front;
}

double ideal_dam_area(const ideal_dam *dam)
{
    double sum = 0;
    for (int i = 0; i + 1 < dam->count; i++)
        sum += (dam->x[i + 1] - dam->x[i]) * (dam->y[i + 1] + dam->y[i]) / 2;
    return sum;
}

double ideal_dam_energy(const ideal_dam *dam)
{
    static double through[DAM_VERTICES];
    if (!quarter_flow(dam->count, dam->x, dam->y, dam->potential, through))
        return (double)NAN;
    double sum = 0;
    for (int i = 0; i + 1 < dam->count; i++) {
        double dx = dam->x[i + 1] - dam->x[i], dy = dam->y[i + 1] - dam->y[i];
        double y0 = dam->y[i], y1 = dam->y[i + 1];
        sum += (dam->potential[i] + dam->potential[i + 1]) / 4 * through[i] * hypot(dx, dy);
        sum += dx * (y0 * y0 + y0 * y1 + y1 * y1) / 6;
    }
    return sum;
}
