/* Scan lines of shapes: where horizontal lines run inside of them, from below to above. */
#ifndef SKV_SCENE_SCAN_H
#define SKV_SCENE_SCAN_H

#include "scene/shape.h"

/* Part of a horizontal line, begin <= end. */
typedef struct skv_span {
    double begin, end;
} skv_span;

/* An edge of a polygon or a piece of a thick line. */
typedef struct skv_scan_edge {
    const double *a, *b; /* its ends */
    double low, high;    /* lines from low to before high may meet it */
    skv_span span;       /* what the last line met of it; an edge's crossing is where it begins */
    bool met;
} skv_scan_edge;

/* A scan of one shape: first the edges that lines meet at present, in the last line's order, and
 * from `next` on those to come, the lowest first. */
typedef struct skv_scan {
    const skv_shape *shape;
    skv_scan_edge *edges;
    int count, active, next;
} skv_scan;

/* How many edges a scan has, and the most spans of a line; at least 1. */
int skv_scan_edges(const skv_shape *shape);

/* Begins a scan of a shape, with memory for its edges. */
void skv_scan_begin(skv_scan *scan, const skv_shape *shape, skv_scan_edge *edges);

/* Writes where the line at height y, above those before it, runs inside the shape: disjoint spans
 * in ascending order; returns their number. */
int skv_scan_line(skv_scan *scan, double y, skv_span *spans);

#endif
