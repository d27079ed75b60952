/* Communicating vessels: three vessels of different widths, joined at the floor, filled to
 * different levels, come to rest at one level. */
#include "experiments/experiment.h"

#include <math.h>

enum { VESSELS = 3, GAUGES = 3, RUN = 14, END = 2, MAX_SAMPLES = 1200 };
enum { LEVEL, HEAD };

/* Widths, and the wall between two vessels, in mean levels; the duct under the walls. */
static const double widths[VESSELS] = {0.5, 0.2, 0.35};
#define WALL 0.12
#define DUCT 0.2

typedef struct vessels {
    double level, head, height, x0[VESSELS], x1[VESSELS], filled[VESSELS];
    skv_instrument gauges[VESSELS][GAUGES];
} vessels;

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

static stage_plan draw(const stage *s, vessels *v)
{
    stage_plan plan = {.height = v->height,
                       .waters = VESSELS,
                       .depth = v->level + v->head / 2,
                       .gravity_y = -skv_stage_gravity(s)};
    double x = 0;
    for (int i = 0; i < VESSELS; i++) {
        v->x0[i] = x;
        v->x1[i] = x += widths[i] * v->level;
        if (i + 1 < VESSELS) {
            plan.solid[plan.solids++] =
                skv_shape_box(x, DUCT * v->level, x + WALL * v->level, v->height + 1);
            x += WALL * v->level;
        }
        plan.water[i] = skv_shape_box(v->x0[i], 0, x, v->filled[i]);
    }
    plan.width = x;
    return plan;
}

static void build(stage *s, vessels *v)
{
    skv_stage_require(s, v->head <= v->level,
                      "vessels.head: it must not be larger than vessels.level");
    choose_levels(v);
    v->height = v->level + v->head + 0.3 * v->level;
    stage_plan plan = draw(s, v);
    skv_stage_build(s, &plan);
    skv_stage_check_passage(s, LEVEL, DUCT);
    for (int i = 0; i < VESSELS; i++) {
        for (int k = 0; k < GAUGES; k++) {
            double x = v->x0[i] + (v->x1[i] - v->x0[i]) * (k + 1) / (GAUGES + 1);
            v->gauges[i][k] =
                skv_stage_add(s, SKV_INSTRUMENT_LEVEL, x, DUCT * v->level / 2, x, v->height, END);
        }
    }
}

/* The level that the water put in amounts to. */
static double filled_level(const stage *s, const vessels *v)
{
    double ducts = (VESSELS - 1) * WALL * DUCT * v->level * v->level, width = 0;
    for (int i = 0; i < VESSELS; i++)
        width += v->x1[i] - v->x0[i];
    return (skv_stage_area(s) - ducts) / width;
}

static void measure(stage *s, findings *found)
{
    static const char *const labels[VESSELS] = {"left", "middle", "right"};
    static const curve_style styles[VESSELS] = {CURVE_LINE, CURVE_RINGS, CURVE_DOTS};
    vessels v = {.level = skv_stage_length(s, LEVEL), .head = skv_stage_length(s, HEAD)};
    s->total = RUN;
    build(s, &v);
    skv_stage_watch(s, RUN);
    double highest = -HUGE_VAL, lowest = HUGE_VAL;
    for (int i = 0; i < VESSELS; i++) {
        highest = fmax(highest, skv_stage_mean_level(s, v.gauges[i], GAUGES));
        lowest = fmin(lowest, skv_stage_mean_level(s, v.gauges[i], GAUGES));
        double times[MAX_SAMPLES], levels[MAX_SAMPLES];
        int count = skv_stage_history(s, v.gauges[i][1], 2, times, levels, MAX_SAMPLES);
        skv_plot_begin(&found->plot, labels[i], styles[i]);
        for (int k = 0; k < count; k += i == 0 ? 1 : 20)
            skv_plot_point(&found->plot, times[k], levels[k]);
    }
    found->measured[0] = highest - lowest;
    found->condition[0] = filled_level(s, &v);
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
    .parameters =
        {
            [LEVEL] = {"vessels.level", SKV_FIELD_NUMBER, "m", 0.2, 2, NULL, "0.45",
                       "mean level of the three vessels"},
            [HEAD] = {"vessels.head", SKV_FIELD_NUMBER, "m", 0.02, 1, NULL, "0.2",
                      "difference between the highest and the lowest level at the start"},
        },
    .x_label = "time (s)",
    .y_label = "level (m)",
    .count = 1,
    .quantities = {{"highest - lowest level", "m", 0.25, true, 0}},
    .measure = measure,
    .expect = expect,
};
