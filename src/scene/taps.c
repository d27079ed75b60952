/* Painted taps: areas of one colour to emitters and drains.
 *
 * An area is what is connected over sides of pixels. A green one emits across its longer axis: it
 * is taken for a strip with the same centre and the same second moments. It emits to where there is
 * more room, downwards where that does not tell, and a dot emits downwards. A red one drains its
 * convex hull. Invariant: every painted pixel belongs to exactly one area.
 */
#include "scene/taps.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "skvalp/acting.h"
#include "world/emitters.h"

#define PAINTED_SPEED 1.0f /* m/s */
#define MOST_ROUND    1.5  /* length over thickness: less is a dot */
#define SAME_ROOM     3.0  /* pixels: a difference that does not tell */

/* One area. */
typedef struct area {
    int count;           /* pixels */
    double x, y;         /* sums of their centres, pixels */
    double xx, yy, xy;   /* ... and of the products */
    int lowest, highest; /* rows */
} area;

/* What is needed to find areas: the pixels still to be looked at, and of the present area the
 * leftmost and rightmost pixel of each row. */
typedef struct finder {
    const skv_scene *scene;
    uint8_t *paint; /* a copy, from which areas are taken */
    int *stack;
    int *left, *right;
} finder;

static void take_pixel(finder *f, area *a, int place)
{
    int x = place % f->scene->width, y = place / f->scene->width;
    double cx = x + 0.5, cy = y + 0.5;
    if (a->count == 0 || y > a->highest) {
        f->left[y] = f->right[y] = x;
        a->highest = y;
        if (a->count == 0)
            a->lowest = y;
    } else if (y < a->lowest) {
        f->left[y] = f->right[y] = x;
        a->lowest = y;
    }
    f->left[y] = x < f->left[y] ? x : f->left[y];
    f->right[y] = x > f->right[y] ? x : f->right[y];
    a->count++;
    a->x += cx;
    a->y += cy;
    a->xx += cx * cx;
    a->yy += cy * cy;
    a->xy += cx * cy;
}

/* Takes the area around a pixel out of the paint. Each pixel is put onto the stack once. */
static area take_area(finder *f, int place)
{
    area a = {0};
    int width = f->scene->width, height = f->scene->height, depth = 0;
    uint8_t paint = f->paint[place];
    f->paint[place] = SKV_PAINT_NONE;
    f->stack[depth++] = place;
    while (depth > 0) {
        int here = f->stack[--depth], x = here % width, y = here / width;
        take_pixel(f, &a, here);
        const int beside[4] = {x > 0 ? here - 1 : -1, x + 1 < width ? here + 1 : -1,
                               y > 0 ? here - width : -1, y + 1 < height ? here + width : -1};
        for (int k = 0; k < 4; k++) {
            if (beside[k] < 0 || f->paint[beside[k]] != paint)
                continue;
            f->paint[beside[k]] = SKV_PAINT_NONE;
            f->stack[depth++] = beside[k];
        }
    }
    return a;
}

/* ---- Emitters -------------------------------------------------------------------------------- */

/* How far it is from a point to a wall, in a direction; pixels. */
static double room(const skv_scene *scene, double x, double y, double dx, double dy)
{
    double pixel = scene->pixel_size, way = 0;
    while (way < scene->width + scene->height &&
           skv_terrain_distance(scene->terrain, (float)((x + way * dx) * pixel),
                                (float)((y + way * dy) * pixel)) > 0)
        way += 1;
    return way;
}

static skv_emitter make_emitter(const skv_scene *scene, const area *a)
{
    double n = a->count, x = a->x / n, y = a->y / n;
    /* Central second moments; that of a pixel itself is 1/12. */
    double xx = a->xx / n - x * x + 1.0 / 12, yy = a->yy / n - y * y + 1.0 / 12;
    double xy = a->xy / n - x * y;
    double mean = 0.5 * (xx + yy), split = sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    double longer = mean + split, shorter = mean - split;
    double gx = (double)scene->def.gravity_x, gy = (double)scene->def.gravity_y;
    double weight = sqrt(gx * gx + gy * gy);
    double dx = weight > 0 ? gx / weight : 0, dy = weight > 0 ? gy / weight : -1;
    if (longer > MOST_ROUND * MOST_ROUND * shorter) {
        /* Across the axis (xy, longer - xx) or (longer - yy, xy), whichever is larger. */
        double ax = xx > yy ? longer - yy : xy, ay = xx > yy ? xy : longer - xx;
        double length = sqrt(ax * ax + ay * ay), nx = -ay / length, ny = ax / length;
        double ahead = room(scene, x, y, nx, ny), behind = room(scene, x, y, -nx, -ny);
        bool turn = fabs(ahead - behind) > SAME_ROOM ? ahead < behind : nx * dx + ny * dy < 0;
        dx = turn ? -nx : nx;
        dy = turn ? -ny : ny;
    }
    double pixel = scene->pixel_size;
    return (skv_emitter){.x = (float)(x * pixel),
                         .y = (float)(y * pixel),
                         .vx = PAINTED_SPEED * (float)dx,
                         .vy = PAINTED_SPEED * (float)dy,
                         .width = (float)(sqrt(12 * longer) * pixel)};
}

/* ---- Drains ---------------------------------------------------------------------------------- */

/* Twice the area of the triangle a, b, c; positive if it turns left. */
static double turn_of(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

/* Adds a point to a chain that turns left only, of `count` points from `first` on. */
static int add_to_chain(double *points, int first, int count, double x, double y)
{
    const double point[2] = {x, y};
    while (count - first >= 2 &&
           turn_of(points + 2 * (count - 2), points + 2 * (count - 1), point) <= 0)
        count--;
    points[2 * count] = x;
    points[2 * count + 1] = y;
    return count + 1;
}

/* The hull of the rows' ends: up along the right side, down along the left one. */
static int find_hull(const finder *f, const area *a, double *points)
{
    int count = 0, first;
    for (int y = a->lowest; y <= a->highest; y++) {
        count = add_to_chain(points, 0, count, f->right[y] + 1, y);
        count = add_to_chain(points, 0, count, f->right[y] + 1, y + 1);
    }
    first = count;
    for (int y = a->highest; y >= a->lowest; y--) {
        count = add_to_chain(points, first, count, f->left[y], y + 1);
        count = add_to_chain(points, first, count, f->left[y], y);
    }
    return count;
}

/* Leaves out the corner that matters least. */
static int drop_corner(double *points, int count)
{
    int least = 0;
    double least_area = INFINITY;
    for (int i = 0; i < count; i++) {
        int before = (i + count - 1) % count, after = (i + 1) % count;
        double size = fabs(turn_of(points + 2 * before, points + 2 * i, points + 2 * after));
        if (size < least_area) {
            least_area = size;
            least = i;
        }
    }
    memmove(points + 2 * least, points + 2 * least + 2,
            2 * (size_t)(count - least - 1) * sizeof *points);
    return count - 1;
}

static skv_drain make_drain(const finder *f, const area *a, double *points)
{
    int count = find_hull(f, a, points);
    while (count > SKV_MAX_CORNERS)
        count = drop_corner(points, count);
    float corners[2 * SKV_MAX_CORNERS];
    for (int i = 0; i < 2 * count; i++)
        corners[i] = (float)(points[i] * f->scene->pixel_size);
    return (skv_drain){.area = skv_polygon(corners, count)};
}

/* ---- All of them ----------------------------------------------------------------------------- */

/* Names the area's first pixel as painters count them, from the top left. */
static skv_result check_width(const skv_scene *scene, const skv_emitter *e, int place,
                              const char *label, skv_error *error)
{
    char wide[160];
    if (!skv_emitter_is_wide(e, scene->def.fluid.spacing, wide, sizeof wide))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE, "%s: the green area at pixel (%d, %d) %s", label,
                    place % scene->width, scene->height - 1 - place / scene->width, wide);
}

static skv_result add_tap(skv_scene *scene, finder *f, int place, double *points, const char *label,
                          skv_error *error)
{
    bool green = f->paint[place] == SKV_PAINT_EMITTER;
    area a = take_area(f, place);
    const int limits[] = {SKV_MAX_DRAINS, SKV_MAX_EMITTERS};
    int most = limits[green];
    int *count = green ? &scene->emitter_count : &scene->drain_count;
    if (*count == most)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%s: there are more than %d %s areas; paint fewer, or join some", label,
                        most, green ? "green (emitter)" : "red (drain)");
    if (!green) {
        scene->drains[(*count)++] = make_drain(f, &a, points);
        return SKV_OK;
    }
    skv_emitter emitter = make_emitter(scene, &a);
    scene->emitters[(*count)++] = emitter;
    return check_width(scene, &emitter, place, label, error);
}

skv_result skv_scene_build_taps(skv_scene *scene, const char *label, skv_error *error)
{
    int pixels = scene->width * scene->height;
    if (scene->marked[SKV_PAINT_EMITTER] + scene->marked[SKV_PAINT_DRAIN] == 0)
        return SKV_OK;
    finder f = {.scene = scene,
                .paint = skv_calloc((size_t)pixels, 1),
                .stack = skv_calloc((size_t)pixels, sizeof *f.stack),
                .left = skv_calloc((size_t)scene->height, sizeof *f.left),
                .right = skv_calloc((size_t)scene->height, sizeof *f.right)};
    double *points = skv_calloc(4 * (size_t)scene->height, 2 * sizeof *points);
    skv_result result = SKV_OK;
    bool made = f.paint && f.stack && f.left && f.right && points;
    if (!made)
        result = skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
    else
        memcpy(f.paint, scene->paint, (size_t)pixels);
    for (int i = 0; made && i < pixels && result == SKV_OK; i++)
        if (f.paint[i] == SKV_PAINT_EMITTER || f.paint[i] == SKV_PAINT_DRAIN)
            result = add_tap(scene, &f, i, points, label, error);
    skv_free(f.paint);
    skv_free(f.stack);
    skv_free(f.left);
    skv_free(f.right);
    skv_free(points);
    return result;
}
