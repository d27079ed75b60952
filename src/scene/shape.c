/* Shapes: their bounds and thickness, and what they contain. Invariant: a shape contains nothing
 * outside of its bounds. */
#include "scene/shape.h"

#include <math.h>

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

void skv_shape_set_bounds(skv_shape *shape)
{
    double margin = shape->kind == SKV_SHAPE_POLYGON ? 0.0 : shape->radius;
    const double centre[2] = {shape->x, shape->y};
    const double *points = shape->kind == SKV_SHAPE_CIRCLE ? centre : shape->points;
    int count = shape->kind == SKV_SHAPE_CIRCLE ? 1 : shape->point_count;
    shape->x0 = shape->x1 = points[0];
    shape->y0 = shape->y1 = points[1];
    for (int i = 1; i < count; i++) {
        shape->x0 = smaller(shape->x0, points[2 * i]);
        shape->x1 = larger(shape->x1, points[2 * i]);
        shape->y0 = smaller(shape->y0, points[2 * i + 1]);
        shape->y1 = larger(shape->y1, points[2 * i + 1]);
    }
    shape->x0 -= margin;
    shape->x1 += margin;
    shape->y0 -= margin;
    shape->y1 += margin;
}

/* ---- Thickness ------------------------------------------------------------------------------- */

/* Twice the area over the outline's length: of a long shape, its width. */
static double mean_width(const skv_shape *polygon)
{
    double area = 0.0, length = 0.0;
    const double *previous = polygon->points + 2 * (polygon->point_count - 1);
    for (int i = 0; i < polygon->point_count; i++) {
        const double *point = polygon->points + 2 * i;
        double dx = point[0] - previous[0], dy = point[1] - previous[1];
        area += previous[0] * dy - previous[1] * dx;
        length += sqrt(dx * dx + dy * dy);
        previous = point;
    }
    return length > 0.0 ? fabs(area) / length : 0.0;
}

/* Widens begin..end to `least` around its middle. */
static bool widen(double *begin, double *end, double least)
{
    if (*end - *begin >= least)
        return false;
    double middle = 0.5 * (*begin + *end);
    *begin = middle - 0.5 * least;
    *end = middle + 0.5 * least;
    return true;
}

bool skv_shape_thicken(skv_shape *shape, double least)
{
    if (shape->kind == SKV_SHAPE_BOX) {
        bool wider = widen(&shape->x0, &shape->x1, least);
        return widen(&shape->y0, &shape->y1, least) || wider;
    }
    if (shape->kind == SKV_SHAPE_POLYGON) {
        if (mean_width(shape) >= least)
            return false;
        shape->kind = SKV_SHAPE_LINE;
        shape->radius = 0.0;
    }
    if (2.0 * shape->radius >= least)
        return false;
    shape->radius = 0.5 * least;
    skv_shape_set_bounds(shape);
    return true;
}

/* ---- Containment ----------------------------------------------------------------------------- */

bool skv_edge_crossing(const double *a, const double *b, double y, double *x)
{
    if ((a[1] <= y) == (b[1] <= y))
        return false;
    *x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    return true;
}

static bool in_polygon(const skv_shape *shape, double x, double y)
{
    bool inside = false;
    const double *previous = shape->points + 2 * (shape->point_count - 1);
    for (int i = 0; i < shape->point_count; i++) {
        const double *point = shape->points + 2 * i;
        double crossing;
        if (skv_edge_crossing(previous, point, y, &crossing) && crossing > x)
            inside = !inside;
        previous = point;
    }
    return inside;
}

static double square_distance_to_segment(const double *a, const double *b, double x, double y)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], px = x - a[0], py = y - a[1];
    double length = dx * dx + dy * dy;
    double t = length > 0.0 ? (px * dx + py * dy) / length : 0.0;
    t = larger(0.0, smaller(1.0, t));
    px -= t * dx;
    py -= t * dy;
    return px * px + py * py;
}

static bool in_line(const skv_shape *shape, double x, double y)
{
    for (int i = 0; i + 1 < shape->point_count; i++) {
        const double *a = shape->points + 2 * i;
        if (square_distance_to_segment(a, a + 2, x, y) <= shape->radius * shape->radius)
            return true;
    }
    return false;
}

bool skv_shape_contains(const skv_shape *shape, double x, double y)
{
    if (x < shape->x0 || x > shape->x1 || y < shape->y0 || y > shape->y1)
        return false;
    double dx = x - shape->x, dy = y - shape->y;
    switch (shape->kind) {
    case SKV_SHAPE_BOX:
        return true;
    case SKV_SHAPE_CIRCLE:
        return dx * dx + dy * dy <= shape->radius * shape->radius;
    case SKV_SHAPE_POLYGON:
        return in_polygon(shape, x, y);
    case SKV_SHAPE_LINE:
        return in_line(shape, x, y);
    }
    return false;
}
