/* Water at the start, and the spacing that makes it hold a wanted number of particles.
 *
 * Invariant: the same water, terrain and spacing give the same particles here and in the world,
 * because both ask skv_water_inside through the same lattice.
 */
#include "scene/water.h"

#include <math.h>

#include "scene/fields.h"
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

/* Whether a point of the surface is given up. Multiples of the golden ratio's fraction spread any
 * share evenly over the columns of a lattice. */
static bool is_thinned(const skv_water *water, float x, float y)
{
    if (water->thinning <= 0.0 || is_fluid(water, x, y + water->surface_step))
        return false;
    double column = floor(2.0 * (double)x / (double)water->surface_step) * 0.6180339887498949;
    return column - floor(column) < water->thinning;
}

bool skv_water_inside(float x, float y, void *user)
{
    const skv_water *water = user;
    return is_fluid(water, x, y) && !is_thinned(water, x, y);
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

/* ---- Spacing --------------------------------------------------------------------------------- */

skv_fill_def skv_water_fill_def(skv_water *water)
{
    skv_fill_def def = skv_default_fill_def();
    def.x0 = water->x0;
    def.y0 = water->y0;
    def.x1 = water->x1;
    def.y1 = water->y1;
    def.inside = skv_water_inside;
    def.user = water;
    return def;
}

int skv_water_count_to(const skv_water *water, const skv_terrain *terrain, float spacing, int most)
{
    skv_water copy = *water; /* the callback's user pointer is not constant */
    skv_fill_def def = skv_water_fill_def(&copy);
    def.limit = most;
    return skv_fill_count(terrain, spacing, &def);
}

static int count_all(const skv_water *water, const skv_terrain *terrain, float spacing)
{
    return skv_water_count_to(water, terrain, spacing, -1);
}

void skv_water_count_range(const skv_water *water, const skv_terrain *terrain, int *fewest,
                           int *most)
{
    const skv_field *spacing = &skv_scene_fields(NULL)[SKV_F_FLUID_SPACING];
    skv_water whole = *water;
    whole.thinning = 0.0;
    float finest = (float)spacing->minimum;
    *fewest = skv_water_count_to(&whole, terrain, (float)spacing->maximum, SKV_MAX_PARTICLES);
    *most = 0;
    for (float probe = 32.0f * finest; probe >= finest && *most < SKV_MAX_PARTICLES; probe *= 0.5f)
        *most = skv_water_count_to(&whole, terrain, probe, SKV_MAX_PARTICLES);
    if (*fewest < 1)
        *fewest = 1;
}

/* Finds a spacing at or above `least` that holds at least `wanted`, starting from `spacing`, which
 * may hold less; false if there is none. Steps by the area that seems to be there. */
static bool shrink_until_enough(const skv_water *water, const skv_terrain *terrain, int wanted,
                                float least, float *spacing, int *count)
{
    while (*count < wanted) {
        if (*spacing <= least)
            return false;
        double factor = *count > 0 ? sqrt((double)*count / wanted) : 0.5;
        *spacing *= (float)(factor < 0.98 ? factor : 0.98);
        if (*spacing < least)
            *spacing = least;
        *count = count_all(water, terrain, *spacing);
    }
    return true;
}

/* Between `low`, which holds enough, and `high`, which does not: keeps the best spacing seen, the
 * widest of equals, in *spacing and *count. */
static void bisect(const skv_water *water, const skv_terrain *terrain, int wanted, float low,
                   float high, float *spacing, int *count)
{
    for (int i = 0; i < 40 && *count != wanted; i++) {
        float middle = 0.5f * (low + high);
        if (middle <= low || middle >= high)
            return;
        int there = count_all(water, terrain, middle);
        if (there < wanted) {
            high = middle;
            continue;
        }
        low = middle;
        if (there <= *count) {
            *count = there;
            *spacing = middle;
        }
    }
}

/* Gives up as much of the surfaces as leaves `wanted`, or a few more. */
static void thin_surface_by(skv_water *water, const skv_terrain *terrain, int wanted, float spacing,
                            float step, int *count)
{
    double enough = 0.0, high = 1.0;
    water->surface_step = step;
    for (int i = 0; i < 20 && *count != wanted; i++) {
        water->thinning = 0.5 * (enough + high);
        int there = count_all(water, terrain, spacing);
        if (there >= wanted) {
            enough = water->thinning;
            *count = there;
        } else {
            high = water->thinning;
        }
    }
    water->thinning = enough;
}

/* The number changes by whole rows at some spacings, so a few too many may remain. Cutting them off
 * the top could take half a droplet; instead every surface gives up some of its particles. A step
 * just below the height of the lattice's rows, 0.93 spacings, finds the highest row alone; just
 * above it, the next one as well, which leaves two ragged rows, but a row that lies lower, too. */
static void thin_surface(skv_water *water, const skv_terrain *terrain, int wanted, float spacing,
                         int *count)
{
    int all = *count;
    thin_surface_by(water, terrain, wanted, spacing, 0.9f * spacing, count);
    if (*count == wanted)
        return;
    water->thinning = 0;
    *count = all;
    thin_surface_by(water, terrain, wanted, spacing, spacing, count);
}

skv_result skv_water_choose_spacing(skv_water *water, const skv_terrain *terrain, int wanted,
                                    float least, float *spacing, int *count)
{
    const float most = (float)skv_scene_fields(NULL)[SKV_F_FLUID_SPACING].maximum;
    double area = ((double)water->x1 - (double)water->x0) * ((double)water->y1 - (double)water->y0);
    float high = (float)sqrt(area / wanted) * 1.1f;
    high = high > most ? most : high < least ? least : high;
    *spacing = high;
    *count = count_all(water, terrain, high);
    while (*count > wanted) {
        if (high >= most)
            return SKV_ERROR_VALUE;
        high = high * 1.2f > most ? most : high * 1.2f;
        *spacing = high;
        *count = count_all(water, terrain, high);
    }
    if (shrink_until_enough(water, terrain, wanted, least, spacing, count)) {
        bisect(water, terrain, wanted, *spacing, high, spacing, count);
        thin_surface(water, terrain, wanted, *spacing, count);
    }
    return SKV_OK;
}
