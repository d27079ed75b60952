/* Communicating vessels: three vessels of different widths, joined at the floor, filled to
 * different levels, come to rest at one level. */
#include "experiments/experiment.h"

#include <math.h>

/* Seconds are those of scale 1. */
enum { VESSELS = 3, GAUGES = 3, RUN = 20, END = 2 };
enum { C_LEVEL, C_RUN };
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

static rig_plan plan_of(const rig *s, vessels *v)
{
    rig_plan plan = {.height = v->height,
                     .waters = VESSELS,
                     .depth = v->level + v->head / 2,
                     .gravity_y = -skv_rig_gravity(s)};
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

static void build(rig *s, vessels *v)
{
    skv_rig_require(s, v->head <= v->level,
                    "vessels.head: it must not be larger than vessels.level");
    choose_levels(v);
    v->height = v->level + v->head + 0.3 * v->level;
    rig_plan plan = plan_of(s, v);
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, LEVEL, DUCT);
    for (int i = 0; i < VESSELS; i++) {
        for (int k = 0; k < GAUGES; k++) {
            double x = v->x0[i] + (v->x1[i] - v->x0[i]) * (k + 1) / (GAUGES + 1);
            v->gauges[i][k] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, DUCT * v->level / 2, x,
                                          v->height, END * skv_rig_pace(s));
        }
    }
}

/* The level that the water put in amounts to. */
static double filled_level(const rig *s, const vessels *v)
{
    double ducts = (VESSELS - 1) * WALL * DUCT * v->level * v->level, width = 0;
    for (int i = 0; i < VESSELS; i++)
        width += v->x1[i] - v->x0[i];
    return (skv_rig_area(s) - ducts) / width;
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    static const char *const labels[VESSELS] = {PLOT_LABEL("left"), PLOT_LABEL("middle"),
                                                PLOT_LABEL("right")};
    static const skv_curve_style styles[VESSELS] = {SKV_CURVE_LINE, SKV_CURVE_RINGS,
                                                    SKV_CURVE_DOTS};
    const vessels *v = set_up;
    for (int i = 0; i < VESSELS; i++) {
        skv_plot_begin(&found->plot, labels[i], styles[i]);
        skv_rig_trace(s, v->gauges[i][1], 2, i == 0 ? 1 : 20);
    }
}

static void measure(rig *s, findings *found)
{
    vessels v = {.level = skv_rig_length(s, LEVEL), .head = skv_rig_length(s, HEAD)};
    s->total = RUN * skv_rig_pace(s);
    build(s, &v);
    found->condition[C_LEVEL] = filled_level(s, &v);
    found->condition[C_RUN] = s->total;
    found->foreseen = true;
    skv_rig_show(s, draw, &v);
    skv_rig_watch(s, s->total);
    skv_rig_draw(s);
    double highest = -HUGE_VAL, lowest = HUGE_VAL;
    for (int i = 0; i < VESSELS; i++) {
        highest = fmax(highest, skv_rig_mean_level(s, v.gauges[i], GAUGES));
        lowest = fmin(lowest, skv_rig_mean_level(s, v.gauges[i], GAUGES));
    }
    found->measured[0] = highest - lowest;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = 0;
    skv_plot_begin(plot, "theory: one level", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, condition[C_LEVEL]);
    skv_plot_point(plot, condition[C_RUN], condition[C_LEVEL]);
}

const experiment skv_exp_vessels = {
    .info =
        {
            .name = "vessels",
            .title = "Communicating vessels",
            .description =
                "Three vessels of different widths, joined at the floor, end at one level.",
            .question =
                "In vessels of different widths that are joined below, which stands highest?",
            .predict = "Mark the three levels at the end. The wide vessel holds more water: does "
                       "that push the others up?",
            .measure = "Three vessels begin with different levels. Three gauges in each read the "
                       "level for the length of the run.",
            .compare =
                "Pressure at the floor depends on the height above it alone, so water flows until "
                "all heights are equal: the level is the volume divided by the sum of the widths. "
                "What is left should be less than a quarter of the particles' spacing.",
            .x_label = "time (s)",
            .y_label = "level (m)",
            .scatters = true,
        },
    .parameters =
        {
            [LEVEL] = {"vessels.level", SKV_FIELD_NUMBER, "m", 0.2, 2, NULL, "0.45",
                       "mean level of the three vessels"},
            [HEAD] = {"vessels.head", SKV_FIELD_NUMBER, "m", 0.02, 1, NULL, "0.2",
                      "difference between the highest and the lowest level at the start"},
        },
    .count = 1,
    .quantities = {{"highest - lowest level", "m", 0.25, IN_SPACINGS, 0}},
    .measure = measure,
    .expect = expect,
};
