/* Measures what a brush costs while a world runs: walls drawn and erased, water poured and taken.
 *
 * Invariant: only the edit itself runs between two readings of the clock; each is followed by a
 * frame, so that it meets fluid that moves.
 */
#include "bench.h"

#include <math.h>
#include <stdlib.h>

#include "machine.h"
#include "skvalp/particles.h"

enum { WIDTH = 1024, HEIGHT = 576, STEP = 12 /* pixels from frame to frame */ };
enum { MOST_ROUNDS = 64, QUICK_ROUNDS = 16 };

static const float pixel = 1.6f / WIDTH;

/* A brush on its way, and what it does. */
typedef struct brush {
    skv_world *world;
    float x0, y0, x1, y1, radius; /* m */
    int round, rounds;
} brush;

/* Draws for a while, then erases on the same way. */
static skv_result paint(const brush *b, skv_error *error)
{
    const skv_brush_stroke stroke = {b->x0, b->y0,     b->x1,
                                     b->y1, b->radius, b->round >= b->rounds / 2};
    skv_terrain *painted;
    skv_result result = skv_terrain_paint(skv_world_terrain(b->world), &stroke, 1, &painted, error);
    if (result != SKV_OK)
        return result;
    result = skv_world_set_terrain(b->world, painted, NULL, error);
    if (result != SKV_OK)
        skv_terrain_destroy(painted);
    return result;
}

static skv_result pour(const brush *b, skv_error *error)
{
    skv_area area = skv_swept_circle(b->x0, b->y0, b->x1, b->y1, b->radius);
    skv_fill_def def = skv_default_fill_def();
    def.area = &area;
    def.aligned = true;
    return skv_world_fill(b->world, &def, NULL, error);
}

static skv_result take(const brush *b, skv_error *error)
{
    skv_area area = skv_swept_circle(b->x0, b->y0, b->x1, b->y1, b->radius);
    return skv_world_remove_area(b->world, &area, NULL, error);
}

static const struct {
    const char *name;
    skv_result (*act)(const brush *b, skv_error *error);
    float radius; /* pixels */
    float height; /* of the middle of its way, m */
} edits[BENCH_EDITS] = {
    {"wall, 20 pixels wide", paint, 10, 0.4f},
    {"wall, 3 pixels wide", paint, 1.5f, 0.4f},
    {"water poured", pour, 20, 0.7f},
    {"water taken", take, 20, 0.2f},
};

/* A tank, half full. */
static skv_result open_tank(const bench_options *options, int particles, skv_world **world,
                            skv_error *error)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = WIDTH;
    terrain.height = HEIGHT;
    terrain.pixel_size = pixel;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = sqrtf(1.6f * 0.45f / (float)particles);
    def.threads = options->threads;
    *world = NULL;
    skv_result result = skv_terrain_create(&terrain, &def.terrain, error);
    if (result != SKV_OK)
        return result;
    result = skv_world_create(&def, world, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        return result;
    }
    skv_fill_def fill = skv_default_fill_def();
    fill.y1 = 0.45f;
    return skv_world_fill(*world, &fill, NULL, error);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static skv_result measure(const bench_options *options, int kind, bench_edit *row, skv_error *error)
{
    brush b = {.radius = edits[kind].radius * pixel,
               .rounds = options->quick ? QUICK_ROUNDS : MOST_ROUNDS};
    double seconds[MOST_ROUNDS];
    skv_result result = open_tank(options, row->particles, &b.world, error);
    row->name = edits[kind].name;
    for (b.round = 0; b.round < b.rounds && result == SKV_OK; b.round++) {
        float way = STEP * pixel * (float)(b.round % (b.rounds / 2));
        b.x0 = 0.4f + way;
        b.y0 = edits[kind].height + 0.4f * way;
        b.x1 = b.x0 + STEP * pixel;
        b.y1 = b.y0 + 0.4f * STEP * pixel;
        double from = bench_seconds(BENCH_CLOCK);
        result = edits[kind].act(&b, error);
        seconds[b.round] = bench_seconds(BENCH_CLOCK) - from;
        if (result == SKV_OK)
            result = skv_world_step(b.world, 1.0f / 60, error);
    }
    if (result == SKV_OK) {
        qsort(seconds, (size_t)b.rounds, sizeof *seconds, compare);
        row->time = (bench_time){seconds[0], seconds[b.rounds / 2]};
        row->threads = skv_world_threads(b.world);
    }
    skv_world_destroy(b.world);
    return result;
}

skv_result bench_measure_edits(const bench_options *options, bench_report *report, skv_error *error)
{
    skv_result result = SKV_OK;
    for (int i = 0; i < BENCH_EDITS && result == SKV_OK; i++) {
        report->edit[i].particles = options->particles ? options->particles : 10000;
        result = measure(options, i, &report->edit[i], error);
    }
    return result;
}
