/* The swept test: how far a straight move may go.
 *
 * Far from walls it jumps by what the distance allows; near them it goes from cell to cell and
 * solves for the point where the sampled distance falls below the limit. Inside a cell the
 * distance along a straight line is a quadratic, in a saddle two straight pieces, so no wall is
 * too thin to be seen. Invariant: every point of the accepted part of the move is at least as far
 * from walls as the limit, up to rounding.
 */
#include "base/assert.h"
#include "terrain/sample.h"

#include <math.h>

/* Pixels by which a move may undercut its limit, so that rounding does not make a particle stick
 * that slides along a wall. Position rounding is below 1/1000 pixel in the largest picture. */
#define TOLERANCE (1.0 / 256)

/* The sampled distance falls by at most sqrt(2) a pixel: each axis by at most one. */
#define STEEPEST 1.4143

/* Pixels over the limit from which on a jump beats going from cell to cell. */
#define JUMP_FROM 2.0

/* A move in grid coordinates; distances along it in pixels. */
typedef struct move {
    const skv_terrain *terrain;
    double x0, y0, dx, dy; /* from the start by (dx, dy) for t = 1 */
    double length;
    double limit;
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
    return divisor > 0 && 2 * a < divisor ? fmax(0, 2 * a / divisor) : 2;
}

/* The same inside a saddle, from (u, v) by (du, dv): straight up to the diagonal that joins the
 * solid corners and straight after it. */
static double first_below_in_saddle(const skv_corners *c, double scale, double limit, double u,
                                    double v, double du, double dv)
{
    bool rising = c->d00 < 0;
    double side = rising ? u - v : u + v - 1, turn = rising ? du - dv : du + dv;
    double kink = turn != 0 ? -side / turn : 2;
    double knots[4] = {0, kink, 1, 1};
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

/* The first fraction of the piece t0..t1 of the move, which lies in cell (x, y), that is below the
 * limit, or 2. */
static double first_below_in_cell(const move *m, int x, int y, double t0, double t1)
{
    skv_corners c = skv_corners_at(m->terrain, x, y);
    double scale = (double)m->terrain->per_metre;
    double u = m->x0 + t0 * m->dx - x, v = m->y0 + t0 * m->dy - y;
    double du = (t1 - t0) * m->dx, dv = (t1 - t0) * m->dy;
    if (skv_is_saddle(&c))
        return first_below_in_saddle(&c, scale, m->limit, u, v, du, dv);
    double a = (double)c.d00, b = (double)c.d10 - a, e = (double)c.d01 - a;
    double twist = (double)c.d11 - (double)c.d10 - e;
    double start = a + b * u + e * v + twist * u * v;
    double slope = b * du + e * dv + twist * (u * dv + v * du);
    return first_below(scale * start - m->limit, scale * slope, scale * twist * du * dv);
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

/* Whether the point at t lies in solid on the other side of the middle of a wall than the start,
 * whose slope is (sx, sy). In a wall of two pixels the middle is no deeper than what is beside it,
 * so that the limit alone would let a particle through that has got inside. */
static bool crossed_middle(const move *m, double t, float sx, float sy)
{
    double x = m->x0 + t * m->dx, y = m->y0 + t * m->dy;
    if (!inside_grid(m->terrain, x, y) || distance_at(m, t) >= 0)
        return false;
    float tx, ty;
    skv_grid_slope(m->terrain, (float)x, (float)y, &tx, &ty);
    return tx * sx + ty * sy <= 0;
}

static double march(const move *m, double distance)
{
    float sx = 0, sy = 0;
    if (distance < 0 && inside_grid(m->terrain, m->x0, m->y0))
        skv_grid_slope(m->terrain, (float)m->x0, (float)m->y0, &sx, &sy);
    bool guarded = sx != 0 || sy != 0;
    /* A bound for moves along the outside, which need not come to an end in reasonable time. */
    int pieces = 64 + 4 * (m->terrain->columns + m->terrain->rows);
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
        if (inside_grid(m->terrain, x, y)) {
            end = fmin(1, fmin(next_line(m->x0, m->dx, x), next_line(m->y0, m->dy, y)));
            /* Rounding may leave the point on the line that it has just met. */
            end = fmax(end, t + 1e-9);
            double middle = 0.5 * (t + end);
            hit = first_below_in_cell(m, (int)(m->x0 + middle * m->dx),
                                      (int)(m->y0 + middle * m->dy), t, end);
        } else {
            end = fmin(1, t + 0.5 / m->length);
            if (distance_at(m, end) < m->limit)
                hit = 0;
        }
        if (hit <= 1)
            return t + hit * (end - t);
        if (guarded && crossed_middle(m, end, sx, sy))
            return t;
        if (end >= 1)
            return 1;
        t = end;
        distance = distance_at(m, t);
    }
    return t;
}

float skv_terrain_sweep(const skv_terrain *terrain, float x0, float y0, float x1, float y1,
                        float clearance)
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
    double distance = distance_at(&m, 0);
    m.limit = fmin((double)clearance * scale, distance) - TOLERANCE;
    if (distance - STEEPEST * m.length >= m.limit)
        return 1;
    if (!(m.length <= 1e30))
        return 0;
    return (float)march(&m, distance);
}
