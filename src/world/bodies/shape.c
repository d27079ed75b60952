/* From an area to a body's shape. Circles and their ways become polygons of the same area, so that
 * whatever asks for a shape (mass, walls, contacts, pictures) asks the same one. Invariant:
 * outlines run counter-clockwise about their centre of mass. */
#include "world/bodies/shape.h"

#include "base/exact.h"
#include "base/memory.h"
#include "world/bodies/bodies.h"

#include <math.h>
#include <string.h>

enum { ROUND = 48 }; /* corners of a circle: within r/900 of it */

/* Pixels of a shape's picture a spacing: its corners are rounded by less than a tenth of a particle
 * then. */
#define PIXELS_A_SPACING 6

/* Spacings between points of the rim, at least: what they may miss is a corner between two. */
#define RIM_STEP 0.5

#define MOST_REACH 8.0 /* m: the largest terrain is 16 m wide */

static void put_corner(skv_outline *o, double x, double y)
{
    o->corner[o->corners][0] = x;
    o->corner[o->corners++][1] = y;
}

/* An arc from corner number `from` to `to` of a circle's polygon, which has the circle's area,
 * about a point; turned so that the first corner lies in the direction (cx, cy). */
static void put_arc(skv_outline *o, const skv_area *a, double x, double y, int from, int to,
                    double cx, double cy)
{
    double part = 2 * SKV_PI / ROUND, radius = (double)a->radius * sqrt(part / skv_sin(part));
    for (int k = from; k <= to; k++) {
        double c = radius * skv_cos(k * part), s = radius * skv_sin(k * part);
        put_corner(o, x + c * cx - s * cy, y + c * cy + s * cx);
    }
}

static void draw(const skv_area *a, skv_outline *o)
{
    double x0 = (double)a->x0, y0 = (double)a->y0, x1 = (double)a->x1, y1 = (double)a->y1;
    double dx = x1 - x0, dy = y1 - y0, way = sqrt(dx * dx + dy * dy);
    switch (a->kind) {
    case SKV_AREA_CIRCLE:
        put_arc(o, a, x0, y0, 0, ROUND - 1, 1, 0);
        break;
    case SKV_AREA_SWEPT_CIRCLE:
        if (!(way > 0)) {
            put_arc(o, a, x0, y0, 0, ROUND - 1, 1, 0);
            break;
        }
        put_arc(o, a, x0, y0, ROUND / 4, 3 * ROUND / 4, dx / way, dy / way);
        put_arc(o, a, x1, y1, -ROUND / 4, ROUND / 4, dx / way, dy / way);
        break;
    case SKV_AREA_BOX:
        put_corner(o, x0, y0);
        put_corner(o, x1, y0);
        put_corner(o, x1, y1);
        put_corner(o, x0, y1);
        break;
    case SKV_AREA_POLYGON:
        for (int k = 0; k < a->count && k < SKV_MAX_CORNERS; k++)
            put_corner(o, (double)a->corners[2 * k], (double)a->corners[2 * k + 1]);
        break;
    }
}

/* Twice the area of the triangle (a, b, c), above 0 if it runs counter-clockwise. */
static double side_of(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool crosses(const double a[2], const double b[2], const double c[2], const double d[2])
{
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

static bool is_simple(const skv_outline *o)
{
    int n = o->corners;
    for (int i = 0; i < n; i++)
        for (int k = i + 2; k < n; k++)
            if (crosses(o->corner[i], o->corner[i + 1], o->corner[k], o->corner[(k + 1) % n]))
                return false;
    return true;
}

/* The area, above 0 if the corners run counter-clockwise, and its moments. */
static double find_area(const skv_outline *o, double *x, double *y)
{
    double area = 0;
    *x = *y = 0;
    for (int i = 0; i < o->corners; i++) {
        const double *a = o->corner[i], *b = o->corner[(i + 1) % o->corners];
        double cross = a[0] * b[1] - b[0] * a[1];
        area += cross / 2;
        *x += (a[0] + b[0]) * cross / 6;
        *y += (a[1] + b[1]) * cross / 6;
    }
    return area;
}

/* Puts the corners into their order and about their centre of mass. */
static void centre(skv_outline *o)
{
    int n = o->corners;
    double x, y, area = find_area(o, &x, &y);
    for (int i = 0; area < 0 && i < n / 2; i++) {
        double kept[2];
        memcpy(kept, o->corner[i], sizeof kept);
        memcpy(o->corner[i], o->corner[n - 1 - i], sizeof kept);
        memcpy(o->corner[n - 1 - i], kept, sizeof kept);
    }
    o->middle_x = area != 0 ? x / area : 0;
    o->middle_y = area != 0 ? y / area : 0;
    for (int i = 0; i < n; i++) {
        o->corner[i][0] -= o->middle_x;
        o->corner[i][1] -= o->middle_y;
    }
}

void skv_outline_measure(skv_outline *o)
{
    double x, y;
    o->area = find_area(o, &x, &y);
    o->inertia = o->around = o->reach = 0;
    for (int i = 0; i < o->corners; i++) {
        const double *a = o->corner[i], *b = o->corner[(i + 1) % o->corners];
        double cross = a[0] * b[1] - b[0] * a[1], dx = b[0] - a[0], dy = b[1] - a[1];
        double squares = a[0] * a[0] + a[0] * b[0] + b[0] * b[0];
        squares += a[1] * a[1] + a[1] * b[1] + b[1] * b[1];
        o->inertia += cross / 12 * squares;
        o->around += sqrt(dx * dx + dy * dy);
        o->reach = skv_max(sqrt(a[0] * a[0] + a[1] * a[1]), o->reach);
    }
}

static bool is_finite_area(const skv_area *a)
{
    bool finite = skv_within((double)a->x0, -100, 100) && skv_within((double)a->y0, -100, 100) &&
                  skv_within((double)a->x1, -100, 100) && skv_within((double)a->y1, -100, 100) &&
                  skv_within((double)a->radius, 0, 100);
    if (a->kind == SKV_AREA_POLYGON) {
        finite = a->count >= 3 && a->count <= SKV_MAX_CORNERS;
        for (int k = 0; finite && k < 2 * a->count; k++)
            finite = skv_within((double)a->corners[k], -100, 100);
    }
    return finite;
}

skv_result skv_outline_check(const skv_outline *o, float spacing, skv_error *error)
{
    if (!is_simple(o))
        return skv_fail(error, SKV_ERROR_VALUE, "body: the sides of its shape cross each other");
    double least = (double)spacing * (double)spacing;
    if (!(o->area >= least))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its shape has %g m^2; the least is a particle's, %g m^2", o->area,
                        least);
    if (!(o->reach <= MOST_REACH))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its shape reaches %g m from its middle; allowed is %g m", o->reach,
                        MOST_REACH);
    return SKV_OK;
}

skv_result skv_outline_make(const skv_area *area, float spacing, skv_outline *o, skv_error *error)
{
    memset(o, 0, sizeof *o);
    if (!is_finite_area(area))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "body: its shape has numbers beyond 100 m, or a polygon of other than 3 "
                        "to %d corners",
                        SKV_MAX_CORNERS);
    draw(area, o);
    centre(o);
    skv_outline_measure(o);
    return skv_outline_check(o, spacing, error);
}

/* Signed distance of a point from the outline, above 0 outside. */
static double distance_from(const skv_outline *o, double x, double y)
{
    double least = INFINITY;
    bool inside = false;
    for (int i = 0; i < o->corners; i++) {
        const double *a = o->corner[i], *b = o->corner[(i + 1) % o->corners];
        double dx = b[0] - a[0], dy = b[1] - a[1], px = x - a[0], py = y - a[1];
        double square = dx * dx + dy * dy, at = square > 0 ? (px * dx + py * dy) / square : 0;
        at = skv_min(skv_max(at, 0), 1);
        px -= at * dx;
        py -= at * dy;
        least = skv_min(px * px + py * py, least);
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / dy * dx)
            inside = !inside;
    }
    return inside ? -sqrt(least) : sqrt(least);
}

/* The picture: grey by the distance from the outline, so that between two pixel centres the wall
 * lies where the outline does. */
static void paint(const skv_body_shape *shape, const skv_terrain_def *def, uint8_t *coverage)
{
    double pixel = (double)def->pixel_size;
    for (int j = 0; j < def->height; j++) {
        for (int i = 0; i < def->width; i++) {
            double x = (i + 0.5) * pixel - (double)shape->middle_x;
            double y = (j + 0.5) * pixel - (double)shape->middle_y;
            double solid = 0.5 - distance_from(&shape->outline, x, y) / (2 * pixel);
            solid = skv_min(skv_max(solid, 0), 1);
            coverage[(size_t)j * (size_t)def->width + (size_t)i] = (uint8_t)(255 * solid + 0.5);
        }
    }
}

static skv_result make_terrain(skv_body_shape *shape, const skv_world *world, skv_error *error)
{
    const skv_outline *o = &shape->outline;
    double low_x = 0, low_y = 0, high_x = 0, high_y = 0;
    for (int i = 0; i < o->corners; i++) {
        low_x = skv_min(o->corner[i][0], low_x);
        low_y = skv_min(o->corner[i][1], low_y);
        high_x = skv_max(o->corner[i][0], high_x);
        high_y = skv_max(o->corner[i][1], high_y);
    }
    skv_terrain_def def = skv_default_terrain_def();
    def.pixel_size = world->fluid.spacing / PIXELS_A_SPACING;
    double pixel = (double)def.pixel_size, margin = (double)world->h + 2 * pixel;
    double width = ceil((high_x - low_x + 2 * margin) / pixel);
    double height = ceil((high_y - low_y + 2 * margin) / pixel);
    if (!(width <= SKV_TERRAIN_MAX_PIXELS && height <= SKV_TERRAIN_MAX_PIXELS))
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "body: it is too large for a spacing of %g m; use a larger spacing",
                        (double)world->fluid.spacing);
    def.width = (int)width;
    def.height = (int)height;
    def.open_sides = SKV_SIDE_LEFT | SKV_SIDE_RIGHT | SKV_SIDE_BOTTOM | SKV_SIDE_TOP;
    shape->middle_x = (float)(margin - low_x);
    shape->middle_y = (float)(margin - low_y);
    uint8_t *coverage = skv_calloc((size_t)def.width * (size_t)def.height, 1);
    if (!coverage)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a body");
    paint(shape, &def, coverage);
    def.coverage = coverage;
    skv_result result = skv_terrain_create(&def, &shape->terrain, error);
    skv_free(coverage);
    return result;
}

static void place_rim(skv_body_shape *shape, double spacing)
{
    const skv_outline *o = &shape->outline;
    double room = SKV_MOST_RIM - o->corners, step = skv_max(RIM_STEP * spacing, o->around / room);
    for (int i = 0; i < o->corners; i++) {
        const double *a = o->corner[i], *b = o->corner[(i + 1) % o->corners];
        double dx = b[0] - a[0], dy = b[1] - a[1];
        int parts = (int)ceil(sqrt(dx * dx + dy * dy) / step);
        for (int k = 0; k < parts && shape->rims < SKV_MOST_RIM; k++, shape->rims++) {
            shape->rim[shape->rims][0] = (float)(a[0] + dx * k / parts);
            shape->rim[shape->rims][1] = (float)(a[1] + dy * k / parts);
        }
    }
}

/* Gives a shape that has a picture the walls of another with the same: places round the outlines of
 * equal shapes differently, but hardly any pixel. One map is still in the cache where several are
 * not. Returns whether there is one. */
static bool borrow_walls(skv_body_shape *shape, const skv_bodies *others)
{
    for (int k = 0; others && k < others->count; k++) {
        skv_body_shape *had = others->body[k].shape;
        if (had->terrain->hash != shape->terrain->hash)
            continue;
        skv_terrain_destroy(shape->terrain);
        had->owners++;
        shape->lender = had;
        shape->terrain = had->terrain;
        shape->walls = had->walls;
        return true;
    }
    return false;
}

static skv_result make_walls(skv_body_shape *shape, const skv_world *world, skv_error *error)
{
    skv_result result =
        skv_wall_map_create(shape->terrain, world->h, world->fluid.spacing,
                            skv_law_kernel(world->fluid.law), world->pool, &shape->walls, error);
    if (result == SKV_OK && skv_has_images(&world->fluid))
        result = skv_wall_map_add_images(shape->walls, shape->terrain, world->pool, error);
    return result;
}

skv_result skv_body_shape_create(const skv_world *world, const skv_bodies *others,
                                 const skv_outline *outline, skv_body_shape **out, skv_error *error)
{
    skv_body_shape *shape = skv_calloc(1, sizeof *shape);
    *out = NULL;
    if (!shape)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a body");
    shape->owners = 1;
    shape->outline = *outline;
    skv_result result = make_terrain(shape, world, error);
    if (result == SKV_OK && !borrow_walls(shape, others))
        result = make_walls(shape, world, error);
    if (result != SKV_OK) {
        skv_body_shape_destroy(shape);
        return result;
    }
    const skv_boundary *fixed = &world->boundary;
    shape->boundary = (skv_boundary){
        .terrain = shape->terrain,
        .walls = shape->walls,
        .margin = skv_minf(fixed->margin, 0.5f * skv_terrain_pixel_size(shape->terrain)),
        .contact_distance = fixed->contact_distance,
        .unit = 1,
        .per_unit = 1,
    };
    place_rim(shape, (double)world->fluid.spacing);
    *out = shape;
    return SKV_OK;
}

void skv_body_shape_destroy(skv_body_shape *shape)
{
    if (!shape || --shape->owners > 0)
        return;
    if (shape->lender) {
        skv_body_shape_destroy(shape->lender);
    } else {
        skv_wall_map_destroy(shape->walls);
        skv_terrain_destroy(shape->terrain);
    }
    skv_free(shape);
}
