/* Flow through a channel: the profile of the speed between two plates.
 *
 * A flume that closes in itself: a block stands in a tank, a hand drags the water above it to the
 * left, and the water returns to the right through the channel between the block and the floor.
 * Nothing drives it there but the difference of the pressures at the channel's ends. Layers
 * three fifths down the channel, where its entrance is forgotten and its exit not yet felt, give
 * the mean speed for twelve seconds after twelve of running up. The fluid is a viscous one, so that
 * the flow is laminar.
 */
#include "experiments/experiment.h"
#include "skvalp/acting.h"

#include <math.h>

enum { WAIT = 12, WATCH = 12, LAYERS = 12 };
enum { LENGTH, HEIGHT, SPEED, FRICTION, VISCOSITY };

/* In heights of the channel. */
#define BLOCK 0.6 /* height of the block */
#define ABOVE 1.6 /* depth of the water above it */
#define TURN  1.5 /* width of the shafts at its ends */

typedef struct flume {
    double length, channel, width, top, surface;
    skv_instrument layers[LAYERS];
} flume;

static void build(rig *s, flume *f)
{
    double turn = TURN * f->channel;
    f->width = f->length + 2 * turn;
    f->top = (1 + BLOCK) * f->channel;
    f->surface = f->top + ABOVE * f->channel;
    s->total = WAIT + WATCH;
    skv_rig_set(s, "fluid.wall_friction", skv_rig_value(s, FRICTION));
    skv_rig_set(s, "fluid.viscosity_linear", skv_rig_value(s, VISCOSITY));
    rig_plan plan = {
        .width = f->width,
        .height = f->surface + f->channel,
        .solids = 1,
        .solid = {skv_shape_box(turn, f->channel, f->width - turn, f->top)},
        .waters = 1,
        .water = {skv_shape_box(0, 0, f->width, f->surface)},
        .depth = f->surface,
        .gravity_y = -skv_rig_gravity(s),
        .share = 1.5,
    };
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, HEIGHT, 1);
}

static void start_pump(rig *s, const flume *f)
{
    skv_hand pump = skv_default_hand();
    pump.x = (float)(f->width / 2);
    pump.y = (float)(f->top + ABOVE * f->channel / 2);
    pump.radius = (float)(f->channel * ABOVE);
    pump.attraction = 0;
    pump.friction = 0;
    pump.follow = 10;
    pump.vx = (float)(-skv_rig_value(s, SPEED) * sqrt(s->settings.common[PARAM_SCALE]));
    if (skv_rig_ok(s))
        skv_rig_keep(s, skv_world_set_hands(s->world, &pump, 1, s->error));
}

static void add_layers(rig *s, flume *f)
{
    /* R^2 is 0.9973, 0.9977, 0.9977, 0.9973 and 0.9945 at 0.4, 0.5, 0.6, 0.65 and 0.75: there,
     * within a height of the exit, the water turns up to it already and is faster under the block.
     */
    double middle = (f->width - f->length) / 2 + 0.6 * f->length, half = f->length / 10;
    for (int i = 0; i < LAYERS; i++)
        f->layers[i] = skv_rig_add(s, SKV_INSTRUMENT_REGION, middle - half, f->channel * i / LAYERS,
                                   middle + half, f->channel * (i + 1) / LAYERS, WATCH);
}

/* A place across the channel, -1 at the floor to 1 at the block, and the speed there. */
typedef struct sample {
    double e, v;
} sample;

/* Least squares of v = a + b e^2; returns R^2. */
static double fit_parabola(const sample *samples, int count, double *a, double *b)
{
    double s1 = 0, s2 = 0, v0 = 0, v1 = 0;
    for (int i = 0; i < count; i++) {
        double square = samples[i].e * samples[i].e;
        s1 += square;
        s2 += square * square;
        v0 += samples[i].v;
        v1 += square * samples[i].v;
    }
    *b = (count * v1 - s1 * v0) / (count * s2 - s1 * s1);
    *a = (v0 - *b * s1) / count;
    double miss = 0, spread = 0;
    for (int i = 0; i < count; i++) {
        double error = samples[i].v - *a - *b * samples[i].e * samples[i].e;
        miss += error * error;
        spread += (samples[i].v - v0 / count) * (samples[i].v - v0 / count);
    }
    return 1 - miss / spread;
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    const flume *f = set_up;
    sample samples[LAYERS];
    int count = 0;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < LAYERS; i++) {
        /* A layer's speed is that of its particles, and so belongs where these are, not to its
         * middle: beside a wall they keep to rows. */
        double height = skv_rig_read(s, f->layers[i], 3) / f->channel;
        double speed = skv_rig_read(s, f->layers[i], 4);
        /* A layer may lie between two rows of particles, and nothing pass through it. */
        if (isnan(height) || isnan(speed))
            continue;
        skv_plot_point(&found->plot, height, speed);
        samples[count++] = (sample){2 * height - 1, speed};
    }
    found->measured[0] = fit_parabola(samples, count, &found->condition[0], &found->condition[1]);
}

static void measure(rig *s, findings *found)
{
    flume f = {.length = skv_rig_length(s, LENGTH), .channel = skv_rig_length(s, HEIGHT)};
    build(s, &f);
    start_pump(s, &f);
    skv_rig_wait(s, WAIT);
    add_layers(s, &f);
    found->foreseen = true;
    skv_rig_show(s, draw, &f);
    skv_rig_watch(s, WATCH);
    skv_rig_draw(s);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = 1;
    skv_plot_begin(plot, "theory: a parabola", SKV_CURVE_THEORY);
    for (int i = 0; i <= 40; i++) {
        double e = i / 20.0 - 1;
        skv_plot_point(plot, i / 40.0, condition[0] + condition[1] * e * e);
    }
}

const experiment skv_exp_channel = {
    .info =
        {
            .name = "channel",
            .title = "Flow through a channel",
            .description =
                "A flume drives water through a channel: the profile of its speed is a parabola.",
            .question =
                "Where in a channel is the water fastest, and how slow is it beside the walls?",
            .predict = "Sketch the speed across the channel, from wall to wall.",
            .measure = "A flume drives a viscous liquid round through a straight channel with "
                       "rough walls. Layers across it read the mean speed along it.",
            .compare = "Viscosity carries the push from layer to layer to the walls, where the "
                       "liquid rests: the profile is a parabola (Poiseuille). The dashed line is "
                       "the best one through the points.",
            .x_label = "height / height of the channel",
            .y_label = "speed along the channel (m/s)",
            .scatters = true,
        },
    .parameters =
        SKV_BESIDE_ROWS([LENGTH] = {"channel.length", SKV_FIELD_NUMBER, "m", 0.4, 4, NULL, "1.2",
                                    "length of the channel under the block"},
                        [HEIGHT] = {"channel.height", SKV_FIELD_NUMBER, "m", 0.04, 0.6, NULL, "0.2",
                                    "height of the channel"},
                        [SPEED] = {"channel.speed", SKV_FIELD_NUMBER, "m/s", 0.02, 10, NULL, "3",
                                   "speed to which the pump drags the water above the block"},
                        [FRICTION] = {"channel.friction", SKV_FIELD_NUMBER, "", 0, 1, NULL, "1",
                                      "share of the speed along a wall lost in 1/60 s"},
                        [VISCOSITY] = {"channel.viscosity", SKV_FIELD_NUMBER, "1/s", 0, 1000, NULL,
                                       "150",
                                       "linear viscosity sigma of the fluid in the channel"}),
    .count = 1,
    .quantities = SKV_BESIDE_ROWS({"profile, R^2 of the best parabola", "", 0.005, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
