/* Sloshing: the lowest standing wave of a tank.
 *
 * Gravity is tilted until the surface rests at the wanted slope, then turns upright. The swing is
 * read from the mean x of all fluid, which follows the lowest wave and ignores the shorter ones
 * that a straight slope also contains. Theory gets the depth that gauges read just before: weight
 * compresses the water, so it is less than what was asked for.
 */
#include "experiments/experiment.h"
#include "experiments/oscillation.h"
#include "experiments/theory.h"
#include "skvalp/acting.h"

#include <math.h>

enum { WAIT = 4, HALF_SWINGS = 4, GAUGES = 9, MAX_SAMPLES = 4000 };
enum { WIDTH, DEPTH, ANGLE };
enum { C_WIDTH, C_DEPTH, C_GRAVITY, C_SLOPE, C_TIME };

#define PERIODS 3.5
/* At the start, unless told: this slope, and no more than this share of the depth at a wall, since
 * a higher wave breaks in shallow water. */
#define SLOPE    0.15
#define STEEPEST 0.3

typedef struct tank {
    double width, depth, gravity, slope;
    skv_instrument all, gauges[GAUGES];
} tank;

static void build(rig *s, tank *t)
{
    double rise = t->slope * t->width / 2, length = sqrt(1 + t->slope * t->slope);
    skv_rig_require(s, rise < 0.75 * t->depth,
                    "slosh.angle: the floor would fall dry; make it flatter or deeper");
    rig_plan plan = {
        .width = t->width,
        .height = t->depth + 3 * rise,
        .waters = 1,
        .water = {{4, {0, t->width, t->width, 0}, {0, 0, t->depth + rise, t->depth - rise}, 0, 0}},
        .depth = t->depth + rise,
        .gravity_x = t->gravity * t->slope / length,
        .gravity_y = -t->gravity / length};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
    skv_rig_wait(s, WAIT);
    if (skv_rig_ok(s))
        skv_rig_keep(s, skv_world_set_gravity(s->world, 0, (float)-t->gravity, s->error));
    t->all = skv_rig_add(s, SKV_INSTRUMENT_REGION, 0, 0, t->width, plan.height, 0);
    for (int i = 0; i < GAUGES; i++) {
        double x = t->width * (i + 1) / (GAUGES + 1);
        t->gauges[i] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, plan.height, 0);
    }
    skv_rig_sample(s);
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    const tank *t = set_up;
    double times[MAX_SAMPLES], centre[MAX_SAMPLES];
    int count = skv_rig_history(s, t->all, 2, times, centre, MAX_SAMPLES);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i] - times[0], centre[i] - t->width / 2);
}

static void measure(rig *s, findings *found)
{
    tank t = {skv_rig_length(s, WIDTH),
              skv_rig_length(s, DEPTH),
              skv_rig_gravity(s),
              skv_rig_value(s, ANGLE),
              0,
              {0}};
    if (t.slope == 0)
        t.slope = fmin(SLOPE, STEEPEST * t.depth / (t.width / 2));
    double watch = fmin(PERIODS * skv_theory_slosh_period(t.gravity, t.width, t.depth), 60);
    s->total = WAIT + watch;
    build(s, &t);
    /* The water rests on a straight slope as yet, and the gauges stand evenly about the middle:
     * their mean is the depth once it is level. */
    double depth = skv_rig_mean_level(s, t.gauges, GAUGES);
    found->condition[C_WIDTH] = t.width;
    found->condition[C_DEPTH] = depth;
    found->condition[C_GRAVITY] = t.gravity;
    found->condition[C_SLOPE] = t.slope;
    found->condition[C_TIME] = watch;
    found->foreseen = true;
    skv_rig_show(s, draw, &t);
    skv_rig_watch(s, watch);
    skv_rig_draw(s);
    double times[MAX_SAMPLES], centre[MAX_SAMPLES];
    int count = skv_rig_history(s, t.all, 2, times, centre, MAX_SAMPLES);
    oscillation o = skv_oscillation_read(times, centre, count, t.width / 2, HALF_SWINGS);
    found->measured[0] = o.period;
    found->measured[1] = o.amplitude1;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double width = condition[C_WIDTH], depth = condition[C_DEPTH], slope = condition[C_SLOPE];
    expected->theory[0] = skv_theory_slosh_period(condition[C_GRAVITY], width, depth);
    expected->theory[1] = skv_theory_slosh_amplitude(width, depth, slope);
    /* It begins where the centre of a wedge of that slope is. */
    skv_plot_swing(plot, "theory: small waves", slope * width * width / (12 * depth),
                   expected->theory[0], condition[C_TIME]);
}

const experiment skv_exp_slosh = {
    .info =
        {
            .name = "slosh",
            .title = "Sloshing tank",
            .description = "The lowest standing wave of a tank: its period, and what is left after "
                           "one period.",
            .question = "How does water slosh in a tank, and how much of the motion is left after "
                        "one period?",
            .predict = "Guess the period. Is it longer in deeper water? In a longer tank? Is the "
                       "second swing as large as the first?",
            .measure =
                "Gravity is tilted until the surface slopes, then turned upright. The centre of "
                "mass "
                "of all water is followed sideways: its crossings give the period, its turning "
                "points the loss.",
            .compare = "The lowest standing wave is twice as long as the tank: omega^2 = g k "
                       "tanh(k depth) with k = pi / width. The amplitude is compared with an "
                       "ideal liquid's, which has no friction: from the default slope it keeps "
                       "0.92, because the wave steepens; small waves keep nearly all. What is lost "
                       "beyond that goes to the walls.",
            .x_label = "time (s)",
            .y_label = "centre of mass, x - middle (m)",
        },
    .parameters =
        {
            [WIDTH] = {"slosh.width", SKV_FIELD_NUMBER, "m", 0.2, 4, NULL, "1.6",
                       "width of the tank"},
            [DEPTH] = {"slosh.depth", SKV_FIELD_NUMBER, "m", 0.05, 2, NULL, "0.4", "depth at rest"},
            [ANGLE] = {"slosh.angle", SKV_FIELD_NUMBER, "rad", 0, 0.4, NULL, "0",
                       "slope of the surface at the start; 0: 0.15, in shallow water less"},
        },
    .count = 2,
    .quantities = {{"period", "s", 0.02, AS_WRITTEN, 0},
                   {"amplitude after one period", "", 0.05, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
