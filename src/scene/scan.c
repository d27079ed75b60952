/* Scan lines. From line to line edges hardly change their order, so sorting them again costs next
 * to nothing, and edges that no line meets cost nothing.
 *
 * Invariant: a point is contained exactly if it lies in a span of its own height, up to rounding.
 */
#include "scene/scan.h"

#include <math.h>
#include <stdlib.h>

/* By how much more than its radius, relative to the numbers, lines about a piece of a thick line
 * are asked: rounding may not leave one out. */
#define SLACK 1e-6

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* ---- Thick lines ----------------------------------------------------------------------------- */

static bool circle_span(double cx, double cy, double radius, double y, skv_span *span)
{
    double rest = radius * radius - (y - cy) * (y - cy);
    if (rest <= 0.0)
        return false;
    double half = sqrt(rest);
    *span = (skv_span){cx - half, cx + half};
    return true;
}

/* Narrows a span to where low <= slope x + offset <= high. */
static void narrow(skv_span *span, double slope, double offset, double low, double high)
{
    if (slope == 0.0) {
        if (offset < low || offset > high)
            span->end = span->begin - 1.0;
        return;
    }
    double a = (low - offset) / slope, b = (high - offset) / slope;
    span->begin = larger(span->begin, smaller(a, b));
    span->end = smaller(span->end, larger(a, b));
}

/* The capsule around a segment is convex, so a line cuts it once: the hull of what it cuts from the
 * two round ends and from the slab between them. */
static bool capsule_span(const double *a, const double *b, double radius, double y, skv_span *span)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
    skv_span part[3];
    int count = 0;
    count += circle_span(a[0], a[1], radius, y, &part[count]);
    count += circle_span(b[0], b[1], radius, y, &part[count]);
    if (length > 0.0) {
        skv_span slab = {smaller(a[0], b[0]) - radius, larger(a[0], b[0]) + radius};
        double ux = dx / length, uy = dy / length;
        narrow(&slab, ux, uy * (y - a[1]) - ux * a[0], 0.0, length);
        narrow(&slab, -uy, ux * (y - a[1]) + uy * a[0], -radius, radius);
        if (slab.begin < slab.end)
            part[count++] = slab;
    }
    if (count == 0)
        return false;
    *span = part[0];
    for (int i = 1; i < count; i++) {
        span->begin = smaller(span->begin, part[i].begin);
        span->end = larger(span->end, part[i].end);
    }
    return true;
}

/* ---- Scans ----------------------------------------------------------------------------------- */

int skv_scan_edges(const skv_shape *shape)
{
    return shape->kind == SKV_SHAPE_POLYGON || shape->kind == SKV_SHAPE_LINE ? shape->point_count
                                                                             : 1;
}

static int compare_low(const void *a, const void *b)
{
    double x = ((const skv_scan_edge *)a)->low, y = ((const skv_scan_edge *)b)->low;
    return (x > y) - (x < y);
}

void skv_scan_begin(skv_scan *scan, const skv_shape *shape, skv_scan_edge *edges)
{
    *scan = (skv_scan){.shape = shape, .edges = edges};
    bool closed = shape->kind == SKV_SHAPE_POLYGON;
    if (!closed && shape->kind != SKV_SHAPE_LINE)
        return;
    double reach = closed ? 0 : shape->radius * (1 + SLACK);
    for (int i = closed ? 0 : 1; i < shape->point_count; i++) {
        const double *b = shape->points + 2 * i;
        const double *a = i > 0 ? b - 2 : shape->points + 2 * (shape->point_count - 1);
        double slack = closed ? 0 : SLACK * (fabs(a[1]) + fabs(b[1]));
        edges[scan->count++] = (skv_scan_edge){.a = a,
                                               .b = b,
                                               .low = smaller(a[1], b[1]) - reach - slack,
                                               .high = larger(a[1], b[1]) + reach + slack};
    }
    qsort(edges, (size_t)scan->count, sizeof *edges, compare_low);
}

/* Finds what a line meets of an edge. */
static void meet(const skv_scan *scan, double y, skv_scan_edge *edge)
{
    edge->met = scan->shape->kind == SKV_SHAPE_POLYGON
                    ? skv_edge_crossing(edge->a, edge->b, y, &edge->span.begin)
                    : capsule_span(edge->a, edge->b, scan->shape->radius, y, &edge->span);
}

/* Meets all edges anew, without those that end below the line, and puts them in its order. */
static void advance(skv_scan *scan, double y)
{
    skv_scan_edge *edges = scan->edges;
    while (scan->next < scan->count && edges[scan->next].low <= y)
        edges[scan->active++] = edges[scan->next++];
    int kept = 0;
    for (int i = 0; i < scan->active; i++) {
        skv_scan_edge edge = edges[i];
        if (edge.high <= y)
            continue;
        meet(scan, y, &edge);
        int place = kept++;
        for (; place > 0 && edges[place - 1].span.begin > edge.span.begin; place--)
            edges[place] = edges[place - 1];
        edges[place] = edge;
    }
    scan->active = kept;
}

/* Adds a span that begins no farther left than those before it. */
static int add_span(skv_span *spans, int count, skv_span span)
{
    if (count == 0 || span.begin > spans[count - 1].end) {
        spans[count] = span;
        return count + 1;
    }
    spans[count - 1].end = larger(spans[count - 1].end, span.end);
    return count;
}

static int edge_spans(skv_scan *scan, double y, skv_span *spans)
{
    advance(scan, y);
    bool pairs = scan->shape->kind == SKV_SHAPE_POLYGON, odd = false;
    double begin = 0;
    int count = 0;
    for (int i = 0; i < scan->active; i++) {
        const skv_scan_edge *edge = &scan->edges[i];
        if (!edge->met)
            continue;
        if (!pairs)
            count = add_span(spans, count, edge->span);
        else if (odd)
            count = add_span(spans, count, (skv_span){begin, edge->span.begin});
        begin = edge->span.begin;
        odd = !odd;
    }
    return count;
}

int skv_scan_line(skv_scan *scan, double y, skv_span *spans)
{
    const skv_shape *shape = scan->shape;
    if (y < shape->y0 || y > shape->y1)
        return 0;
    switch (shape->kind) {
    case SKV_SHAPE_BOX:
        spans[0] = (skv_span){shape->x0, shape->x1};
        return 1;
    case SKV_SHAPE_CIRCLE:
        return circle_span(shape->x, shape->y, shape->radius, y, &spans[0]);
    default:
        return edge_spans(scan, y, spans);
    }
}
