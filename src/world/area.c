/* Areas: circle, box and polygon, and the particles that lie in one. Invariant: an area that is not
 * finite, or a circle of negative radius, contains nothing. */
#include "world/area.h"

#include "base/assert.h"
#include "base/exact.h"
#include "world/world_internal.h"

#include <math.h>

skv_area skv_circle(float x, float y, float radius)
{
    return (skv_area){.kind = SKV_AREA_CIRCLE, .x0 = x, .y0 = y, .radius = radius};
}

skv_area skv_box(float x0, float y0, float x1, float y1)
{
    return (skv_area){.kind = SKV_AREA_BOX, .x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1};
}

skv_area skv_polygon(const float *points, int count)
{
    return (skv_area){.kind = SKV_AREA_POLYGON, .points = points, .count = count};
}

static bool is_sane(const skv_area *a)
{
    const float numbers[] = {a->x0, a->y0, a->x1, a->y1, a->radius};
    for (int i = 0; i < 5; i++)
        if (!isfinite(numbers[i]))
            return false;
    if (a->kind != SKV_AREA_POLYGON)
        return a->kind == SKV_AREA_BOX || (a->kind == SKV_AREA_CIRCLE && a->radius >= 0);
    if (!a->points || a->count < 3)
        return false;
    for (int i = 0; i < a->count; i++)
        if (!isfinite(a->points[2 * i]) || !isfinite(a->points[2 * i + 1]))
            return false;
    return true;
}

skv_bounds skv_area_bounds(const skv_area *a)
{
    if (!is_sane(a))
        return (skv_bounds){a, 1, 1, 0, 0};
    if (a->kind == SKV_AREA_CIRCLE)
        return (skv_bounds){a, a->x0 - a->radius, a->y0 - a->radius, a->x0 + a->radius,
                            a->y0 + a->radius};
    if (a->kind == SKV_AREA_BOX)
        return (skv_bounds){a, skv_minf(a->x0, a->x1), skv_minf(a->y0, a->y1),
                            skv_maxf(a->x0, a->x1), skv_maxf(a->y0, a->y1)};
    skv_bounds bounds = {a, a->points[0], a->points[1], a->points[0], a->points[1]};
    for (int i = 1; i < a->count; i++) {
        bounds.x0 = skv_minf(bounds.x0, a->points[2 * i]);
        bounds.y0 = skv_minf(bounds.y0, a->points[2 * i + 1]);
        bounds.x1 = skv_maxf(bounds.x1, a->points[2 * i]);
        bounds.y1 = skv_maxf(bounds.y1, a->points[2 * i + 1]);
    }
    return bounds;
}

/* Even-odd: whether a ray to the right of the point crosses an odd number of sides. */
static bool is_in_polygon(const skv_area *a, double x, double y)
{
    bool inside = false;
    for (int i = 0, before = a->count - 1; i < a->count; before = i++) {
        double ax = (double)a->points[2 * before], ay = (double)a->points[2 * before + 1];
        double bx = (double)a->points[2 * i], by = (double)a->points[2 * i + 1];
        if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax))
            inside = !inside;
    }
    return inside;
}

bool skv_is_within(const skv_bounds *bounds, float x, float y)
{
    if (!(x >= bounds->x0 && x <= bounds->x1 && y >= bounds->y0 && y <= bounds->y1))
        return false;
    const skv_area *a = bounds->area;
    if (a->kind == SKV_AREA_BOX)
        return true;
    if (a->kind == SKV_AREA_POLYGON)
        return is_in_polygon(a, (double)x, (double)y);
    float dx = x - a->x0, dy = y - a->y0;
    return dx * dx + dy * dy <= a->radius * a->radius;
}

int skv_world_query(const skv_world *world, const skv_area *area, int *indices, int capacity)
{
    SKV_ASSERT_OR(world && area && (indices || capacity <= 0), 0);
    const skv_state *s = &world->state;
    skv_bounds bounds = skv_area_bounds(area);
    int found = 0;
    for (int i = 0; i < s->count; i++) {
        if (!skv_is_within(&bounds, s->x[i], s->y[i]))
            continue;
        if (found < capacity)
            indices[found] = i;
        found++;
    }
    return found;
}
