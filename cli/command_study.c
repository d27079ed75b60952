/* skvalp lab --jobs and --gather: lists the runs of a study, and reads their tables.
 *
 * Invariant: nothing is run here. A list is printed only if every one of its runs may be run, and a
 * table is written only if every file that is there is a run's.
 */
#include "command_study.h"

#include <stdlib.h>
#include <string.h>

#include "cleanup.h"
#include "commands.h"
#include "output_file.h"
#include "study_folder.h"

/* Runs that are named if they lack; of more their number is said. */
enum { MOST_NAMED = 10 };

/* ---- Whether the options fit together -------------------------------------------------------- */

static skv_result refuse(skv_error *error, const char *option, const char *why)
{
    return skv_fail(error, SKV_ERROR_VALUE, "--%s: %s", option, why);
}

/* What makes no sense beside an option of studies; null if there is nothing. */
static const char *wasted_with(const cli_options *options)
{
    return options->json                       ? "json"
           : options->cards                    ? "cards"
           : options->plot && !options->gather ? "plot"
           : options->csv && !options->gather  ? "csv"
                                               : NULL;
}

skv_result study_check(const cli_options *options, skv_error *error)
{
    bool described = options->experiment_count || options->setting_count || options->starts;
    const char *mode = options->jobs     ? "jobs"
                       : options->gather ? "gather"
                       : options->job    ? "job"
                                         : NULL;
    if (!mode && options->sweep_count)
        return refuse(error, "sweep",
                      "it makes a study; add --jobs DIR to list its runs, and later --gather DIR "
                      "to make one table of them");
    if (!mode && options->csv)
        return refuse(error, "csv",
                      "it is where --gather writes; curves are written by --plot DIR, rows by "
                      "--json");
    if (!mode)
        return SKV_OK;
    if (!!options->jobs + !!options->gather + !!options->job > 1)
        return refuse(error, mode, "one of --jobs, --gather and --job at a time; omit the others");
    if (strcmp(options->jobs ? options->jobs : options->gather ? options->gather : "", "-") == 0)
        return refuse(error, mode, "'-' is not supported; name a folder");
    if (wasted_with(options))
        return skv_fail(error, SKV_ERROR_VALUE, "--%s: nothing is written for --%s; omit one", mode,
                        wasted_with(options));
    if (options->jobs && options->sweep_count == 0)
        return refuse(error, mode, "nothing is swept; add --sweep PATH=FROM:TO:NUMBER");
    if (options->job && options->sweep_count > 0)
        return refuse(error, mode, "it is one run; say --set instead of --sweep");
    if (options->gather && options->sweep_count == 0 && described)
        return refuse(error, mode,
                      "what its runs are is said by the folder, or by all that was said to --jobs; "
                      "add --sweep, or omit the rest");
    return SKV_OK;
}

/* ---- --jobs ---------------------------------------------------------------------------------- */

/* A word as a shell takes it for one: as it is if it holds no other characters than `plain`. */
static void print_word(const char *word, const char *plain)
{
    if (*word && word[strspn(word, plain)] == '\0') {
        fputs(word, stdout);
        return;
    }
    putchar('\'');
    for (; *word; word++) {
        if (*word == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*word);
    }
    putchar('\'');
}

#define PLAIN "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+,:/@%"

static void print_job(const cli_options *options, const skv_study *study, int run, const char *path)
{
    skv_setting setting;
    /* A word with = in front of all others would set a variable. */
    print_word(options->program, PLAIN);
    printf(" lab %s", options->experiments[0]);
    for (int i = 0; skv_study_run_setting(study, run, i, &setting); i++)
        printf(" --set %s=%s", setting.path, setting.value);
    if (options->starts > 0)
        printf(" --starts %d", options->starts);
    /* Many runs fill the processors by themselves. */
    printf(" --threads %d --job=", options->threads > 0 ? options->threads : 1);
    print_word(path, PLAIN "=");
    putchar('\n');
}

static skv_result print_jobs(const cli_options *options, const skv_study *study, skv_error *error)
{
    for (int run = 0; run < skv_study_runs(study); run++) {
        char *path = study_run_path(options->jobs, study, run);
        if (!path)
            return skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
        print_job(options, study, run, path);
        free(path);
    }
    return SKV_OK;
}

static int list_jobs(const cli_options *options, skv_error *error)
{
    skv_study *study = NULL;
    skv_result result = study_of_options(options, &study, error);
    if (result == SKV_OK && strpbrk(options->jobs, "\r\n"))
        result = refuse(error, "jobs", "the folder's name has a line break; name another");
    if (result == SKV_OK)
        result = output_folder_make(options->jobs, "jobs", error);
    if (result == SKV_OK)
        result = study_keep(options, study, error);
    if (result == SKV_OK)
        result = print_jobs(options, study, error);
    skv_study_destroy(study);
    return result == SKV_OK ? STATUS_DONE : STATUS_BAD;
}

/* ---- --gather -------------------------------------------------------------------------------- */

typedef struct gathering {
    const cli_options *options;
    skv_study *study;
    int lacking;
    int bad; /* files that are no run's; of the last `wrong` says why */
    skv_error wrong;
} gathering;

static skv_result open_study(gathering *g, skv_error *error)
{
    const char *folder = g->options->gather;
    if (g->options->sweep_count > 0)
        return study_of_options(g->options, &g->study, error);
    skv_result result = study_of_folder(folder, &g->study, error);
    if (result == SKV_OK && !g->study)
        result =
            skv_fail(error, SKV_ERROR_FILE,
                     "%s: there is no study.txt; name the folder that was given to --jobs", folder);
    return result;
}

/* One line for each file that is wrong: the last is printed with the exit status. */
static void note_bad(gathering *g, const skv_error *why)
{
    if (g->bad++ > 0)
        fprintf(stderr, "skvalp: %s\n", g->wrong.text);
    g->wrong = *why;
}

static void note_lacking(gathering *g, const char *path)
{
    char plain[1024];
    skv_format(plain, sizeof plain, "%s", path);
    skv_make_plain(plain);
    if (g->lacking++ < MOST_NAMED && !g->options->quiet)
        fprintf(stderr, "skvalp: note: %s: not there yet\n", plain);
}

static skv_result read_runs(gathering *g, skv_error *error)
{
    for (int run = 0; run < skv_study_runs(g->study); run++) {
        bool there = false;
        skv_error why = {.code = SKV_OK};
        char *path = study_run_path(g->options->gather, g->study, run);
        if (!path)
            return skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
        if (study_read_run(g->study, run, path, &there, &why) != SKV_OK)
            note_bad(g, &why);
        else if (!there)
            note_lacking(g, path);
        free(path);
    }
    if (g->bad)
        *error = g->wrong;
    return g->bad ? SKV_ERROR_FORMAT : SKV_OK;
}

typedef skv_result study_writer(const skv_study *, skv_write *, void *, skv_error *);

/* Opens a file and fills it; it has its name only after the caller's commit. */
static skv_result fill(output_file *file, const char *name, study_writer *writer,
                       const skv_study *study, skv_error *error)
{
    skv_error why = {.code = SKV_OK};
    skv_result result = output_file_open(file, name, error);
    if (result != SKV_OK)
        return result;
    result = writer(study, output_file_take, file, &why);
    if (result == SKV_ERROR_FILE) /* named with the system's reason */
        return output_file_check(file, error);
    if (result != SKV_OK)
        *error = why;
    return result;
}

static bool drop(const char *text, size_t length, void *user)
{
    (void)text, (void)length, (void)user;
    return true;
}

/* The picture first, and once to nowhere: what it refuses leaves no table and no folder behind. */
static skv_result write_results(const gathering *g, skv_error *error)
{
    output_file picture = {0}, table = {0};
    char *path = NULL;
    skv_result result = SKV_OK;
    if (g->options->plot)
        result = skv_study_plot(g->study, drop, NULL, error);
    if (g->options->plot && result == SKV_OK)
        result = output_folder_make(g->options->plot, "plot", error);
    if (g->options->plot && result == SKV_OK) {
        path = study_picture_path(g->options->plot, g->study);
        result = path ? fill(&picture, path, skv_study_plot, g->study, error)
                      : skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
    }
    if (result == SKV_OK)
        result =
            fill(&table, g->options->csv ? g->options->csv : "-", skv_study_table, g->study, error);
    if (result == SKV_OK)
        result = output_file_commit(&picture, error);
    if (result == SKV_OK)
        result = output_file_commit(&table, error);
    output_file_discard(&picture);
    output_file_discard(&table);
    free(path);
    return result;
}

static int gather(const cli_options *options, skv_error *error)
{
    gathering g = {.options = options};
    skv_result result = open_study(&g, error);
    if (result == SKV_OK)
        result = read_runs(&g, error);
    if (result == SKV_OK)
        result = write_results(&g, error);
    int runs = g.study ? skv_study_runs(g.study) : 0;
    skv_study_destroy(g.study);
    if (result != SKV_OK)
        return STATUS_BAD;
    if (g.lacking == 0)
        return STATUS_DONE;
    skv_fail(error, SKV_ERROR_FILE,
             "lab: %d of %d runs lack; run the jobs again, those that are "
             "done end at once",
             g.lacking, runs);
    return STATUS_FAILED;
}

int study_command(const cli_options *options, skv_error *error)
{
    cleanup_install();
    return options->jobs ? list_jobs(options, error) : gather(options, error);
}
