/* Measures the cases of the plan.
 *
 * Invariant: only skv_world_step runs between two readings of the clock. A case's worlds (fast and
 * reference, on one and on all threads) start from the same particles and take their rounds in
 * turn, so that whatever disturbs the machine meets all of them.
 */
#include "company.h"
#include "plan.h"
#include "twin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "skvalp/query.h"
#include "skvalp/snapshot.h"

enum {
    MOST_ROUNDS = 40,
    MOST_STEPS = 6,
    MOST_TIMES = MOST_ROUNDS * MOST_STEPS,
    REFERENCE_ROUNDS = 5
};

/* A world and its times. */
typedef struct runner {
    skv_world *world;
    int steps_a_round; /* calls of skv_world_step, each timed */
    float dt;          /* s, of a call */
    int substeps;      /* of a call */
    int times;
    double seconds[MOST_TIMES]; /* a substep */
    skv_profile best;           /* of the fastest call, s a substep */
} runner;

/* A case while it is measured: [0] on one thread, [1] on all. */
typedef struct bench {
    const bench_options *options;
    bench_case what;
    int counts; /* of threads: 1 or 2 */
    runner fast[2], reference[2];
    bool with_reference;
} bench;

/* ---- Setting up ------------------------------------------------------------------------------ */

/* The clavet law's viscosity in its own units, h = dt = 1: sigma = 0.05, beta = 2. */
static void make_viscous(skv_fluid_def *fluid, const skv_world *world)
{
    const float most = 1000; /* what a fluid may have */
    fluid->viscosity_linear = fminf(0.05f * 60 * (float)skv_world_substeps_per_frame(world), most);
    fluid->viscosity_quadratic = fminf(2 / skv_world_smoothing_radius(world), most);
}

/* The scene's world with the case's fluid, on all threads. */
static skv_result open_world(bench *b, skv_world **world, skv_error *error)
{
    const skv_setting law = {"fluid.law", skv_law_name(b->what.law)};
    skv_scene_options options = skv_default_scene_options();
    options.particles = b->what.particles;
    options.settings = &law;
    options.setting_count = 1;
    skv_scene *scene = NULL;
    skv_world *source = NULL;
    *world = NULL;
    skv_result result = skv_scene_load(b->what.scene, &options, &scene, error);
    if (result == SKV_OK)
        result = skv_scene_create_world(scene, 1, &source, error);
    if (result == SKV_OK) {
        skv_fluid_def fluid = *skv_world_fluid(source);
        if (b->what.viscous)
            make_viscous(&fluid, source);
        result = bench_twin(source, &fluid, SKV_SOLVER_FAST, b->options->threads, world, error);
    }
    skv_world_destroy(source);
    skv_scene_destroy(scene);
    return result;
}

/* Half a second of motion for few particles, a frame at least for many. */
static skv_result warm_up(const bench *b, skv_world *world, skv_error *error)
{
    int frames = 30 * (b->options->quick ? 10000 : 30000) / b->what.particles;
    frames = frames < 1 ? 1 : frames > 30 ? 30 : frames;
    skv_result result = SKV_OK;
    for (int i = 0; i < frames && result == SKV_OK; i++)
        result = skv_world_step(world, 1.0f / 60, error);
    return result;
}

/* A pool with company: a copy of it runs on one thread. The reference solver is left out. */
static skv_result open_company(bench *b, const char *text, skv_error *error)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = b->what.particles;
    skv_scene *scene = NULL;
    skv_world *first = NULL;
    skv_result result =
        skv_scene_load_memory(text, strlen(text), "json", b->what.scene, &options, &scene, error);
    if (result == SKV_OK)
        result = skv_scene_create_world(scene, b->options->threads, &first, error);
    skv_scene_destroy(scene);
    if (result != SKV_OK)
        return result;
    b->counts = skv_world_threads(first) > 1 ? 2 : 1;
    b->fast[b->counts - 1].world = first;
    result = warm_up(b, first, error);
    if (result != SKV_OK || b->counts == 1)
        return result;
    skv_world_def host = skv_default_world_def();
    host.threads = 1;
    return skv_world_copy(first, &host, &b->fast[0].world, error);
}

/* Whole frames; several a round where they are short, as the first one finds cold caches. */
static void prepare_fast(runner *r)
{
    r->substeps = skv_world_substeps_per_frame(r->world);
    int steps = 1 + 50000 / (skv_world_particle_count(r->world) * r->substeps);
    r->steps_a_round = steps < MOST_STEPS ? steps : MOST_STEPS;
    r->dt = 1.0f / 60;
}

/* A few substeps: they are long, and all alike for the reference. */
static void prepare_reference(runner *r)
{
    int frame = skv_world_substeps_per_frame(r->world);
    int wanted = 1 + 30000 / skv_world_particle_count(r->world);
    r->steps_a_round = 1;
    r->substeps = wanted < frame ? wanted : frame;
    r->dt = (float)r->substeps / 60 / (float)frame;
}

/* One of the two scenes, and twins of it for the reference solver. */
static skv_result open_plain(bench *b, skv_error *error)
{
    skv_world *first;
    skv_result result = open_world(b, &first, error);
    if (result != SKV_OK)
        return result;
    int threads = skv_world_threads(first);
    b->counts = threads > 1 ? 2 : 1;
    b->fast[b->counts - 1].world = first;
    result = warm_up(b, first, error);
    if (result == SKV_OK && b->counts == 2)
        result =
            bench_twin(first, skv_world_fluid(first), SKV_SOLVER_FAST, 1, &b->fast[0].world, error);
    b->with_reference = b->what.particles <= BENCH_REFERENCE_MOST;
    for (int t = 0; t < b->counts && b->with_reference && result == SKV_OK; t++)
        result = bench_twin(first, skv_world_fluid(first), SKV_SOLVER_REFERENCE,
                            t == 0 ? 1 : threads, &b->reference[t].world, error);
    return result;
}

static skv_result open_bench(bench *b, skv_error *error)
{
    const char *company = bench_company_scene(b->what.scene);
    skv_result result = company ? open_company(b, company, error) : open_plain(b, error);
    for (int t = 0; t < b->counts && result == SKV_OK; t++) {
        prepare_fast(&b->fast[t]);
        if (b->with_reference)
            prepare_reference(&b->reference[t]);
    }
    return result;
}

static void close_bench(bench *b)
{
    for (int t = 0; t < 2; t++) {
        skv_world_destroy(b->fast[t].world);
        skv_world_destroy(b->reference[t].world);
    }
}

/* ---- Measuring ------------------------------------------------------------------------------- */

/* Takes one step and returns the seconds of a substep. */
static skv_result time_step(runner *r, double *seconds, skv_error *error)
{
    skv_world_profile(r->world, true);
    int64_t before = skv_world_substep_count(r->world);
    double start = bench_seconds(BENCH_CLOCK);
    skv_result result = skv_world_step(r->world, r->dt, error);
    double took = bench_seconds(BENCH_CLOCK) - start;
    if (result == SKV_OK)
        r->substeps = (int)(skv_world_substep_count(r->world) - before);
    *seconds = took / r->substeps;
    return result;
}

static void record(runner *r, double seconds)
{
    bool best = true;
    for (int i = 0; i < r->times; i++)
        best = best && seconds < r->seconds[i];
    r->seconds[r->times++] = seconds;
    if (!best)
        return;
    r->best = skv_world_profile(r->world, false);
    for (int i = 0; i < r->best.count; i++)
        r->best.seconds[i] /= r->substeps;
}

static skv_result measure_round(runner *r, skv_error *error)
{
    skv_result result = SKV_OK;
    for (int i = 0; i < r->steps_a_round && r->times < MOST_TIMES && result == SKV_OK; i++) {
        double seconds;
        result = time_step(r, &seconds, error);
        if (result == SKV_OK)
            record(r, seconds);
    }
    return result;
}

/* The first step of a world, which allocates and finds cold caches, counts only if it is so long
 * that this is nothing. Returns its time in all. */
static skv_result first_step(runner *r, double *total, skv_error *error)
{
    const double long_step = 0.5; /* s */
    double seconds;
    skv_result result = time_step(r, &seconds, error);
    *total = seconds * r->substeps;
    if (result == SKV_OK && *total > long_step)
        record(r, seconds);
    return result;
}

/* As many rounds as a second or so holds, judged by the first steps. */
static skv_result choose_rounds(bench *b, int *rounds, skv_error *error)
{
    double wanted = b->options->quick ? 0.2 : 1.0, longest = 0, total;
    int most = b->options->quick ? 15 : MOST_ROUNDS;
    for (int t = 0; t < b->counts; t++) {
        skv_result result = first_step(&b->fast[t], &total, error);
        longest = fmax(longest, total * b->fast[t].steps_a_round);
        if (result == SKV_OK && b->with_reference)
            result = first_step(&b->reference[t], &total, error);
        if (result != SKV_OK)
            return result;
    }
    *rounds = (int)fmin(most, fmax(2, wanted / longest));
    return SKV_OK;
}

static skv_result run_rounds(bench *b, bench_progress *progress, void *user, double done,
                             skv_error *error)
{
    int rounds, reference_rounds = b->options->quick ? 2 : REFERENCE_ROUNDS;
    skv_result result = choose_rounds(b, &rounds, error);
    for (int round = 0; result == SKV_OK && (round < rounds || round < reference_rounds); round++) {
        if (progress)
            progress(&b->what, done, user);
        for (int t = 0; t < b->counts && result == SKV_OK; t++) {
            if (round < rounds)
                result = measure_round(&b->fast[t], error);
            if (result == SKV_OK && b->with_reference && round < reference_rounds)
                result = measure_round(&b->reference[t], error);
        }
    }
    return result;
}

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static bench_time summary(const runner *r)
{
    if (r->times == 0)
        return (bench_time){NAN, NAN};
    double sorted[MOST_TIMES];
    memcpy(sorted, r->seconds, sizeof *sorted * (size_t)r->times);
    qsort(sorted, (size_t)r->times, sizeof *sorted, compare);
    return (bench_time){sorted[0], (sorted[(r->times - 1) / 2] + sorted[r->times / 2]) / 2};
}

static skv_result add_rows(const bench *b, bench_report *report, skv_error *error)
{
    skv_stats stats = skv_world_stats(b->fast[0].world);
    report->lost += stats.escaped + stats.not_finite;
    skv_packing packing;
    skv_result result = skv_world_packing(b->fast[0].world, &packing, error);
    if (result != SKV_OK)
        return result;
    for (int t = 0; t < b->counts; t++) {
        const skv_world *world = b->fast[t].world;
        skv_memory memory = skv_world_memory(world);
        report->row[report->count++] = (bench_row){
            .what = b->what,
            .particles = stats.particles,
            .threads = skv_world_threads(world),
            .substeps = skv_world_substeps_per_frame(world),
            .neighbours = packing.neighbours,
            .fast = summary(&b->fast[t]),
            .reference = summary(&b->reference[t]),
            .bytes = (double)memory.particles / stats.particles,
            .kept_bytes = (double)memory.kept / stats.particles,
            .grid_bytes = (double)(memory.grid + memory.histograms) / stats.particles,
            .phases = b->fast[t].best,
        };
        report->threads = skv_world_threads(world);
    }
    return SKV_OK;
}

/* What a case takes, roughly: the same for each, and more for many particles. */
static double effort(const bench_case *what)
{
    return 50000 + what->particles;
}

skv_result bench_measure(const bench_options *options, bench_progress *progress, void *user,
                         bench_report *report, skv_error *error)
{
    bench_case cases[BENCH_MAX_CASES];
    int count = bench_plan(options, cases);
    *report = (bench_report){.instruction_set = skv_instruction_set_name(SKV_ISA_BEST),
                             .load = bench_load(),
                             .quick = options->quick,
                             .only = options->particles};
    bench_name_cpu(report->cpu, sizeof report->cpu);
    bench_name_compiler(report->compiler, sizeof report->compiler);
    report->row = calloc((size_t)count * 2, sizeof *report->row);
    if (!report->row)
        return skv_fail(error, SKV_ERROR_MEMORY, "bench: out of memory");
    skv_result result = SKV_OK;
    double total = 0, past = 0;
    for (int i = 0; i < count; i++)
        total += effort(&cases[i]);
    for (int i = 0; i < count && result == SKV_OK; past += effort(&cases[i++])) {
        bench b = {.options = options, .what = cases[i]};
        if (progress)
            progress(&b.what, past / total, user);
        result = open_bench(&b, error);
        if (result == SKV_OK)
            result = run_rounds(&b, progress, user, past / total, error);
        if (result == SKV_OK)
            result = add_rows(&b, report, error);
        close_bench(&b);
    }
    if (result == SKV_OK)
        result = bench_measure_edits(options, report, error);
    if (result == SKV_OK)
        result = bench_measure_frames(options, report, error);
    return result == SKV_OK ? bench_measure_rivals(options, report, error) : result;
}

void bench_report_free(bench_report *report)
{
    free(report->row);
    *report = (bench_report){0};
}
