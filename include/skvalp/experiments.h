/** @file
 * Experiments: worlds that are measured and set against the textbook.
 *
 * An experiment builds a world of its own, reads it with the instruments of skvalp/measure.h and
 * compares the readings with theory. Units are SI, as there.
 */
#ifndef SKVALP_EXPERIMENTS_H
#define SKVALP_EXPERIMENTS_H

#include "skvalp/base.h"
#include "skvalp/frame.h"
#include "skvalp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An experiment: a world, what is measured in it, and what the textbook says. Its texts are those
 * of a card that a class works through from the top: plain text, one paragraph each. */
typedef struct skv_experiment {
    const char *name;        /**< "u-tube" */
    const char *title;       /**< "U-tube" */
    const char *description; /**< one or two sentences */
    const char *question;    /**< what is to be found out */
    const char *predict;     /**< what to write down before it runs */
    const char *measure;     /**< how it is measured here */
    const char *compare;     /**< what theory says, and what to make of the difference */
    const char *x_label;     /**< of its plot, with the unit: "time (s)" */
    const char *y_label;
    /** Its rows differ so much from one slightly different start to the next that a single run says
     * little: look at several (`skvalp lab` takes eight). */
    bool scatters;
} skv_experiment;

/** The experiments in the order in which they are presented; null past the last. Static. */
SKV_API const skv_experiment *skv_experiment_info(int i);

/** The number of the experiment with a name; SKV_ERROR_VALUE if there is none. */
SKV_API skv_result skv_experiment_find(const char *name, int *found, skv_error *error);

/** Writes the set-up of an experiment as the text of a scene to play with: its walls, its water and
 * its fluid as they are when measuring begins. What else drives it, a hand, a spin, is left out.
 * Takes about as long as making its world. Fails with SKV_ERROR_VALUE (no such experiment),
 * SKV_ERROR_FILE (`write` returned false) or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_experiment_scene(int i, skv_write *write, void *user, skv_error *error);

/** With how many particles the world of an experiment begins where that many are chosen: with more
 * where its narrowest passage needs them, and within the range of the setting `particles`. 0
 * chosen: as it says itself. 0 if there is no such experiment. */
SKV_API int skv_experiment_particles(int i, int chosen);

/** The parameters of the experiments in documentation order; null past the last. Static. A path
 * without a dot and those that begin with "fluid." concern all experiments (the latter are those of
 * scenes), the others the one they name. */
SKV_API const skv_field *skv_lab_parameter(int i);

/** How a curve is meant to be drawn. */
typedef enum skv_curve_style {
    SKV_CURVE_DOTS,
    SKV_CURVE_RINGS,
    SKV_CURVE_LINE,
    SKV_CURVE_THEORY /**< a dashed line: what the textbook says */
} skv_curve_style;

/** A curve of an experiment's plot: `count` points. */
typedef struct skv_curve {
    const char *label;
    skv_curve_style style;
    int count;
    const double *x, *y;
} skv_curve;

/** A moment of an experiment that runs, for whoever shows it: valid during the call. */
typedef struct skv_lab_moment {
    double share;            /**< how far it is, 0..1 */
    const skv_frame *frame;  /**< its world */
    const skv_curve *curves; /**< what has been measured, and the theory as far as it is known */
    int curve_count;
} skv_lab_moment;

/** Told about an experiment after each of its frames of 1/60 s; it may take its time. Return false
 * to stop it, which skv_experiment_run reports as SKV_STOPPED. */
typedef bool skv_lab_observer(const skv_lab_moment *moment, void *user);

/** How to run an experiment. Initialise with skv_default_lab_options. */
typedef struct skv_lab_options {
    uint32_t cookie;
    const skv_setting *settings; /**< applied in order */
    int setting_count;
    int threads;               /**< as in skv_world_def */
    skv_lab_observer *observe; /**< null: nobody */
    void *user;                /**< handed to it */
    int particles; /**< what a person chose: its world begins with skv_experiment_particles of it,
                      whatever the settings say; 0: as they say */
} skv_lab_options;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_lab_options skv_default_lab_options(void);
SKV_API void skv_lab_options_init(skv_lab_options *def, size_t size);

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
/** A curve of the report's plot; false past the last. Owned by the report. */
SKV_API bool skv_report_curve(const skv_report *report, int i, skv_curve *curve);
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
