/* Running an experiment and reporting on it.
 *
 * Invariant: a row is judged from what measure() and expect() have said, by this file alone; an
 * experiment cannot pass itself.
 */
#include "experiments/experiment.h"

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "base/more.h"

#include <math.h>

struct skv_report {
    const experiment *experiment;
    findings found;
    skv_lab_row rows[MAX_QUANTITIES];
};

/* The experiment of a number, to be run; null if there is none, or it comes with more. */
static const experiment *find(int number, skv_error *error)
{
    const experiment *e = skv_experiment_at(number);
    if (!e)
        skv_fail(error, SKV_ERROR_VALUE, "lab: there is no experiment %d", number);
#ifdef SKV_WITHOUT_EXPERIMENTS_BESIDE
    else if (!e->measure) {
        skv_want_more(error);
        return NULL;
    }
#endif
    return e;
}

/* ---- The set-up ------------------------------------------------------------------------------ */

/* Lets an experiment go as far as its plan, or as the outline of it. */
static void sketch(rig *s, const experiment *e, const skv_lab_options *options, bool outline,
                   rig_plan *plan, skv_error *error)
{
    findings found = {0};
    *plan = (rig_plan){0};
    skv_rig_open(s, e, options, &found, error);
    s->sketch = plan;
    s->outline = outline;
    e->measure(s, &found);
    skv_findings_free(&found);
    s->found = NULL;
}

/* What the setting `particles` has to be for a chosen number in the world, of which there are
 * `*share` times as many. */
static double setting_for(const experiment *e, const skv_lab_options *options, int chosen,
                          double *share)
{
    const skv_field *field = skv_lab_parameter(PARAM_PARTICLES);
    rig_plan plan;
    rig set_up;
    skv_error unused;
    sketch(&set_up, e, options, true, &plan, &unused);
    *share = plan.share > 0 ? plan.share : 1;
    double wanted = set_up.settings.common[PARAM_PARTICLES];
    if (chosen > 0)
        wanted = (chosen + 0.5) / *share; /* which is rounded down when it is multiplied */
    wanted = fmax(wanted, fmax(set_up.enough, field->minimum));
    skv_rig_close(&set_up);
    return fmin(wanted, field->maximum);
}

int skv_experiment_particles(int number, int chosen)
{
    const experiment *e = skv_experiment_at(number);
    double share;
    if (!e || !e->measure)
        return 0;
    double setting = setting_for(e, NULL, chosen, &share);
    return (int)floor(setting * share);
}

skv_result skv_experiment_scene(int number, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(write, SKV_ERROR_VALUE);
    const experiment *e = find(number, error);
    if (!e)
        return SKV_ERROR_VALUE;
    rig_plan plan;
    rig set_up;
    sketch(&set_up, e, NULL, false, &plan, error);
    if (skv_rig_ok(&set_up) || set_up.result == SKV_STOPPED)
        set_up.result = skv_rig_write(&set_up, write, user, error);
    return skv_rig_close(&set_up);
}

/* ---- The run --------------------------------------------------------------------------------- */

skv_result skv_experiment_measure(const experiment *e, const skv_lab_options *options,
                                  findings *found, skv_error *error)
{
    *found = (findings){
        .plot = {.title = e->info.title, .x_label = e->info.x_label, .y_label = e->info.y_label}};
    rig set_up;
    double unused;
    skv_rig_open(&set_up, e, options, found, error);
    if (skv_rig_ok(&set_up) && options && options->particles > 0)
        set_up.settings.common[PARAM_PARTICLES] =
            setting_for(e, options, options->particles, &unused);
    e->measure(&set_up, found);
    if (skv_rig_ok(&set_up)) {
        found->particles = set_up.particles;
        bool beside = set_up.own_substeps > 0;
        found->substeps = beside ? set_up.own_substeps : skv_world_substeps_per_frame(set_up.world);
        found->spacing = set_up.spacing;
        found->seconds = beside ? set_up.own_seconds : set_up.done;
        found->pace = skv_rig_pace(&set_up);
        found->speed = skv_rig_speed(&set_up);
    }
    return skv_rig_close(&set_up);
}

void skv_findings_free(findings *found)
{
    skv_plot_free(&found->plot);
}

static double rms_deviation(const double *a, const double *b, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum / count);
}

void skv_experiment_judge(const experiment *e, const findings *found, const expectation *expected,
                          skv_lab_row *rows)
{
    const double unit[] = {1, found->spacing, found->pace, found->speed}; /* by allowance */
    for (int i = 0; i < e->count; i++) {
        const quantity *q = &e->quantities[i];
        skv_lab_row *row = &rows[i];
        *row = (skv_lab_row){
            .experiment = e->info.name,
            .quantity = q->name,
            .unit = q->unit,
            .measured = found->measured[i],
            .theory = expected->theory[i],
            .ratio = (double)NAN,
            .tolerance = q->tolerance * unit[q->allowance],
        };
        if (q->points > 0) {
            row->measured = rms_deviation(found->point, expected->point, q->points);
            row->theory = 0;
        }
        double miss = row->measured;
        if (row->theory != 0) {
            row->ratio = row->measured / row->theory;
            miss = row->ratio - 1;
            if (q->allowance == IN_SPACINGS)
                row->tolerance /= row->theory;
        }
        /* A NaN does not pass. */
        row->pass = fabs(miss) <= row->tolerance;
    }
}

skv_result skv_experiment_run(int number, const skv_lab_options *options, skv_report **out,
                              skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = NULL;
    skv_lab_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_lab_options(options, &own), SKV_ERROR_VALUE);
    const experiment *e = find(number, error);
    if (!e)
        return SKV_ERROR_VALUE;
    skv_report *report = skv_calloc(1, sizeof *report);
    if (!report)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a report");
    report->experiment = e;
    skv_result result = skv_experiment_measure(e, options, &report->found, error);
    if (result == SKV_OK) {
        expectation expected = {0};
        e->expect(report->found.condition, &expected, &report->found.plot);
        skv_experiment_judge(e, &report->found, &expected, report->rows);
        if (report->found.plot.failed)
            result = skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a plot");
    }
    if (result != SKV_OK) {
        skv_report_destroy(report);
        return result;
    }
    *out = report;
    return SKV_OK;
}

void skv_report_destroy(skv_report *report)
{
    if (!report)
        return;
    skv_findings_free(&report->found);
    skv_free(report);
}

const skv_lab_row *skv_report_row(const skv_report *report, int i)
{
    SKV_ASSERT_OR(report, NULL);
    return i >= 0 && i < report->experiment->count ? &report->rows[i] : NULL;
}

void skv_report_facts(const skv_report *report, int *particles, double *spacing, int *substeps,
                      double *seconds)
{
    SKV_ASSERT(report && particles && spacing && substeps && seconds);
    *particles = report->found.particles;
    *spacing = report->found.spacing;
    *substeps = report->found.substeps;
    *seconds = report->found.seconds;
}

bool skv_report_curve(const skv_report *report, int i, skv_curve *out)
{
    SKV_ASSERT_OR(report && out, false);
    if (i < 0 || i >= report->found.plot.count)
        return false;
    *out = skv_plot_curve(&report->found.plot, i);
    return true;
}

skv_result skv_report_plot(const skv_report *report, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(report && write, SKV_ERROR_VALUE);
    return skv_plot_write_svg(&report->found.plot, write, user, error);
}

skv_result skv_report_csv(const skv_report *report, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(report && write, SKV_ERROR_VALUE);
    return skv_plot_write_csv(&report->found.plot, write, user, error);
}
