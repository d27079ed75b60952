/* An experiment: measuring, theory and judging kept apart.
 *
 * measure() runs the world and writes down what the instruments read, and beside it the conditions:
 * what was set up, and where and when it was measured. expect() gets the conditions alone and says
 * what the textbook predicts for them. judge() compares. Neither side sees the other's numbers.
 */
#ifndef SKV_EXPERIMENTS_EXPERIMENT_H
#define SKV_EXPERIMENTS_EXPERIMENT_H

#include "experiments/list.h"
#include "experiments/plot.h"
#include "experiments/rig.h"

enum { MAX_QUANTITIES = 8, MAX_CONDITIONS = 16, MAX_POINTS = 16 };

/* What a tolerance is multiplied with. */
typedef enum allowance {
    AS_WRITTEN,
    IN_SPACINGS, /* of the particles, m, also where the theory is a length */
    BY_PACE,     /* a time at scale 1 under 9.81 m/s^2; see skv_rig_pace */
    BY_SPEED,    /* a speed there; see skv_rig_speed */
} allowance;

/* One measured quantity. */
typedef struct quantity {
    const char *name, *unit;
    double tolerance; /* of the ratio, or in `unit` where the theory is 0 */
    allowance allowance;
    int points; /* above 0: the quantity is the rms deviation of that many points of a curve */
} quantity;

struct findings {
    double measured[MAX_QUANTITIES];
    double point[MAX_POINTS]; /* of a curve that is judged as a whole */
    double condition[MAX_CONDITIONS];
    bool foreseen; /* the conditions are known before the end: theory may be drawn */
    skv_plot plot;
    int particles, substeps;
    double spacing, seconds;
    double pace, speed; /* of the rig */
};

typedef struct expectation {
    double theory[MAX_QUANTITIES];
    double point[MAX_POINTS];
} expectation;

struct experiment {
    skv_experiment info;
    /* Its own parameters, numbers all of them, with paths that begin with its name; ends with an
     * empty one. */
    skv_field parameters[MAX_OWN + 1];
    int count;
    quantity quantities[MAX_QUANTITIES];
    void (*measure)(rig *rig, findings *found);
    /* Says what theory predicts, and adds its curves to the plot. */
    void (*expect)(const double *condition, expectation *expected, skv_plot *plot);
};

/* What an experiment beside does, and the rows and parameters that it has. A first visit to the
 * page has room for its card, and no more: there these are null and empty, and who wants it run
 * gets the larger module (web/CMakeLists.txt). */
#ifdef SKV_WITHOUT_EXPERIMENTS_BESIDE
#define SKV_BESIDE(function) (0 ? (function) : NULL)
#define SKV_BESIDE_ROWS(...) {{0}}
#else
#define SKV_BESIDE(function) (function)
#define SKV_BESIDE_ROWS(...) {__VA_ARGS__}
#endif

#define DECLARE(name) extern const experiment skv_exp_##name;
SKV_EXPERIMENTS(DECLARE)
#undef DECLARE

/* The i-th, null past the last. */
const experiment *skv_experiment_at(int i);

/* Runs measure() on a fresh rig. `found` needs skv_findings_free afterwards, also on failure. */
skv_result skv_experiment_measure(const experiment *e, const skv_lab_options *options,
                                  findings *found, skv_error *error);
void skv_findings_free(findings *found);

/* Compares; writes e->count rows. */
void skv_experiment_judge(const experiment *e, const findings *found, const expectation *expected,
                          skv_lab_row *rows);

#endif
