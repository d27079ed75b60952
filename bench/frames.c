/* Measures a frame of the app, without a window: a stage steps and publishes, a face asks for it,
 * a renderer issues it.
 *
 * Invariant: only what is named runs between two readings of a clock; the stage's thread has
 * nothing to do when a frame begins.
 */
#include "bench.h"

#include <math.h>
#include <skvalp/render.h>
#include <skvalp/stage.h>
#include <stdlib.h>
#include <time.h>

#include "machine.h"

enum { MOST_FRAMES = 200, LEAST_FRAMES = 5, KEYS = 5 };
enum { LARGE = 200000 };             /* particles whose step takes longer than a frame */
enum { VIEW_X = 640, VIEW_Y = 360 }; /* pixels */

static const double longest_measuring = 3; /* s */

/* The times of one row. */
typedef struct series {
    int count;
    double clock[MOST_FRAMES], processor; /* s; of the processor the least */
} series;

static void note(series *s, double clock, double processor)
{
    if (s->count == MOST_FRAMES)
        return;
    s->clock[s->count++] = clock;
    s->processor = s->count == 1 ? processor : fmin(s->processor, processor);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void add_row(bench_report *report, const char *name, int particles, int threads, series *s)
{
    if (s->count == 0 || report->frame_count == BENCH_FRAMES)
        return;
    qsort(s->clock, (size_t)s->count, sizeof *s->clock, compare);
    report->frame[report->frame_count++] = (bench_frame){
        .name = name,
        .particles = particles,
        .threads = threads,
        .time = {s->clock[0], s->clock[s->count / 2]},
        .longest = s->clock[s->count - 1],
        .processor = s->processor,
    };
}

/* The pool, open and awake. */
static skv_result open_pool(int particles, int threads, skv_stage **stage, skv_error *error)
{
    skv_stage_def def = skv_default_stage_def();
    def.threads = threads;
    skv_result result = skv_stage_create(&def, stage, error);
    if (result != SKV_OK)
        return result;
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_stage_set_view(*stage, 0, 1280, 720);
    skv_stage_open(*stage, "pool", &options);
    skv_stage_wait(*stage);
    skv_stage_set_gravity(*stage, 0, 0.5, -1);
    skv_stage_wait(*stage);
    skv_outcome outcome;
    while (skv_stage_next_outcome(*stage, &outcome))
        if (outcome.error.code != SKV_OK) {
            *error = outcome.error;
            return error->code;
        }
    return SKV_OK;
}

/* Frame by frame: what the stage's thread does for it, and then what drawing it costs. */
static skv_result measure_frames(skv_stage *stage, series *stepped, series *issued,
                                 skv_error *error)
{
    skv_offscreen *offscreen = NULL;
    static uint8_t rgb[VIEW_X * VIEW_Y * 3];
    skv_render_style style = skv_default_render_style();
    skv_result result = SKV_OK;
    if (skv_offscreen_create(VIEW_X, VIEW_Y, &offscreen, NULL) != SKV_OK)
        offscreen = NULL; /* without OpenGL that row is left out */
    double begun = bench_seconds(BENCH_CLOCK);
    for (int i = 0; i < MOST_FRAMES && result == SKV_OK; i++) {
        if (i >= LEAST_FRAMES && bench_seconds(BENCH_CLOCK) - begun > longest_measuring)
            break;
        double clock = bench_seconds(BENCH_CLOCK), processor = bench_seconds(BENCH_PROCESS);
        skv_stage_advance(stage, 1.0 / 60, 0);
        skv_stage_wait(stage);
        note(stepped, bench_seconds(BENCH_CLOCK) - clock, bench_seconds(BENCH_PROCESS) - processor);

        skv_stage_look(stage);
        const skv_picture *picture = skv_stage_picture(stage, 0);
        clock = bench_seconds(BENCH_CLOCK);
        processor = bench_seconds(BENCH_THREAD);
        if (offscreen)
            result = skv_offscreen_render(offscreen, &picture->frame, &style, rgb, error);
        if (offscreen && i > 0) /* the first makes the textures */
            note(issued, bench_seconds(BENCH_CLOCK) - clock,
                 bench_seconds(BENCH_THREAD) - processor);
    }
    skv_offscreen_destroy(offscreen);
    return result;
}

/* One turn of the face's loop, with all of its calls; whether gravity to that side shows. */
static bool take_turn(skv_stage *stage, double tilt, double *last, series *calls)
{
    double clock = bench_seconds(BENCH_CLOCK), processor = bench_seconds(BENCH_THREAD);
    skv_stage_advance(stage, clock - *last, 0);
    *last = clock;
    skv_stage_look(stage);
    const skv_picture *picture = skv_stage_picture(stage, 0);
    bool shows = fabs(picture->tilt_x - tilt) < 0.01;
    note(calls, bench_seconds(BENCH_CLOCK) - clock, bench_seconds(BENCH_THREAD) - processor);
    return shows;
}

/* From a key, pressed while a step is at work, to the picture that shows it; and the face's calls
 * meanwhile. */
static void measure_keys(skv_stage *stage, series *keys, series *calls)
{
    const struct timespec pause = {.tv_nsec = 2000000};
    double last = bench_seconds(BENCH_CLOCK);
    for (int i = 0; i < KEYS; i++) {
        double tilt = i % 2 ? 0.5 : -0.5;
        for (int k = 0; k < 10; k++, nanosleep(&pause, NULL))
            take_turn(stage, tilt, &last, calls);
        double clock = bench_seconds(BENCH_CLOCK), processor = bench_seconds(BENCH_PROCESS);
        skv_stage_set_gravity(stage, 0, tilt, -1);
        while (!take_turn(stage, tilt, &last, calls))
            nanosleep(&pause, NULL);
        note(keys, bench_seconds(BENCH_CLOCK) - clock, bench_seconds(BENCH_PROCESS) - processor);
    }
}

static skv_result measure(int particles, int threads, bench_report *report, skv_error *error)
{
    series stepped = {0}, issued = {0}, keys = {0}, calls = {0};
    skv_stage *stage = NULL;
    skv_result result = open_pool(particles, threads, &stage, error);
    if (result == SKV_OK)
        result = measure_frames(stage, &stepped, &issued, error);
    if (result == SKV_OK)
        measure_keys(stage, &keys, &calls);
    skv_stage_destroy(stage);
    add_row(report, "step and publish", particles, report->threads, &stepped);
    add_row(report, "issue", particles, 1, &issued);
    add_row(report, "from a key to its picture", particles, report->threads, &keys);
    add_row(report, "the face's calls", particles, 1, &calls);
    return result;
}

skv_result bench_measure_frames(const bench_options *options, bench_report *report,
                                skv_error *error)
{
    skv_result result =
        measure(options->particles ? options->particles : 10000, options->threads, report, error);
    if (result == SKV_OK && !options->particles && !options->quick)
        result = measure(LARGE, options->threads, report, error);
    return result;
}
