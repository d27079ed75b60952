/* Studies: what `lab` does for --jobs and --gather. */
#ifndef CLI_COMMAND_STUDY_H
#define CLI_COMMAND_STUDY_H

#include "options.h"

/* Whether the options of studies fit together, and with the others of `lab`. */
skv_result study_check(const cli_options *options, skv_error *error);
/* Lists the jobs of a study, or gathers their tables. Returns the exit status. */
int study_command(const cli_options *options, skv_error *error);

#endif
