/* Archimedes: the force of water at rest on a body that is held in it.
 *
 * A square body is fixed in the middle of a pool. After six seconds the force meter watches for
 * four.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

enum { WAIT = 6, WATCH = 4, MAX_SAMPLES = 1000 };
enum { SIZE, DEPTH };
enum { C_DENSITY, C_GRAVITY, C_AREA };

static skv_instrument build(stage *s, double size, double depth)
{
    double width = 5 * size, below = size, level = below + size + depth;
    double x = width / 2 - size / 2, margin = size / 4;
    s->total = WAIT + WATCH;
    stage_plan plan = {.width = width,
                       .height = level + size,
                       .solids = 1,
                       .solid = {skv_shape_box(x, below, x + size, below + size)},
                       .waters = 1,
                       .water = {skv_shape_box(0, 0, width, level)},
                       .depth = level,
                       .gravity_y = -skv_stage_gravity(s)};
    skv_stage_build(s, &plan);
    skv_stage_check_passage(s, SIZE, 1);
    skv_stage_check_passage(s, DEPTH, 1);
    return skv_stage_add(s, SKV_INSTRUMENT_FORCE, x - margin, below - margin, x + size + margin,
                         below + size + margin, WATCH);
}

static void draw(const stage *s, const void *meter, findings *found)
{
    double times[MAX_SAMPLES], force[MAX_SAMPLES];
    int count = skv_stage_history(s, *(const skv_instrument *)meter, 1, times, force, MAX_SAMPLES);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    for (int i = 0; i < count; i++)
        skv_plot_point(&found->plot, times[i], force[i]);
}

static void measure(stage *s, findings *found)
{
    double size = skv_stage_length(s, SIZE);
    skv_instrument meter = build(s, size, skv_stage_length(s, DEPTH));
    found->condition[C_DENSITY] = skv_stage_density(s);
    found->condition[C_GRAVITY] = skv_stage_gravity(s);
    found->condition[C_AREA] = size * size;
    found->foreseen = true;
    skv_stage_show(s, draw, &meter);
    skv_stage_wait(s, WAIT);
    skv_stage_watch(s, WATCH);
    found->measured[0] = skv_stage_read(s, meter, 1);
    skv_stage_draw(s);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] =
        skv_theory_buoyancy(condition[C_DENSITY], condition[C_GRAVITY], condition[C_AREA]);
    skv_plot_begin(plot, "theory: weight of the displaced water", SKV_CURVE_THEORY);
    skv_plot_point(plot, WAIT, expected->theory[0]);
    skv_plot_point(plot, WAIT + WATCH, expected->theory[0]);
}

const experiment skv_exp_archimedes = {
    .info =
        {
            .name = "archimedes",
            .title = "Archimedes' force",
            .description = "What water at rest does to a body held in it.",
            .question = "With which force does water push a body upwards that is held under it?",
            .predict = "Guess the force in newtons. Does it grow when the body is held deeper? "
                       "Does the body's own weight matter?",
            .measure = "A square block is held in a pool. A force meter adds up what all the "
                       "particles do to its four sides.",
            .compare = "The pressure below is higher than above by density times gravity times "
                       "height, so the force is the weight of the water that the body displaces, "
                       "at any depth (Archimedes).",
            .x_label = "time (s)",
            .y_label = "force upwards (N)",
        },
    .parameters =
        {
            [SIZE] = {"archimedes.size", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.2",
                      "side of the square body"},
            [DEPTH] = {"archimedes.depth", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.2",
                       "depth of its upper side below the surface"},
        },
    .count = 1,
    .quantities = {{"force upwards", "N", 0.03, false, 0}},
    .measure = measure,
    .expect = expect,
};
