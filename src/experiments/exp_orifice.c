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
enum { WIDTH, DEPTH, SLOT };
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
    double width, depth, slot;
    double floor, low, high; /* heights of the tank's floor and the slot's edges */
    skv_instrument gauges[GAUGES], gate, section;
} tank;

static shape bevel(double x, double width, double edge, double end)
{
    /* From the sharp edge on the inside at 45 degrees outwards. */
    double up = end > edge ? width : -width;
    return (shape){4, {x, x + width, x + width, x}, {edge, edge + up, end, end}, 0, 0};
}

static rig_plan draw(const rig *s, const tank *t, bool plugged)
{
    double wall = WALL * t->slot, height = t->floor + t->depth + 2 * t->slot;
    return (rig_plan){
        .width = t->width + wall + OUTSIDE * t->slot,
        .height = height,
        .open_right = true,
        .open_bottom = true,
        .solids = plugged ? 4 : 3,
        .solid = {skv_shape_box(-1, -1, t->width + wall, t->floor),
                  bevel(t->width, wall, t->low, -1), bevel(t->width, wall, t->high, height + 1),
                  skv_shape_box(t->width, t->low - wall, t->width + wall, t->high + wall)},
        .waters = 1,
        .water = {skv_shape_box(0, t->floor, t->width, t->floor + t->depth)},
        .depth = t->depth,
        .gravity_y = -skv_rig_gravity(s),
        /* The slot is the smallest thing here: more particles than elsewhere, for ten and more
         * spacings in it. */
        .share = 2.5,
    };
}

static void build(rig *s, tank *t)
{
    skv_rig_require(s, t->depth >= (SILL + 3) * t->slot && t->width >= 4 * t->slot,
                    "orifice.slot: it must not exceed a quarter of the width and two ninths of "
                    "the depth");
    rig_plan plan = draw(s, t, true);
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SLOT, 1);
    skv_rig_wait(s, WAIT);
    plan = draw(s, t, false);
    skv_rig_rebuild(s, &plan);
    for (int i = 0; i < GAUGES; i++) {
        double x = t->width * (0.1 + 0.5 * i / (GAUGES - 1));
        t->gauges[i] =
            skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, t->floor, x, t->floor + 1.2 * t->depth, 0);
    }
}

/* The gate, and around it half a slot height of the jet. */
static void add_jet_instruments(rig *s, tank *t, double watch)
{
    double x = t->width + 1.2 * t->slot, low = t->low - 2 * t->slot, high = t->high + t->slot;
    t->gate = skv_rig_add(s, SKV_INSTRUMENT_GATE, x, low, x, high, watch);
    t->section =
        skv_rig_add(s, SKV_INSTRUMENT_REGION, x - t->slot / 4, low, x + t->slot / 4, high, watch);
    skv_rig_sample(s);
}

static void measure(rig *s, findings *found)
{
    tank t = {.width = skv_rig_length(s, WIDTH),
              .depth = skv_rig_length(s, DEPTH),
              .slot = skv_rig_length(s, SLOT)};
    double gravity = skv_rig_gravity(s);
    t.floor = DROP * t.slot;
    t.low = t.floor + SILL * t.slot;
    t.high = t.low + t.slot;
    double pace = skv_rig_pace(s), watch = WATCH * pace, surface = 0, level = 0, first = 0;
    s->total = WAIT + START * pace + watch;
    build(s, &t);
    skv_rig_wait(s, START * pace);
    add_jet_instruments(s, &t, watch);
    found->condition[C_GRAVITY] = gravity;
    int frames = (int)(watch * 60);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < frames; i++) {
        skv_rig_watch(s, 1 / 60.0);
        double speed = (double)NAN;
        skv_rig_history(s, t.section, 7, NULL, &speed, 1);
        skv_plot_point(&found->plot, (i + 1) / 60.0, speed);
        level = skv_rig_mean_level(s, t.gauges, GAUGES);
        first = i == 0 ? level : first;
        surface += level / frames;
        double jet = skv_rig_read(s, t.section, 3);
        found->condition[C_FALL_START] = first - jet;
        found->condition[C_FALL_END] = level - jet;
        found->condition[C_TIME] = (i + 1) / 60.0;
        found->foreseen = true;
    }
    double jet = skv_rig_read(s, t.section, 3);
    found->measured[0] = skv_rig_read(s, t.section, 7);
    /* The coefficient is the flow over what the whole slot would pass at sqrt(2 g head). */
    double head = surface - (t.low + t.high) / 2;
    found->measured[1] = skv_rig_read(s, t.gate, 0) / (t.slot * sqrt(2 * gravity * head));
    found->condition[C_FALL] = surface - jet;
    found->condition[C_TIME] = watch;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL]);
    expected->theory[1] = skv_theory_contraction();
    skv_plot_begin(plot, "theory: sqrt(2 g h)", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL_START]));
    skv_plot_point(plot, condition[C_TIME],
                   skv_theory_jet_speed(condition[C_GRAVITY], condition[C_FALL_END]));
}

const experiment skv_exp_orifice = {
    .info =
        {
            .name = "orifice",
            .title = "Jet from an orifice",
            .description = "Water leaves a tank through a sharp-edged slot: the jet's speed, and "
                           "how much flows.",
            .question = "How fast does water leave a tank through a slot, and how much of it?",
            .predict = "Compare it with a stone that falls from the surface to the slot. Is the "
                       "jet as wide as the slot?",
            .measure = "A sharp-edged slot opens in the wall of a tank. A section of the jet reads "
                       "its speed, a gate the flow, gauges the surface above.",
            .compare = "Each bit of water trades its depth for speed: v = sqrt(2 g h), the stone's "
                       "speed (Torricelli). The jet narrows behind a sharp edge to pi / (pi + 2) = "
                       "0.61 of the slot, so only so much flows.",
            .x_label = "time (s)",
            .y_label = "speed of the jet (m/s)",
        },
    .parameters =
        {
            [WIDTH] = {"orifice.width", SKV_FIELD_NUMBER, "m", 0.2, 3, NULL, "1",
                       "width of the tank"},
            [DEPTH] = {"orifice.depth", SKV_FIELD_NUMBER, "m", 0.2, 2, NULL, "0.8",
                       "depth of the water at the start"},
            [SLOT] = {"orifice.slot", SKV_FIELD_NUMBER, "m", 0.02, 0.4, NULL, "0.1",
                      "height of the slot"},
        },
    .count = 2,
    .quantities = {{"jet speed", "m/s", 0.02, AS_WRITTEN, 0},
                   {"discharge coefficient", "", 0.07, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
