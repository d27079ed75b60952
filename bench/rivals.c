/* Five seconds of a pool and of a dam break, by our method and by FLIP: what a frame costs, and
 * what has become of the water.
 *
 * Invariant: both begin with the same water in the same tank, take the same time, and are asked for
 * the same figures.
 */
#include "plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flip.h"
#include "machine.h"
#include "skvalp/query.h"

enum { FRAMES = 300, LAST = 60 };
enum { MOST = 30000 }; /* particles: five seconds of more take minutes */

/* The built-in scenes' water, m, in a tank of 1.6 x 0.9 m. */
static const double tank[2] = {1.6, 0.9}, water[2][2] = {{1.6, 0.45}, {0.4, 0.8}};

/* The mean height at which that water comes to rest. */
static double resting_height(int scene)
{
    return water[scene][0] * water[scene][1] / tank[0] / 2;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bench_time summary(double seconds[LAST])
{
    qsort(seconds, LAST, sizeof *seconds, compare);
    return (bench_time){seconds[0], seconds[LAST / 2]};
}

/* Watches one method; `advance` takes a frame. */
typedef skv_result advance_frame(void *method, skv_error *error);

static skv_result watch(advance_frame *advance, void *method, bench_time *time, skv_error *error)
{
    double seconds[LAST];
    skv_result result = SKV_OK;
    for (int i = 0; i < FRAMES && result == SKV_OK; i++) {
        double start = bench_seconds(BENCH_CLOCK);
        result = advance(method, error);
        if (i >= FRAMES - LAST)
            seconds[i - (FRAMES - LAST)] = bench_seconds(BENCH_CLOCK) - start;
    }
    if (result == SKV_OK)
        *time = summary(seconds);
    return result;
}

static skv_result advance_flip(void *method, skv_error *error)
{
    (void)error;
    for (int i = 0; i < FLIP_STEPS; i++)
        flip_step(method, 1.0f / 60 / FLIP_STEPS);
    return SKV_OK;
}

static skv_result advance_world(void *method, skv_error *error)
{
    return skv_world_step(method, 1.0f / 60, error);
}

static skv_result add_flip(int scene, int particles, bench_report *report, skv_error *error)
{
    flip *f = flip_create(tank[0], tank[1], water[scene][0], water[scene][1], particles);
    if (!f)
        return skv_fail(error, SKV_ERROR_MEMORY, "bench: out of memory");
    bench_rival rival = {"FLIP", bench_scenes[scene], flip_particles(f), FLIP_STEPS, {0, 0}, 0, 0};
    skv_result result = watch(advance_flip, f, &rival.time, error);
    double height;
    flip_measure(f, &rival.speed, &height);
    rival.level = height / resting_height(scene);
    report->rival[report->rival_count++] = rival;
    flip_destroy(f);
    return result;
}

static skv_result open_scene(int scene, int particles, skv_world **world, skv_error *error)
{
    const skv_setting awake = {"sleep", "false"};
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    options.settings = &awake;
    options.setting_count = 1;
    skv_scene *loaded;
    skv_result result = skv_scene_load(bench_scenes[scene], &options, &loaded, error);
    if (result != SKV_OK)
        return result;
    result = skv_scene_create_world(loaded, 1, world, error);
    skv_scene_destroy(loaded);
    return result;
}

static skv_result add_ours(int scene, int particles, bench_report *report, skv_error *error)
{
    skv_world *world = NULL;
    skv_result result = open_scene(scene, particles, &world, error);
    bench_rival rival = {.method = "skvalp", .scene = bench_scenes[scene]};
    if (result == SKV_OK)
        result = watch(advance_world, world, &rival.time, error);
    if (result == SKV_OK) {
        skv_particles p = skv_world_particles(world);
        double sum = 0;
        for (int i = 0; i < p.count; i++)
            sum += (double)p.y[i];
        rival.particles = p.count;
        rival.steps = skv_world_substeps_per_frame(world);
        rival.level = sum / p.count / resting_height(scene);
        rival.speed = skv_world_stats(world).rms_speed;
        report->rival[report->rival_count++] = rival;
    }
    skv_world_destroy(world);
    return result;
}

skv_result bench_measure_rivals(const bench_options *options, bench_report *report,
                                skv_error *error)
{
    skv_result result = SKV_OK;
    const int sizes[2] = {options->particles ? options->particles : bench_sizes[0], bench_sizes[1]};
    int count = options->particles ? 1 : 2;
    for (int scene = 0; scene < 2; scene++)
        for (int i = 0; i < count && sizes[i] <= MOST && result == SKV_OK; i++) {
            result = add_ours(scene, sizes[i], report, error);
            if (result == SKV_OK)
                result = add_flip(scene, sizes[i], report, error);
        }
    return result;
}
