/* Archimedes: the force of water at rest on a body that is held in it.
 *
 * A square body is fixed in the middle of a pool. After six seconds the force meter watches for
 * four.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 6, WATCH = 4, MAX_SAMPLES = 1000 };
enum { C_DENSITY, C_GRAVITY, C_AREA };

static skv_result build(stage *s, double size, double depth, skv_instrument *meter,
                        skv_error *error)
{
    double width = 5 * size, below = size, level = below + size + depth;
    double x = width / 2 - size / 2, margin = size / 4;
    skv_stage_choose_spacing(s, width * level - size * size, 1);
    stage_plan plan = {.width = width,
                       .height = level + size,
                       .solids = {skv_solid_box(x, below, x + size, below + size)},
                       .solid_count = 1,
                       .depth = level,
                       .gravity_y = -s->settings->value[PARAM_GRAVITY]};
    skv_result result = skv_stage_check_passage(s, "archimedes.size", fmin(size, depth), error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, width, level, NULL, NULL, error);
    if (result == SKV_OK)
        result = skv_stage_add(s, SKV_INSTRUMENT_FORCE, x - margin, below - margin,
                               x + size + margin, below + size + margin, WATCH, meter, error);
    return result;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    double size = skv_settings_length(s->settings, PARAM_BODY_SIZE);
    double depth = skv_settings_length(s->settings, PARAM_BODY_DEPTH);
    skv_instrument meter;
    s->total = WAIT + WATCH;
    skv_result result = build(s, size, depth, &meter, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    for (int i = 0; i < WATCH * 60 && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    found->measured[0] = skv_lab_reading(s->lab, meter, 1);
    double times[MAX_SAMPLES], force[MAX_SAMPLES];
    int count = skv_lab_history(s->lab, meter, 1, times, force, MAX_SAMPLES);
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i], force[i]);
    found->condition[C_DENSITY] = s->settings->value[PARAM_DENSITY];
    found->condition[C_GRAVITY] = s->settings->value[PARAM_GRAVITY];
    found->condition[C_AREA] = size * size;
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] =
        skv_theory_buoyancy(condition[C_DENSITY], condition[C_GRAVITY], condition[C_AREA]);
    skv_plot_begin(plot, "theory: weight of the displaced water", CURVE_THEORY);
    skv_plot_point(plot, WAIT, expected->theory[0]);
    skv_plot_point(plot, WAIT + WATCH, expected->theory[0]);
}

const experiment skv_exp_archimedes = {
    .info = {"archimedes", "Archimedes' force", "What water at rest does to a body held in it."},
    .x_label = "time (s)",
    .y_label = "force upwards (N)",
    .count = 1,
    .quantities = {{"force upwards", "N", 0.03, false, 0}},
    .measure = measure,
    .expect = expect,
};
