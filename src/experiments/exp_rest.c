/* Coming to rest: how long a filled pool takes to settle, and what is left of motion afterwards.
 *
 * The pool is filled, settled as every scene is, and let go. Its rms speed is read every frame
 * for 23 seconds; it has settled at the moment after which it never exceeds 0.02 m/s again.
 */
#include "experiments/experiment.h"

#include <math.h>

enum { SECONDS = 23 };
enum { WIDTH, DEPTH };

#define SETTLED 0.02 /* m/s */

/* Root of the mean square of the samples with from <= t < to. */
static double rms_between(const double *t, const double *v, int count, double from, double to)
{
    double sum = 0;
    int used = 0;
    for (int i = 0; i < count; i++) {
        if (t[i] >= from && t[i] < to) {
            sum += v[i] * v[i];
            used++;
        }
    }
    return used ? sqrt(sum / used) : (double)NAN;
}

static skv_instrument build(stage *s)
{
    double width = skv_stage_length(s, WIDTH), depth = skv_stage_length(s, DEPTH);
    s->total = SECONDS;
    stage_plan plan = {.width = width,
                       .height = 1.4 * depth,
                       .waters = 1,
                       .water = {skv_shape_box(0, 0, width, depth)},
                       .depth = depth,
                       .gravity_y = -skv_stage_gravity(s)};
    skv_stage_build(s, &plan);
    skv_stage_check_passage(s, DEPTH, 1);
    return skv_stage_add(s, SKV_INSTRUMENT_ENERGY, 0, 0, 0, 0, 0);
}

static void draw(const stage *s, const void *energy, findings *found)
{
    double times[SECONDS * 60], speeds[SECONDS * 60];
    int count =
        skv_stage_history(s, *(const skv_instrument *)energy, 2, times, speeds, SECONDS * 60);
    skv_plot_begin(&found->plot, "rms speed", SKV_CURVE_LINE);
    for (int i = 0; i < count && times[i] < 10; i += 3)
        skv_plot_point(&found->plot, times[i], speeds[i]);
}

static void measure(stage *s, findings *found)
{
    skv_instrument energy = build(s);
    found->foreseen = true;
    skv_stage_show(s, draw, &energy);
    skv_stage_watch(s, SECONDS);
    skv_stage_draw(s);
    double times[SECONDS * 60], speeds[SECONDS * 60];
    int count = skv_stage_history(s, energy, 2, times, speeds, SECONDS * 60);
    double settled = 0;
    for (int i = 0; i < count; i++)
        if (speeds[i] >= SETTLED)
            settled = times[i];
    found->measured[0] = settled;
    found->measured[1] = rms_between(times, speeds, count, 6, 9);
    found->measured[2] = rms_between(times, speeds, count, 20, 23);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    (void)condition;
    expected->theory[0] = expected->theory[1] = expected->theory[2] = 0;
    skv_plot_begin(plot, "settled", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, SETTLED);
    skv_plot_point(plot, 10, SETTLED);
}

const experiment skv_exp_rest = {
    .info =
        {
            .name = "rest",
            .title = "Coming to rest",
            .description =
                "A pool put down at rest: whether it stays so, and how still it is then.",
            .question =
                "Does water that is put down at rest stay at rest, and how still is it then?",
            .predict = "The water is put down with the pressure that carries it. What would happen "
                       "without, and how long until nothing moves faster than 2 cm/s?",
            .measure =
                "A pool is filled, settled and let go. An energy meter reads the rms speed of all "
                "particles for twenty-three seconds.",
            .compare = "There is no theory for it here, only two bounds: particles that tremble "
                       "for ever are a fault of the method, not of water. What remains after "
                       "twenty seconds should be below a millimetre a second.",
            .x_label = "time (s)",
            .y_label = "rms speed (m/s)",
            .scatters = true,
        },
    .parameters =
        {
            [WIDTH] = {"rest.width", SKV_FIELD_NUMBER, "m", 0.2, 4, NULL, "1", "width of the pool"},
            [DEPTH] = {"rest.depth", SKV_FIELD_NUMBER, "m", 0.1, 2, NULL, "0.5",
                       "depth of the pool"},
        },
    .count = 3,
    .quantities = {{"time to settle below 0.02 m/s", "s", 2, false, 0},
                   {"rms speed, 6-9 s", "m/s", 0.005, false, 0},
                   {"rms speed, 20-23 s", "m/s", 0.001, false, 0}},
    .measure = measure,
    .expect = expect,
};
