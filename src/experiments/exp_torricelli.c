/* Three holes at three heights of one tank: how fast each jet is, and how far it reaches.
 *
 * In a sheet jets would meet, so one hole after the other is opened, each in a tank that is full.
 * A hole is a sharp-edged slot; a plug holds the water until it is calm. A little more than a slot
 * height outside a region gives the jet's speed. Another lies where the jet falls through the level
 * of the tank's floor, and is read later by the time of the fall, when the water lands that passed
 * the first.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { HOLES = 3, GAUGES = 5 };
enum { WIDTH, DEPTH, SLOT };
/* From the first on each hole has its head, that of the jet's section, and its height. */
enum { C_GRAVITY, C_FIRST };
enum { C_HEAD, C_FALL, C_HEIGHT, PER_HOLE };

/* In slot heights. */
#define WALL  1.0 /* thickness of the wall */
#define BELOW 1.0 /* from the floor of the world to that of the tank */
/* In depths: to the side of the world, farther than any jet reaches, which is a depth; and where
 * landing begins, beyond what drips off the wall. */
#define OUTSIDE 1.2
#define LANDS   0.3
/* The water is calm, the jet starts, then it is nearly steady; s at scale 1. A jet of speed v
 * starts as v tanh(t v / 2 L), where L is how much of the tank's water moves with it, in lengths of
 * jet: 0.35 m. So the high one has 97 % after 0.8 s. Later the level falls faster than it can
 * follow. */
#define WAIT  1.0
#define START 0.8
#define WATCH 0.3

static const double heights[HOLES] = {0.25, 0.5, 0.75}; /* of the depth */

typedef struct tank {
    double width, depth, slot, floor;
    double hole; /* height of its middle above the tank's floor */
} tank;

/* From one sharp edge on the inside at 45 degrees outwards to another. */
static shape pane(const tank *t, double low, double high, bool sharp_below, bool sharp_above)
{
    double wall = WALL * t->slot, x = t->width;
    return (shape){4,
                   {x, x + wall, x + wall, x},
                   {low, sharp_below ? low + wall : low, sharp_above ? high - wall : high, high},
                   0,
                   0};
}

static rig_plan draw(const rig *s, const tank *t, bool plugged)
{
    double wall = WALL * t->slot, height = t->floor + t->depth + 2 * t->slot;
    double low = t->floor + t->hole - t->slot / 2, high = low + t->slot;
    return (rig_plan){
        .width = t->width + OUTSIDE * t->depth,
        .height = height,
        .open_right = true,
        .open_bottom = true,
        .solids = plugged ? 4 : 3,
        .solid = {skv_shape_box(-1, -1, t->width + wall, t->floor),
                  pane(t, t->floor - wall, low, false, true),
                  pane(t, high, height + 1, true, false),
                  skv_shape_box(t->width, low - wall, t->width + wall, high + wall)},
        .waters = 1,
        .water = {skv_shape_box(0, t->floor, t->width, t->floor + t->depth)},
        .depth = t->depth,
        .gravity_y = -skv_rig_gravity(s),
        /* The slots are the smallest things here: six spacings and more. */
        .share = 4,
    };
}

static void open_hole(rig *s, const tank *t, double pace)
{
    rig_plan plan = draw(s, t, true);
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SLOT, 1);
    skv_rig_wait(s, WAIT * pace);
    plan = draw(s, t, false);
    skv_rig_rebuild(s, &plan);
    skv_rig_wait(s, START * pace);
}

/* How long water falls from a hole to the height of the tank's floor. */
static double fall_time(const rig *s, const tank *t)
{
    return sqrt(2 * t->hole / skv_rig_gravity(s));
}

static void measure_hole(rig *s, const tank *t, int k, findings *found)
{
    double watch = WATCH * skv_rig_pace(s), surface = 0, middle = t->floor + t->hole;
    open_hole(s, t, skv_rig_pace(s));
    skv_instrument gauges[GAUGES];
    for (int i = 0; i < GAUGES; i++) {
        double x = t->width * (0.1 + 0.5 * i / (GAUGES - 1));
        gauges[i] =
            skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, t->floor, x, t->floor + 1.2 * t->depth, 0);
    }
    double x = t->width + 1.2 * t->slot, high = middle + 1.5 * t->slot;
    skv_instrument section = skv_rig_add(s, SKV_INSTRUMENT_REGION, x - t->slot / 4,
                                         middle - 2.5 * t->slot, x + t->slot / 4, high, watch);
    skv_instrument landing =
        skv_rig_add(s, SKV_INSTRUMENT_REGION, t->width + LANDS * t->depth, t->floor - t->slot / 4,
                    t->width + OUTSIDE * t->depth, t->floor + t->slot / 4, watch);
    int frames = (int)(watch * 60);
    for (int i = 0; i < frames; i++) {
        skv_rig_watch(s, 1 / 60.0);
        surface += skv_rig_mean_level(s, gauges, GAUGES) / frames;
    }
    double *condition = found->condition + C_FIRST + k * PER_HOLE;
    condition[C_HEAD] = surface - middle;
    condition[C_FALL] = surface - skv_rig_read(s, section, 3);
    condition[C_HEIGHT] = t->hole;
    found->measured[k] = skv_rig_read(s, section, 7);
    skv_rig_watch(s, fall_time(s, t));
    found->measured[HOLES + k] = skv_rig_read(s, landing, 2) - t->width;
    double level = surface - t->floor;
    if (k == 0)
        skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    skv_plot_point(&found->plot, t->hole / level, found->measured[HOLES + k] / level);
}

static void measure(rig *s, findings *found)
{
    tank t = {.width = skv_rig_length(s, WIDTH),
              .depth = skv_rig_length(s, DEPTH),
              .slot = skv_rig_length(s, SLOT)};
    t.floor = BELOW * t.slot;
    skv_rig_require(s, t.depth >= 6 * t.slot && t.width >= 4 * t.slot,
                    "torricelli.slot: it must not exceed a sixth of the depth and a quarter of "
                    "the width");
    s->total = HOLES * (WAIT + START + WATCH) * skv_rig_pace(s);
    for (int k = 0; k < HOLES; k++) {
        t.hole = heights[k] * t.depth;
        s->total += fall_time(s, &t);
    }
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    for (int k = 0; k < HOLES; k++) {
        t.hole = heights[k] * t.depth;
        measure_hole(s, &t, k, found);
    }
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    enum { STEPS = 40 };
    for (int k = 0; k < HOLES; k++) {
        const double *c = condition + C_FIRST + k * PER_HOLE;
        expected->theory[k] = skv_theory_jet_speed(condition[C_GRAVITY], c[C_FALL]);
        expected->theory[HOLES + k] = skv_theory_jet_range(c[C_HEAD], c[C_HEIGHT]);
    }
    skv_plot_begin(plot, "theory: 2 sqrt(h y)", SKV_CURVE_THEORY);
    for (int i = 0; i <= STEPS; i++) { /* closer at the ends, where it is steep */
        double share = (double)i / STEPS, y = share * share * (3 - 2 * share);
        skv_plot_point(plot, y, skv_theory_jet_range(1 - y, y));
    }
}

const experiment skv_exp_torricelli = {
    .info =
        {
            .name = "torricelli",
            .title = "Three holes",
            .description = "A hole low, halfway up or high in the wall of a tank: how fast each "
                           "jet is, and how far it reaches.",
            .question = "A tank has three holes, one above the other. From which does the water "
                        "squirt farthest?",
            .predict = "Which jet is fastest, and which has most time to fall? Order the three by "
                       "how far they reach on the level of the floor.",
            .measure = "One hole after the other is opened in a full tank. A section of the jet "
                       "reads its speed, a region how far it is when it falls through the level "
                       "of the tank's floor.",
            .compare = "Under the head h the jet has v = sqrt(2 g h) (Torricelli); from the height "
                       "y it falls for sqrt(2 y / g). So it reaches 2 sqrt(h y): farthest from "
                       "halfway up, and equally far from a quarter and three quarters.",
            .x_label = "height of the hole / level",
            .y_label = "range / level",
        },
    .parameters = SKV_BESIDE_ROWS([WIDTH] = {"torricelli.width", SKV_FIELD_NUMBER, "m", 0.2, 3,
                                             NULL, "2", "width of the tank"},
                                  [DEPTH] = {"torricelli.depth", SKV_FIELD_NUMBER, "m", 0.2, 2,
                                             NULL, "0.8", "depth of the water at the start"},
                                  [SLOT] = {"torricelli.slot", SKV_FIELD_NUMBER, "m", 0.02, 0.3,
                                            NULL, "0.1", "height of each hole"}),
    .count = 2 * HOLES,
    .quantities = SKV_BESIDE_ROWS({"speed, low hole", "m/s", 0.03, AS_WRITTEN, 0},
                                  {"speed, middle hole", "m/s", 0.03, AS_WRITTEN, 0},
                                  {"speed, high hole", "m/s", 0.03, AS_WRITTEN, 0},
                                  {"range, low hole", "m", 0.1, AS_WRITTEN, 0},
                                  {"range, middle hole", "m", 0.1, AS_WRITTEN, 0},
                                  {"range, high hole", "m", 0.1, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
