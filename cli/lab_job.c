/* Does one run of a study.
 *
 * Invariant: the file has its name only with the whole table in it, and a table that is there is
 * never written again; so a job may be killed, and run twice, at any time.
 */
#include "lab_job.h"

#include "study_folder.h"

skv_result lab_job_open(lab_job *job, const cli_options *options, bool *done, skv_error *error)
{
    *job = (lab_job){.name = options->job};
    *done = false;
    skv_result result = study_of_options(options, &job->study, error);
    if (result == SKV_OK)
        result = study_read_run(job->study, 0, options->job, done, error);
    if (result == SKV_OK && !*done)
        result = output_file_open(&job->file, options->job, error);
    return result;
}

void lab_job_add(lab_job *job, const lab_figure *figure)
{
    if (!job->study || job->count == MAX_JOB_ROWS)
        return;
    job->rows[job->count++] = (skv_study_row){
        .row = figure->row,
        .starts = figure->starts,
        .passed = figure->passed,
        .measured_deviation = lab_deviation(figure->measured_squares, figure->starts),
        .ratio_deviation = lab_deviation(figure->ratio_squares, figure->starts),
    };
}

static skv_result write_table(lab_job *job, skv_error *error)
{
    /* What could not be written is named by commit, with the system's reason. */
    skv_study_write(job->study, 0, job->rows, output_file_take, &job->file, NULL);
    return output_file_commit(&job->file, error);
}

skv_result lab_job_commit(lab_job *job, skv_error *error)
{
    if (!job->study)
        return SKV_OK;
    skv_result result = write_table(job, error);
    if (result == SKV_OK)
        return result;
    /* In a common folder a machine that sees no locks of others takes their temporary files for
     * those of dead programs. The rows are still here: once more. */
    result = output_file_open(&job->file, job->name, error);
    return result == SKV_OK ? write_table(job, error) : result;
}

void lab_job_close(lab_job *job)
{
    output_file_discard(&job->file);
    skv_study_destroy(job->study);
    job->study = NULL;
}
