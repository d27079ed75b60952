/* Dam break: a column twice as high as wide collapses on a dry floor.
 *
 * The column settles for three seconds behind a gate, which is then gone. The front is the farthest
 * fluid along the floor, half a spacing above it; the time is read at Martin and Moyce's points.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 3, MAX_SAMPLES = 600 };
enum { WIDTH };

#define ASPECT 2.0
#define LENGTH 6.0 /* of the floor, in widths of the column */

/* The front at a time, linear between samples; NaN beyond them. */
static double front_at(const double *times, const double *fronts, int count, double time)
{
    for (int i = 1; i < count; i++) {
        if (times[i] >= time && times[i - 1] <= time) {
            double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
            return fronts[i - 1] + share * (fronts[i] - fronts[i - 1]);
        }
    }
    return (double)NAN;
}

static skv_instrument build(stage *s, double a)
{
    stage_plan plan = {.width = LENGTH * a,
                       .height = 1.5 * ASPECT * a,
                       .solids = 1,
                       .solid = {skv_shape_box(a, -1, 1.3 * a, 2 * ASPECT * a)},
                       .waters = 1,
                       .water = {skv_shape_box(0, 0, a, ASPECT * a)},
                       .depth = ASPECT * a,
                       .gravity_y = -skv_stage_gravity(s)};
    skv_stage_build(s, &plan);
    skv_stage_check_passage(s, WIDTH, 1);
    skv_stage_wait(s, WAIT);
    plan.solids = 0;
    skv_stage_rebuild(s, &plan);
    return skv_stage_add(s, SKV_INSTRUMENT_LEVEL, 0.2 * a, s->spacing, LENGTH * a, s->spacing, 0);
}

static void measure(stage *s, findings *found)
{
    double a = skv_stage_length(s, WIDTH);
    double unit = sqrt(a / skv_stage_gravity(s) / ASPECT); /* of T, s */
    double watch = (skv_theory_dam[DAM_POINTS - 1].time + 0.1) * unit;
    s->total = WAIT + watch;
    skv_instrument gauge = build(s, a);
    skv_stage_sample(s);
    skv_stage_watch(s, watch + 1.0 / 60);
    double times[MAX_SAMPLES], fronts[MAX_SAMPLES];
    int count = skv_stage_history(s, gauge, 1, times, fronts, MAX_SAMPLES);
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i] / unit, fronts[i] / a);
    for (int i = 0; i < DAM_POINTS; i++)
        found->point[i] = front_at(times, fronts, count, skv_theory_dam[i].time * unit) / a;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    (void)condition; /* in units of the column, the experiment has none */
    skv_plot_begin(plot, "Martin and Moyce 1952", CURVE_THEORY);
    for (int i = 0; i < DAM_POINTS; i++) {
        expected->point[i] = skv_theory_dam[i].front;
        skv_plot_point(plot, skv_theory_dam[i].time, skv_theory_dam[i].front);
    }
}

const experiment skv_exp_dam_break = {
    .info = {"dam-break", "Dam break",
             "A column of water collapses on a dry floor: where its front is, and when."},
    .parameters =
        {
            [WIDTH] = {"dam-break.width", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.3",
                       "width of the column; it is twice as high"},
        },
    .x_label = "T = t sqrt(2 g / a)",
    .y_label = "front Z = x / a",
    .count = 1,
    .quantities = {{"front Z(T), rms deviation", "", 0.1, false, DAM_POINTS}},
    .measure = measure,
    .expect = expect,
};
