/* The folder of a study: a table for each run that is done, and study.txt, which says what was
 * asked for. */
#ifndef CLI_STUDY_FOLDER_H
#define CLI_STUDY_FOLDER_H

#include "options.h"
#include "skvalp/study.h"

/* The study that options ask for: of one experiment, which must be named. */
skv_result study_of_options(const cli_options *options, skv_study **study, skv_error *error);

/* The study that a folder's study.txt asks for. Without such a file *study is null. */
skv_result study_of_folder(const char *folder, skv_study **study, skv_error *error);

/* Writes study.txt, unless the folder is another study's: then its runs would be mixed up. */
skv_result study_keep(const cli_options *options, const skv_study *study, skv_error *error);

/* Where the table of a run is, and where a picture of all goes; null if memory is out. The caller
 * frees them. */
char *study_run_path(const char *folder, const skv_study *study, int run);
char *study_picture_path(const char *folder, const skv_study *study);

/* Takes in the table of a run from its file. False in *there if there is no such file. */
skv_result study_read_run(skv_study *study, int run, const char *path, bool *there,
                          skv_error *error);

#endif
