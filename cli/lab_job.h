/* A job: one run of a study, which leaves its table in a file. */
#ifndef CLI_LAB_JOB_H
#define CLI_LAB_JOB_H

#include "lab_starts.h"
#include "output_file.h"
#include "skvalp/study.h"

enum { MAX_JOB_ROWS = 16 };

/* All zero is no job; every function below but the first accepts it. */
typedef struct lab_job {
    skv_study *study; /* of this run alone */
    const char *name; /* of the file, as the user wrote it */
    output_file file;
    skv_study_row rows[MAX_JOB_ROWS];
    int count;
} lab_job;

/* Opens the file of a job; *done says that the run's table is whole already. Fails if the file is
 * something else. Needs lab_job_close, also on failure. */
skv_result lab_job_open(lab_job *job, const cli_options *options, bool *done, skv_error *error);
/* Adds the next of the experiment's rows. */
void lab_job_add(lab_job *job, const lab_figure *figure);
/* Writes the table once all rows are there. */
skv_result lab_job_commit(lab_job *job, skv_error *error);
void lab_job_close(lab_job *job);

#endif
