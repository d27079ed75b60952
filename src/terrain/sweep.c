/* The swept test: how far a straight move may go.
 *
 * Far from walls it jumps by what the distance allows; near them it goes from cell to cell and
 * solves for the point where the sampled distance falls below the limit. Inside a cell the
 * distance along a straight line is a quadratic, in a saddle two straight pieces, so no wall is
 * too thin to be seen. Invariant: every point of the accepted part of the move is at least as far
 * from walls as the limit, up to rounding.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "terrain/sample.h"

#include <math.h>

/* By how much a move may undercut its limit and go on, as a share of the coordinates: four times
 * what float rounds them by, so that rounding does not make a particle stick that slides along a
 * wall. A move that falls farther is stopped at the limit itself, so that pushing again and again
 * gains nothing. */
#define ROUNDING (4.0 / 16777216)

/* The sampled distance falls by at most sqrt(2) a pixel: each axis by at most one. */
#define STEEPEST 1.4143

/* Pixels over the limit from which on a jump beats going from cell to cell. */
#define JUMP_FROM 2.0

/* The longest piece, in pixels, of a move that starts inside solid. */
#define GUARDED_PIECE 0.25

/* How much of the start's slope, in pixels (4.8 beside a straight wall), must be left at the end of
 * such a piece: well above rounding, so that nothing comes to rest exactly in a wall's middle. */
#define LEAST_SLOPE 1e-3

/* The farthest from the origin that a move may begin, in pixels: eight pictures' width. Farther out
 * rounding comes near to a thin wall's depth. And how long it may be, in pixels: the fraction of a
 * longer one does not tell places in a cell apart. */
#define FARTHEST_START 65536.0
#define LONGEST        1e9

/* A move in grid coordinates; distances along it in pixels. */
typedef struct move {
    const skv_terrain *terrain;
    double x0, y0, dx, dy; /* from the start by (dx, dy) for t = 1 */
    double length;
    double limit;     /* the distance below which the move must not get */
    double tolerance; /* and by how much it may */
} move;

static double distance_at(const move *m, double t)
{
    float distance =
        skv_grid_distance(m->terrain, (float)(m->x0 + t * m->dx), (float)(m->y0 + t * m->dy));
    return (double)distance * (double)m->terrain->per_metre;
}

/* The first fraction in 0..1 at which a quadratic through a (over the limit) with slope b and
 * curvature c reaches the limit, or 2 if it does not. */
static double first_below(double a, double b, double c)
{
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return 2;
    /* The smallest positive root in the form that does not cancel; negative if there is none. */
    double divisor = sqrt(discriminant) - b;
    return divisor > 0 && 2 * a < divisor ? skv_max(0, 2 * a / divisor) : 2;
}

/* The same inside a saddle, from (u, v) by (du, dv): straight up to the diagonal that joins the
 * solid corners and straight after it. */
static double first_below_in_saddle(const skv_corners *c, double scale, double limit, double u,
                                    double v, double du, double dv)
{
    bool rising = c->d00 < 0;
    double side = rising ? u - v : u + v - 1, turn = rising ? du - dv : du + dv;
    double kink = turn != 0 ? -side / turn : 2;
    double knots[3] = {0, kink, 1};
    int pieces = 2;
    if (!(kink > 0 && kink < 1)) {
        knots[1] = 1;
        pieces = 1;
    }
    for (int i = 0; i < pieces; i++) {
        double from = knots[i], to = knots[i + 1];
        double before =
            scale * (double)skv_cell_distance(c, (float)(u + from * du), (float)(v + from * dv));
        double after =
            scale * (double)skv_cell_distance(c, (float)(u + to * du), (float)(v + to * dv));
        double hit = first_below(before - limit, after - before, 0);
        if (hit <= 1)
            return from + hit * (to - from);
    }
    return 2;
}

/* The first fraction of the piece t0..t1 of the move, which lies in one cell, that is below the
 * limit, or 2. */
static double first_below_in_cell(const move *m, double limit, double t0, double t1)
{
    double middle = 0.5 * (t0 + t1);
    int x = (int)(m->x0 + middle * m->dx), y = (int)(m->y0 + middle * m->dy);
    skv_corners c = skv_corners_at(m->terrain, x, y);
    double scale = (double)m->terrain->per_metre;
    double u = m->x0 + t0 * m->dx - x, v = m->y0 + t0 * m->dy - y;
    double du = (t1 - t0) * m->dx, dv = (t1 - t0) * m->dy;
    if (skv_is_saddle(&c))
        return first_below_in_saddle(&c, scale, limit, u, v, du, dv);
    double a = (double)c.d00, b = (double)c.d10 - a, e = (double)c.d01 - a;
    double twist = (double)c.d11 - (double)c.d10 - e;
    double start = a + b * u + e * v + twist * u * v;
    double slope = b * du + e * dv + twist * (u * dv + v * du);
    return first_below(scale * start - limit, scale * slope, scale * twist * du * dv);
}

/* Where a coordinate that runs from g by dg per unit of t next meets a line between cells. */
static double next_line(double g0, double dg, double g)
{
    if (dg > 0)
        return (floor(g) + 1 - g0) / dg;
    if (dg < 0)
        return (ceil(g) - 1 - g0) / dg;
    return 2;
}

static bool inside_grid(const skv_terrain *terrain, double x, double y)
{
    return x >= (double)SKV_GRID_LOW && x < (double)skv_grid_high(terrain->columns) &&
           y >= (double)SKV_GRID_LOW && y < (double)skv_grid_high(terrain->rows);
}

/* Keeps a move that starts inside solid on its side of the wall until it has come out. The limit
 * alone would not: in a wall of two pixels the middle is no deeper than what is beside it. */
typedef struct guard {
    bool active;
    double x, y;   /* direction of the slope at the start */
    double needed; /* component of the slope along it below which the middle has been reached */
} guard;

static void slope_at(const move *m, double t, double *sx, double *sy)
{
    double scale = (double)m->terrain->per_metre;
    double x = m->x0 + t * m->dx, y = m->y0 + t * m->dy;
    float fx = 0, fy = 0;
    if (inside_grid(m->terrain, x, y))
        skv_grid_slope(m->terrain, (float)x, (float)y, &fx, &fy);
    *sx = scale * (double)fx;
    *sy = scale * (double)fy;
}

static guard make_guard(const move *m, double distance)
{
    double x, y;
    if (distance >= 0)
        return (guard){0};
    slope_at(m, 0, &x, &y);
    double steepness = sqrt(x * x + y * y);
    if (steepness == 0)
        return (guard){0};
    return (guard){true, x / steepness, y / steepness,
                   steepness < LEAST_SLOPE ? steepness : LEAST_SLOPE};
}

/* Whether the move has met the middle of the wall at t. */
static bool meets_middle(const guard *g, const move *m, double t)
{
    double x, y;
    slope_at(m, t, &x, &y);
    return x * g->x + y * g->y < g->needed;
}

static double march(const move *m, double distance)
{
    guard held = make_guard(m, distance);
    /* A bound for moves along the outside, which need not come to an end in reasonable time. */
    int pieces = 64 + 4 * (m->terrain->columns + m->terrain->rows);
    /* Rounding may leave a point on the line that it has just met. Going on by so much takes it
     * over the line, and by less than anything that matters. */
    double least = skv_min(1e-9, 1e-6 / m->length);
    double t = 0;
    while (pieces-- > 0) {
        if (distance - m->limit > JUMP_FROM) {
            t += (distance - m->limit) / (STEEPEST * m->length);
            if (t >= 1)
                return 1;
            distance = distance_at(m, t);
            continue;
        }
        double x = m->x0 + t * m->dx, y = m->y0 + t * m->dy, end, hit = 2;
        bool inside = inside_grid(m->terrain, x, y);
        if (inside) {
            end = skv_min(1, skv_min(next_line(m->x0, m->dx, x), next_line(m->y0, m->dy, y)));
            end = skv_max(end, t + least);
            if (held.active)
                end = skv_min(end, t + GUARDED_PIECE / m->length);
            hit = first_below_in_cell(m, m->limit - m->tolerance, t, end);
            if (hit <= 1)
                hit = skv_min(hit, first_below_in_cell(m, m->limit, t, end));
        } else {
            end = skv_min(1, t + 0.5 / m->length);
            if (distance_at(m, end) < m->limit - m->tolerance)
                hit = 0;
        }
        if (hit <= 1)
            return t + hit * (end - t);
        distance = distance_at(m, end);
        if (held.active) {
            if (inside && meets_middle(&held, m, end))
                return t;
            held.active = distance < 0;
        }
        if (end >= 1)
            return 1;
        t = end;
    }
    return t;
}

float skv_terrain_sweep(const skv_terrain *terrain, float x0, float y0, float x1, float y1,
                        float margin)
{
    SKV_ASSERT_OR(terrain, 0);
    double scale = (double)terrain->per_metre, shift = (double)SKV_TERRAIN_RIM - 0.5;
    move m = {
        .terrain = terrain,
        .x0 = (double)x0 * scale + shift,
        .y0 = (double)y0 * scale + shift,
        .dx = ((double)x1 - (double)x0) * scale,
        .dy = ((double)y1 - (double)y0) * scale,
    };
    m.length = sqrt(m.dx * m.dx + m.dy * m.dy);
    m.tolerance = ROUNDING * (fabs(m.x0) + fabs(m.y0));
    double distance = distance_at(&m, 0);
    double wanted = (double)margin * scale;
    m.limit = wanted < distance ? wanted : distance;
    /* Most moves are short and end here. Those inside solid always march, however short: what
     * keeps them on their side of a wall must not be outrun by many small steps. */
    if (distance >= 0 && distance + m.tolerance - STEEPEST * m.length >= m.limit)
        return 1;
    if (!(fabs(m.x0) <= FARTHEST_START && fabs(m.y0) <= FARTHEST_START && m.length <= LONGEST))
        return 0;
    if (m.length == 0)
        return 1;
    return (float)march(&m, distance);
}
