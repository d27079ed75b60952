/* Dam break: a column twice as high as wide collapses on a dry floor.
 *
 * The column settles for three seconds behind a gate, which is then gone. The front is the farthest
 * fluid along the floor, a spacing above it; it is read at the times of Martin and Moyce's points,
 * and compared with an ideal liquid's at the same height.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 3, MAX_SAMPLES = 600 };
enum { WIDTH };
enum { C_HEIGHT }; /* of the gauge, in widths of the column */

#define ASPECT 2.0
#define PASSED 2.0 /* the front's place, in widths, whose time is a row of its own */
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

/* When the front first is so far; NaN if it never is. */
static double time_at(const double *times, const double *fronts, int count, double front)
{
    for (int i = 1; i < count; i++) {
        if (fronts[i] >= front && fronts[i - 1] < front) {
            double share = (front - fronts[i - 1]) / (fronts[i] - fronts[i - 1]);
            return times[i - 1] + share * (times[i] - times[i - 1]);
        }
    }
    return (double)NAN;
}

static skv_instrument build(rig *s, double a)
{
    rig_plan plan = {.width = LENGTH * a,
                     .height = 1.5 * ASPECT * a,
                     .solids = 1,
                     .solid = {skv_shape_box(a, -1, 1.3 * a, 2 * ASPECT * a)},
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, a, ASPECT * a)},
                     .depth = ASPECT * a,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, WIDTH, 1);
    skv_rig_wait(s, WAIT);
    plan.solids = 0;
    skv_rig_rebuild(s, &plan);
    return skv_rig_add(s, SKV_INSTRUMENT_LEVEL, 0.2 * a, s->spacing, LENGTH * a, s->spacing, 0);
}

typedef struct column {
    skv_instrument gauge;
    double width, unit; /* m; of T, s */
} column;

/* Times are from the first sample on, when the wall vanishes. */
static int read_front(const rig *s, const column *c, double *times, double *fronts)
{
    int count = skv_rig_history(s, c->gauge, 1, times, fronts, MAX_SAMPLES);
    double start = count > 0 ? times[0] : 0;
    for (int i = 0; i < count; i++)
        times[i] -= start;
    return count;
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    const column *c = set_up;
    double times[MAX_SAMPLES], fronts[MAX_SAMPLES];
    int count = read_front(s, c, times, fronts);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i] / c->unit, fronts[i] / c->width);
}

static void measure(rig *s, findings *found)
{
    double a = skv_rig_length(s, WIDTH);
    double unit = sqrt(a / skv_rig_gravity(s) / ASPECT); /* of T, s */
    double watch = (skv_theory_dam[DAM_POINTS - 1].time + 0.1) * unit;
    s->total = WAIT + watch;
    column c = {build(s, a), a, unit};
    found->condition[C_HEIGHT] = s->spacing / a;
    found->foreseen = true;
    skv_rig_show(s, draw, &c);
    skv_rig_sample(s);
    skv_rig_watch(s, watch + 1.0 / 60);
    skv_rig_draw(s);
    double times[MAX_SAMPLES], fronts[MAX_SAMPLES];
    int count = read_front(s, &c, times, fronts);
    for (int i = 0; i < DAM_POINTS; i++)
        found->point[i] = front_at(times, fronts, count, skv_theory_dam[i].time * unit) / a;
    found->measured[1] = time_at(times, fronts, count, PASSED * a) / unit;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double times[DAM_POINTS];
    skv_plot_begin(plot, "ideal liquid", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, 1);
    for (int i = 0; i < DAM_POINTS; i++) {
        times[i] = skv_theory_dam[i].time;
        expected->point[i] = skv_theory_dam_front(i, condition[C_HEIGHT]);
        skv_plot_point(plot, times[i], expected->point[i]);
    }
    expected->theory[1] = time_at(times, expected->point, DAM_POINTS, PASSED);
    skv_plot_begin(plot, "Martin and Moyce 1952, T less 0.26", SKV_CURVE_RINGS);
    for (int i = 0; i < DAM_POINTS; i++)
        skv_plot_point(plot, times[i] - DAM_LATE, skv_theory_dam[i].measured);
}

const experiment skv_exp_dam_break = {
    .info =
        {
            .name = "dam-break",
            .title = "Dam break",
            .description =
                "A column of water collapses on a dry floor: where its front is, and when.",
            .question = "How fast does the front of a collapsing column of water run?",
            .predict = "When has the front gone as far as the column is high? Does a larger column "
                       "arrive earlier or later?",
            .measure = "A column twice as high as wide stands beside a wall that vanishes. A gauge "
                       "reads how far the water on the floor has come.",
            .compare = "Lengths in column widths and times in sqrt(a / 2g) make all sizes alike. "
                       "The dashed curve is the front of an ideal liquid, released at once, at the "
                       "gauge's height. The rings are the experiment of Martin and Moyce (1952), "
                       "whose diaphragm of wax had to melt: moved to earlier times by 0.26 in T, "
                       "it lies on the ideal liquid's curve.",
            .x_label = "T = t sqrt(2 g / a)",
            .y_label = "front Z = x / a",
        },
    .parameters =
        {
            [WIDTH] = {"dam-break.width", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.3",
                       "width of the column; it is twice as high"},
        },
    .count = 2,
    .quantities = {{"front Z(T), rms deviation", "", 0.03, AS_WRITTEN, DAM_POINTS},
                   {"T when Z = 2", "", 0.05, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
