/* A droplet without gravity pulls itself round.
 *
 * It starts as an ellipse, overshoots and rings about its shape of rest, like a drop of any thin
 * liquid. So what is read is the mean shape over one whole swing: of the second moments of the
 * particles, from the first to the third time that the droplet is as wide as high; then the ratio
 * of the shorter to the longer principal axis. A droplet that does not swing is read in the end.
 * Particles farther from the centre than 1.3 radii of the circle have escaped.
 *
 * Beside it a drop of twelve particles, the smallest that looks like one, is laid as a circle and
 * left alone: rain is made of these.
 */
#include "base/exact.h"
#include "experiments/experiment.h"

#include <math.h>

enum { LONGEST = 60, CROSSINGS = 3 };
/* Particles of the small drop, and s after which its shape is read. */
enum { FEW = 12, LEFT_ALONE = 2 };
enum { RADIUS, ASPECT };
enum { C_TIME };

/* Second moments about the centre. */
typedef struct moments {
    double xx, xy, yy;
} moments;

/* The moments, and how many particles are beyond `limit` from the centre. */
static moments moments_of(const skv_particles *p, double limit, int *escaped)
{
    double x = 0, y = 0;
    moments m = {0};
    for (int i = 0; i < p->count; i++) {
        x += (double)p->x[i] / p->count;
        y += (double)p->y[i] / p->count;
    }
    *escaped = 0;
    for (int i = 0; i < p->count; i++) {
        double dx = (double)p->x[i] - x, dy = (double)p->y[i] - y;
        m.xx += dx * dx / p->count;
        m.xy += dx * dy / p->count;
        m.yy += dy * dy / p->count;
        *escaped += dx * dx + dy * dy > limit * limit;
    }
    return m;
}

/* Shorter over longer principal axis. */
static double axes(moments m)
{
    double mean = (m.xx + m.yy) / 2, half = (m.xx - m.yy) / 2;
    double root = sqrt(half * half + m.xy * m.xy);
    return sqrt((mean - root) / (mean + root));
}

static void watch(rig *s, findings *found, double limit)
{
    moments now = {0}, before = {0}, sum = {0};
    int escaped = 0, crossings = 0, counted = 0, frame = 0;
    found->condition[C_TIME] = LONGEST;
    found->foreseen = true;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (; frame <= LONGEST * 60 && crossings < CROSSINGS && skv_rig_ok(s); frame++) {
        if (frame > 0)
            skv_rig_wait(s, 1 / 60.0);
        skv_particles p = skv_world_particles(s->world);
        now = moments_of(&p, limit, &escaped);
        crossings += frame > 0 && (now.xx > now.yy) != (before.xx > before.yy);
        if (crossings > 0) {
            sum = (moments){sum.xx + now.xx, sum.xy + now.xy, sum.yy + now.yy};
            counted++;
        }
        before = now;
        skv_plot_point(&found->plot, frame / 60.0, axes(now));
    }
    found->measured[0] = axes(counted ? sum : now);
    found->measured[1] = escaped;
    found->condition[C_TIME] = (frame - 1) / 60.0;
}

/* The shape of the small drop, whose particles are as far apart as those of the large one. */
static double small_drop(rig *s)
{
    double radius = s->spacing * sqrt(FEW / SKV_PI), room = 10 * radius;
    rig_plan plan = {.width = room,
                     .height = room,
                     .waters = 1,
                     .water = {skv_shape_ellipse(room / 2, room / 2, radius, radius)},
                     .depth = 2 * radius};
    skv_rig_build_beside(s, &plan, FEW);
    skv_rig_wait(s, LEFT_ALONE);
    if (!skv_rig_ok(s))
        return (double)NAN;
    int escaped;
    skv_particles p = skv_world_particles(s->world);
    return axes(moments_of(&p, radius, &escaped));
}

static void measure(rig *s, findings *found)
{
    double radius = skv_rig_length(s, RADIUS), stretch = sqrt(skv_rig_value(s, ASPECT));
    double room = 5 * radius * stretch;
    s->total = LONGEST + LEFT_ALONE;
    rig_plan plan = {
        .width = room,
        .height = room,
        .waters = 1,
        .water = {skv_shape_ellipse(room / 2, room / 2, radius * stretch, radius / stretch)},
        .depth = 2 * radius * stretch,
    };
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, RADIUS, 1 / stretch);
    watch(s, found, 1.3 * radius);
    found->measured[2] = small_drop(s);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = 1;
    expected->theory[1] = 0;
    expected->theory[2] = 1;
    skv_plot_begin(plot, "theory: a circle", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, 1);
    skv_plot_point(plot, condition[C_TIME], 1);
}

const experiment skv_exp_droplet = {
    .info =
        {
            .name = "droplet",
            .title = "Droplet without gravity",
            .description = "An elongated droplet pulls itself round.",
            .question = "What does a drop do that was pulled out of shape and is left alone?",
            .predict =
                "Which shape has it in the end? Does it get there slowly, or does it swing past?",
            .measure = "An elongated droplet floats without gravity. The principal axes of its "
                       "particles give the shape, the mean one over a whole swing.",
            .compare =
                "Surface tension wants the shortest outline, which is a circle. Inertia carries "
                "the drop past it, so it rings and settles; no particle may be lost on the way.",
            .x_label = "time (s)",
            .y_label = "shorter / longer axis",
        },
    .parameters =
        SKV_BESIDE_ROWS([RADIUS] = {"droplet.radius", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.25",
                                    "radius of the circle of the same area"},
                        [ASPECT] = {"droplet.aspect", SKV_FIELD_NUMBER, "", 1, 3, NULL, "1.5",
                                    "length over width at the start"}),
    .count = 3,
    .quantities = SKV_BESIDE_ROWS({"shorter / longer axis", "", 0.05, AS_WRITTEN, 0},
                                  {"particles escaped", "", 0, AS_WRITTEN, 0},
                                  {"shorter / longer axis, 12 particles", "", 0.2, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
