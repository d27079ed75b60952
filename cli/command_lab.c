/* skvalp lab: runs experiments and sets what was measured against theory.
 *
 * Invariant: names, settings and the folder for plots are checked before anything is computed; a
 * row that misses what it must reach is printed like any other, and an experiment that the settings
 * do not fit keeps no other from running; the exit status tells.
 */
#include "commands.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cleanup.h"
#include "command_study.h"
#include "lab_job.h"
#include "lab_starts.h"
#include "output_file.h"
#include "output_json.h"
#include "output_lab.h"
#include "progress.h"
#include "skvalp/experiments.h"

enum { MAX_EXPERIMENTS = 64, MAX_FIGURES = 16 };

typedef struct lab_run {
    const cli_options *options;
    skv_lab_options lab;
    lab_starts starts;
    int chosen[MAX_EXPERIMENTS], count;
    int at;    /* which of them is running, */
    int start; /* and from which of its starts */
    progress_line progress;
    lab_job job; /* whose table the rows go to; all zero: none */
    int rows, missed;
    int refused;       /* experiments that the settings do not fit */
    skv_error refusal; /* of the first of them */
} lab_run;

/* Those named, each once, or all. */
static skv_result choose(lab_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    for (int i = 0; i < options->experiment_count; i++) {
        int found = 0;
        skv_result result = skv_experiment_find(options->experiments[i], &found, error);
        if (result != SKV_OK)
            return result;
        bool known = false;
        for (int k = 0; k < run->count; k++)
            known = known || run->chosen[k] == found;
        if (!known && run->count < MAX_EXPERIMENTS)
            run->chosen[run->count++] = found;
    }
    for (int i = 0; options->experiment_count == 0 && skv_experiment_info(i); i++)
        run->chosen[run->count++] = i;
    return SKV_OK;
}

static bool show_progress(const skv_lab_moment *moment, void *user)
{
    lab_run *run = user;
    char text[128];
    int starts = lab_starts_count(&run->starts, skv_experiment_info(run->chosen[run->at]));
    double done = run->at + (run->start + moment->share) / starts;
    snprintf(text, sizeof text, "lab  %3.0f %%  %s", 100 * done / run->count,
             skv_experiment_info(run->chosen[run->at])->title);
    progress_show(&run->progress, text);
    return true;
}

static skv_result prepare(lab_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    skv_result result = choose(run, error);
    if (result != SKV_OK)
        return result;
    run->lab = skv_default_lab_options();
    run->lab.settings = options->settings;
    run->lab.setting_count = options->setting_count;
    run->lab.threads = options->threads;
    run->lab.observe = show_progress;
    run->lab.user = run;
    result = skv_lab_check(&run->lab, error);
    if (result == SKV_OK)
        result = lab_starts_open(&run->starts, options, error);
    if (result == SKV_OK && options->plot)
        result = output_folder_make(options->plot, "plot", error);
    return result;
}

typedef skv_result report_writer(const skv_report *, skv_write *, void *, skv_error *);

static skv_result write_file(const char *folder, const char *name, const char *ending,
                             report_writer *writer, const skv_report *report, skv_error *error)
{
    size_t size = strlen(folder) + strlen(name) + strlen(ending) + 2;
    char *path = malloc(size);
    if (!path)
        return skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
    snprintf(path, size, "%s/%s%s", folder, name, ending);
    output_file file = {0};
    skv_result result = output_file_open(&file, path, error);
    if (result == SKV_OK) {
        /* What could not be written is named by commit, with the system's reason. */
        writer(report, output_file_take, &file, NULL);
        result = output_file_commit(&file, error);
    }
    output_file_discard(&file);
    free(path);
    return result;
}

static skv_result write_plots(const lab_run *run, const skv_report *report, skv_error *error)
{
    const char *folder = run->options->plot;
    const char *name = skv_experiment_info(run->chosen[run->at])->name;
    skv_result result = write_file(folder, name, ".svg", skv_report_plot, report, error);
    if (result == SKV_OK)
        result = write_file(folder, name, ".csv", skv_report_csv, report, error);
    return result;
}

/* Notes an experiment whose set-up cannot be built from the settings. Alone it has no table to
 * stand in: what conclude() says is enough. */
static void refuse(lab_run *run, const skv_error *why)
{
    progress_end(&run->progress);
    if (run->refused++ == 0)
        run->refusal = *why;
    if (run->count > 1 && !run->options->json && !run->options->quiet)
        printf("%s%s: not run; %s\n", run->at ? "\n" : "",
               skv_experiment_info(run->chosen[run->at])->title, why->text);
    fflush(stdout);
}

/* Runs the experiment from each start; gives its figures, and the report of the first start. Of
 * starts that nobody asked for those are left out that the experiment has no room for. */
static skv_result run_starts(lab_run *run, lab_figure *figures, skv_report **first,
                             skv_error *error)
{
    int count = lab_starts_count(&run->starts, skv_experiment_info(run->chosen[run->at]));
    *first = NULL;
    for (run->start = 0; run->start < count; run->start++) {
        skv_report *report;
        lab_starts_choose(&run->starts, run->start, &run->lab);
        skv_result result = skv_experiment_run(run->chosen[run->at], &run->lab, &report, error);
        bool refused = result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT;
        if (refused && *first && run->options->starts == 0)
            continue;
        if (result != SKV_OK)
            return result;
        for (int i = 0; i < MAX_FIGURES && skv_report_row(report, i); i++)
            lab_figure_add(&figures[i], skv_report_row(report, i));
        if (*first)
            skv_report_destroy(report);
        else
            *first = report;
    }
    return SKV_OK;
}

static skv_result print_report(lab_run *run, const skv_report *report, const lab_figure *figures,
                               skv_error *error)
{
    skv_result result = SKV_OK;
    if (!run->options->json && !run->options->quiet && !run->options->job) {
        fputs(run->at ? "\n" : "", stdout);
        lab_table(skv_experiment_info(run->chosen[run->at]), report, figures);
    }
    for (int i = 0; i < MAX_FIGURES && figures[i].starts > 0 && result == SKV_OK; i++) {
        if (run->options->json)
            result = lab_json(run->rows, &figures[i], error);
        lab_job_add(&run->job, &figures[i]);
        run->rows++;
        run->missed += !figures[i].row.pass;
    }
    fflush(stdout);
    return result == SKV_OK ? lab_job_commit(&run->job, error) : result;
}

static skv_result run_one(lab_run *run, skv_error *error)
{
    lab_figure figures[MAX_FIGURES] = {0};
    skv_report *report;
    skv_result result = run_starts(run, figures, &report, error);
    if (result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT) {
        refuse(run, error);
        result = SKV_OK;
    } else if (result == SKV_OK) {
        progress_end(&run->progress);
        result = print_report(run, report, figures, error);
        if (run->options->plot && result == SKV_OK)
            result = write_plots(run, report, error);
    }
    skv_report_destroy(report);
    return result;
}

/* What a class works through, one experiment after the other; the pages of docs/lab have it, too.
 */
static void print_cards(const lab_run *run)
{
    if (run->options->experiment_count == 0)
        puts("# Experiments\n\n"
             "One card for each experiment of the lab: read the question, write down what you "
             "expect, run it\n(in the app, or with the command below the title), and compare.\n");
    for (int i = 0; i < run->count; i++) {
        const skv_experiment *card = skv_experiment_info(run->chosen[i]);
        printf("%s## %s\n\n`skvalp lab %s`\n\n", i ? "\n" : "", card->title, card->name);
        printf("**Question.** %s\n\n", card->question);
        printf("**Predict.** %s\n\n", card->predict);
        printf("**Measure.** %s\n\n", card->measure);
        printf("**Compare.** %s\n", card->compare);
    }
}

/* The exit status, and the line that goes with it. */
static int conclude(const lab_run *run, skv_error *error)
{
    if (run->refused && run->count == 1) {
        *error = run->refusal;
        return STATUS_BAD;
    }
    if (run->refused) {
        skv_fail(error, SKV_ERROR_VALUE, "lab: %d of %d experiments not run; %s", run->refused,
                 run->count, run->refusal.text);
        return STATUS_BAD;
    }
    /* What a study finds out is no failure. */
    if (run->missed && !run->options->job) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "lab: %d of %d figures miss what they must reach; see docs/lab.md", run->missed,
                 run->rows);
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static int run_all(lab_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    skv_result result = SKV_OK;
    run->progress = progress_start("lab", 0, options->quiet);
    if (options->json)
        output_list_begin();
    for (run->at = 0; run->at < run->count && result == SKV_OK; run->at++)
        result = run_one(run, error);
    progress_end(&run->progress);
    if (options->json)
        output_list_end();
    return result == SKV_OK ? conclude(run, error) : STATUS_BAD;
}

int lab_command(const cli_options *options, skv_error *error)
{
    lab_run run = {.options = options};
    int status = STATUS_BAD;
    bool done = false;
    if (study_check(options, error) != SKV_OK)
        return STATUS_BAD;
    if (options->jobs || options->gather)
        return study_command(options, error);
    cleanup_install();
    skv_result result = prepare(&run, error);
    if (result == SKV_OK && options->job)
        result = lab_job_open(&run.job, options, &done, error);
    if (result == SKV_OK) {
        status = STATUS_DONE;
        if (options->cards)
            print_cards(&run);
        else if (!done)
            status = run_all(&run, error);
    }
    lab_job_close(&run.job);
    lab_starts_close(&run.starts);
    return status;
}
