/* skvalp bench: measures what a substep costs, and writes it down.
 *
 * Invariant: nothing is printed and no file gets its name before all of it has been measured.
 */
#include "commands.h"

#include "bench/bench.h"
#include "cleanup.h"
#include "output_file.h"
#include "output_json.h"
#include "progress.h"

static void show_case(const bench_case *what, double done, void *user)
{
    char text[128];
    snprintf(text, sizeof text, "bench  %3.0f %%  %s, %s law, %d particles", 100 * done,
             what->scene, skv_law_name(what->law), what->particles);
    progress_show(user, text);
}

static json_t *json_row(const bench_report *report, const bench_row *row)
{
    json_t *phases = json_object();
    for (int i = 0; i < row->phases.count; i++)
        json_object_set_new(phases, row->phases.name[i],
                            output_number(bench_ns(row, row->phases.seconds[i])));
    /* clang-format off */
    return json_pack("{so ss sb si si si so so so so so so so so so so so so so so so}",
        "scene", output_text(row->what.scene),
        "law", skv_law_name(row->what.law),
        "viscosity", row->what.viscous,
        "particles", row->particles,
        "threads", row->threads,
        "substeps", row->substeps,
        "neighbours", output_number(row->neighbours),
        "ms_per_step", output_number(1e3 * row->fast.minimum),
        "ms_per_step_median", output_number(1e3 * row->fast.median),
        "ms_per_frame", output_number(bench_frame_ms(row)),
        "ns_per_particle_substep", output_number(bench_ns(row, row->fast.minimum)),
        "ns_per_particle_substep_median", output_number(bench_ns(row, row->fast.median)),
        "reference_ns_per_particle_substep", output_number(bench_ns(row, row->reference.minimum)),
        "ratio", output_number(bench_ratio(row)),
        "bytes_per_particle", output_number(row->bytes),
        "kept_bytes_per_particle", output_number(row->kept_bytes),
        "grid_bytes_per_particle", output_number(row->grid_bytes),
        "phases", phases,
        "instruction_set", output_text(report->instruction_set),
        "compiler", output_text(report->compiler),
        "cpu", output_text(report->cpu));
    /* clang-format on */
}

static skv_result print_json(const bench_report *report, skv_error *error)
{
    skv_result result = SKV_OK;
    output_list_begin();
    for (int i = 0; i < report->count && result == SKV_OK; i++)
        result = output_list_add(i, json_row(report, &report->row[i]), error);
    output_list_end();
    return result;
}

static skv_result open_outputs(const cli_options *options, output_file *csv, output_file *plot,
                               skv_error *error)
{
    skv_result result = SKV_OK;
    if (options->csv)
        result = output_file_open(csv, options->csv, error);
    if (!result && options->plot)
        result = output_file_open(plot, options->plot, error);
    if (!result && output_file_same(csv, plot))
        result = skv_fail(error, SKV_ERROR_VALUE,
                          "%s: two outputs would go there; name a second file", options->plot);
    return result;
}

/* Writes all that was asked for. */
static skv_result write_report(const cli_options *options, const bench_report *report,
                               output_file *csv, output_file *plot, skv_error *error)
{
    if (csv->stream)
        bench_write_csv(csv->stream, report);
    if (plot->stream)
        bench_write_plot(plot->stream, report);
    skv_result result = output_file_commit(csv, error);
    if (!result)
        result = output_file_commit(plot, error);
    if (result)
        return result;
    if (options->json)
        return print_json(report, error);
    if (options->markdown || (!options->quiet && !options_use_stdout(options)))
        bench_write_tables(stdout, report, options->markdown);
    return SKV_OK;
}

int bench_command(const cli_options *options, skv_error *error)
{
    const bench_options wanted = {options->quick, options->particles, options->threads};
    output_file csv = {0}, plot = {0};
    bench_report report = {0};
    int status = STATUS_BAD;
    cleanup_install();
    skv_result result = open_outputs(options, &csv, &plot, error);
    if (!result) {
        progress_line progress = progress_start("bench", 0, options->quiet);
        result = bench_measure(&wanted, show_case, &progress, &report, error);
        progress_end(&progress);
    }
    if (!result)
        result = write_report(options, &report, &csv, &plot, error);
    if (!result)
        status = STATUS_DONE;
    if (!result && report.lost) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "bench: %d particles escaped or are not finite; the figures are worth nothing",
                 report.lost);
        status = STATUS_FAILED;
    }
    output_file_discard(&csv);
    output_file_discard(&plot);
    bench_report_free(&report);
    return status;
}
