/** @file
 * Experiments: worlds that are measured and set against the textbook.
 *
 * An experiment builds a world of its own, reads it with the instruments of skvalp/measure.h and
 * compares the readings with theory. Units are SI, as there.
 */
#ifndef SKVALP_EXPERIMENTS_H
#define SKVALP_EXPERIMENTS_H

#include "skvalp/base.h"
#include "skvalp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An experiment: a world, what is measured in it, and what the textbook says. */
typedef struct skv_experiment {
    const char *name;        /**< "u-tube" */
    const char *title;       /**< "U-tube" */
    const char *description; /**< one or two sentences */
} skv_experiment;

/** The experiments in the order in which they are presented; null past the last. Static. */
SKV_API const skv_experiment *skv_experiment_info(int i);

/** The parameters of the experiments in documentation order; null past the last. Static. A path
 * without a dot and those that begin with "fluid." concern all experiments (the latter are those of
 * scenes), the others the one they name. */
SKV_API const skv_field *skv_lab_parameter(int i);

/** Told about an experiment's progress, 0..1; return false to stop it, which skv_experiment_run
 * reports as SKV_STOPPED. */
typedef bool skv_lab_progress(double share, void *user);

/** How to run an experiment. Initialise with skv_default_lab_options. */
typedef struct skv_lab_options {
    const skv_setting *settings; /**< applied in order */
    int setting_count;
    int threads; /**< as in skv_world_def */
    skv_lab_progress *progress;
    void *user;
    int cookie;
} skv_lab_options;

SKV_API skv_lab_options skv_default_lab_options(void);

/** Checks settings without running anything: SKV_ERROR_VALUE names the path and what is allowed. */
SKV_API skv_result skv_lab_check(const skv_lab_options *options, skv_error *error);

/** One measured quantity and what it was expected to be. */
typedef struct skv_lab_row {
    const char *experiment;
    const char *quantity;
    const char *unit;
    double measured, theory; /**< in `unit` */
    double ratio;            /**< measured/theory; NaN where the theory is 0 */
    /** Allowed: |ratio - 1|, or, where the theory is 0, |measured| in `unit`. */
    double tolerance;
    bool pass;
} skv_lab_row;

typedef struct skv_report skv_report;

/** Runs one experiment: seconds to half a minute. The worlds are its own; reports of the same
 * options are the same. `options` may be null. Fails with SKV_ERROR_VALUE if a setting is wrong or
 * the set-up cannot be built from it (a tube narrower than the fluid's spacing allows). */
SKV_API skv_result skv_experiment_run(int experiment, const skv_lab_options *options,
                                      skv_report **report, skv_error *error);
SKV_API void skv_report_destroy(skv_report *report);

/** The rows of a report; null past the last. Owned by the report. */
SKV_API const skv_lab_row *skv_report_row(const skv_report *report, int i);
/** What was run: particles at the start, their spacing (m), substeps a frame, simulated seconds. */
SKV_API void skv_report_facts(const skv_report *report, int *particles, double *spacing,
                              int *substeps, double *seconds);
/** Writes the measured curve with the theory over it as an SVG picture. */
SKV_API skv_result skv_report_plot(const skv_report *report, skv_write *write, void *user,
                                   skv_error *error);
/** Writes the points of that picture as CSV: series,x,y. */
SKV_API skv_result skv_report_csv(const skv_report *report, skv_write *write, void *user,
                                  skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
