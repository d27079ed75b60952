/* Analytic shapes for the terrain tests. */
#include "shapes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

static double disc_distance(const shape *s, double x, double y)
{
    return hypot(x - s->x, y - s->y) - s->radius;
}

static double bowl_distance(const shape *s, double x, double y)
{
    return s->radius - hypot(x - s->x, y - s->y);
}

static double wall_distance(const shape *s, double x, double y)
{
    return (x - s->x) * s->nx + (y - s->y) * s->ny;
}

shape disc_shape(const char *name, double x, double y, double radius)
{
    return (shape){name, disc_distance, x, y, radius, 0, 0};
}

shape bowl_shape(const char *name, double x, double y, double radius)
{
    return (shape){name, bowl_distance, x, y, radius, 0, 0};
}

shape wall_shape(const char *name, double x, double y, double degrees)
{
    double angle = degrees * acos(-1.0) / 180;
    return (shape){name, wall_distance, x, y, 0, -sin(angle), cos(angle)};
}

double shape_distance(const shape *s, double x, double y)
{
    return s->distance(s, x, y);
}

void shape_normal(const shape *s, double x, double y, double *nx, double *ny)
{
    const double e = 1e-4;
    double dx = shape_distance(s, x + e, y) - shape_distance(s, x - e, y);
    double dy = shape_distance(s, x, y + e) - shape_distance(s, x, y - e);
    double length = hypot(dx, dy);
    *nx = dx / length;
    *ny = dy / length;
}

static double solid_share(const shape *s, double x, double y)
{
    const int points = 16;
    double middle = shape_distance(s, x + 0.5, y + 0.5);
    if (fabs(middle) > 1)
        return middle < 0;
    int solid = 0;
    for (int j = 0; j < points; j++) {
        for (int i = 0; i < points; i++)
            solid += shape_distance(s, x + (i + 0.5) / points, y + (j + 0.5) / points) < 0;
    }
    return (double)solid / (points * points);
}

void paint_shape(const shape *s, int width, int height, bool grey, uint8_t *coverage)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            double share =
                grey ? solid_share(s, x, y) : (double)(shape_distance(s, x + 0.5, y + 0.5) < 0);
            coverage[(size_t)y * (size_t)width + (size_t)x] = (uint8_t)(255 * share + 0.5);
        }
    }
}

skv_terrain *make_terrain(int width, int height, const uint8_t *coverage, float pixel_size,
                          unsigned open_sides)
{
    skv_terrain_def def = skv_default_terrain_def();
    def.width = width;
    def.height = height;
    def.coverage = coverage;
    def.pixel_size = pixel_size;
    def.open_sides = open_sides;
    skv_terrain *terrain = NULL;
    skv_error error = {0};
    if (skv_terrain_create(&def, &terrain, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_non_null(terrain);
    return terrain;
}

double roll(dice *d)
{
    d->state = d->state * 6364136223846793005u + 1442695040888963407u;
    return (double)(d->state >> 11) / 9007199254740992.0;
}

skv_wall_map *make_image_map(const skv_terrain *terrain, float radius)
{
    skv_wall_map *map;
    assert_int_equal(
        skv_wall_map_create(terrain, radius, radius / 3, SKV_KERNEL_SMOOTH, NULL, &map, NULL),
        SKV_OK);
    assert_int_equal(skv_wall_map_shade(map, terrain, NULL, NULL), SKV_OK);
    assert_int_equal(skv_wall_map_add_images(map, terrain, NULL, NULL), SKV_OK);
    return map;
}
