/* Rasteriser: each pixel row is cut by LINES scan lines; along a line areas are exact.
 *
 * Invariant: on a scan line `solid` and `air` are disjoint lists of disjoint spans in ascending
 * order: what the shapes so far have filled and what they have carved. A pixel's coverage is its
 * solid part plus the picture's share of the part that no shape has touched, so that shapes which
 * share an edge inside a pixel leave no seam.
 */
#include "scene/raster.h"

#include <string.h>

#include "base/memory.h"
#include "scene/scan.h"

#define LINES 16

/* Of spans, one among so many is inserted, while more of them are merged. */
#define FEW 8

typedef struct span_list {
    skv_span *spans;
    int count;
} span_list;

/* Sums of spans over a pixel row: what the pixels at a span's ends get, and where runs of fully
 * covered pixels begin (+1) and end (-1). */
typedef struct row_sum {
    double *partial, *run;
} row_sum;

typedef struct raster {
    int width;
    double pixel_size;
    skv_scan *scans; /* of the shapes */
    span_list solid, air, cut, scratch;
    row_sum solid_sum, air_sum;
} raster;

/* The first span that does not end before `x`. */
static int find_span(const span_list *list, double x)
{
    int low = 0, high = list->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (list->spans[middle].end < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* target := target united with one span. */
static void unite_span(span_list *target, skv_span span)
{
    int first = find_span(target, span.begin), end = first;
    for (; end < target->count && target->spans[end].begin <= span.end; end++) {
        const skv_span *met = &target->spans[end];
        span.begin = met->begin < span.begin ? met->begin : span.begin;
        span.end = met->end > span.end ? met->end : span.end;
    }
    memmove(target->spans + first + 1, target->spans + end,
            (size_t)(target->count - end) * sizeof *target->spans);
    target->spans[first] = span;
    target->count += first + 1 - end;
}

/* target := target united with `cut`. */
static void unite(span_list *target, const span_list *cut, span_list *scratch)
{
    if (cut->count * FEW <= target->count) {
        for (int k = 0; k < cut->count; k++)
            unite_span(target, cut->spans[k]);
        return;
    }
    int i = 0, j = 0, count = 0;
    while (i < target->count || j < cut->count) {
        bool first =
            j == cut->count || (i < target->count && target->spans[i].begin <= cut->spans[j].begin);
        skv_span next = first ? target->spans[i++] : cut->spans[j++];
        if (count > 0 && next.begin <= scratch->spans[count - 1].end) {
            if (next.end > scratch->spans[count - 1].end)
                scratch->spans[count - 1].end = next.end;
        } else {
            scratch->spans[count++] = next;
        }
    }
    memcpy(target->spans, scratch->spans, (size_t)count * sizeof *scratch->spans);
    target->count = count;
}

/* target := target without `cut`. */
static void subtract(span_list *target, const span_list *cut, span_list *scratch)
{
    if (target->count == 0)
        return;
    int j = 0, count = 0;
    for (int i = 0; i < target->count; i++) {
        skv_span rest = target->spans[i];
        while (j < cut->count && cut->spans[j].end <= rest.begin)
            j++;
        for (int k = j; k < cut->count && cut->spans[k].begin < rest.end; k++) {
            if (cut->spans[k].begin > rest.begin)
                scratch->spans[count++] = (skv_span){rest.begin, cut->spans[k].begin};
            rest.begin = cut->spans[k].end;
        }
        if (rest.begin < rest.end)
            scratch->spans[count++] = rest;
    }
    memcpy(target->spans, scratch->spans, (size_t)count * sizeof *scratch->spans);
    target->count = count;
}

static double to_pixels(const raster *r, double x)
{
    double pixels = x / r->pixel_size;
    if (pixels < 0.0)
        return 0.0;
    return pixels < r->width ? pixels : r->width;
}

static void sum_spans(const raster *r, const span_list *list, row_sum *sum)
{
    for (int i = 0; i < list->count; i++) {
        double begin = to_pixels(r, list->spans[i].begin), end = to_pixels(r, list->spans[i].end);
        int first = (int)begin, last = (int)end;
        if (first == last) {
            sum->partial[first] += end - begin;
            continue;
        }
        sum->partial[first] += first + 1 - begin;
        sum->partial[last] += end - last;
        sum->run[first + 1] += 1.0;
        sum->run[last] -= 1.0;
    }
}

/* Walks all shapes over one scan line and adds it to the sums; false if no shape is met. */
static bool scan_line(raster *r, const skv_shape *shapes, int count, double y)
{
    bool met = false;
    r->solid.count = 0;
    r->air.count = 0;
    for (int i = 0; i < count; i++) {
        r->cut.count = skv_scan_line(&r->scans[i], y, r->cut.spans);
        if (r->cut.count == 0)
            continue;
        met = true;
        unite(shapes[i].carve ? &r->air : &r->solid, &r->cut, &r->scratch);
        subtract(shapes[i].carve ? &r->solid : &r->air, &r->cut, &r->scratch);
    }
    sum_spans(r, &r->solid, &r->solid_sum);
    sum_spans(r, &r->air, &r->air_sum);
    return met;
}

/* Turns the sums of a pixel row into coverage and clears them. */
static void finish_row(raster *r, uint8_t *coverage)
{
    double solid_run = 0.0, air_run = 0.0;
    for (int x = 0; x < r->width; x++) {
        solid_run += r->solid_sum.run[x];
        air_run += r->air_sum.run[x];
        double solid = (solid_run + r->solid_sum.partial[x]) / LINES;
        double air = (air_run + r->air_sum.partial[x]) / LINES;
        double value = 255.0 * solid + coverage[x] * (1.0 - solid - air);
        value = value < 0.0 ? 0.0 : value > 255.0 ? 255.0 : value;
        coverage[x] = (uint8_t)(value + 0.5);
    }
    size_t bytes = ((size_t)r->width + 2) * sizeof(double);
    memset(r->solid_sum.partial, 0, bytes);
    memset(r->solid_sum.run, 0, bytes);
    memset(r->air_sum.partial, 0, bytes);
    memset(r->air_sum.run, 0, bytes);
}

/* Memory for all that a raster needs. */
typedef struct raster_memory {
    skv_scan *scans;
    skv_scan_edge *edges;
    skv_span *spans;
    double *sums;
} raster_memory;

/* Gives every list and every scan its part of the memory. */
static bool allocate(raster *r, const skv_shape *shapes, int count, raster_memory *memory)
{
    size_t row = (size_t)r->width + 2, edges = 0;
    for (int i = 0; i < count; i++)
        edges += (size_t)skv_scan_edges(&shapes[i]);
    size_t spans = edges + 1; /* each span that is added or cut makes at most one more */
    *memory = (raster_memory){
        skv_calloc((size_t)count, sizeof *memory->scans), skv_calloc(edges, sizeof *memory->edges),
        skv_calloc(spans * 4, sizeof *memory->spans), skv_calloc(row * 4, sizeof *memory->sums)};
    if (!memory->scans || !memory->edges || !memory->spans || !memory->sums)
        return false;
    r->scans = memory->scans;
    skv_scan_edge *next = memory->edges;
    for (int i = 0; i < count; i++) {
        skv_scan_begin(&r->scans[i], &shapes[i], next);
        next += skv_scan_edges(&shapes[i]);
    }
    r->solid.spans = memory->spans;
    r->air.spans = memory->spans + spans;
    r->cut.spans = memory->spans + 2 * spans;
    r->scratch.spans = memory->spans + 3 * spans;
    r->solid_sum = (row_sum){memory->sums, memory->sums + row};
    r->air_sum = (row_sum){memory->sums + 2 * row, memory->sums + 3 * row};
    return true;
}

/* The rows of the picture that a shape's pieces go through, if it is a thick line. */
static double count_rows(const skv_shape *shape, int height, double pixel_size)
{
    double rows = 0.0;
    for (int i = 1; shape->kind == SKV_SHAPE_LINE && i < shape->point_count; i++) {
        double from = shape->points[2 * i - 1], to = shape->points[2 * i + 1];
        double low = ((from < to ? from : to) - shape->radius) / pixel_size;
        double high = ((from < to ? to : from) + shape->radius) / pixel_size;
        low = low > 0.0 ? low : 0.0;
        high = high < height ? high : height;
        rows += high > low ? high - low : 0.0;
    }
    return rows;
}

int skv_raster_too_much(const skv_shape *shapes, int count, int height, double pixel_size)
{
    double rows = 0.0;
    for (int i = 0; i < count; i++) {
        rows += count_rows(&shapes[i], height, pixel_size);
        if (rows > SKV_RASTER_MOST_ROWS)
            return i;
    }
    return count;
}

skv_result skv_raster_solids(const skv_shape *shapes, int count, int width, int height,
                             double pixel_size, uint8_t *coverage, skv_error *error)
{
    raster r = {.width = width, .pixel_size = pixel_size};
    raster_memory memory;
    bool ready = allocate(&r, shapes, count, &memory);
    for (int y = 0; ready && y < height; y++) {
        bool met = false;
        for (int i = 0; i < LINES; i++)
            met |= scan_line(&r, shapes, count, (y + (i + 0.5) / LINES) * pixel_size);
        if (met)
            finish_row(&r, coverage + (size_t)y * (size_t)width);
    }
    skv_free(memory.scans);
    skv_free(memory.edges);
    skv_free(memory.spans);
    skv_free(memory.sums);
    return ready ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the walls");
}
