/* skvalp run: simulates a scene and writes what was asked for.
 *
 * Invariants: looking never changes the run, the state is only read between steps; the time of the
 * simulation is that of skv_world_step alone; no output gets its name before the run is over.
 */
#include "commands.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "cleanup.h"
#include "output_json.h"
#include "output_png.h"
#include "output_table.h"
#include "output_video.h"
#include "progress.h"
#include "skvalp/air.h"
#include "skvalp/bodies.h"
#include "skvalp/measure.h"
#include "skvalp/render.h"
#include "state_file.h"
#include "stepping.h"

/* Length of a run that goes on from a state, if none is asked for, s. */
#define STATE_SECONDS 10

typedef struct cli_run {
    const cli_options *options;
    skv_scene *scene; /* null where a state goes on */
    run_stepping stepping;
    const skv_world *world; /* that is stepped */
    run_timeline timeline;
    double step_seconds;  /* wall time inside skv_world_step */
    int64_t steps_before; /* that the world had taken before this run */
    output_file csv, trace, png, snapshot;
    series_bodies bodies; /* of the csv */
    output_video video;
    /* Pictures; null without --png and --video. */
    skv_offscreen *offscreen;
    skv_render_style style;
    int width, height;
    uint8_t *rgb;
} cli_run;

static const char *name_of(const cli_run *run)
{
    return run->scene ? skv_scene_name(run->scene) : name_of_input(run->options->scene);
}

/* The file number `i` that the run is read from, or null. */
static const char *input_file(const cli_run *run, int i)
{
    if (run->scene)
        return skv_scene_file(run->scene, i);
    return i == 0 ? run->options->scene : NULL;
}

/* No output may take the place of a file that the scene was read from. */
static skv_result check_inputs(const cli_run *run, const char *name, skv_error *error)
{
    for (int i = 0; input_file(run, i); i++) {
        if (output_is_file(name, input_file(run, i)))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "%s: the scene is read from there and would be lost; name another file",
                            name);
    }
    return SKV_OK;
}

/* Opens every file before anything costs time. */
static skv_result open_outputs(cli_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    struct {
        const char *name;
        output_file *file;
    } wanted[] = {{options->csv, &run->csv},
                  {options->trace, &run->trace},
                  {options->png, &run->png},
                  {options->snapshot, &run->snapshot},
                  {options->video, &run->video.file}};
    for (int i = 0; i < (int)(sizeof wanted / sizeof *wanted); i++) {
        bool video = wanted[i].file == &run->video.file;
        if (!wanted[i].name)
            continue;
        skv_result result = video ? video_open(&run->video, wanted[i].name, error)
                                  : output_file_open(wanted[i].file, wanted[i].name, error);
        if (!result)
            result = check_inputs(run, wanted[i].name, error);
        if (result)
            return result;
        for (int k = 0; k < i; k++) {
            if (output_file_same(wanted[i].file, wanted[k].file)) {
                return skv_fail(error, SKV_ERROR_VALUE,
                                "%s: two outputs would go there; name a second file",
                                wanted[i].name);
            }
        }
    }
    return SKV_OK;
}

/* The size asked for, or the world's shape with 1280 pixels along; even, for the video's sake. */
static void choose_size(cli_run *run)
{
    const skv_terrain *terrain = skv_world_terrain(run->world);
    double width = (double)skv_terrain_width(terrain), height = (double)skv_terrain_height(terrain);
    double scale = 1280 / fmax(width, height);
    run->width = run->options->width;
    run->height = run->options->height;
    if (!run->width) {
        run->width = (int)fmax(PICTURE_MIN, 2 * floor(width * scale / 2 + 0.5));
        run->height = (int)fmax(PICTURE_MIN, 2 * floor(height * scale / 2 + 0.5));
    }
}

static skv_result open_pictures(cli_run *run, skv_error *error)
{
    if (!run->options->png && !run->options->video)
        return SKV_OK;
    choose_size(run);
    run->style = run->options->style;
    if (run->options->tracers)
        run->style.overlays |= SKV_OVERLAY_TRACERS;
    run->rgb = malloc((size_t)run->width * (size_t)run->height * 3);
    if (!run->rgb) {
        return skv_fail(error, SKV_ERROR_MEMORY,
                        "--size: no memory for %d x %d pixels; ask for less", run->width,
                        run->height);
    }
    skv_result result = skv_offscreen_create(run->width, run->height, &run->offscreen, error);
    if (!result && run->options->video)
        result = video_start(&run->video, run->width, run->height, error);
    return result;
}

/* A state or a replay is what it is: nothing of its scene can be changed. */
static skv_result load_state(cli_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    if (options->particles || options->setting_count)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%.200s: a state goes on as it is; leave out --particles, --law and --set",
                        name_of_input(options->scene));
    skv_result result = is_state_file(options->scene)
                            ? state_file_read(options, &run->stepping.world, error)
                            : replay_file_read(options, &run->stepping.player, error);
    return result;
}

static skv_result load_scene(cli_run *run, skv_error *error)
{
    skv_scene_options wanted = options_for_scene(run->options);
    return skv_scene_load(run->options->scene, &wanted, &run->scene, error);
}

static skv_result start_timeline(cli_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    double end = run->scene ? skv_scene_seconds(run->scene) : STATE_SECONDS;
    if (run->stepping.player)
        end = (double)skv_player_end(run->stepping.player) / 60;
    double every = options->trace_every > 0 ? options->trace_every : 0.1;
    if (options->seconds >= 0)
        end = options->seconds;
    if (options->at > end)
        return skv_fail(error, SKV_ERROR_VALUE, "--at: %g s are past the end, %g s; add --seconds",
                        options->at, end);
    double snapshot = !options->snapshot ? -1 : options->at < 0 ? end : options->at;
    run->timeline = timeline_start(end, options->trace ? every : 0, snapshot);
    return SKV_OK;
}

/* What the world has to say while it runs. */
static void print_note(const char *text, void *user)
{
    (void)user;
    fprintf(stderr, "skvalp: note: %s\n", text);
}

static skv_result open_run(cli_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    bool state = is_state_file(options->scene) || is_replay_file(options->scene);
    skv_result result = state ? load_state(run, error) : load_scene(run, error);
    if (!result)
        result = start_timeline(run, error);
    if (!result)
        result = open_outputs(run, error);
    if (!result && run->scene)
        result = skv_scene_create_world(run->scene, options->threads, &run->stepping.world, error);
    run->world = result ? NULL : stepping_world(&run->stepping);
    if (!result)
        result = open_pictures(run, error);
    if (!result) {
        run->steps_before = skv_world_substep_count(run->world);
        if (!options->quiet && run->stepping.world)
            skv_world_set_log(run->stepping.world, print_note, NULL);
        if (!options->quiet && run->scene)
            print_notices(run->scene);
        if (options->csv)
            series_head(&run->csv, run->world, run->scene, &run->bodies);
        if (options->trace)
            trace_head(&run->trace);
    }
    return result;
}

static skv_result draw(const cli_run *run, skv_error *error)
{
    skv_frame frame = skv_world_frame(run->world);
    return skv_offscreen_render(run->offscreen, &frame, &run->style, run->rgb, error);
}

/* Writes what belongs to the present moment. */
static skv_result record(cli_run *run, skv_error *error)
{
    const run_timeline *now = &run->timeline;
    skv_result result = SKV_OK;
    if (run->csv.stream && (now->at_frame || now->at_end)) {
        skv_packing packing;
        result = skv_world_packing(run->world, &packing, error);
        if (!result) {
            series_row(&run->csv, run->world, &run->bodies, &packing, now->time);
            result = output_file_check(&run->csv, error);
        }
    }
    if (!result && run->trace.stream && (now->at_trace || now->at_end)) {
        trace_rows(&run->trace, run->world, now->time);
        result = output_file_check(&run->trace, error);
    }
    if (!result && run->snapshot.stream && now->at_snapshot)
        result = state_file_write(&run->snapshot, run->world, error);
    /* A picture lasts until the next frame: the end has none, or the video would be too long. */
    bool picture = now->at_frame && (!now->at_end || now->frame == 0);
    if (!result && run->video.process && picture) {
        result = draw(run, error);
        if (!result)
            result = video_add(&run->video, run->rgb, error);
    }
    return result;
}

static skv_result simulate(cli_run *run, skv_error *error)
{
    progress_line progress = progress_start(name_of(run), run->timeline.end, run->options->quiet);
    skv_result result = record(run, error);
    while (!result && !run->timeline.at_end) {
        double before = clock_seconds();
        skv_error cause;
        result = stepping_advance(&run->stepping, &run->timeline, &cause);
        run->step_seconds += clock_seconds() - before;
        if (result) {
            skv_fail(error, result, "%s: the step at %g s failed: %s", run->options->scene,
                     run->timeline.time, cause.text);
            break;
        }
        result = record(run, error);
        progress_update(&progress, run->timeline.time);
    }
    progress_end(&progress);
    return result;
}

/* Draws the last picture, completes every file. */
static skv_result finish(cli_run *run, skv_error *error)
{
    skv_result result = SKV_OK;
    if (run->options->png) {
        result = draw(run, error);
        if (!result)
            result = png_write(&run->png, run->rgb, run->width, run->height, error);
    }
    if (!result)
        result = video_commit(&run->video, error);
    output_file *const files[] = {&run->csv, &run->trace, &run->png, &run->snapshot};
    for (int i = 0; i < 4 && !result; i++)
        result = output_file_commit(files[i], error);
    return result;
}

/* What is told of each fluid; a fluid without a particle has no centre. */
static json_t *list_fluids(const skv_world *world)
{
    json_t *list = json_array();
    const skv_liquid *liquid;
    for (int i = 0; (liquid = skv_world_liquid(world, i)); i++) {
        skv_stats stats = skv_world_fluid_stats(world, i);
        bool placed = stats.particles > stats.not_finite;
        json_t *fluid =
            json_pack("{so si so so so}", "name", output_text(liquid->name), "particles",
                      stats.particles, "centre_x", output_number(placed ? stats.centre_x : NAN),
                      "centre_y", output_number(placed ? stats.centre_y : NAN), "kinetic_energy",
                      output_number(stats.kinetic_energy));
        if (json_array_append_new(list, fluid) != 0) {
            json_decref(list);
            return NULL;
        }
    }
    return list;
}

/* What is told of each body: by the scene's name, else by its own. */
static json_t *list_bodies(const cli_run *run)
{
    json_t *list = json_array();
    skv_survey *survey = NULL;
    skv_body body;
    if (skv_world_body_count(run->world) > 0 && skv_survey_create(&survey, NULL) == SKV_OK &&
        skv_survey_take(survey, run->world, NULL) != SKV_OK) {
        skv_survey_destroy(survey);
        survey = NULL;
    }
    for (int i = 0; skv_world_body_at(run->world, i, &body); i++) {
        char number[32];
        const char *name = body_name(run->scene, body.id, number);
        double under = survey ? skv_survey_submerged(survey, &body) : NAN;
        json_t *told =
            json_pack("{so so so so so so so so}", "name", output_text(name), "x",
                      output_number((double)body.x), "y", output_number((double)body.y), "angle",
                      output_number((double)body.angle), "vx", output_number((double)body.vx), "vy",
                      output_number((double)body.vy), "spin", output_number((double)body.spin),
                      "submerged", output_number(under));
        if (json_array_append_new(list, told) != 0) {
            json_decref(list);
            list = NULL;
            break;
        }
    }
    skv_survey_destroy(survey);
    return list;
}

/* What is told of each pocket of air, from the highest on. */
static json_t *list_pockets(const skv_world *world)
{
    json_t *list = json_array();
    int count = skv_world_pockets(world, NULL, 0);
    skv_pocket *pockets = calloc((size_t)count + 1, sizeof *pockets);
    if (!pockets)
        count = 0;
    skv_world_pockets(world, pockets, count);
    for (int i = 0; i < count; i++) {
        const skv_pocket *p = &pockets[i];
        json_array_append_new(list, json_pack("{so so so so}", "x", output_number((double)p->x),
                                              "y", output_number((double)p->y), "volume",
                                              output_number((double)p->volume), "pressure",
                                              output_number((double)p->pressure)));
    }
    free(pockets);
    return list;
}

static skv_result print_json(const cli_run *run, const skv_stats *stats, const skv_packing *packing,
                             skv_error *error)
{
    int64_t steps = skv_world_substep_count(run->world) - run->steps_before;
    char hash[17];
    snprintf(hash, sizeof hash, "%016" PRIx64, skv_world_hash(run->world));
    /* clang-format off */
    skv_flow flow = skv_world_flow(run->world);
    return output_json(json_pack("{so si si sI so so so ss si si so so sI sI sI sI sI so si so so si}",
        "scene", output_text(name_of(run)),
        "particles", stats->particles,
        "substeps", skv_world_substeps_per_frame(run->world),
        "steps", (json_int_t)steps,
        "sim_seconds", output_number(run->timeline.time),
        "ms_per_step", output_number(steps ? 1000 * run->step_seconds / (double)steps : NAN),
        "neighbours", output_number(packing->neighbours),
        "hash", hash,
        "escaped", stats->escaped,
        "nan", stats->not_finite,
        "kinetic_energy", output_number(stats->kinetic_energy),
        "volume_ratio", output_number(packing->volume_ratio),
        "emitted", (json_int_t)flow.emitted,
        "drained", (json_int_t)flow.drained,
        "left", (json_int_t)flow.left,
        "replaced", (json_int_t)flow.replaced,
        "blocked", (json_int_t)flow.blocked,
        "fluids", list_fluids(run->world),
        "springs", skv_world_spring_count(run->world),
        "bodies", list_bodies(run),
        "pockets", list_pockets(run->world),
        "awake", skv_world_awake_count(run->world)), error);
    /* clang-format on */
}

static void print_summary(const cli_run *run, const skv_stats *stats, const skv_packing *packing)
{
    double simulated = run->timeline.time;
    int64_t steps = skv_world_substep_count(run->world) - run->steps_before;
    printf("%s: %d particles, %.4g s simulated in %.3g s",
           run->scene ? skv_scene_title(run->scene) : name_of(run), stats->particles, simulated,
           run->step_seconds);
    if (steps) {
        printf(" (%.3gx real time)\n  %" PRId64 " substeps of %.3g ms, %d a frame",
               simulated / run->step_seconds, steps, 1000 * run->step_seconds / (double)steps,
               skv_world_substeps_per_frame(run->world));
    }
    printf("\n  %.1f neighbours, volume ratio %.3f, speed %.3g m/s (rms), kinetic energy %.4g J/m\n"
           "  %d escaped, %d not finite, hash %016" PRIx64 "\n",
           packing->neighbours, packing->volume_ratio, stats->rms_speed, stats->kinetic_energy,
           stats->escaped, stats->not_finite, skv_world_hash(run->world));
    skv_flow flow = skv_world_flow(run->world);
    if (flow.emitted || flow.drained || flow.left || flow.blocked)
        printf("  %" PRId64 " emitted, %" PRId64 " drained, %" PRId64 " left, %" PRId64
               " replaced, %" PRId64 " blocked\n",
               flow.emitted, flow.drained, flow.left, flow.replaced, flow.blocked);
}

/* Prints the result, and judges it. */
static int report(const cli_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    skv_stats stats = skv_world_stats(run->world);
    skv_packing packing;
    skv_result result = skv_world_packing(run->world, &packing, error);
    if (result == SKV_OK && options->json)
        result = print_json(run, &stats, &packing, error);
    if (result != SKV_OK)
        return STATUS_BAD;
    if (!options->json && !options->quiet && !options_use_stdout(options))
        print_summary(run, &stats, &packing);
    if (stats.escaped || stats.not_finite) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "%s: the fluid went wrong: %d particles escaped, %d are not finite; "
                 "take more substeps, --set substeps=N",
                 options->scene, stats.escaped, stats.not_finite);
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static void close_run(cli_run *run)
{
    video_discard(&run->video);
    output_file_discard(&run->csv);
    output_file_discard(&run->trace);
    output_file_discard(&run->png);
    output_file_discard(&run->snapshot);
    skv_offscreen_destroy(run->offscreen);
    free(run->rgb);
    stepping_free(&run->stepping);
    skv_scene_destroy(run->scene);
}

int run_command(const cli_options *options, skv_error *error)
{
    cli_run run = {.options = options};
    int status = STATUS_BAD;
    cleanup_install();
    skv_result result = open_run(&run, error);
    if (!result)
        result = simulate(&run, error);
    if (!result)
        result = finish(&run, error);
    if (!result)
        status = report(&run, error);
    close_run(&run);
    return status;
}
