/* skvalp, the command line: picks the command and turns its result into an exit status.
 *
 * Invariant: a failure is exactly one line on stderr, "skvalp: place: what; remedy", printed here.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"

static const struct {
    const char *name;
    command which;
    int (*run)(const cli_options *, skv_error *);
} commands[] = {
    {"run", COMMAND_RUN, run_command},       {"scenes", COMMAND_SCENES, scenes_command},
    {"check", COMMAND_CHECK, check_command}, {"bench", COMMAND_BENCH, bench_command},
    {"lab", COMMAND_LAB, lab_command},       {"replay", COMMAND_REPLAY, replay_command},
    {"share", COMMAND_SHARE, share_command},
};
enum { COMMAND_COUNT = (int)(sizeof commands / sizeof commands[0]) };

static int run_one(const char *program, int index, int count, char **arguments, skv_error *error)
{
    cli_options options;
    int status = STATUS_BAD;
    if (options_parse(commands[index].which, count, arguments, &options, error) == SKV_OK) {
        options.program = program;
        if (options.help) {
            help_print_command(commands[index].which);
            status = STATUS_DONE;
        } else {
            status = commands[index].run(&options, error);
        }
    }
    options_free(&options);
    return status;
}

static int find_command(const char *name)
{
    int index = COMMAND_COUNT - 1;
    while (index >= 0 && strcmp(commands[index].name, name) != 0)
        index--;
    return index;
}

static int help(int count, char **arguments, skv_error *error)
{
    int index = count > 0 ? find_command(arguments[0]) : -1;
    if (index >= 0) {
        help_print_command(commands[index].which);
    } else if (count > 0 && strcmp(arguments[0], "set") == 0) {
        help_print_settings();
    } else if (count > 0) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "help: there is none on '%s'; say help run, help scenes, help check, help bench, "
                 "help lab, help replay, help share or help set",
                 arguments[0]);
        return STATUS_BAD;
    } else {
        help_print();
    }
    return STATUS_DONE;
}

static int unknown_command(const char *name, skv_error *error)
{
    static const char *const names[] = {"run", "scenes", "check", "bench",
                                        "lab", "replay", "share", "help"};
    if (!*name) {
        skv_fail(error, SKV_ERROR_VALUE, "the command is empty; see 'skvalp --help'");
        return STATUS_BAD;
    }
    const char *nearest = skv_nearest_name(name, names, (int)(sizeof names / sizeof names[0]));
    if (nearest) {
        skv_fail(error, SKV_ERROR_VALUE, "%s: no such command; did you mean %s?", name, nearest);
    } else {
        skv_fail(error, SKV_ERROR_VALUE, "%s: no such command; see 'skvalp --help'", name);
    }
    return STATUS_BAD;
}

static int dispatch(int count, char **arguments, skv_error *error)
{
    if (count < 2) {
        skv_fail(error, SKV_ERROR_VALUE,
                 "no command; say for example 'skvalp run dam-break', or see "
                 "'skvalp --help'");
        return STATUS_BAD;
    }
    const char *name = arguments[1];
    int index = find_command(name);
    if (index >= 0)
        return run_one(arguments[0], index, count - 2, arguments + 2, error);
    if (strcmp(name, "help") == 0 || strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0)
        return help(count - 2, arguments + 2, error);
    if (strcmp(name, "--version") == 0) {
        printf("skvalp %s\n", skv_version());
        return STATUS_DONE;
    }
    return unknown_command(name, error);
}

int main(int count, char **arguments)
{
    /* With a standard stream closed, the next file opened would take its place. */
    while (fcntl(STDERR_FILENO, F_GETFD) == -1 || fcntl(STDOUT_FILENO, F_GETFD) == -1 ||
           fcntl(STDIN_FILENO, F_GETFD) == -1) {
        if (open("/dev/null", O_RDONLY) == -1)
            return STATUS_BAD;
    }
    skv_error error = {.code = SKV_OK};
    int status = dispatch(count, arguments, &error);
    if (status == STATUS_DONE && (fflush(stdout) != 0 || ferror(stdout))) {
        skv_fail(&error, SKV_ERROR_FILE, "standard output: %s; send it elsewhere", strerror(errno));
        status = STATUS_BAD;
    }
    if (status != STATUS_DONE)
        fprintf(stderr, "skvalp: %s\n", error.text);
    return status;
}
