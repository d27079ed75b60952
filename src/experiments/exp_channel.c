/* Flow through a channel: the profile of the speed between two plates.
 *
 * A flume that closes in itself: a block stands in a tank, a hand drags the water above it to the
 * left, and the water returns to the right through the channel between the block and the floor.
 * Nothing drives it there but the difference of the pressures at the channel's ends. Layers
 * three quarters down the channel, where its entrance is forgotten, give the mean speed for twelve
 * seconds after twelve of running up. The fluid is a viscous one, so that the flow is laminar.
 */
#include "experiments/experiment.h"

#include <math.h>

enum { WAIT = 12, WATCH = 12, LAYERS = 12 };

/* In heights of the channel. */
#define BLOCK 0.6 /* height of the block */
#define ABOVE 1.6 /* depth of the water above it */
#define TURN  1.5 /* width of the shafts at its ends */

typedef struct flume {
    double length, channel, width, top, surface;
    skv_instrument layers[LAYERS];
} flume;

static skv_result build(stage *s, flume *f, skv_error *error)
{
    double turn = TURN * f->channel;
    f->width = f->length + 2 * turn;
    f->top = (1 + BLOCK) * f->channel;
    f->surface = f->top + ABOVE * f->channel;
    s->fluid.wall_friction = (float)s->settings->value[PARAM_CHANNEL_FRICTION];
    s->fluid.viscosity_linear = (float)s->settings->value[PARAM_CHANNEL_VISCOSITY];
    skv_stage_choose_spacing(s, f->width * f->surface - f->length * BLOCK * f->channel, 1.5);
    stage_plan plan = {
        .width = f->width,
        .height = f->surface + f->channel,
        .solids = {skv_solid_box(turn, f->channel, f->width - turn, f->top)},
        .solid_count = 1,
        .depth = f->surface,
        .gravity_y = -s->settings->value[PARAM_GRAVITY],
    };
    skv_result result = skv_stage_check_passage(s, "channel.height", f->channel, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, f->width, f->surface, NULL, NULL, error);
    skv_hand pump = skv_default_hand();
    pump.x = (float)(f->width / 2);
    pump.y = (float)(f->top + ABOVE * f->channel / 2);
    pump.radius = (float)(f->channel * ABOVE);
    pump.attraction = 0;
    pump.friction = 0;
    pump.follow = 10;
    pump.vx =
        (float)(-s->settings->value[PARAM_CHANNEL_SPEED] * sqrt(s->settings->value[PARAM_SCALE]));
    if (result == SKV_OK)
        result = skv_world_set_hands(s->world, &pump, 1, error);
    return result;
}

static skv_result add_layers(stage *s, flume *f, skv_error *error)
{
    skv_result result = SKV_OK;
    double middle = (f->width - f->length) / 2 + 0.75 * f->length, half = f->length / 10;
    for (int i = 0; i < LAYERS && result == SKV_OK; i++)
        result = skv_stage_add(s, SKV_INSTRUMENT_REGION, middle - half, f->channel * i / LAYERS,
                               middle + half, f->channel * (i + 1) / LAYERS, WATCH, &f->layers[i],
                               error);
    return result;
}

/* Least squares of v = a + b e^2, e from -1 at the floor to 1 at the block; returns R^2. */
static double fit_parabola(const double *v, int count, double *a, double *b)
{
    double s1 = 0, s2 = 0, v0 = 0, v1 = 0;
    for (int i = 0; i < count; i++) {
        double e = 2 * (i + 0.5) / count - 1, square = e * e;
        s1 += square;
        s2 += square * square;
        v0 += v[i];
        v1 += square * v[i];
    }
    *b = (count * v1 - s1 * v0) / (count * s2 - s1 * s1);
    *a = (v0 - *b * s1) / count;
    double miss = 0, spread = 0;
    for (int i = 0; i < count; i++) {
        double e = 2 * (i + 0.5) / count - 1, error = v[i] - *a - *b * e * e;
        miss += error * error;
        spread += (v[i] - v0 / count) * (v[i] - v0 / count);
    }
    return 1 - miss / spread;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    flume f = {.length = skv_settings_length(s->settings, PARAM_CHANNEL_LENGTH),
               .channel = skv_settings_length(s->settings, PARAM_CHANNEL_HEIGHT)};
    s->total = WAIT + WATCH;
    skv_result result = build(s, &f, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    if (result == SKV_OK)
        result = add_layers(s, &f, error);
    for (int i = 0; i < WATCH * 60 && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    double speeds[LAYERS], a, b;
    skv_plot_begin(&found->plot, "measured", CURVE_DOTS);
    for (int i = 0; i < LAYERS; i++) {
        speeds[i] = skv_lab_reading(s->lab, f.layers[i], 4);
        skv_plot_point(&found->plot, (i + 0.5) / LAYERS, speeds[i]);
    }
    found->measured[0] = fit_parabola(speeds, LAYERS, &a, &b);
    found->condition[0] = a;
    found->condition[1] = b;
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = 1;
    skv_plot_begin(plot, "theory: a parabola", CURVE_THEORY);
    for (int i = 0; i <= 40; i++) {
        double e = i / 20.0 - 1;
        skv_plot_point(plot, i / 40.0, condition[0] + condition[1] * e * e);
    }
}

const experiment skv_exp_channel = {
    .info = {"channel", "Flow through a channel",
             "A flume drives water through a channel: the profile of its speed is a parabola."},
    .x_label = "height / height of the channel",
    .y_label = "speed along the channel (m/s)",
    .count = 1,
    .quantities = {{"profile, R^2 of the best parabola", "", 0.005, false, 0}},
    .measure = measure,
    .expect = expect,
};
