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

/* What is needed to find areas: the pixels still to be looked at, places from which their rows are
 * to be followed, and of the present area the leftmost and rightmost pixel of each row. */
typedef struct finder {
    const skv_scene *scene;
    uint8_t *paint; /* a copy, from which areas are taken */
    int *stack;
    int depth, room; /* of the stack */
    int *left, *right;
} finder;

static bool push(finder *f, int place)
{
    if (f->depth == f->room) {
        int room = f->room ? 2 * f->room : 1024;
        int *stack = skv_calloc((size_t)room, sizeof *stack);
        if (!stack)
            return false;
        if (f->depth > 0)
            memcpy(stack, f->stack, (size_t)f->depth * sizeof *stack);
        skv_free(f->stack);
        f->stack = stack;
        f->room = room;
    }
    f->stack[f->depth++] = place;
    return true;
}

/* Adds the pixels of row y from `first` to `last`. */
static void take_run(finder *f, skv_tap_area *a, int first, int last, int y)
{
    if (a->count == 0)
        a->lowest = a->highest = y;
    if (a->count == 0 || y > a->highest || y < a->lowest) {
        f->left[y] = first;
        f->right[y] = last;
        a->lowest = y < a->lowest ? y : a->lowest;
        a->highest = y > a->highest ? y : a->highest;
    }
    f->left[y] = first < f->left[y] ? first : f->left[y];
    f->right[y] = last > f->right[y] ? last : f->right[y];
    for (int x = first; x <= last; x++) {
        double cx = x + 0.5, cy = y + 0.5;
        a->count++;
        a->x += cx;
        a->y += cy;
        a->xx += cx * cx;
        a->yy += cy * cy;
        a->xy += cx * cy;
        f->paint[(size_t)y * (size_t)f->scene->width + (size_t)x] = SKV_PAINT_NONE;
    }
}

/* Pushes the first place of each run of a paint that touches row y from `first` to `last`. */
static bool push_runs(finder *f, uint8_t paint, int first, int last, int y)
{
    const uint8_t *row = f->paint + (size_t)y * (size_t)f->scene->width;
    bool room = true;
    for (int x = first; x <= last && room; x++) {
        if (row[x] == paint && (x == first || row[x - 1] != paint))
            room = push(f, y * f->scene->width + x);
    }
    return room;
}

/* Takes the area around a pixel out of the paint, run by run; false if memory is out. */
static bool take_area(finder *f, int place, skv_tap_area *a)
{
    int width = f->scene->width, height = f->scene->height;
    uint8_t paint = f->paint[place];
    *a = (skv_tap_area){.place = place};
    bool room = push(f, place);
    while (room && f->depth > 0) {
        int here = f->stack[--f->depth], y = here / width, first = here % width, last = first;
        const uint8_t *row = f->paint + (size_t)y * (size_t)width;
        if (row[first] != paint)
            continue;
        while (first > 0 && row[first - 1] == paint)
            first--;
        while (last + 1 < width && row[last + 1] == paint)
            last++;
        take_run(f, a, first, last, y);
        if (y > 0)
            room = push_runs(f, paint, first, last, y - 1);
        if (room && y + 1 < height)
            room = push_runs(f, paint, first, last, y + 1);
    }
    return room;
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

static skv_emitter make_emitter(const skv_scene *scene, const skv_tap_area *a)
{
    double n = (double)a->count, x = a->x / n, y = a->y / n;
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
static int find_hull(const finder *f, const skv_tap_area *a, double *points)
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

static skv_drain make_drain(const finder *f, const skv_tap_area *a, double *points)
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

static skv_result find_tap(skv_scene *scene, finder *f, int place, double *points,
                           const char *label, skv_taps *taps, skv_error *error)
{
    bool green = f->paint[place] == SKV_PAINT_EMITTER;
    const int limits[] = {[false] = SKV_MAX_DRAINS, [true] = SKV_MAX_EMITTERS};
    int most = limits[green];
    if ((green ? taps->count : scene->drain_count) == most)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%s: there are more than %d %s areas; paint fewer, or join some", label,
                        most, green ? "green (emitter)" : "red (drain)");
    skv_tap_area a;
    if (!take_area(f, place, &a))
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
    if (green)
        taps->green[taps->count++] = a;
    else
        scene->drains[scene->drain_count++] = make_drain(f, &a, points);
    return SKV_OK;
}

skv_result skv_scene_find_taps(skv_scene *scene, const char *label, skv_taps *taps,
                               skv_error *error)
{
    int pixels = scene->width * scene->height;
    taps->count = 0;
    if (scene->marked[SKV_PAINT_EMITTER] + scene->marked[SKV_PAINT_DRAIN] == 0)
        return SKV_OK;
    finder f = {.scene = scene,
                .paint = skv_malloc((size_t)pixels, 1),
                .left = skv_calloc((size_t)scene->height, sizeof *f.left),
                .right = skv_calloc((size_t)scene->height, sizeof *f.right)};
    double *points = skv_calloc(4 * (size_t)scene->height, 2 * sizeof *points);
    skv_result result = SKV_OK;
    bool made = f.paint && f.left && f.right && points;
    if (!made)
        result = skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
    else
        memcpy(f.paint, scene->paint, (size_t)pixels);
    for (int i = 0; made && i < pixels && result == SKV_OK; i++)
        if (f.paint[i] == SKV_PAINT_EMITTER || f.paint[i] == SKV_PAINT_DRAIN)
            result = find_tap(scene, &f, i, points, label, taps, error);
    skv_free(f.paint);
    skv_free(f.stack);
    skv_free(f.left);
    skv_free(f.right);
    skv_free(points);
    return result;
}

skv_result skv_scene_add_emitters(skv_scene *scene, const skv_taps *taps, const char *label,
                                  skv_error *error)
{
    skv_result result = SKV_OK;
    for (int i = 0; i < taps->count && result == SKV_OK; i++) {
        skv_emitter emitter = make_emitter(scene, &taps->green[i]);
        scene->emitters[scene->emitter_count++] = emitter;
        result = check_width(scene, &emitter, taps->green[i].place, label, error);
    }
    return result;
}
