/* A jet from a slot in the side of a tank: its speed, and how much flows.
 *
 * The slot's edge is sharp: the wall is bevelled to the outside. A plug holds the water for three
 * seconds and is then gone. A little more than a slot height outside, where the jet has contracted
 * and its pressure is gone, a region gives its speed and its height, which is set against the level
 * in the tank, and a gate counts how much flows.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { WAIT = 3, GAUGES = 5 };
/* How far the jet is below the surface: on average, at the start and at the end of watching. */
enum { C_GRAVITY, C_FALL, C_FALL_START, C_FALL_END, C_TIME };

/* In slot heights. */
#define WALL    1.0 /* thickness of the wall */
#define SILL    1.5 /* from the floor of the tank to the slot */
#define DROP    4.0 /* from the floor of the tank to the floor of the world */
#define OUTSIDE 5.0 /* from the wall to the side of the world, through which the jet leaves */
/* The jet starts, then the flow is nearly steady; s at scale 1. */
#define START 0.35
#define WATCH 0.6

typedef struct tank {
    double width, depth, slot, gravity;
    double floor, low, high; /* heights of the tank's floor and the slot's edges */
    skv_instrument gauges[GAUGES], gate, section;
} tank;

static solid bevel(double x, double width, double edge, double far)
{
    /* From the sharp edge on the inside at 45 degrees outwards. */
    double up = far > edge ? width : -width;
    if (far > edge)
        return (solid){4, {x, x + width, x + width, x}, {edge, edge + up, far, far}};
    return (solid){4, {x, x, x + width, x + width}, {edge, far, far, edge + up}};
}

static stage_plan draw(const tank *t, bool plugged)
{
    double wall = WALL * t->slot, height = t->floor + t->depth + 2 * t->slot;
    stage_plan plan = {.width = t->width + wall + OUTSIDE * t->slot,
                       .height = height,
                       .open_sides = SKV_SIDE_RIGHT | SKV_SIDE_BOTTOM,
                       .depth = t->depth,
                       .gravity_y = -t->gravity};
    plan.solids[0] = skv_solid_box(-1, -1, t->width + wall, t->floor);
    plan.solids[1] = bevel(t->width, wall, t->low, -1);
    plan.solids[2] = bevel(t->width, wall, t->high, height + 1);
    plan.solids[3] = skv_solid_box(t->width, t->low - wall, t->width + wall, t->high + wall);
    plan.solid_count = plugged ? 4 : 3;
    return plan;
}

static skv_result build(stage *s, tank *t, skv_error *error)
{
    /* The slot is the smallest thing here: more particles than elsewhere, for ten and more spacings
     * in it. */
    skv_stage_choose_spacing(s, t->width * t->depth, 2.5);
    if (t->depth < (SILL + 3) * t->slot || t->width < 4 * t->slot)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "orifice.slot: it must not exceed a quarter of the width and two ninths of "
                        "the depth");
    skv_result result = skv_stage_check_passage(s, "orifice.slot", t->slot, error);
    if (result != SKV_OK)
        return result;
    stage_plan plan = draw(t, true);
    result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, t->floor, t->width, t->floor + t->depth, NULL, NULL, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    plan = draw(t, false);
    if (result == SKV_OK)
        result = skv_stage_rebuild(s, &plan, error);
    for (int i = 0; i < GAUGES && result == SKV_OK; i++) {
        double x = t->width * (0.1 + 0.5 * i / (GAUGES - 1));
        result = skv_stage_add(s, SKV_INSTRUMENT_LEVEL, x, t->floor, x, t->floor + 1.2 * t->depth,
                               0, &t->gauges[i], error);
    }
    return result;
}

/* The gate, and around it half a slot height of the jet. */
static skv_result add_jet_instruments(stage *s, tank *t, double watch, skv_error *error)
{
    double x = t->width + 1.2 * t->slot, low = t->low - 2 * t->slot, high = t->high + t->slot;
    skv_result result =
        skv_stage_add(s, SKV_INSTRUMENT_GATE, x, low, x, high, watch, &t->gate, error);
    if (result == SKV_OK)
        result = skv_stage_add(s, SKV_INSTRUMENT_REGION, x - t->slot / 4, low, x + t->slot / 4,
                               high, watch, &t->section, error);
    return result;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    tank t = {.width = skv_settings_length(s->settings, PARAM_ORIFICE_WIDTH),
              .depth = skv_settings_length(s->settings, PARAM_ORIFICE_DEPTH),
              .slot = skv_settings_length(s->settings, PARAM_ORIFICE_SLOT),
              .gravity = s->settings->value[PARAM_GRAVITY]};
    t.floor = DROP * t.slot;
    t.low = t.floor + SILL * t.slot;
    t.high = t.low + t.slot;
    /* Times grow with the root of a length over gravity. */
    double pace = sqrt(s->settings->value[PARAM_SCALE] * 9.81 / t.gravity);
    double watch = WATCH * pace;
    s->total = WAIT + START * pace + watch;
    skv_result result = build(s, &t, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, START * pace, error);
    if (result == SKV_OK)
        result = add_jet_instruments(s, &t, watch, error);
    if (result == SKV_OK)
        result = skv_lab_sample(s->lab, s->world, error);
    double start = s->world ? skv_world_time(s->world) : 0, surface = 0;
    int frames = (int)(watch * 60);
    skv_plot_begin(&found->plot, "measured", CURVE_DOTS);
    for (int i = 0; i < frames && result == SKV_OK; i++) {
        result = skv_stage_frame(s, error);
        if (result != SKV_OK)
            break;
        surface += skv_stage_mean_level(s, t.gauges, GAUGES) / frames;
        double times[1], speed[1];
        skv_lab_history(s->lab, t.section, 7, times, speed, 1);
        skv_plot_point(&found->plot, times[0] - start, speed[0]);
        if (i == 0)
            found->condition[C_FALL_START] = skv_stage_mean_level(s, t.gauges, GAUGES);
    }
    if (result != SKV_OK)
        return result;
    double jet = skv_lab_reading(s->lab, t.section, 3);
    found->measured[0] = skv_lab_reading(s->lab, t.section, 7);
    /* The coefficient is the flow over what the whole slot would pass at sqrt(2 g head). */
    double head = surface - (t.low + t.high) / 2;
    found->measured[1] = skv_lab_reading(s->lab, t.gate, 0) / (t.slot * sqrt(2 * t.gravity * head));
    found->condition[C_GRAVITY] = t.gravity;
    found->condition[C_FALL] = surface - jet;
    found->condition[C_FALL_START] -= jet;
    found->condition[C_FALL_END] = skv_stage_mean_level(s, t.gauges, GAUGES) - jet;
    found->condition[C_TIME] = watch;
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL]);
    expected->theory[1] = skv_theory_contraction();
    skv_plot_begin(plot, "theory: sqrt(2 g h)", CURVE_THEORY);
    skv_plot_point(plot, 0, skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL_START]));
    skv_plot_point(plot, condition[C_TIME],
                   skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL_END]));
}

const experiment skv_exp_orifice = {
    .info =
        {"orifice", "Jet from an orifice",
         "Water leaves a tank through a sharp-edged slot: the jet's speed, and how much flows."},
    .x_label = "time (s)",
    .y_label = "speed of the jet (m/s)",
    .count = 2,
    .quantities = {{"jet speed", "m/s", 0.03, false, 0},
                   {"discharge coefficient", "", 0.1, false, 0}},
    .measure = measure,
    .expect = expect,
};
