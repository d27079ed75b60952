/* Momentum: a blob that drifts and turns without gravity, far from all walls, keeps its momentum.
 *
 * The blob is a square, so that it pulls itself round while it drifts. Its mean velocity is read
 * once a second for ten seconds; what counts is the largest deviation from the first.
 */
#include "experiments/experiment.h"

#include <math.h>

enum { SECONDS = 10 };

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    double size = skv_settings_length(s->settings, PARAM_BLOB_SIZE);
    double speed = s->settings->value[PARAM_BLOB_SPEED];
    double spin = s->settings->value[PARAM_BLOB_SPIN], vx = 0.8 * speed, vy = 0.6 * speed;
    double room = 2.5 * size + SECONDS * speed, middle = room / 2;
    skv_stage_choose_spacing(s, size * size, 1);
    stage_plan plan = {.width = room, .height = room, .depth = size};
    s->total = SECONDS;
    skv_instrument all;
    skv_result result = skv_stage_check_passage(s, "momentum.size", size, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    double x0 = middle - size / 2 - vx * SECONDS / 2, y0 = middle - size / 2 - vy * SECONDS / 2;
    if (result == SKV_OK)
        result = skv_stage_fill(s, x0, y0, x0 + size, y0 + size, NULL, NULL, error);
    skv_particles p = {0};
    if (result == SKV_OK)
        p = skv_world_particles(s->world);
    for (int i = 0; i < p.count && result == SKV_OK; i++) {
        double turn_x = -spin * ((double)p.y[i] - y0 - size / 2);
        double turn_y = spin * ((double)p.x[i] - x0 - size / 2);
        result = skv_world_add_velocity(s->world, i, 1, (float)(vx + turn_x), (float)(vy + turn_y),
                                        error);
    }
    if (result == SKV_OK)
        result =
            skv_stage_add(s, SKV_INSTRUMENT_REGION, -1, -1, room + 1, room + 1, 0, &all, error);
    double start_x = 0, start_y = 0, drift = 0;
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    for (int second = 0; second <= SECONDS && result == SKV_OK; second++) {
        if (second > 0)
            result = skv_stage_wait(s, 1, error);
        if (result == SKV_OK)
            result = skv_lab_sample(s->lab, s->world, error);
        double now_x = skv_lab_reading(s->lab, all, 4), now_y = skv_lab_reading(s->lab, all, 5);
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
    return result;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    (void)condition;
    expected->theory[0] = 0;
    skv_plot_begin(plot, "theory: none", CURVE_THEORY);
    skv_plot_point(plot, 0, 0);
    skv_plot_point(plot, SECONDS, 0);
}

const experiment skv_exp_momentum = {
    .info = {"momentum", "Momentum",
             "A blob without gravity drifts and turns: its momentum stays as it was."},
    .x_label = "time (s)",
    .y_label = "change of momentum / momentum",
    .count = 1,
    /* Single precision: 6e-8 a rounding. */
    .quantities = {{"momentum drift in 10 s", "", 1e-6, false, 0}},
    .measure = measure,
    .expect = expect,
};
