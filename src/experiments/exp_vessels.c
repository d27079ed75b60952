/* Communicating vessels: three vessels of different widths, joined at the floor, filled to
 * different levels, come to rest at one level. */
#include "experiments/experiment.h"

#include <math.h>

enum { VESSELS = 3, GAUGES = 3, RUN = 14, END = 2, MAX_SAMPLES = 1200 };

/* Widths, and the wall between two vessels, in mean levels; the duct under the walls. */
static const double widths[VESSELS] = {0.5, 0.2, 0.35};
#define WALL 0.12
#define DUCT 0.2

typedef struct vessels {
    double level, head, height, x0[VESSELS], x1[VESSELS], filled[VESSELS];
    skv_instrument gauges[VESSELS][GAUGES];
} vessels;

static stage_plan draw(vessels *v, double gravity)
{
    stage_plan plan = {.height = v->height, .gravity_y = -gravity};
    double x = 0;
    for (int i = 0; i < VESSELS; i++) {
        v->x0[i] = x;
        v->x1[i] = x += widths[i] * v->level;
        if (i + 1 < VESSELS) {
            plan.solids[plan.solid_count++] =
                skv_solid_box(x, DUCT * v->level, x + WALL * v->level, v->height + 1);
            x += WALL * v->level;
        }
    }
    plan.width = x;
    return plan;
}

/* Levels at the start, around a mean that is weighted with the widths. */
static void choose_levels(vessels *v)
{
    static const double share[VESSELS] = {0.5, -0.5, -0.1};
    double sum = 0, width = 0;
    for (int i = 0; i < VESSELS; i++) {
        sum += widths[i] * share[i];
        width += widths[i];
    }
    for (int i = 0; i < VESSELS; i++)
        v->filled[i] = v->level + v->head * (share[i] - sum / width);
}

static skv_result build(stage *s, vessels *v, skv_error *error)
{
    choose_levels(v);
    v->height = v->level + v->head + 0.3 * v->level;
    stage_plan plan = draw(v, s->settings->value[PARAM_GRAVITY]);
    plan.depth = v->level + v->head / 2;
    double area = (VESSELS - 1) * WALL * DUCT * v->level * v->level;
    for (int i = 0; i < VESSELS; i++)
        area += widths[i] * v->level * v->filled[i];
    skv_stage_choose_spacing(s, area, 1);
    if (v->head > v->level)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "vessels.head: it must not be larger than vessels.level");
    skv_result result = skv_stage_check_passage(s, "vessels.level", DUCT * v->level, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    for (int i = 0; i < VESSELS && result == SKV_OK; i++) {
        double end = i + 1 < VESSELS ? v->x0[i + 1] : v->x1[i];
        result = skv_stage_fill(s, v->x0[i], 0, end, v->filled[i], NULL, NULL, error);
        for (int k = 0; k < GAUGES && result == SKV_OK; k++) {
            double x = v->x0[i] + (v->x1[i] - v->x0[i]) * (k + 1) / (GAUGES + 1);
            result = skv_stage_add(s, SKV_INSTRUMENT_LEVEL, x, DUCT * v->level / 2, x, v->height,
                                   END, &v->gauges[i][k], error);
        }
    }
    return result;
}

/* The level that the water put in amounts to. */
static double filled_level(const stage *s, const vessels *v)
{
    double ducts = (VESSELS - 1) * WALL * DUCT * v->level * v->level, width = 0;
    for (int i = 0; i < VESSELS; i++)
        width += v->x1[i] - v->x0[i];
    return (skv_world_particle_count(s->world) * s->spacing * s->spacing - ducts) / width;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    static const char *const labels[VESSELS] = {"left", "middle", "right"};
    static const curve_style styles[VESSELS] = {CURVE_LINE, CURVE_RINGS, CURVE_DOTS};
    vessels v = {.level = skv_settings_length(s->settings, PARAM_VESSELS_LEVEL),
                 .head = skv_settings_length(s->settings, PARAM_VESSELS_HEAD)};
    s->total = RUN;
    skv_result result = build(s, &v, error);
    for (int i = 0; i < RUN * 60 && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    double highest = -HUGE_VAL, lowest = HUGE_VAL;
    for (int i = 0; i < VESSELS; i++) {
        highest = fmax(highest, skv_stage_mean_level(s, v.gauges[i], GAUGES));
        lowest = fmin(lowest, skv_stage_mean_level(s, v.gauges[i], GAUGES));
        double times[MAX_SAMPLES], levels[MAX_SAMPLES];
        int count = skv_lab_history(s->lab, v.gauges[i][1], 2, times, levels, MAX_SAMPLES);
        skv_plot_begin(&found->plot, labels[i], styles[i]);
        for (int k = 0; k < count; k += i == 0 ? 1 : 20)
            skv_plot_point(&found->plot, times[k], levels[k]);
    }
    found->measured[0] = highest - lowest;
    found->condition[0] = filled_level(s, &v);
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = 0;
    skv_plot_begin(plot, "theory: one level", CURVE_THEORY);
    skv_plot_point(plot, 0, condition[0]);
    skv_plot_point(plot, RUN, condition[0]);
}

const experiment skv_exp_vessels = {
    .info = {"vessels", "Communicating vessels",
             "Three vessels of different widths, joined at the floor, end at one level."},
    .x_label = "time (s)",
    .y_label = "level (m)",
    .count = 1,
    .quantities = {{"highest - lowest level", "m", 0.25, true, 0}},
    .measure = measure,
    .expect = expect,
};
