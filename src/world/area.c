/* Areas: circle, swept circle, box and polygon, and the particles that lie in one. Invariant: an
 * area that is not finite, or a circle of negative radius, contains nothing. */
#include "world/area.h"

#include "base/assert.h"
#include "base/exact.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

skv_area skv_circle(float x, float y, float radius)
{
    return (skv_area){.kind = SKV_AREA_CIRCLE, .x0 = x, .y0 = y, .radius = radius};
}

skv_area skv_swept_circle(float x0, float y0, float x1, float y1, float radius)
{
    return (skv_area){
        .kind = SKV_AREA_SWEPT_CIRCLE, .x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1, .radius = radius};
}

skv_area skv_box(float x0, float y0, float x1, float y1)
{
    return (skv_area){.kind = SKV_AREA_BOX, .x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1};
}

skv_area skv_polygon(const float *corners, int count)
{
    skv_area area = {.kind = SKV_AREA_POLYGON};
    if (!corners || count < 3 || count > SKV_MAX_CORNERS)
        return area;
    area.count = count;
    memcpy(area.corners, corners, 2 * (size_t)count * sizeof *corners);
    return area;
}

bool skv_area_is_sane(const skv_area *a)
{
    const float numbers[] = {a->x0, a->y0, a->x1, a->y1, a->radius};
    for (int i = 0; i < 5; i++)
        if (!isfinite(numbers[i]))
            return false;
    if (a->kind != SKV_AREA_POLYGON)
        return a->kind == SKV_AREA_BOX ||
               ((a->kind == SKV_AREA_CIRCLE || a->kind == SKV_AREA_SWEPT_CIRCLE) && a->radius >= 0);
    if (a->count < 3 || a->count > SKV_MAX_CORNERS)
        return false;
    for (int i = 0; i < 2 * a->count; i++)
        if (!isfinite(a->corners[i]))
            return false;
    return true;
}

skv_region skv_area_region(const skv_area *a)
{
    if (!skv_area_is_sane(a))
        return (skv_region){.x0 = 1, .x1 = 0};
    if (a->kind == SKV_AREA_CIRCLE)
        return (skv_region){.x0 = a->x0 - a->radius,
                            .y0 = a->y0 - a->radius,
                            .x1 = a->x0 + a->radius,
                            .y1 = a->y0 + a->radius,
                            .x = a->x0,
                            .y = a->y0,
                            .radius = a->radius};
    if (a->kind == SKV_AREA_SWEPT_CIRCLE)
        return (skv_region){.x0 = skv_minf(a->x0, a->x1) - a->radius,
                            .y0 = skv_minf(a->y0, a->y1) - a->radius,
                            .x1 = skv_maxf(a->x0, a->x1) + a->radius,
                            .y1 = skv_maxf(a->y0, a->y1) + a->radius,
                            .x = a->x0,
                            .y = a->y0,
                            .radius = a->radius,
                            .way_x = a->x1 - a->x0,
                            .way_y = a->y1 - a->y0};
    if (a->kind == SKV_AREA_BOX)
        return (skv_region){.x0 = skv_minf(a->x0, a->x1),
                            .y0 = skv_minf(a->y0, a->y1),
                            .x1 = skv_maxf(a->x0, a->x1),
                            .y1 = skv_maxf(a->y0, a->y1),
                            .radius = -1};
    const float *c = a->corners;
    skv_region r = {.x0 = c[0],
                    .y0 = c[1],
                    .x1 = c[0],
                    .y1 = c[1],
                    .radius = -1,
                    .corners = c,
                    .count = a->count};
    for (int i = 1; i < a->count; i++) {
        r.x0 = skv_minf(r.x0, c[2 * i]);
        r.y0 = skv_minf(r.y0, c[2 * i + 1]);
        r.x1 = skv_maxf(r.x1, c[2 * i]);
        r.y1 = skv_maxf(r.y1, c[2 * i + 1]);
    }
    return r;
}

static inline bool is_in_box(const skv_region *r, float x, float y)
{
    return (x >= r->x0) & (x <= r->x1) & (y >= r->y0) & (y <= r->y1);
}

/* Whether any of some particles is in the box: a loop without a branch, several at once. */
static bool is_any_in_box(const skv_state *state, const skv_region *box, int from, int to)
{
    const float *x = state->x, *y = state->y;
    const skv_region r = *box;
    int found = 0;
    for (int i = from; i < to; i++)
        found |= is_in_box(&r, x[i], y[i]);
    return found;
}

int skv_next_in_box(const skv_state *state, const skv_region *box, int from)
{
    enum { BLOCK = 64 };
    for (int i = from, end; i < state->count; i = end) {
        end = (i / BLOCK + 1) * BLOCK;
        end = end < state->count ? end : state->count;
        if (i % BLOCK == 0 && !is_any_in_box(state, box, i, end))
            continue;
        for (; i < end; i++)
            if (is_in_box(box, state->x[i], state->y[i]))
                return i;
    }
    return state->count;
}

int skv_next_in_region(const skv_state *state, const skv_region *region, int from)
{
    int i = skv_next_in_box(state, region, from);
    while (i < state->count && !skv_region_cut(region, state->x[i], state->y[i]))
        i = skv_next_in_box(state, region, i + 1);
    return i;
}

void skv_exchange_area(skv_port *port, skv_area *a)
{
    uint64_t kind = (uint64_t)a->kind;
    float *const numbers[] = {&a->x0, &a->y0, &a->x1, &a->y1, &a->radius};
    skv_exchange(port, &kind, 1);
    a->kind = (skv_area_kind)kind;
    for (int i = 0; i < 5; i++)
        skv_exchange_float(port, numbers[i]);
    skv_exchange_count(port, &a->count, SKV_MAX_CORNERS);
    for (int i = 0; i < 2 * a->count; i++)
        skv_exchange_float(port, &a->corners[i]);
}

int skv_world_query(const skv_world *world, const skv_area *area, int *indices, int capacity)
{
    SKV_ASSERT_OR(world && area && (indices || capacity <= 0), 0);
    const skv_state *s = &world->state;
    skv_region region = skv_area_region(area);
    int found = 0;
    for (int i = skv_next_in_region(s, &region, 0); i < s->count;
         i = skv_next_in_region(s, &region, i + 1)) {
        if (found < capacity)
            indices[found] = i;
        found++;
    }
    return found;
}
