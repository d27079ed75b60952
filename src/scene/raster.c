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

#define LINES 16

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
    span_list solid, air, cut, scratch;
    row_sum solid_sum, air_sum;
} raster;

/* target := target united with `cut`. */
static void unite(span_list *target, const span_list *cut, span_list *scratch)
{
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
        r->cut.count = skv_shape_spans(&shapes[i], y, r->cut.spans);
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

/* Gives every list its part of two blocks of memory. */
static bool allocate(raster *r, int spans, skv_span **span_memory, double **sum_memory)
{
    size_t row = (size_t)r->width + 2;
    *span_memory = skv_calloc((size_t)spans * 4, sizeof **span_memory);
    *sum_memory = skv_calloc(row * 4, sizeof **sum_memory);
    if (*span_memory == NULL || *sum_memory == NULL)
        return false;
    r->solid.spans = *span_memory;
    r->air.spans = *span_memory + spans;
    r->cut.spans = *span_memory + 2 * (size_t)spans;
    r->scratch.spans = *span_memory + 3 * (size_t)spans;
    r->solid_sum = (row_sum){*sum_memory, *sum_memory + row};
    r->air_sum = (row_sum){*sum_memory + 2 * row, *sum_memory + 3 * row};
    return true;
}

skv_result skv_raster_solids(const skv_shape *shapes, int count, int width, int height,
                             double pixel_size, uint8_t *coverage, skv_error *error)
{
    raster r = {.width = width, .pixel_size = pixel_size};
    skv_span *span_memory = NULL;
    double *sum_memory = NULL;
    int spans = 1; /* each span that is added or cut makes at most one more */
    for (int i = 0; i < count; i++)
        spans += skv_shape_max_spans(&shapes[i]);
    bool ready = allocate(&r, spans, &span_memory, &sum_memory);
    for (int y = 0; ready && y < height; y++) {
        bool met = false;
        for (int i = 0; i < LINES; i++)
            met |= scan_line(&r, shapes, count, (y + (i + 0.5) / LINES) * pixel_size);
        if (met)
            finish_row(&r, coverage + (size_t)y * (size_t)width);
    }
    skv_free(span_memory);
    skv_free(sum_memory);
    return ready ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the walls");
}
