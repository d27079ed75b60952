/* Reads and writes what is in a study's folder.
 *
 * Invariant: study.txt is the arguments of the study, one a line, and is read by what reads
 * arguments. A table is taken for a run's only if it is that to the last byte.
 */
#include "study_folder.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output_file.h"

#define NOTE "study.txt"

/* Far more than any study.txt or table of a run takes, in bytes. */
enum { LARGEST_FILE = 1 << 20 };

static char *join(const char *folder, const char *name, const char *ending)
{
    size_t length = strlen(folder), size = length + strlen(name) + strlen(ending) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s%s%s%s", folder, folder[length - 1] == '/' ? "" : "/", name,
                 ending);
    return path;
}

static skv_result out_of_memory(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_MEMORY, "lab: out of memory");
}

/* ---- Files ----------------------------------------------------------------------------------- */

/* The bytes of an open file, with a zero behind them; null with errno. The caller frees them. */
static char *read_open(int file, size_t *size)
{
    char *text = malloc(LARGEST_FILE + 1);
    ssize_t count = text ? 1 : -1;
    *size = 0;
    while (count > 0 || (count == -1 && errno == EINTR && text)) {
        count = read(file, text + *size, LARGEST_FILE - *size);
        *size += count > 0 ? (size_t)count : 0;
    }
    if (count == -1) {
        int reason = errno;
        free(text);
        errno = reason;
        return NULL;
    }
    text[*size] = '\0';
    return text;
}

/* The bytes of a file as above; null without a failure if there is no such file. */
static skv_result read_file(const char *path, char **text, size_t *size, skv_error *error)
{
    struct stat status;
    *text = NULL;
    /* Opening a pipe would wait for somebody to write. */
    int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file == -1 && errno == ENOENT)
        return SKV_OK;
    bool usable = file != -1 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                  status.st_size < LARGEST_FILE;
    if (usable)
        *text = read_open(file, size);
    else if (file != -1)
        errno = 0;
    int reason = errno;
    if (file != -1)
        close(file);
    if (*text)
        return SKV_OK;
    if (reason == 0)
        return skv_fail(error, SKV_ERROR_FORMAT,
                        "%s: it is no file that belongs to a study; move it away", path);
    return skv_fail(error, SKV_ERROR_FILE, "%s: cannot be read: %s; make it readable or remove it",
                    path, strerror(reason));
}

/* ---- The study ------------------------------------------------------------------------------- */

skv_result study_of_options(const cli_options *options, skv_study **study, skv_error *error)
{
    skv_study_plan plan = {.settings = options->settings,
                           .setting_count = options->setting_count,
                           .sweeps = options->sweeps,
                           .sweep_count = options->sweep_count,
                           .starts = options->starts};
    *study = NULL;
    if (options->experiment_count != 1)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "lab: a study is of one experiment, but %d are named; name one, see "
                        "'skvalp lab --help'",
                        options->experiment_count);
    skv_result result = skv_experiment_find(options->experiments[0], &plan.experiment, error);
    return result == SKV_OK ? skv_study_create(&plan, study, error) : result;
}

/* Cuts a text into its lines, which stay in it; returns how many there are. */
static int split_lines(char *text, char **lines)
{
    int count = 0;
    for (char *rest; text && *text; text = rest) {
        rest = strchr(text, '\n');
        if (rest)
            *rest++ = '\0';
        if (lines)
            lines[count] = text;
        count++;
    }
    return count;
}

static skv_result study_of_text(char *text, skv_study **study, skv_error *error)
{
    /* As many lines at most as there are line feeds, and one. */
    int most = 1;
    for (const char *at = text; (at = strchr(at, '\n')); at++)
        most++;
    char **lines = calloc((size_t)most, sizeof *lines);
    if (!lines)
        return out_of_memory(error);
    cli_options options;
    int count = split_lines(text, lines);
    skv_result result = options_parse(COMMAND_LAB, count, lines, &options, error);
    if (result == SKV_OK)
        result = study_of_options(&options, study, error);
    options_free(&options);
    free(lines);
    return result;
}

skv_result study_of_folder(const char *folder, skv_study **study, skv_error *error)
{
    char *path = join(folder, NOTE, ""), *text = NULL;
    size_t size = 0;
    *study = NULL;
    if (!path)
        return out_of_memory(error);
    skv_result result = read_file(path, &text, &size, error);
    if (text) {
        skv_error cause = {.code = SKV_OK};
        result = study_of_text(text, study, &cause);
        if (result != SKV_OK)
            skv_fail(error, result, "%s: %s", path, cause.text);
    }
    free(text);
    free(path);
    return result;
}

static void write_note(const cli_options *options, FILE *out)
{
    fprintf(out, "%s\n", options->experiments[0]);
    for (int i = 0; i < options->setting_count; i++)
        fprintf(out, "--set=%s=%s\n", options->settings[i].path, options->settings[i].value);
    for (int i = 0; i < options->sweep_count; i++)
        fprintf(out, "--sweep=%s=%s\n", options->sweeps[i].path, options->sweeps[i].value);
    if (options->starts > 0)
        fprintf(out, "--starts=%d\n", options->starts);
}

skv_result study_keep(const cli_options *options, const skv_study *study, skv_error *error)
{
    const char *folder = options->jobs;
    skv_study *old = NULL;
    skv_result result = study_of_folder(folder, &old, error);
    if (old && !skv_study_is_alike(old, study))
        result = skv_fail(error, SKV_ERROR_VALUE,
                          "%s: it is the folder of another study, see its " NOTE
                          "; name another folder with --jobs",
                          folder);
    skv_study_destroy(old);
    char *path = result == SKV_OK ? join(folder, NOTE, "") : NULL;
    if (result == SKV_OK && !path)
        result = out_of_memory(error);
    output_file file = {0};
    if (result == SKV_OK)
        result = output_file_open(&file, path, error);
    if (result == SKV_OK) {
        write_note(options, file.stream);
        result = output_file_commit(&file, error);
    }
    output_file_discard(&file);
    free(path);
    return result;
}

/* ---- Its runs -------------------------------------------------------------------------------- */

char *study_run_path(const char *folder, const skv_study *study, int run)
{
    char name[SKV_RUN_NAME];
    skv_study_run_name(study, run, name);
    return join(folder, name, ".csv");
}

char *study_picture_path(const char *folder, const skv_study *study)
{
    return join(folder, skv_experiment_info(skv_study_experiment(study))->name, ".svg");
}

skv_result study_read_run(skv_study *study, int run, const char *path, bool *there,
                          skv_error *error)
{
    char *text = NULL;
    size_t size = 0;
    skv_error cause = {.code = SKV_OK};
    skv_result result = read_file(path, &text, &size, error);
    *there = result != SKV_OK || text;
    if (text) {
        result = skv_study_read(study, run, text, size, &cause);
        if (result != SKV_OK)
            skv_fail(error, result, "%s: %s; remove it and run its job again", path, cause.text);
    }
    free(text);
    return result;
}
