/* U-tube: a liquid column swings between two arms.
 *
 * The difference of the levels is held by tilting gravity until the water is calm; then gravity
 * turns upright. The level of an arm is its content over its width. Period from the first four half
 * swings; the final difference of the levels from gauges, over two seconds after all swinging.
 */
#include "experiments/experiment.h"
#include "experiments/oscillation.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 4, PERIODS = 7, HALF_SWINGS = 4, END = 2, GAUGES = 5, MAX_SAMPLES = 4000 };
enum { C_ARM, C_GAP, C_LEVEL, C_GRAVITY, C_HEAD, C_TIME };

typedef struct tube {
    double arm, gap, level, head, width, height, gravity;
    skv_instrument content[2], gauges[2][GAUGES];
} tube;

static skv_result build(stage *s, tube *t, skv_error *error)
{
    double arm = t->arm, low = t->level - t->head / 2, high = t->level + t->head / 2;
    skv_stage_choose_spacing(s, 2 * arm * t->level + (t->gap - arm) * arm, 1);
    t->width = t->gap + arm;
    t->height = high + t->head;
    if (t->gap < 1.5 * arm || low < 1.5 * arm)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "u-tube: the gap and the lower level need to be 1.5 arm widths or more");
    skv_result result = skv_stage_check_passage(s, "u-tube.arm", arm, error);
    if (result != SKV_OK)
        return result;
    /* Gravity at a right angle to the line between the two surfaces' middles. */
    double length = sqrt(t->head * t->head + t->gap * t->gap);
    stage_plan plan = {
        .width = t->width,
        .height = t->height,
        .solids = {skv_solid_box(arm, arm, t->width - arm, t->height + 1)},
        .solid_count = 1,
        .depth = high,
        .gravity_x = -t->gravity * t->head / length,
        .gravity_y = -t->gravity * t->gap / length,
    };
    result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, t->width / 2, high, NULL, NULL, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, t->width / 2, 0, t->width, low, NULL, NULL, error);
    return result;
}

static skv_result add_instruments(stage *s, tube *t, skv_error *error)
{
    skv_result result = SKV_OK;
    for (int side = 0; side < 2; side++) {
        double x = side ? t->width - t->arm : 0;
        if (result == SKV_OK)
            result = skv_stage_add(s, SKV_INSTRUMENT_REGION, x, t->arm, x + t->arm, t->height, 0,
                                   &t->content[side], error);
        for (int i = 0; i < GAUGES && result == SKV_OK; i++) {
            double at = x + t->arm * (i + 1) / (GAUGES + 1);
            result = skv_stage_add(s, SKV_INSTRUMENT_LEVEL, at, t->arm / 2, at, t->height, END,
                                   &t->gauges[side][i], error);
        }
    }
    return result;
}

/* Left level minus right level, from the arms' contents. */
static int read_swing(const stage *s, const tube *t, double *times, double *swing)
{
    double right[MAX_SAMPLES];
    int count = skv_lab_history(s->lab, t->content[0], 1, times, swing, MAX_SAMPLES);
    skv_lab_history(s->lab, t->content[1], 1, NULL, right, MAX_SAMPLES);
    for (int i = 0; i < count; i++)
        swing[i] = (swing[i] - right[i]) / t->arm;
    return count;
}

static double gauge_difference(const stage *s, const tube *t)
{
    return skv_stage_mean_level(s, t->gauges[0], GAUGES) -
           skv_stage_mean_level(s, t->gauges[1], GAUGES);
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    tube t = {.arm = skv_settings_length(s->settings, PARAM_U_ARM),
              .gap = skv_settings_length(s->settings, PARAM_U_GAP),
              .level = skv_settings_length(s->settings, PARAM_U_LEVEL),
              .head = skv_settings_length(s->settings, PARAM_U_HEAD),
              .gravity = s->settings->value[PARAM_GRAVITY]};
    /* Long enough in any case: by the centre line's length. */
    double watch =
        fmin(PERIODS * skv_theory_u_tube_period(t.gravity, 2 * t.level + t.gap), 60) + END;
    s->total = WAIT + watch;
    skv_result result = build(s, &t, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    if (result == SKV_OK)
        result = add_instruments(s, &t, error);
    if (result == SKV_OK)
        result = skv_world_set_gravity(s->world, 0, (float)-t.gravity, error);
    double start = s->world ? skv_world_time(s->world) : 0;
    for (int i = 0; i < (int)(watch * 60) && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    double times[MAX_SAMPLES], swing[MAX_SAMPLES];
    int count = read_swing(s, &t, times, swing);
    oscillation o = skv_oscillation_read(times, swing, count, 0, HALF_SWINGS);
    found->measured[0] = o.period;
    found->measured[1] = gauge_difference(s, &t);
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    for (int i = 0; i < count; i += 2)
        skv_plot_point(&found->plot, times[i] - start, swing[i]);
    found->condition[C_ARM] = t.arm;
    found->condition[C_GAP] = t.gap;
    found->condition[C_LEVEL] = t.level;
    found->condition[C_GRAVITY] = t.gravity;
    found->condition[C_HEAD] = t.head;
    found->condition[C_TIME] = watch;
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double length =
        skv_theory_inertial_length(condition[C_ARM], condition[C_GAP], condition[C_LEVEL]);
    expected->theory[0] = skv_theory_u_tube_period(condition[C_GRAVITY], length);
    expected->theory[1] = 0;
    skv_plot_swing(plot, "theory: without friction", condition[C_HEAD], expected->theory[0],
                   condition[C_TIME]);
}

const experiment skv_exp_u_tube = {
    .info = {"u-tube", "U-tube",
             "Water swings between two arms: its period, and whether it ends level."},
    .x_label = "time (s)",
    .y_label = "left level - right level (m)",
    .count = 2,
    .quantities = {{"period", "s", 0.02, false, 0}, {"final level difference", "m", 0.25, true, 0}},
    .measure = measure,
    .expect = expect,
};
