/* Coming to rest: how long a filled pool takes to settle, and what is left of motion afterwards.
 *
 * The pool is filled, settled as every scene is, and let go. Its rms speed is read every frame
 * for 23 seconds; it has settled at the moment after which it never exceeds 0.02 m/s again. Seconds
 * and speeds are those of scale 1: a larger pool takes longer, and what moves in it is faster.
 * Beside it as much water stands between two walls that lean by 45 degrees, one over it and one
 * below, along which rows of particles may slip.
 */
#include "experiments/experiment.h"
#include "skvalp/query.h"

#include <math.h>

enum { SECONDS = 23, FRAMES_A_POINT = 6 };
enum { WIDTH, DEPTH };
enum { C_END, C_FAST };

#define SETTLED 0.02 /* m/s */

/* The last two rows' mean squares, between these seconds; the slanted vessel has the last. */
enum { PERIODS = 2, SLANTED = PERIODS + 1 };
static const double periods[PERIODS][2] = {{6, 9}, {20, 23}};

static skv_instrument build(rig *s)
{
    double width = skv_rig_length(s, WIDTH), depth = skv_rig_length(s, DEPTH);
    s->total = 2 * SECONDS * skv_rig_pace(s);
    rig_plan plan = {.width = width,
                     .height = 1.4 * depth,
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, width, depth)},
                     .depth = depth,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
    return skv_rig_add(s, SKV_INSTRUMENT_ENERGY, 0, 0, 0, 0, 0);
}

static void draw(const rig *s, const void *energy, findings *found)
{
    skv_plot_begin(&found->plot, "rms speed", SKV_CURVE_LINE);
    skv_rig_trace(s, *(const skv_instrument *)energy, 2, FRAMES_A_POINT);
}

/* The rms speed that is left between walls that lean to the right by 45 degrees. */
static double slanted(rig *s)
{
    double width = skv_rig_length(s, WIDTH), depth = skv_rig_length(s, DEPTH);
    double height = 1.4 * depth, pace = skv_rig_pace(s);
    shape left = {3, {0, height, 0}, {0, height, height}, 0, 0},
          right = {3, {width, width + height, width + height}, {0, 0, height}, 0, 0};
    rig_plan plan = {.width = width + height,
                     .height = height,
                     .solids = 2,
                     .solid = {left, right},
                     .waters = 1,
                     .water = {{4, {0, width, width + depth, depth}, {0, 0, depth, depth}, 0, 0}},
                     .depth = depth,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build_beside(s, &plan, s->particles);
    skv_rig_wait(s, periods[PERIODS - 1][0] * pace);
    int frames = (int)((periods[PERIODS - 1][1] - periods[PERIODS - 1][0]) * pace * 60 + 0.5);
    double sum = 0;
    for (int f = 0; f < frames && skv_rig_ok(s); f++) {
        skv_rig_wait(s, 1 / 60.0);
        double speed = skv_world_stats(s->world).rms_speed;
        sum += speed * speed / frames;
    }
    return sqrt(sum);
}

static void measure(rig *s, findings *found)
{
    double pace = skv_rig_pace(s), fast = SETTLED * skv_rig_speed(s);
    skv_instrument energy = build(s);
    found->condition[C_END] = SECONDS * pace;
    found->condition[C_FAST] = fast;
    found->foreseen = true;
    skv_rig_show(s, draw, &energy);
    double settled = 0, sums[PERIODS] = {0};
    int samples[PERIODS] = {0};
    int frames = (int)(SECONDS * pace * 60 + 0.5);
    for (int f = 1; f <= frames; f++) {
        skv_rig_watch(s, 1 / 60.0);
        double t = f / 60.0, speed = skv_rig_read(s, energy, 2);
        settled = speed >= fast ? t : settled;
        for (int i = 0; i < PERIODS; i++) {
            if (t >= periods[i][0] * pace && t < periods[i][1] * pace) {
                sums[i] += speed * speed;
                samples[i]++;
            }
        }
    }
    skv_rig_draw(s);
    found->measured[0] = settled;
    for (int i = 0; i < PERIODS; i++)
        found->measured[1 + i] = sqrt(sums[i] / samples[i]);
    found->measured[SLANTED] = slanted(s);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    for (int i = 0; i <= SLANTED; i++)
        expected->theory[i] = 0;
    skv_plot_begin(plot, "settled", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, condition[C_FAST]);
    skv_plot_point(plot, condition[C_END], condition[C_FAST]);
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
                       "twenty seconds should be below 0.7 mm/s.",
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
    .count = 4,
    .quantities = {{"time to settle below 0.02 m/s", "s", 2, BY_PACE, 0},
                   {"rms speed, 6-9 s", "m/s", 0.005, BY_SPEED, 0},
                   {"rms speed, 20-23 s", "m/s", 0.0007, BY_SPEED, 0},
                   {"rms speed, leaning walls, 20-23 s", "m/s", 0.0007, BY_SPEED, 0}},
    .measure = measure,
    .expect = expect,
};
