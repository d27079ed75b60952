/* Circles and polygons. Invariant: an answer depends on the point and the region alone, so equal
 * points are in or out on every machine. */
#include "base/region.h"

static bool is_in_polygon(const skv_region *r, double x, double y)
{
    bool inside = false;
    for (int i = 0, before = r->count - 1; i < r->count; before = i++) {
        double ax = (double)r->corners[2 * before], ay = (double)r->corners[2 * before + 1];
        double bx = (double)r->corners[2 * i], by = (double)r->corners[2 * i + 1];
        if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax))
            inside = !inside;
    }
    return inside;
}

bool skv_region_cut(const skv_region *r, float x, float y)
{
    if (r->count > 0)
        return is_in_polygon(r, (double)x, (double)y);
    if (r->radius < 0)
        return true;
    float dx = x - r->x, dy = y - r->y;
    float along = dx * r->way_x + dy * r->way_y;
    if (along > 0) {
        /* A way so short that its square is none ends where it begins. */
        float square = r->way_x * r->way_x + r->way_y * r->way_y;
        float share = along < square ? along / square : 1;
        dx -= share * r->way_x;
        dy -= share * r->way_y;
    }
    return dx * dx + dy * dy <= r->radius * r->radius;
}
