/* Painting: a new version of a terrain, in which strokes have drawn or erased walls.
 *
 * A stroke's coverage falls from 1 to 0 over the two pixels about its edge: then the contour, which
 * runs where coverage interpolated between two pixel centres is one half, lies on the edge itself.
 * Invariant: everything but the picture is a function of the picture, so what is found anew where
 * it changed equals what would be found of the whole.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "terrain/distance.h"
#include "terrain/terrain.h"

#include <math.h>
#include <string.h>

/* Over how many pixels to each side of its edge a stroke fades. */
#define SOFT_EDGE 1.0

/* A radius in pixels that leaves no gap between the pixels of a line. */
#define LEAST_RADIUS 0.5

/* A stroke in pixels; pixel centres have whole coordinates. */
typedef struct brush {
    double x0, y0, dx, dy, radius;
} brush;

static bool is_sane(const skv_brush_stroke *s)
{
    const float places[4] = {s->x0, s->y0, s->x1, s->y1};
    for (int i = 0; i < 4; i++)
        if (!(places[i] >= -1000 && places[i] <= 1000))
            return false;
    return s->radius > 0 && s->radius <= 100;
}

static brush make_brush(const skv_terrain *terrain, const skv_brush_stroke *s)
{
    double scale = (double)terrain->per_metre;
    return (brush){
        .x0 = (double)s->x0 * scale - 0.5,
        .y0 = (double)s->y0 * scale - 0.5,
        .dx = ((double)s->x1 - (double)s->x0) * scale,
        .dy = ((double)s->y1 - (double)s->y0) * scale,
        .radius = skv_max((double)s->radius * scale, LEAST_RADIUS),
    };
}

/* How much of pixel (x, y) the brush covers, as a byte. */
static uint8_t coverage_at(const brush *b, int x, int y)
{
    double px = x - b->x0, py = y - b->y0;
    double along = px * b->dx + py * b->dy, square = b->dx * b->dx + b->dy * b->dy;
    double t = square > 0 ? skv_max(0, skv_min(1, along / square)) : 0;
    double ex = px - t * b->dx, ey = py - t * b->dy;
    double share = 0.5 + 0.5 / SOFT_EDGE * (b->radius - sqrt(ex * ex + ey * ey));
    return (uint8_t)(255 * skv_max(0, skv_min(1, share)) + 0.5);
}

/* The pixels from `low` to before `high` of `count` that a stretch may touch. */
static void touched_pixels(double from, double way, double reach, int count, int *low, int *high)
{
    *low = (int)skv_max(0, skv_min(count, ceil(from + skv_min(way, 0) - reach)));
    *high = (int)skv_max(0, skv_min(count, floor(from + skv_max(way, 0) + reach) + 1));
}

/* Paints one stroke; true if a pixel has changed. */
static bool paint(skv_terrain *terrain, const skv_brush_stroke *stroke, skv_squares *changed)
{
    const int rim = SKV_TERRAIN_RIM;
    brush b = make_brush(terrain, stroke);
    double reach = b.radius + SOFT_EDGE;
    int left, right, bottom, top;
    touched_pixels(b.x0, b.dx, reach, terrain->width, &left, &right);
    touched_pixels(b.y0, b.dy, reach, terrain->height, &bottom, &top);
    bool any = false;
    for (int y = bottom; y < top; y++) {
        uint8_t *row = terrain->coverage + (size_t)(y + rim) * (size_t)terrain->columns + rim;
        for (int x = left; x < right; x++) {
            uint8_t share = coverage_at(&b, x, y);
            bool changes = stroke->erase ? row[x] > 255 - share : row[x] < share;
            if (!changes)
                continue;
            row[x] = stroke->erase ? (uint8_t)(255 - share) : share;
            skv_squares_add(changed, x + rim, y + rim);
            any = true;
        }
    }
    return any;
}

/* Paints and finds the distances anew where they may have changed. */
static skv_result edit(skv_terrain *made, const skv_brush_stroke *strokes, int count, bool *any,
                       skv_squares *changed, skv_error *error)
{
    for (int i = 0; i < count; i++)
        *any = paint(made, &strokes[i], changed) || *any;
    if (!*any)
        return SKV_OK;
    /* A pixel has a part in the cells beside it. */
    skv_squares reached;
    skv_result result = skv_squares_spread(changed, SKV_TERRAIN_REACH + 2, &reached, error);
    skv_coverage coverage = skv_terrain_coverage(made);
    if (result == SKV_OK)
        result = skv_coverage_check(&coverage, error);
    if (result == SKV_OK)
        result = skv_distance_fill(&coverage, made->pixel_size, &reached, made->field, NULL, error);
    if (result == SKV_OK)
        skv_terrain_derive(made, &reached);
    skv_squares_destroy(&reached);
    return result;
}

static skv_terrain *copy(const skv_terrain *terrain)
{
    skv_terrain *made = skv_terrain_allocate(terrain->width, terrain->height);
    if (!made)
        return NULL;
    size_t pixels = (size_t)terrain->columns * (size_t)terrain->rows;
    memcpy(made->field, terrain->field, pixels * sizeof *made->field);
    memcpy(made->coverage, terrain->coverage, pixels);
    memcpy(made->row_hash, terrain->row_hash, (size_t)made->height * sizeof *made->row_hash);
    memcpy(made->row_free, terrain->row_free, (size_t)made->height * sizeof *made->row_free);
    made->pixel_size = terrain->pixel_size;
    made->per_metre = terrain->per_metre;
    made->open_sides = terrain->open_sides;
    return made;
}

skv_result skv_terrain_paint(const skv_terrain *terrain, const skv_brush_stroke *strokes, int count,
                             skv_terrain **painted, skv_error *error)
{
    SKV_ASSERT_OR(painted, SKV_ERROR_VALUE);
    *painted = NULL;
    SKV_ASSERT_OR(terrain && count >= 0 && (strokes || count == 0), SKV_ERROR_VALUE);
    for (int i = 0; i < count; i++)
        if (!is_sane(&strokes[i]))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "stroke %d: an end is not finite or beyond 1000 m, or the radius not "
                            "above 0 and at most 100 m",
                            i);
    skv_squares changed;
    skv_result result = skv_squares_create(terrain->columns, terrain->rows, &changed, error);
    if (result != SKV_OK)
        return result;
    skv_terrain *made = copy(terrain);
    bool any = false;
    if (made)
        result = edit(made, strokes, count, &any, &changed, error);
    else
        result = skv_fail(error, SKV_ERROR_MEMORY, "terrain: no memory for %d x %d pixels",
                          terrain->width, terrain->height);
    skv_squares_destroy(&changed);
    if (result == SKV_OK && any)
        *painted = made;
    else
        skv_terrain_destroy(made);
    if (result == SKV_OK && !any)
        *painted = skv_terrain_share(terrain);
    return result;
}
