/* The commands. Each returns the exit status: 0 done, 1 a check failed, 2 bad usage or bad input;
 * `error` holds the line for stderr unless it is 0. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

#include "options.h"

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_BAD = 2 };

int run_command(const cli_options *options, skv_error *error);
int scenes_command(const cli_options *options, skv_error *error);
int check_command(const cli_options *options, skv_error *error);
int bench_command(const cli_options *options, skv_error *error);
int replay_command(const cli_options *options, skv_error *error);
int share_command(const cli_options *options, skv_error *error);
int lab_command(const cli_options *options, skv_error *error);

/* Help: of the program, of a command, of the fields that --set changes. */
void help_print(void);
void help_print_command(command which);
void help_print_settings(void);
/* The experiments and their parameters. */
void help_print_lab(void);

/* "skvalp: note: ..." on stderr for everything that loading a scene has to say. */
void print_notices(const skv_scene *scene);

#endif
