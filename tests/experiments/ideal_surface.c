/* The moving surface of an ideal liquid: it goes with the potential flow under it.
 *
 * Mixed Eulerian and Lagrangian: at any time the flow is that of the surface's potential (boundary
 * elements); vertices move with it and their potential changes by Bernoulli, with the method of
 * Runge and Kutta of fourth order. Along the surface everything is a cubic spline of the vertices'
 * number, and goes on behind walls and floor as its image there. Invariant: vertex 0 is on the wall
 * x = 0, the last one on the floor or on another wall, where its liquid says.
 *
 * A filter against what turns its sign from vertex to vertex (Longuet-Higgins and Cokelet 1976),
 * which nothing else would hold down, vanishes with the length of the elements.
 */
#include "ideal_surface.h"

#include <math.h>
#include <string.h>

enum {
    RENEWAL = 4, /* steps from one renewal of the vertices to the next */
    MOST_ELEMENTS = SURFACE_VERTICES / 2
};

/* ---- Splines --------------------------------------------------------------------------------- */

/* Second derivatives of three splines through the vertices. */
typedef struct bends {
    double x[SURFACE_VERTICES], y[SURFACE_VERTICES], potential[SURFACE_VERTICES];
} bends;

/* Writes the second derivatives of the cubic spline through values at 0, 1, ... An end whose image
 * turns the sign has none. */
static void bend(int count, const double *value, bool turns_first, bool turns_last, double *second)
{
    static double factor[SURFACE_VERTICES];
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

static void bend_all(const ideal_surface *s, bends *b)
{
    bool on_wall = s->liquid->ends_on_wall;
    bend(s->count, s->x, true, on_wall, b->x);
    bend(s->count, s->y, false, !on_wall, b->y);
    bend(s->count, s->potential, false, false, b->potential);
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

bool ideal_surface_velocity(const ideal_surface *s, double *u, double *v)
{
    static double through[SURFACE_VERTICES];
    static bends b;
    int count = s->count;
    if (!s->liquid->flow(count, s->x, s->y, s->potential, through))
        return false;
    bend_all(s, &b);
    for (int i = 0; i < count; i++) {
        double tx = slope(count, s->x, b.x, i), ty = slope(count, s->y, b.y, i);
        double square = tx * tx + ty * ty, length = sqrt(square);
        double along = slope(count, s->potential, b.potential, i) / square;
        double out = at_vertex(through, count - 1, i) / length;
        u[i] = along * tx - out * ty;
        v[i] = along * ty + out * tx;
    }
    u[0] = 0;
    *(s->liquid->ends_on_wall ? &u[count - 1] : &v[count - 1]) = 0;
    return true;
}

/* ---- Vertices -------------------------------------------------------------------------------- */

/* Takes out of a sequence what turns its sign from vertex to vertex. */
static void filter(int count, double *value, bool turns_first, bool turns_last)
{
    static double old[SURFACE_VERTICES + 4];
    int last = count + 1; /* the values are old[2] to old[last] */
    memcpy(old + 2, value, (size_t)count * sizeof *old);
    for (int k = 1; k <= 2; k++) {
        old[2 - k] = turns_first ? 2 * old[2] - old[2 + k] : old[2 + k];
        old[last + k] = turns_last ? 2 * old[last] - old[last - k] : old[last - k];
    }
    for (int i = 0; i < count; i++)
        value[i] = (4 * (old[i + 1] + old[i + 3]) + 10 * old[i + 2] - old[i] - old[i + 4]) / 16;
}

static double length_at(const ideal_surface *s, double height)
{
    return s->liquid->wanted_length(height) / s->fineness;
}

bool ideal_surface_spread(ideal_surface *s)
{
    static ideal_surface old;
    static bends b;
    static double sum[SURFACE_VERTICES];
    old = *s;
    bend_all(&old, &b);
    int last = old.count - 1;
    sum[0] = 0;
    for (int i = 1; i <= last; i++)
        sum[i] = sum[i - 1] + hypot(old.x[i] - old.x[i - 1], old.y[i] - old.y[i - 1]) /
                                  length_at(s, (old.y[i] + old.y[i - 1]) / 2);
    if (!(sum[last] < MOST_ELEMENTS))
        return false;
    int elements = (int)ceil(sum[last]);
    for (int k = 1, i = 0; k < elements; k++) {
        double wanted = sum[last] * k / elements;
        while (sum[i + 1] < wanted)
            i++;
        double share = (wanted - sum[i]) / (sum[i + 1] - sum[i]);
        s->x[k] = between(old.x, b.x, i, share);
        s->y[k] = between(old.y, b.y, i, share);
        s->potential[k] = between(old.potential, b.potential, i, share);
    }
    s->x[elements] = old.x[last];
    s->y[elements] = old.y[last];
    s->potential[elements] = old.potential[last];
    s->count = elements + 1;
    return true;
}

static bool renew(ideal_surface *s)
{
    bool on_wall = s->liquid->ends_on_wall;
    if (s->liquid->cut)
        s->liquid->cut(s);
    filter(s->count, s->x, true, on_wall);
    filter(s->count, s->y, false, !on_wall);
    filter(s->count, s->potential, false, false);
    return ideal_surface_spread(s);
}

/* ---- Time ------------------------------------------------------------------------------------ */

/* How fast a state changes. */
typedef struct change {
    double x[SURFACE_VERTICES], y[SURFACE_VERTICES], potential[SURFACE_VERTICES];
} change;

static bool change_of(const ideal_surface *s, change *c)
{
    if (!ideal_surface_velocity(s, c->x, c->y))
        return false;
    for (int i = 0; i < s->count; i++)
        c->potential[i] = (c->x[i] * c->x[i] + c->y[i] * c->y[i]) / 2 - s->y[i];
    return true;
}

static void add(ideal_surface *s, const change *c, double dt)
{
    for (int i = 0; i < s->count; i++) {
        s->x[i] += dt * c->x[i];
        s->y[i] += dt * c->y[i];
        s->potential[i] += dt * c->potential[i];
    }
}

/* A step that waves as short as an element, and its stretching, allow. */
static double longest_step(const ideal_surface *s, const change *c)
{
    double dt = 1;
    for (int i = 0; i + 1 < s->count; i++) {
        double length = hypot(s->x[i + 1] - s->x[i], s->y[i + 1] - s->y[i]);
        double stretch = hypot(c->x[i + 1] - c->x[i], c->y[i + 1] - c->y[i]);
        dt = fmin(dt, 0.15 * fmin(sqrt(length), length / (stretch + 1e-9)));
    }
    return dt;
}

bool ideal_surface_step(ideal_surface *s, double until)
{
    static const double share[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    static ideal_surface begin, at;
    static change c;
    begin = *s;
    double dt = 0;
    for (int stage = 0; stage < 4; stage++) {
        at = begin;
        add(&at, &c, share[stage] * dt);
        if (!change_of(&at, &c))
            return false;
        if (stage == 0)
            dt = fmin(longest_step(s, &c), until - s->time);
        add(s, &c, weight[stage] * dt / 6);
    }
    s->time += dt;
    s->steps++;
    return s->steps % RENEWAL != 0 || renew(s);
}

bool ideal_surface_run(ideal_surface *s, double time)
{
    while (s->time < time - 1e-12)
        if (!ideal_surface_step(s, time))
            return false;
    return true;
}

/* ---- Readings -------------------------------------------------------------------------------- */

double ideal_surface_area(const ideal_surface *s)
{
    double sum = 0;
    for (int i = 0; i + 1 < s->count; i++)
        sum += (s->x[i + 1] - s->x[i]) * (s->y[i + 1] + s->y[i]) / 2;
    return sum;
}

double ideal_surface_energy(const ideal_surface *s)
{
    static double through[SURFACE_VERTICES];
    if (!s->liquid->flow(s->count, s->x, s->y, s->potential, through))
        return (double)NAN;
    double sum = 0;
    for (int i = 0; i + 1 < s->count; i++) {
        double dx = s->x[i + 1] - s->x[i], dy = s->y[i + 1] - s->y[i];
        double y0 = s->y[i], y1 = s->y[i + 1];
        sum += (s->potential[i] + s->potential[i + 1]) / 4 * through[i] * hypot(dx, dy);
        sum += dx * (y0 * y0 + y0 * y1 + y1 * y1) / 6;
    }
    return sum;
}
