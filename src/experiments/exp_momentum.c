/* Momentum: a blob that drifts and turns without gravity, far from all walls, keeps its momentum.
 *
 * The blob is a square, so that it pulls itself round while it drifts. Its mean velocity is read
 * once a second for ten seconds; what counts is the largest deviation from the first.
 */
#include "experiments/experiment.h"

#include <math.h>

enum { SECONDS = 10 };
enum { SIZE, SPEED, SPIN };

/* Adds a rotation about a point. */
static void spin_up(rig *s, double spin, double x, double y)
{
    int count = skv_rig_ok(s) ? skv_world_particle_count(s->world) : 0;
    for (int i = 0; i < count && skv_rig_ok(s); i++) {
        skv_particles p = skv_world_particles(s->world);
        float vx = (float)(-spin * ((double)p.y[i] - y)), vy = (float)(spin * ((double)p.x[i] - x));
        skv_rig_keep(s, skv_world_add_velocity(s->world, i, 1, vx, vy, s->error));
    }
}

static skv_instrument build(rig *s)
{
    double size = skv_rig_length(s, SIZE), speed = skv_rig_value(s, SPEED);
    double vx = 0.8 * speed, vy = 0.6 * speed;
    double room = 2.5 * size + SECONDS * speed;
    double x = (room - vx * SECONDS) / 2, y = (room - vy * SECONDS) / 2;
    s->total = SECONDS;
    rig_plan plan = {
        .width = room,
        .height = room,
        .waters = 1,
        .water = {skv_shape_box(x - size / 2, y - size / 2, x + size / 2, y + size / 2)},
        .depth = size,
    };
    plan.water[0].vx = vx;
    plan.water[0].vy = vy;
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SIZE, 1);
    spin_up(s, skv_rig_value(s, SPIN), x, y);
    return skv_rig_add(s, SKV_INSTRUMENT_REGION, -1, -1, room + 1, room + 1, 0);
}

static void measure(rig *s, findings *found)
{
    skv_instrument all = build(s);
    double start_x = 0, start_y = 0, drift = 0;
    found->foreseen = true;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (int second = 0; second <= SECONDS; second++) {
        skv_rig_wait(s, second > 0);
        skv_rig_sample(s);
        double now_x = skv_rig_read(s, all, 4), now_y = skv_rig_read(s, all, 5);
        if (second == 0) {
            start_x = now_x;
            start_y = now_y;
        }
        double dx = now_x - start_x, dy = now_y - start_y;
        double change = sqrt((dx * dx + dy * dy) / (start_x * start_x + start_y * start_y));
        drift = fmax(drift, change);
        skv_plot_point(&found->plot, second, change);
    }
    found->measured[0] = drift;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    (void)condition;
    expected->theory[0] = 0;
    skv_plot_begin(plot, "theory: none", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, 0);
    skv_plot_point(plot, SECONDS, 0);
}

const experiment skv_exp_momentum = {
    .info =
        {
            .name = "momentum",
            .title = "Momentum",
            .description = "A blob without gravity drifts and turns: its momentum stays as it was.",
            .question = "Does a blob of water that touches nothing keep its momentum?",
            .predict = "After ten seconds of tumbling with all of its inner collisions: by how "
                       "much has the momentum changed?",
            .measure = "A blob without gravity drifts and turns. The momentum of all its particles "
                       "is added up every second.",
            .compare = "Inner forces come in opposite pairs (Newton's third law), so they cannot "
                       "change the sum. What is left are rounding errors: about a ten-millionth.",
            .x_label = "time (s)",
            .y_label = "change of momentum / momentum",
        },
    .parameters =
        {
            [SIZE] = {"momentum.size", SKV_FIELD_NUMBER, "m", 0.05, 2, NULL, "0.5",
                      "side of the square blob"},
            [SPEED] = {"momentum.speed", SKV_FIELD_NUMBER, "m/s", 0.001, 1, NULL, "0.3",
                       "speed with which it drifts"},
            [SPIN] = {"momentum.spin", SKV_FIELD_NUMBER, "1/s", 0, 5, NULL, "0.5",
                      "its angular velocity"},
        },
    .count = 1,
    /* Single precision: 6e-8 a rounding. */
    .quantities = {{"momentum drift in 10 s", "", 1e-6, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
