/* skvalp lab: runs experiments and sets what was measured against theory.
 *
 * Invariant: names, settings and the folder for plots are checked before anything is computed; a
 * row that misses what it must reach is printed like any other, and an experiment that the settings
 * do not fit keeps no other from running; the exit status tells.
 */
#include "commands.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cleanup.h"
#include "output_file.h"
#include "output_json.h"
#include "progress.h"
#include "skvalp/experiments.h"

enum { MAX_EXPERIMENTS = 64 };

typedef struct lab_run {
    const cli_options *options;
    skv_lab_options lab;
    int chosen[MAX_EXPERIMENTS], count;
    int at; /* which of them is running */
    progress_line progress;
    int rows, missed;
    int refused;       /* experiments that the settings do not fit */
    skv_error refusal; /* of the first of them */
} lab_run;

static skv_result find_experiment(const char *name, int *found, skv_error *error)
{
    const char *names[MAX_EXPERIMENTS];
    int count = 0;
    for (; count < MAX_EXPERIMENTS && skv_experiment_info(count); count++) {
        names[count] = skv_experiment_info(count)->name;
        if (strcmp(names[count], name) == 0) {
            *found = count;
            return SKV_OK;
        }
    }
    const char *nearest = skv_nearest_name(name, names, count);
    if (nearest)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "lab: there is no experiment '%s'; did you mean %s?", name, nearest);
    return skv_fail(error, SKV_ERROR_VALUE,
                    "lab: there is no experiment '%s'; see 'skvalp lab --help'", name);
}

/* Those named, each once, or all. */
static skv_result choose(lab_run *run, skv_error *error)
{
    const cli_options *options = run->options;
    for (int i = 0; i < options->experiment_count; i++) {
        int found = 0;
        skv_result result = find_experiment(options->experiments[i], &found, error);
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
    snprintf(text, sizeof text, "lab  %3.0f %%  %s", 100 * (run->at + moment->share) / run->count,
             skv_experiment_info(run->chosen[run->at])->title);
    progress_show(&run->progress, text);
    return true;
}

/* Makes the folder, or makes sure that plots can be written into the one that is there. */
static skv_result prepare_folder(const char *folder, skv_error *error)
{
    struct stat found;
    bool usable = mkdir(folder, 0777) == 0;
    if (!usable && errno == EEXIST && stat(folder, &found) == 0) {
        usable = S_ISDIR(found.st_mode) && access(folder, W_OK | X_OK) == 0;
        errno = S_ISDIR(found.st_mode) ? errno : ENOTDIR;
    }
    if (usable)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_FILE, "%s: %s; name another folder with --plot", folder,
                    strerror(errno));
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
    return result == SKV_OK && options->plot ? prepare_folder(options->plot, error) : result;
}

static bool write_to_stream(const char *text, size_t length, void *user)
{
    return fwrite(text, 1, length, user) == length;
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
        writer(report, write_to_stream, file.stream, NULL);
        result = output_file_commit(&file, error);
    }
    output_file_discard(&file);
    free(path);
    return result;
}

static void print_number(double value)
{
    if (isnan(value))
        printf("%11s", "-");
    else
        printf("%11.4g", value);
}

static void print_row(const skv_lab_row *row)
{
    printf("  %-36s", row->quantity);
    print_number(row->measured);
    print_number(row->theory);
    if (isnan(row->ratio)) {
        printf("%9s", "-");
        printf("   up to %-9.3g", row->tolerance);
    } else {
        printf("%9.3f   +-%5.2g %%    ", row->ratio, 100 * row->tolerance);
    }
    printf("  %-5s %s\n", row->pass ? "pass" : "MISS", row->unit);
}

static void print_report(const lab_run *run, const skv_report *report)
{
    int particles, substeps;
    double spacing, seconds;
    skv_report_facts(report, &particles, &spacing, &substeps, &seconds);
    const skv_experiment *info = skv_experiment_info(run->chosen[run->at]);
    printf("%s%s: %d particles of %.3g mm, %d substeps a frame, %.3g s\n", run->at ? "\n" : "",
           info->title, particles, 1000 * spacing, substeps, seconds);
    printf("  %-36s%11s%11s%9s   %s\n", info->name, "measured", "theory", "ratio",
           "must reach         unit");
    for (int i = 0; skv_report_row(report, i); i++)
        print_row(skv_report_row(report, i));
}

static skv_result print_json(const lab_run *run, const skv_report *report, skv_error *error)
{
    skv_result result = SKV_OK;
    for (int i = 0; skv_report_row(report, i) && result == SKV_OK; i++) {
        const skv_lab_row *row = skv_report_row(report, i);
        /* clang-format off */
        result = output_list_add(run->rows + i, json_pack("{so so so so so so so sb}",
            "experiment", output_text(row->experiment),
            "quantity", output_text(row->quantity),
            "unit", output_text(row->unit),
            "measured", output_number(row->measured),
            "theory", output_number(row->theory),
            "ratio", output_number(row->ratio),
            "tolerance", output_number(row->tolerance),
            "pass", row->pass), error);
        /* clang-format on */
    }
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

static skv_result run_one(lab_run *run, skv_error *error)
{
    int number = run->chosen[run->at];
    skv_report *report;
    skv_result result = skv_experiment_run(number, &run->lab, &report, error);
    if (result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT) {
        refuse(run, error);
        return SKV_OK;
    }
    if (result != SKV_OK)
        return result;
    progress_end(&run->progress);
    if (run->options->json)
        result = print_json(run, report, error);
    else if (!run->options->quiet)
        print_report(run, report);
    fflush(stdout);
    for (int i = 0; skv_report_row(report, i); i++) {
        run->rows++;
        run->missed += !skv_report_row(report, i)->pass;
    }
    if (run->options->plot && result == SKV_OK) {
        const char *folder = run->options->plot, *name = skv_experiment_info(number)->name;
        result = write_file(folder, name, ".svg", skv_report_plot, report, error);
        if (result == SKV_OK)
            result = write_file(folder, name, ".csv", skv_report_csv, report, error);
    }
    skv_report_destroy(report);
    return result;
}

/* What a class works through, one experiment after the other: docs/experiments.md is this. */
static void print_cards(const lab_run *run)
{
    if (run->options->experiment_count == 0)
        puts("# Experiments\n\n"
             "One card for each experiment of the lab: read the question, write down what you "
             "expect, run it\n(in the app, or with the command below the title), and compare. "
             "What these figures were when the\nprogram was tested is in [the lab](lab.md).\n");
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
    if (run->missed) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "lab: %d of %d figures miss what they must reach; see docs/lab.md", run->missed,
                 run->rows);
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

int lab_command(const cli_options *options, skv_error *error)
{
    lab_run run = {.options = options};
    cleanup_install();
    skv_result result = prepare(&run, error);
    if (result == SKV_OK && options->cards) {
        print_cards(&run);
        return STATUS_DONE;
    }
    if (result == SKV_OK) {
        run.progress = progress_start("lab", 0, options->quiet);
        if (options->json)
            output_list_begin();
        for (run.at = 0; run.at < run.count && result == SKV_OK; run.at++)
            result = run_one(&run, error);
        progress_end(&run.progress);
        if (options->json)
            output_list_end();
    }
    return result == SKV_OK ? conclude(&run, error) : STATUS_BAD;
}
