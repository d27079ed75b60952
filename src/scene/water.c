/* Water at the start: whether there is some at a point, and a box around all of it.
 *
 * Invariant: no point outside of the box is water.
 */
#include "scene/water.h"

#include <math.h>

#include "scene/paint.h"

/* What is painted at a point. */
static int paint_at(const skv_water *water, double x, double y)
{
    int column = (int)floor(x / water->pixel_size), row = (int)floor(y / water->pixel_size);
    if (column < 0 || row < 0 || column >= water->width || row >= water->height)
        return SKV_PAINT_NONE;
    return water->paint[(size_t)row * (size_t)water->width + (size_t)column];
}

static bool is_wet(int paint)
{
    return paint == SKV_PAINT_FLUID || paint == SKV_PAINT_OIL;
}

static bool is_painted(const skv_water *water, double x, double y)
{
    return is_wet(paint_at(water, x, y));
}

bool skv_water_is_oil(const skv_water *water, float x, float y)
{
    return water->paint != NULL && paint_at(water, (double)x, (double)y) == SKV_PAINT_OIL;
}

const skv_shape *skv_water_shape_at(const skv_water *water, float x, float y)
{
    for (int i = water->shape_count - 1; i >= 0; i--) {
        if (skv_shape_contains(&water->shapes[i], (double)x, (double)y))
            return &water->shapes[i];
    }
    return NULL;
}

static bool is_fluid(const skv_water *water, float x, float y)
{
    return (double)y < water->level || skv_water_shape_at(water, x, y) != NULL ||
           (water->paint != NULL && is_painted(water, (double)x, (double)y));
}

bool skv_water_inside(float x, float y, void *user)
{
    return is_fluid(user, x, y);
}

/* ---- Bounds ---------------------------------------------------------------------------------- */

typedef struct box {
    double x0, y0, x1, y1;
} box;

static void extend(box *bounds, double x0, double y0, double x1, double y1)
{
    bounds->x0 = x0 < bounds->x0 ? x0 : bounds->x0;
    bounds->y0 = y0 < bounds->y0 ? y0 : bounds->y0;
    bounds->x1 = x1 > bounds->x1 ? x1 : bounds->x1;
    bounds->y1 = y1 > bounds->y1 ? y1 : bounds->y1;
}

static void extend_by_paint(box *bounds, const skv_water *water)
{
    double size = water->pixel_size;
    for (int row = 0; row < water->height; row++) {
        const uint8_t *paint = water->paint + (size_t)row * (size_t)water->width;
        int first = 0, last = water->width - 1;
        while (first < water->width && !is_wet(paint[first]))
            first++;
        if (first == water->width)
            continue;
        while (!is_wet(paint[last]))
            last--;
        extend(bounds, first * size, row * size, (last + 1) * size, (row + 1) * size);
    }
}

void skv_water_set_bounds(skv_water *water)
{
    double width = water->width * water->pixel_size, height = water->height * water->pixel_size;
    box bounds = {width, height, 0.0, 0.0};
    if (water->level > 0.0)
        extend(&bounds, 0.0, 0.0, width, water->level);
    for (int i = 0; i < water->shape_count; i++) {
        const skv_shape *shape = &water->shapes[i];
        extend(&bounds, shape->x0, shape->y0, shape->x1, shape->y1);
    }
    if (water->paint != NULL)
        extend_by_paint(&bounds, water);
    water->x0 = (float)(bounds.x0 > 0.0 ? bounds.x0 : 0.0);
    water->y0 = (float)(bounds.y0 > 0.0 ? bounds.y0 : 0.0);
    water->x1 = (float)(bounds.x1 < width ? bounds.x1 : width);
    water->y1 = (float)(bounds.y1 < height ? bounds.y1 : height);
}
