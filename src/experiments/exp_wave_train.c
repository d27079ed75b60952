/* Wave trains: standing waves much shorter than their tank, how fast they swing and how they die
 * out.
 *
 * A level pool gets the velocities of a standing wave in an ideal liquid, which is flat at that
 * moment: sideways as cosh(k y) sin(k x), upwards as sinh(k y) cos(k x), with so many half waves
 * that the walls fit them. The particles' velocities are projected on that field: they swing as the
 * wave does. One wave is twice as long as the other. Both lose less by any viscosity than waves at
 * whose floor water sticks, so the loss is the method's own, or that of the fluid's settings.
 */
#include "base/exact.h"
#include "experiments/experiment.h"
#include "experiments/oscillation.h"
#include "experiments/theory.h"

#include <math.h>

enum { TRAINS = 2, WAIT = 1, GAUGES = 9, HALF_SWINGS = 4, MAX_SAMPLES = 1000 };
enum { WIDTH, DEPTH, HALF_WAVES };
enum { C_GRAVITY, C_NUMBER, C_DEPTH = C_NUMBER + TRAINS, C_TIME = C_DEPTH + TRAINS };

/* A wave's amplitude times its k: it swings by an eighth of the square, 0.5 %, slower than a small
 * one. And in periods of the longer wave, how long both are watched. */
#define STEEP   0.2
#define PERIODS 5.0

typedef struct train {
    double width, depth, k;
    double times[MAX_SAMPLES], swing[MAX_SAMPLES];
    int count;
} train;

/* At the surface each part reaches about 1/2. */
static void field(const train *t, double x, double y, double *u, double *v)
{
    double up = skv_exp(t->k * (y - t->depth)), down = skv_exp(-t->k * (y + t->depth));
    *u = skv_sin(t->k * x) * (up + down) / 2;
    *v = -skv_cos(t->k * x) * (up - down) / 2;
}

static double project(const skv_world *world, const train *t)
{
    skv_particles p = skv_world_particles(world);
    double sum = 0, norm = 0;
    for (int i = 0; i < p.count; i++) {
        double u, v;
        field(t, (double)p.x[i], (double)p.y[i], &u, &v);
        sum += (double)p.vx[i] * u + (double)p.vy[i] * v;
        norm += u * u + v * v;
    }
    return sum / norm;
}

/* Adds the field, times a speed, to what is there. */
static void start(rig *s, const train *t, double speed)
{
    int count = skv_rig_ok(s) ? skv_world_particle_count(s->world) : 0;
    for (int i = 0; i < count && skv_rig_ok(s); i++) {
        skv_particles p = skv_world_particles(s->world);
        double u, v;
        field(t, (double)p.x[i], (double)p.y[i], &u, &v);
        skv_rig_keep(s, skv_world_add_velocity(s->world, i, 1, (float)(speed * u),
                                               (float)(speed * v), s->error));
    }
}

static void build(rig *s, train *t)
{
    rig_plan plan = {.width = t->width,
                     .height = 1.5 * t->depth,
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, t->width, t->depth)},
                     .depth = t->depth,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
    skv_rig_wait(s, WAIT);
    /* Theory gets the depth that gauges read: weight compresses the water. */
    skv_instrument gauges[GAUGES];
    for (int i = 0; i < GAUGES; i++) {
        double x = t->width * (i + 1) / (GAUGES + 1);
        gauges[i] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, plan.height, 0);
    }
    skv_rig_sample(s);
    t->depth = skv_rig_mean_level(s, gauges, GAUGES);
}

/* Starts a train and follows it. */
static oscillation follow(rig *s, train *t, double watch, skv_plot *plot)
{
    build(s, t);
    double g = skv_rig_gravity(s);
    start(s, t, 2 * STEEP * sqrt(g / t->k));
    for (int f = 0; f < (int)(watch * 60) && t->count < MAX_SAMPLES && skv_rig_ok(s); f++) {
        t->times[t->count] = f / 60.0;
        t->swing[t->count] = project(s->world, t);
        skv_plot_point(plot, t->times[t->count], t->swing[t->count] / t->swing[0]);
        t->count++;
        skv_rig_wait(s, 1 / 60.0);
    }
    return skv_oscillation_read(t->times, t->swing, t->count, 0, HALF_SWINGS);
}

static void measure(rig *s, findings *found)
{
    double width = skv_rig_length(s, WIDTH), depth = skv_rig_length(s, DEPTH);
    double halves = skv_rig_value(s, HALF_WAVES), g = skv_rig_gravity(s);
    skv_rig_require(s, halves == floor(halves), "wave-train.half_waves: it must be a whole number");
    double watch = fmin(PERIODS * skv_theory_slosh_period(g, width / halves, depth), 15);
    s->total = TRAINS * (WAIT + watch);
    found->condition[C_GRAVITY] = g;
    found->condition[C_TIME] = watch;
    static const char *const labels[TRAINS] = {PLOT_LABEL("long waves"), PLOT_LABEL("short waves")};
    for (int i = 0; i < TRAINS; i++) {
        train t = {width, depth, SKV_PI * halves * (i + 1) / width, {0}, {0}, 0};
        skv_plot_begin(&found->plot, labels[i], i ? SKV_CURVE_DOTS : SKV_CURVE_LINE);
        oscillation o = follow(s, &t, watch, &found->plot);
        found->condition[C_NUMBER + i] = t.k;
        found->condition[C_DEPTH + i] = t.depth;
        found->measured[i] = 1 / o.period;
        /* What viscosity would do so: waves die out as exp(-2 nu k^2 t). */
        double viscosity = -skv_log(o.amplitude1) / o.period / (2 * t.k * t.k);
        found->measured[TRAINS + i] = viscosity / (s->spacing * s->spacing) * skv_rig_pace(s);
    }
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    for (int i = 0; i < TRAINS; i++) {
        double k = condition[C_NUMBER + i];
        double period =
            skv_theory_slosh_period(condition[C_GRAVITY], SKV_PI / k, condition[C_DEPTH + i]);
        expected->theory[i] = 1 / period;
        expected->theory[TRAINS + i] = 0;
        if (i == 0)
            skv_plot_swing(plot, "theory: long waves", 1, period, condition[C_TIME]);
    }
}

const experiment skv_exp_wave_train = {
    .info =
        {
            .name = "wave-train",
            .title = "Short waves",
            .description = "Standing waves in a long tank, one twice as long as the other: how "
                           "often they swing, and how they die out.",
            .question = "How often do short waves swing, and which of them live longest?",
            .predict = "One wave is half as long as the other. Does it swing as often, 1.4 times, "
                       "or twice as often?",
            .measure = "A level pool is given the velocities of a standing wave. How much of them "
                       "is left is followed for some periods.",
            .compare = "In deep water omega^2 = g k, with k = 2 pi / length: half the length "
                       "swings 1.4 times as often. Viscosity takes exp(-2 nu k^2 t): from half the "
                       "length four times as much. What the water loses here is the method's own, "
                       "some squares of the particles' spacing a second.",
            .x_label = "time (s)",
            .y_label = "velocity of the wave, share of the start",
        },
    .parameters =
        SKV_BESIDE_ROWS([WIDTH] = {"wave-train.width", SKV_FIELD_NUMBER, "m", 0.2, 4, NULL, "1.6",
                                   "width of the tank"},
                        [DEPTH] = {"wave-train.depth", SKV_FIELD_NUMBER, "m", 0.05, 2, NULL, "0.4",
                                   "depth at rest"},
                        [HALF_WAVES] =
                            {"wave-train.half_waves", SKV_FIELD_NUMBER, "", 1, 12, NULL, "4",
                             "half waves in the tank; the shorter train has twice as many"}),
    .count = 2 * TRAINS,
    .quantities = SKV_BESIDE_ROWS({"frequency, long waves", "1/s", 0.03, AS_WRITTEN, 0},
                                  {"frequency, short waves", "1/s", 0.03, AS_WRITTEN, 0},
                                  {"own viscosity, long waves", "spacings^2/s", 8, AS_WRITTEN, 0},
                                  {"own viscosity, short waves", "spacings^2/s", 8, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
