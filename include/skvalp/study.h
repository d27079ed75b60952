/** @file
 * Studies: an experiment, run for every combination of values of some of its parameters.
 *
 * A study knows its runs by number: what each is called, with which settings it runs, and the table
 * that it leaves. It runs none itself, so that many machines can share them, and reads their tables
 * into one, in its own order.
 */
#ifndef SKVALP_STUDY_H
#define SKVALP_STUDY_H

#include "skvalp/experiments.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Most parameters that a study sweeps; with them the name of a run still fits a file system. */
#define SKV_MAX_SWEEPS 4
/** Most runs of a study. */
#define SKV_MAX_RUNS 100000
/** Room for the name of any run, and for what stands behind it in the name of its file. */
#define SKV_RUN_NAME 256

/** What a study is of. A plain value: every member counts, and 0 does nothing. */
typedef struct skv_study_plan {
    int experiment;              /**< as in skv_experiment_info */
    const skv_setting *settings; /**< of all runs; of a path given twice the last one counts */
    int setting_count;
    /** What is swept, the last of them fastest. A value is a list, "1,2,5", or "FROM:TO:NUMBER":
     * that many numbers from one to the other, in equal steps to twelve digits. */
    const skv_setting *sweeps;
    int sweep_count;
    int starts; /**< that every run is to have; 0: as many as the experiment needs */
} skv_study_plan;

typedef struct skv_study skv_study;

/** A row of a run's table: a measured quantity, over several starts. */
typedef struct skv_study_row {
    skv_lab_row row; /**< numbers are means */
    int starts, passed;
    double measured_deviation, ratio_deviation; /**< NaN for a single start */
} skv_study_row;

/** Checks a plan and counts its runs. The texts of the plan are copied. Fails with SKV_ERROR_VALUE,
 * naming the path and what is allowed (no such parameter, one of another experiment, a value out of
 * its range or given twice), or SKV_ERROR_LIMIT (more than SKV_MAX_SWEEPS or SKV_MAX_RUNS). */
SKV_API skv_result skv_study_create(const skv_study_plan *plan, skv_study **study,
                                    skv_error *error);
SKV_API void skv_study_destroy(skv_study *study);

/** The number of its experiment. */
SKV_API int skv_study_experiment(const skv_study *study);
/** How many runs there are, at least one. */
SKV_API int skv_study_runs(const skv_study *study);
/** The name of a run, which follows from its values: "dam-break,fluid.viscosity=0.01". It holds
 * letters, digits and the signs . _ - + = and comma. */
SKV_API void skv_study_run_name(const skv_study *study, int run, char name[SKV_RUN_NAME]);
/** The i-th setting of a run, those of all runs first; false past the last. Numbers are written in
 * the fewest digits that read back to the same bits. The texts are the study's. */
SKV_API bool skv_study_run_setting(const skv_study *study, int run, int i, skv_setting *setting);
/** Whether two studies differ in the values of what they sweep at most, so that their runs of the
 * same name are the same. */
SKV_API bool skv_study_is_alike(const skv_study *study, const skv_study *other);

/** Writes the table of a run as CSV: a line of names, and a line for each of the experiment's
 * quantities, in their order. A number that is none is empty. Fails with SKV_ERROR_FILE. */
SKV_API skv_result skv_study_write(const skv_study *study, int run, const skv_study_row *rows,
                                   skv_write *write, void *user, skv_error *error);
/** Takes in a run's table, as skv_study_write wrote it. Fails with SKV_ERROR_FORMAT, naming the
 * line, if the text is cut, changed or another run's. */
SKV_API skv_result skv_study_read(skv_study *study, int run, const char *text, size_t size,
                                  skv_error *error);
/** Writes what was taken in as one table, in the order of the runs. */
SKV_API skv_result skv_study_table(const skv_study *study, skv_write *write, void *user,
                                   skv_error *error);
/** Draws what was taken in as one SVG picture: a panel for each quantity and each combination of
 * what is swept besides the first parameter that is a number, along which measurement and theory
 * stand. Fails with SKV_ERROR_VALUE if no number is swept, SKV_ERROR_LIMIT if there would be too
 * many panels, SKV_ERROR_FILE or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_study_plot(const skv_study *study, skv_write *write, void *user,
                                  skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
