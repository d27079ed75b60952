/* Sloshing: the lowest standing wave of a tank.
 *
 * Gravity is tilted until the surface rests at the wanted slope, then turns upright. The swing is
 * read from the mean x of all fluid, which follows the lowest wave and ignores the shorter ones
 * that a straight slope also contains.
 */
#include "experiments/experiment.h"
#include "experiments/oscillation.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 4, HALF_SWINGS = 4, MAX_SAMPLES = 4000 };
enum { C_WIDTH, C_DEPTH, C_GRAVITY, C_START, C_TIME };

#define PERIODS 3.5

/* Water with a sloping surface. */
typedef struct sloping {
    double middle, depth, rise; /* m, m, 1 */
} sloping;

static bool below(float x, float y, void *user)
{
    const sloping *s = user;
    return (double)y < s->depth + s->rise * ((double)x - s->middle);
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    double width = skv_settings_length(s->settings, PARAM_SLOSH_WIDTH);
    double depth = skv_settings_length(s->settings, PARAM_SLOSH_DEPTH);
    double gravity = s->settings->value[PARAM_GRAVITY];
    sloping start = {width / 2, depth, s->settings->value[PARAM_SLOSH_ANGLE]};
    double rise = start.rise * width / 2;
    if (rise >= 0.75 * depth)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "slosh.angle: the floor would fall dry; make it flatter or deeper");
    skv_stage_choose_spacing(s, width * depth, 1);
    double length = sqrt(1 + start.rise * start.rise);
    stage_plan plan = {.width = width,
                       .height = depth + 3 * rise,
                       .depth = depth + rise,
                       .gravity_x = gravity * start.rise / length,
                       .gravity_y = -gravity / length};
    double watch = fmin(PERIODS * skv_theory_slosh_period(gravity, width, depth), 60);
    s->total = WAIT + watch;
    skv_instrument all;
    skv_result result = skv_stage_check_passage(s, "slosh.depth", depth, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, width, depth + rise, below, &start, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    if (result == SKV_OK)
        result = skv_world_set_gravity(s->world, 0, (float)-gravity, error);
    if (result == SKV_OK)
        result = skv_stage_add(s, SKV_INSTRUMENT_REGION, 0, 0, width, plan.height, 0, &all, error);
    if (result == SKV_OK)
        result = skv_lab_sample(s->lab, s->world, error);
    for (int i = 0; i < (int)(watch * 60) && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    double times[MAX_SAMPLES], centre[MAX_SAMPLES];
    int count = skv_lab_history(s->lab, all, 2, times, centre, MAX_SAMPLES);
    oscillation o = skv_oscillation_read(times, centre, count, width / 2, HALF_SWINGS);
    found->measured[0] = o.period;
    found->measured[1] = o.amplitude1;
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i] - times[0], centre[i] - width / 2);
    found->condition[C_WIDTH] = width;
    found->condition[C_DEPTH] = depth;
    found->condition[C_GRAVITY] = gravity;
    /* The centre of a wedge of that slope: slope width^2 / (12 depth). */
    found->condition[C_START] = start.rise * width * width / (12 * depth);
    found->condition[C_TIME] = watch;
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] =
        skv_theory_slosh_period(condition[C_GRAVITY], condition[C_WIDTH], condition[C_DEPTH]);
    expected->theory[1] = 1;
    skv_plot_swing(plot, "theory: small waves", condition[C_START], expected->theory[0],
                   condition[C_TIME]);
}

const experiment skv_exp_slosh = {
    .info = {"slosh", "Sloshing tank",
             "The lowest standing wave of a tank: its period, and what is left after one period."},
    .x_label = "time (s)",
    .y_label = "centre of mass, x - middle (m)",
    .count = 2,
    .quantities = {{"period", "s", 0.02, false, 0},
                   {"amplitude after one period", "", 0.12, false, 0}},
    .measure = measure,
    .expect = expect,
};
