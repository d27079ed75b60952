/* A droplet without gravity pulls itself round.
 *
 * It starts as an ellipse. After eight seconds its shape is read from the second moments of its
 * particles: the ratio of the shorter to the longer principal axis. Particles farther from the
 * centre than 1.3 radii of the circle have escaped.
 */
#include "lab/experiment.h"

#include <math.h>

enum { SECONDS = 8 };
enum { C_ASPECT };

typedef struct ellipse {
    double x, y, a, b;
} ellipse;

static bool inside(float x, float y, void *user)
{
    const ellipse *e = user;
    double dx = ((double)x - e->x) / e->a, dy = ((double)y - e->y) / e->b;
    return dx * dx + dy * dy < 1;
}

/* Shorter over longer principal axis, and how many are beyond `limit` from the centre. */
static double axes(const skv_particles *p, double limit, int *escaped)
{
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int i = 0; i < p->count; i++) {
        x += (double)p->x[i] / p->count;
        y += (double)p->y[i] / p->count;
    }
    *escaped = 0;
    for (int i = 0; i < p->count; i++) {
        double dx = (double)p->x[i] - x, dy = (double)p->y[i] - y;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
        *escaped += dx * dx + dy * dy > limit * limit;
    }
    double mean = (xx + yy) / 2, root = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    return sqrt((mean - root) / (mean + root));
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    double radius = skv_settings_length(s->settings, PARAM_DROPLET_RADIUS);
    double aspect = s->settings->value[PARAM_DROPLET_ASPECT];
    double room = 5 * radius * sqrt(aspect), pi = 3.14159265358979323846;
    ellipse e = {room / 2, room / 2, radius * sqrt(aspect), radius / sqrt(aspect)};
    skv_stage_choose_spacing(s, pi * radius * radius, 1);
    stage_plan plan = {.width = room, .height = room, .depth = 2 * e.a};
    s->total = SECONDS;
    skv_result result = skv_stage_check_passage(s, "droplet.radius", e.b, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, e.x - e.a, e.y - e.b, e.x + e.a, e.y + e.b, inside, &e, error);
    skv_plot_begin(&found->plot, "measured", CURVE_LINE);
    int escaped = 0;
    double shape = 0;
    for (int i = 0; i <= SECONDS * 60 && result == SKV_OK; i++) {
        if (i > 0)
            result = skv_stage_wait(s, 1 / 60.0, error);
        skv_particles p = skv_world_particles(s->world);
        shape = axes(&p, 1.3 * radius, &escaped);
        skv_plot_point(&found->plot, i / 60.0, shape);
    }
    found->measured[0] = shape;
    found->measured[1] = escaped;
    found->condition[C_ASPECT] = aspect;
    return result;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    (void)condition;
    expected->theory[0] = 1;
    expected->theory[1] = 0;
    skv_plot_begin(plot, "theory: a circle", CURVE_THEORY);
    skv_plot_point(plot, 0, 1);
    skv_plot_point(plot, SECONDS, 1);
}

const experiment skv_exp_droplet = {
    .info = {"droplet", "Droplet without gravity", "An elongated droplet pulls itself round."},
    .x_label = "time (s)",
    .y_label = "shorter / longer axis",
    .count = 2,
    .quantities = {{"shorter / longer axis", "", 0.05, false, 0},
                   {"particles escaped", "", 0, false, 0}},
    .measure = measure,
    .expect = expect,
};
