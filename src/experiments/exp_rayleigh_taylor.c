/* Rayleigh and Taylor's instability: how fast a small wave grows between water and a lighter liquid
 * below it.
 *
 * A closed box is full, its lower half of the lighter liquid, up to a flat wave that is as long as
 * the box is wide. The wave's amplitude is the sum over the lower liquid's area of a cosine of x.
 * It starts at rest and so grows as the hyperbolic cosine of the rate times the time: when it has
 * doubled and when it has trebled gives the rate. That is done for three densities.
 */
#include "base/exact.h"
#include "experiments/experiment.h"
#include "experiments/theory.h"
#include "skvalp/particles.h"

#include <math.h>

enum { PAIRS = 3, STEPS = 30 };
enum { SIZE };
enum { C_GRAVITY, C_SIZE, C_DENSITIES, C_WATER = C_DENSITIES + PAIRS };

/* Amplitude at the start, in widths; and how long is waited for it to treble, s at scale 1. */
#define AMPLITUDE (1 / 40.0)
#define WATCH     3.0
/* Where the hyperbolic cosine is 2 and 3. */
#define DOUBLED 1.316958
#define TREBLED 1.762747

/* Of the lighter liquid, kg/m^2: Atwood numbers of 0.05, 0.33 and 0.8 below water. */
static const double densities[PAIRS] = {905, 500, 110};

static void build(rig *s, double size, double density)
{
    rig_plan plan = {.width = size,
                     .height = size,
                     .waters = 2,
                     .depth = size,
                     .gravity_y = -skv_rig_gravity(s),
                     .fluids = 1,
                     .fluid = {{"light", density, 0}},
                     .fluid_of = {1, 0}};
    shape *below = &plan.water[0], *above = &plan.water[1];
    *below = skv_shape_box(0, 0, size, size / 2);
    *above = skv_shape_box(0, size / 2, size, size);
    below->corners = above->corners = 2;
    above->y[0] = above->y[1] = size;
    for (int i = 0; i <= STEPS; i++) {
        double x = size * (STEPS - i) / STEPS;
        double y = size / 2 + AMPLITUDE * size * skv_cos(2 * SKV_PI * x / size);
        below->x[i + 2] = above->x[i + 2] = x;
        below->y[i + 2] = above->y[i + 2] = y;
        below->corners = above->corners = i + 3;
    }
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SIZE, 0.25);
}

static double amplitude(const rig *s, double size)
{
    double sum = 0;
    if (!skv_rig_ok(s))
        return (double)NAN;
    skv_particles p = skv_world_particles(s->world);
    for (int i = 0; i < p.count; i++)
        sum += p.fluid && p.fluid[i] == 1 ? skv_cos(2 * SKV_PI * (double)p.x[i] / size) : 0;
    return 2 / size * sum * s->spacing * s->spacing;
}

/* The rate at which the wave of a box grows; 0 if it does not treble in time. */
static double grow(rig *s, double size, double density)
{
    build(s, size, density);
    double watch = WATCH * skv_rig_pace(s), first = amplitude(s, size), last = first, doubled = 0;
    for (int f = 1; f <= (int)(watch * 60) && skv_rig_ok(s); f++) {
        skv_rig_wait(s, 1 / 60.0);
        double now = amplitude(s, size);
        for (int times = 2; times <= 3; times++) {
            double at = (f - (now - times * first) / (now - last)) / 60;
            if (last >= times * first || now < times * first)
                continue;
            if (times == 3)
                return (TREBLED - DOUBLED) / (at - doubled);
            doubled = at;
        }
        last = now;
    }
    return 0;
}

static void measure(rig *s, findings *found)
{
    double size = skv_rig_length(s, SIZE);
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    found->condition[C_SIZE] = size;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < PAIRS; i++) {
        s->total = s->done + (PAIRS - i) * WATCH * skv_rig_pace(s);
        found->measured[i] = grow(s, size, densities[i]);
        found->condition[C_WATER] = skv_rig_density(s);
        found->condition[C_DENSITIES + i] = densities[i];
        skv_plot_point(&found->plot, skv_theory_atwood(skv_rig_density(s), densities[i]),
                       found->measured[i]);
    }
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double g = condition[C_GRAVITY], size = condition[C_SIZE];
    for (int i = 0; i < PAIRS; i++) {
        double atwood = skv_theory_atwood(condition[C_WATER], condition[C_DENSITIES + i]);
        expected->theory[i] = skv_theory_growth(atwood, g, size, size / 2);
    }
    skv_plot_begin(plot, "theory: sqrt(A g k)", SKV_CURVE_THEORY);
    for (int i = 0; i <= STEPS; i++) { /* closer where it is steep */
        double atwood = (double)(i * i) / (STEPS * STEPS);
        skv_plot_point(plot, atwood, skv_theory_growth(atwood, g, size, size / 2));
    }
}

const experiment skv_exp_rayleigh_taylor = {
    .info =
        {
            .name = "rayleigh-taylor",
            .title = "Heavy on light",
            .description = "Water lies on a lighter liquid, and a small wave between them grows: "
                           "how fast it does.",
            .question = "Water lies on a lighter liquid and falls through it. How fast does that "
                        "begin?",
            .predict = "The lighter liquid weighs nine tenths, half or a tenth of the water. In "
                       "which box does the wave between the two grow fastest, and how much faster?",
            .measure = "In a full box the lighter liquid lies below, up to a flat wave. When the "
                       "wave has doubled its height and when it has trebled it give the rate at "
                       "which it grows. Then two boxes with other liquids follow.",
            .compare =
                "The heavy liquid pulls, and both have to move. So the square of the rate "
                "is A g k, with k = 2 pi / length and Atwood's number A, the difference of "
                "the densities over their sum (Rayleigh, Taylor): with a tenth it grows four "
                "times as fast as with nine tenths.",
            .x_label = "Atwood number",
            .y_label = "growth (1/s)",
            .scatters = true,
        },
    .parameters =
        SKV_BESIDE_ROWS([SIZE] = {"rayleigh-taylor.size", SKV_FIELD_NUMBER, "m", 0.1, 2, NULL,
                                  "0.4",
                                  "side of the square box, which is as wide as the wave is long"}),
    .count = PAIRS,
    .quantities = SKV_BESIDE_ROWS({"growth, nine tenths as heavy", "1/s", 0.2, AS_WRITTEN, 0},
                                  {"growth, half as heavy", "1/s", 0.2, AS_WRITTEN, 0},
                                  {"growth, a tenth as heavy", "1/s", 0.2, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
