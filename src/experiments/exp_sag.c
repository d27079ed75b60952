/* Sagging: how much blocks of jelly lose of their height by their own weight.
 *
 * Three blocks stand side by side on a floor: one, one twice as high, and one as high as that of a
 * jelly twice as stiff. Without weight they take the shape that their surfaces want; level gauges
 * above the middle of each read their heights. Then gravity acts, and when they are calm the gauges
 * read again.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"
#include "skvalp/acting.h"

#include <math.h>
#include <stdlib.h>

enum { BLOCKS = 3, GAUGES = 5, READINGS = BLOCKS * GAUGES };
enum { HEIGHT, MODULUS };
enum { C_DENSITY, C_GRAVITY, C_MODULI, C_HEIGHTS = C_MODULI + BLOCKS };

/* Density, kg/m^2. */
#define JELLY 1000
/* s at scale 1: without weight, until they are calm under it, and how long each is read. */
#define FREE   2.5
#define WEIGHT 6.0
#define WATCH  1.0

/* Of the first block's; and where they begin and how wide they are, in heights of it. */
static const double heights[BLOCKS] = {1, 2, 2}, moduli[BLOCKS] = {1, 1, 2};
static const double lefts[BLOCKS] = {1, 3.5, 6};
#define BLOCK 1.5
#define WIDTH 8.5
#define TOP   2.5

static const char *const labels[] = {PLOT_LABEL("soft jelly"), PLOT_LABEL("stiff jelly")};

static void build(rig *s, double height, double modulus, skv_instrument *gauges)
{
    rig_plan plan = {.width = WIDTH * height,
                     .height = TOP * height,
                     .waters = BLOCKS,
                     .depth = 2 * height,
                     /* Settled with its weight it would hop without it. Who plays wants it. */
                     .gravity_y = s->sketch ? -skv_rig_gravity(s) : 0,
                     .fluids = 2};
    for (int i = 0; i < BLOCKS; i++) {
        double left = lefts[i] * height, right = left + BLOCK * height;
        plan.water[i] = skv_shape_box(left, 0, right, heights[i] * height);
        plan.fluid_of[i] = (int)moduli[i];
    }
    plan.fluid[0] = (plan_fluid){"jelly", JELLY, modulus};
    plan.fluid[1] = (plan_fluid){"stiff jelly", JELLY, 2 * modulus};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, HEIGHT, 1);
    for (int i = 0; i < READINGS; i++) {
        double along = 0.35 + 0.3 * (i % GAUGES) / (GAUGES - 1);
        double x = (lefts[i / GAUGES] + along * BLOCK) * height;
        gauges[i] =
            skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, plan.height, WATCH * skv_rig_pace(s));
    }
}

/* Sets gravity, lets time pass, and reads how high the blocks are then. */
static void read_heights(rig *s, double gravity, double wait, const skv_instrument *gauges,
                         double *found)
{
    if (skv_rig_ok(s))
        skv_rig_keep(s, skv_world_set_gravity(s->world, 0, (float)-gravity, s->error));
    skv_rig_wait(s, wait * skv_rig_pace(s));
    skv_rig_watch(s, WATCH * skv_rig_pace(s));
    for (int i = 0; i < BLOCKS; i++)
        found[i] = skv_rig_mean_level(s, gauges + i * GAUGES, GAUGES);
}

static void measure(rig *s, findings *found)
{
    double modulus = skv_rig_value(s, MODULUS), sagged[BLOCKS];
    double *free = found->condition + C_HEIGHTS;
    skv_instrument gauges[READINGS];
    s->total = (FREE + WEIGHT + 2 * WATCH) * skv_rig_pace(s);
    build(s, skv_rig_length(s, HEIGHT), modulus, gauges);
    read_heights(s, 0, FREE, gauges, free);
    read_heights(s, skv_rig_gravity(s), WEIGHT, gauges, sagged);
    found->condition[C_DENSITY] = JELLY;
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    for (int i = 0; i < BLOCKS; i++) {
        found->condition[C_MODULI + i] = moduli[i] * modulus;
        found->measured[i] = free[i] - sagged[i];
        if (i == 0 || moduli[i] != moduli[i - 1])
            skv_plot_begin(&found->plot, labels[(int)moduli[i] - 1],
                           i ? SKV_CURVE_RINGS : SKV_CURVE_DOTS);
        skv_plot_point(&found->plot, free[i], found->measured[i]);
    }
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    enum { STEPS = 20 };
    double density = condition[C_DENSITY], g = condition[C_GRAVITY];
    const double *height = condition + C_HEIGHTS, *modulus = condition + C_MODULI;
    for (int i = 0; i < BLOCKS; i++)
        expected->theory[i] = skv_theory_sag(density, g, height[i], modulus[i]);
    /* One line: of the stiff jelly from the highest down to nothing, of the soft one up again. */
    skv_plot_begin(plot, "theory: rho g H^2 / 8 G", SKV_CURVE_THEORY);
    for (int i = -STEPS; i <= STEPS; i++) {
        double x = fmax(height[1], height[2]) * abs(i) / STEPS;
        skv_plot_point(plot, x, skv_theory_sag(density, g, x, modulus[i < 0 ? 2 : 0]));
    }
}

const experiment skv_exp_sag = {
    .info =
        {
            .name = "sag",
            .title = "Sagging jelly",
            .description = "Blocks of jelly, one twice as high, one twice as stiff: how much "
                           "height each loses by its own weight.",
            .question = "How much does a block of jelly sag under its own weight, and how much "
                        "more does one that is twice as high?",
            .predict = "One block sags by 3 mm. Guess for one that is twice as high: 3, 6 or "
                       "12 mm? And for one that is twice as high and twice as stiff?",
            .measure = "The blocks stand on a floor, at first without weight. Gauges above the "
                       "middle of each read how high it is. Then gravity acts, and when they are "
                       "calm the gauges read again.",
            .compare = "At each height a block carries what lies above it, so it is squeezed most "
                       "at the floor. That adds up to rho g H^2 / 8 G, with the shear modulus G: "
                       "four times as much at twice the height, and half as much if it is twice "
                       "as stiff. That holds for jelly that can spread and is squeezed by little.",
            .x_label = "height without weight (m)",
            .y_label = "sag (m)",
        },
    .parameters =
        SKV_BESIDE_ROWS([HEIGHT] = {"sag.height", SKV_FIELD_NUMBER, "m", 0.05, 0.5, NULL, "0.1",
                                    "height of the low block; the others are twice as high"},
                        [MODULUS] =
                            {"sag.modulus", SKV_FIELD_NUMBER, "Pa", 500, 10000, NULL, "4000",
                             "shear modulus of the soft jelly; the stiff one has twice as much"}),
    .count = BLOCKS,
    .quantities = SKV_BESIDE_ROWS({"sag, low block", "m", 0.25, AS_WRITTEN, 0},
                                  {"sag, high block", "m", 0.25, AS_WRITTEN, 0},
                                  {"sag, high stiff block", "m", 0.25, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
