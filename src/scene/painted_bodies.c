/* Painted bodies: each connected brown area becomes a body of wood.
 *
 * The border of an area runs along sides of pixels, counter-clockwise. Of its corners those are
 * kept between which no other lies farther than a pixel from the straight way, the farthest first,
 * and 64 at most; then the outline is scaled about its middle to the area that was painted. Holes
 * are filled: a body is one polygon. Invariant: every brown pixel belongs to one border.
 */
#include "scene/painted_bodies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "scene/notes.h"
#include "world/bodies/shape.h"

/* Pixels: a slanting border's corners lie within one of each other's line. */
#define TOLERANCE 1.0

typedef struct corner {
    int x, y;
} corner;

/* The border of one area: the corners at which it turns. */
typedef struct border {
    skv_scene *scene;
    corner *list;
    int count, room;
    int64_t pixels; /* within it */
    int specks;     /* areas so far that are smaller than a particle */
} border;

static bool is_brown(const border *b, int x, int y)
{
    const skv_scene *s = b->scene;
    return x >= 0 && y >= 0 && x < s->width && y < s->height &&
           s->paint[(size_t)y * (size_t)s->width + (size_t)x] == SKV_PAINT_BODY;
}

static bool add_corner(border *b, corner c)
{
    if (b->count == b->room) {
        int room = b->room ? 2 * b->room : 256;
        corner *list = skv_calloc((size_t)room, sizeof *list);
        if (!list)
            return false;
        if (b->count > 0)
            memcpy(list, b->list, (size_t)b->count * sizeof *list);
        skv_free(b->list);
        b->list = list;
        b->room = room;
    }
    b->list[b->count++] = c;
    return true;
}

/* Follows the border from the upper left corner of the area's first pixel, with the area on the
 * left, which is what is connected over sides. False: memory is out. */
static bool follow(border *b, int x, int y)
{
    /* Eastwards, north, west, south; the pixels ahead on the left and on the right lie so from the
     * corner. */
    enum { SOUTH = 3 };
    static const int way[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    static const int left[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    const corner start = {x, ++y};
    int heading = SOUTH;
    b->count = 0;
    do {
        x += way[heading][0];
        y += way[heading][1];
        const int *near = left[heading], *far = left[(heading + 3) % 4];
        int turn = !is_brown(b, x + near[0], y + near[1]) ? 1
                   : is_brown(b, x + far[0], y + far[1])  ? 3
                                                          : 0;
        if (turn != 0 && !add_corner(b, (corner){x, y}))
            return false;
        heading = (heading + turn) % 4;
    } while (x != start.x || y != start.y || heading != SOUTH);
    return true;
}

/* ---- Taking an area out ---------------------------------------------------------------------- */

/* A side of the border that runs up or down, in a row of pixels. */
typedef struct side {
    int x, y;
} side;

static int compare_sides(const void *first, const void *second)
{
    const side *a = first, *b = second;
    return a->y != b->y ? (a->y < b->y ? -1 : 1) : a->x < b->x ? -1 : a->x > b->x;
}

/* The sides that run up or down, row by row and from left to right; their number, or -1. */
static int list_sides(const border *b, side **sides)
{
    size_t count = 0, most = 0;
    for (int i = 0; i < b->count; i++)
        most += (size_t)abs(b->list[(i + 1) % b->count].y - b->list[i].y);
    *sides = most < INT32_MAX ? skv_calloc(most, sizeof **sides) : NULL;
    if (!*sides)
        return -1;
    for (int i = 0; i < b->count; i++) {
        corner from = b->list[i], to = b->list[(i + 1) % b->count];
        int low = from.y < to.y ? from.y : to.y, high = from.y + to.y - low;
        for (int y = low; y < high; y++)
            (*sides)[count++] = (side){from.x, y};
    }
    qsort(*sides, count, sizeof **sides, compare_sides);
    return (int)count;
}

/* Takes what lies within the border out of the painting. False: memory is out. */
static bool take_out(border *b, bool *has_hole)
{
    side *sides;
    int count = list_sides(b, &sides);
    b->pixels = 0;
    *has_hole = false;
    for (int i = 0; i + 1 < count; i += 2) {
        for (int x = sides[i].x; x < sides[i + 1].x; x++) {
            *has_hole |= !is_brown(b, x, sides[i].y);
            b->scene->paint[(size_t)sides[i].y * (size_t)b->scene->width + (size_t)x] =
                SKV_PAINT_NONE;
            b->pixels++;
        }
    }
    skv_free(sides);
    return count >= 0;
}

/* ---- An outline of few corners --------------------------------------------------------------- */

/* A piece of the border between two of its corners, and its corner that is farthest away. */
typedef struct piece {
    int first, last, farthest; /* corners, counted on beyond the end */
    double away;               /* pixels */
} piece;

static corner at(const border *b, int i)
{
    return b->list[i % b->count];
}

static piece look(const border *b, int first, int last)
{
    piece p = {first, last, first, 0};
    corner from = at(b, first), to = at(b, last);
    double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
    for (int i = first + 1; i < last; i++) {
        double x = at(b, i).x - from.x, y = at(b, i).y - from.y;
        double along = square > 0 ? (x * dx + y * dy) / square : 0;
        along = along < 0 ? 0 : along > 1 ? 1 : along;
        x -= along * dx;
        y -= along * dy;
        double away = sqrt(x * x + y * y);
        if (away > p.away) {
            p.away = away;
            p.farthest = i;
        }
    }
    return p;
}

/* Writes the outline's corners, in m; returns their number. */
static int simplify(const border *b, double corners[2 * SKV_MAX_CORNERS])
{
    piece pieces[SKV_MAX_CORNERS];
    int count = 1;
    pieces[0] = look(b, 0, b->count);
    while (count < SKV_MAX_CORNERS) {
        int worst = 0;
        for (int i = 1; i < count; i++)
            worst = pieces[i].away > pieces[worst].away ? i : worst;
        if (pieces[worst].away <= TOLERANCE)
            break;
        piece whole = pieces[worst];
        memmove(&pieces[worst + 1], &pieces[worst], (size_t)(count - worst) * sizeof *pieces);
        pieces[worst] = look(b, whole.first, whole.farthest);
        pieces[worst + 1] = look(b, whole.farthest, whole.last);
        count++;
    }
    for (int i = 0; i < count; i++) {
        corners[2 * i] = at(b, pieces[i].first).x * b->scene->pixel_size;
        corners[2 * i + 1] = at(b, pieces[i].first).y * b->scene->pixel_size;
    }
    return count;
}

/* Scales an outline about its middle so that it has the painted area. */
static skv_area make_area(const border *b)
{
    double corners[2 * SKV_MAX_CORNERS], area = 0, x = 0, y = 0;
    float scaled[2 * SKV_MAX_CORNERS];
    int count = simplify(b, corners);
    for (int i = 0; i < count; i++) {
        const double *p = corners + 2 * i, *q = corners + 2 * ((i + 1) % count);
        double cross = p[0] * q[1] - q[0] * p[1];
        area += cross / 2;
        x += (p[0] + q[0]) * cross / 6;
        y += (p[1] + q[1]) * cross / 6;
    }
    double painted = (double)b->pixels * b->scene->pixel_size * b->scene->pixel_size;
    double scale = area > 0 ? sqrt(painted / area) : 1;
    for (int i = 0; i < count; i++) {
        scaled[2 * i] =
            (float)(area > 0 ? x / area + scale * (corners[2 * i] - x / area) : corners[2 * i]);
        scaled[2 * i + 1] = (float)(area > 0 ? y / area + scale * (corners[2 * i + 1] - y / area)
                                             : corners[2 * i + 1]);
    }
    return skv_polygon(scaled, count);
}

/* ---- All of them ----------------------------------------------------------------------------- */

/* Makes a body of the area whose first pixel lies there, if it is as large as a particle. */
static skv_result make_body(border *b, int x, int y, const char *label, skv_error *error)
{
    skv_scene *scene = b->scene;
    int row = scene->height - 1 - y; /* as painters count */
    bool has_hole;
    if (!follow(b, x, y) || !take_out(b, &has_hole))
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
    double s = (double)scene->def.fluid.spacing, pixel = scene->pixel_size;
    if ((double)b->pixels * pixel * pixel < s * s) {
        b->specks++;
        return SKV_OK;
    }
    if (scene->body_count == SKV_MAX_BODIES)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%s: there are more than %d brown areas and other bodies; paint fewer, or "
                        "join some",
                        label, SKV_MAX_BODIES);
    if (has_hole)
        skv_scene_note(scene, "the brown area at pixel (%d, %d) has holes, which its body fills", x,
                       row);
    skv_scene_body *body = &scene->bodies[scene->body_count++];
    *body = (skv_scene_body){.def = skv_default_body_def()};
    body->def.shape = make_area(b);
    skv_format(body->name, sizeof body->name, "body %d", scene->body_count);
    skv_outline outline;
    skv_error cause;
    skv_result result =
        skv_outline_make(&body->def.shape, scene->def.fluid.spacing, &outline, &cause);
    if (result != SKV_OK)
        return skv_fail(error, result, "%s: the brown area at pixel (%d, %d) is no body: %s", label,
                        x, row, cause.text + strlen("body: "));
    return SKV_OK;
}

skv_result skv_scene_find_bodies(skv_scene *scene, const char *label, skv_error *error)
{
    border b = {.scene = scene};
    skv_result result = SKV_OK;
    for (int y = scene->height - 1; y >= 0 && result == SKV_OK; y--)
        for (int x = 0; x < scene->width && result == SKV_OK; x++)
            if (is_brown(&b, x, y))
                result = make_body(&b, x, y, label, error);
    skv_free(b.list);
    if (b.specks > 0)
        skv_scene_note(scene, "brown areas smaller than a particle are left out: %d", b.specks);
    return result;
}
