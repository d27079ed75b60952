/* U-tube: a liquid column swings between two arms.
 *
 * The difference of the levels is held by tilting gravity until the water is calm; then gravity
 * turns upright. The level of an arm is its content over its width. Period from the first four half
 * swings; the final difference of the levels from gauges, over a whole swing after all that can be
 * seen: what is left of them then cancels.
 * Theory gets the level that the gauges read then: weight compresses the water, so it stands lower
 * than the shapes that were filled.
 */
#include "experiments/experiment.h"
#include "experiments/oscillation.h"
#include "experiments/theory.h"
#include "skvalp/acting.h"

#include <math.h>

enum { WAIT = 4, PERIODS = 10, HALF_SWINGS = 4, GAUGES = 5, MAX_SAMPLES = 4000 };
enum { ARM, GAP, LEVEL, HEAD };
enum { C_ARM, C_GAP, C_LEVEL, C_GRAVITY, C_HEAD, C_TIME };

typedef struct tube {
    double arm, gap, level, head, width, height, gravity, end;
    skv_instrument content[2], gauges[2][GAUGES];
} tube;

static void build(rig *s, tube *t)
{
    double arm = t->arm, low = t->level - t->head / 2, high = t->level + t->head / 2;
    t->width = t->gap + arm;
    t->height = high + t->head;
    skv_rig_require(s, t->gap >= 1.5 * arm && low >= 1.5 * arm,
                    "u-tube: the gap and the lower level need to be 1.5 arm widths or more");
    /* Gravity at a right angle to the line between the two surfaces' middles. */
    double length = sqrt(t->head * t->head + t->gap * t->gap);
    rig_plan plan = {
        .width = t->width,
        .height = t->height,
        .solids = 1,
        .solid = {skv_shape_box(arm, arm, t->width - arm, t->height + 1)},
        .waters = 3,
        .water = {skv_shape_box(0, 0, arm, high), skv_shape_box(arm, 0, t->width - arm, arm),
                  skv_shape_box(t->width - arm, 0, t->width, low)},
        .depth = high,
        .gravity_x = -t->gravity * t->head / length,
        .gravity_y = -t->gravity * t->gap / length,
    };
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, ARM, 1);
}

static void add_instruments(rig *s, tube *t)
{
    for (int side = 0; side < 2; side++) {
        double x = side ? t->width - t->arm : 0;
        t->content[side] =
            skv_rig_add(s, SKV_INSTRUMENT_REGION, x, t->arm, x + t->arm, t->height, 0);
        for (int i = 0; i < GAUGES; i++) {
            double at = x + t->arm * (i + 1) / (GAUGES + 1);
            t->gauges[side][i] =
                skv_rig_add(s, SKV_INSTRUMENT_LEVEL, at, t->arm / 2, at, t->height, t->end);
        }
    }
}

/* Left level minus right level, from the arms' contents. */
static int read_swing(const rig *s, const tube *t, double *times, double *swing)
{
    double right[MAX_SAMPLES];
    int count = skv_rig_history(s, t->content[0], 1, times, swing, MAX_SAMPLES);
    skv_rig_history(s, t->content[1], 1, NULL, right, MAX_SAMPLES);
    for (int i = 0; i < count; i++)
        swing[i] = (swing[i] - right[i]) / t->arm;
    return count;
}

/* The gauges stand evenly across an arm, so an oblique surface's mean is that of the arm. */
static double arm_level(const rig *s, const tube *t, int side)
{
    return skv_rig_mean_level(s, t->gauges[side], GAUGES);
}

static double mean_level(const rig *s, const tube *t)
{
    return (arm_level(s, t, 0) + arm_level(s, t, 1)) / 2;
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    double times[MAX_SAMPLES], swing[MAX_SAMPLES];
    int count = read_swing(s, set_up, times, swing);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (int i = 0; i < count; i += 2)
        skv_plot_point(&found->plot, times[i] - times[0], swing[i]);
}

static void measure(rig *s, findings *found)
{
    tube t = {.arm = skv_rig_length(s, ARM),
              .gap = skv_rig_length(s, GAP),
              .level = skv_rig_length(s, LEVEL),
              .head = skv_rig_length(s, HEAD),
              .gravity = skv_rig_gravity(s)};
    t.end = skv_theory_u_tube_period(t.gravity, skv_theory_inertial_length(t.arm, t.gap, t.level));
    /* Long enough in any case: by the centre line's length. */
    double watch =
        fmin(PERIODS * skv_theory_u_tube_period(t.gravity, 2 * t.level + t.gap), 60) + t.end;
    s->total = WAIT + watch;
    build(s, &t);
    skv_rig_wait(s, WAIT);
    add_instruments(s, &t);
    found->condition[C_ARM] = t.arm;
    found->condition[C_GAP] = t.gap;
    /* While it swings theory is drawn for the level between the two that are held apart. */
    skv_rig_sample(s);
    found->condition[C_LEVEL] = mean_level(s, &t);
    found->condition[C_GRAVITY] = t.gravity;
    found->condition[C_HEAD] = t.head;
    found->condition[C_TIME] = watch;
    found->foreseen = true;
    skv_rig_show(s, draw, &t);
    if (skv_rig_ok(s))
        skv_rig_keep(s, skv_world_set_gravity(s->world, 0, (float)-t.gravity, s->error));
    skv_rig_watch(s, watch);
    skv_rig_draw(s);
    double times[MAX_SAMPLES], swing[MAX_SAMPLES];
    int count = read_swing(s, &t, times, swing);
    oscillation o = skv_oscillation_read(times, swing, count, 0, HALF_SWINGS);
    found->measured[0] = o.period;
    found->measured[1] = arm_level(s, &t, 0) - arm_level(s, &t, 1);
    found->condition[C_LEVEL] = mean_level(s, &t);
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
    .info =
        {
            .name = "u-tube",
            .title = "U-tube",
            .description = "Water swings between two arms: its period, and whether it ends level.",
            .question =
                "With which period does water swing in a U-shaped tube, and where does it stop?",
            .predict = "Guess the period in seconds. Does it depend on how far the water was "
                       "lifted? On how wide the arms are? On the liquid?",
            .measure = "Gravity is tilted until the water stands obliquely, then turned upright. "
                       "What each arm contains, divided by its width, is its level; the period is "
                       "that of the first four half swings.",
            .compare = "The whole column of length L moves at once, driven by the difference of "
                       "the levels: T = 2 pi sqrt(L / 2g), like a pendulum of length L/2. Density "
                       "cancels, and so does the height. At the end both levels are equal.",
            .x_label = "time (s)",
            .y_label = "left level - right level (m)",
            .scatters = true,
        },
    .parameters =
        {
            [ARM] = {"u-tube.arm", SKV_FIELD_NUMBER, "m", 0.03, 0.4, NULL, "0.12",
                     "width of the arms and height of the bend"},
            [GAP] = {"u-tube.gap", SKV_FIELD_NUMBER, "m", 0.1, 3, NULL, "0.6",
                     "distance between the arms' centre lines"},
            [LEVEL] = {"u-tube.level", SKV_FIELD_NUMBER, "m", 0.1, 3, NULL, "0.6",
                       "level in both arms at rest, above the floor"},
            [HEAD] = {"u-tube.head", SKV_FIELD_NUMBER, "m", 0.02, 1, NULL, "0.3",
                      "difference of the levels at the start"},
        },
    .count = 2,
    .quantities = {{"period", "s", 0.015, AS_WRITTEN, 0},
                   {"final level difference", "m", 0.25, IN_SPACINGS, 0}},
    .measure = measure,
    .expect = expect,
};
