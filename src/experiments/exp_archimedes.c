/* Archimedes: the force of water at rest on a body that is held in it.
 *
 * A square body is fixed in the middle of a pool. After six seconds of scale 1 the force meter
 * watches for four.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

enum { WAIT = 6, WATCH = 4 };
enum { SIZE, DEPTH };
enum { C_DENSITY, C_GRAVITY, C_AREA, C_PACE };

static skv_instrument build(rig *s, double size, double depth)
{
    double width = 5 * size, below = size, level = below + size + depth;
    double x = width / 2 - size / 2, margin = size / 4;
    double pace = skv_rig_pace(s);
    s->total = (WAIT + WATCH) * pace;
    rig_plan plan = {.width = width,
                     .height = level + size,
                     .solids = 1,
                     .solid = {skv_shape_box(x, below, x + size, below + size)},
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, width, level)},
                     .depth = level,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SIZE, 1);
    skv_rig_check_passage(s, DEPTH, 1);
    return skv_rig_add(s, SKV_INSTRUMENT_FORCE, x - margin, below - margin, x + size + margin,
                       below + size + margin, WATCH * pace);
}

static void draw(const rig *s, const void *meter, findings *found)
{
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_LINE);
    skv_rig_trace(s, *(const skv_instrument *)meter, 1, 1);
}

static void measure(rig *s, findings *found)
{
    double size = skv_rig_length(s, SIZE);
    skv_instrument meter = build(s, size, skv_rig_length(s, DEPTH));
    found->condition[C_DENSITY] = skv_rig_density(s);
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    found->condition[C_AREA] = size * size;
    found->condition[C_PACE] = skv_rig_pace(s);
    found->foreseen = true;
    skv_rig_show(s, draw, &meter);
    skv_rig_wait(s, WAIT * skv_rig_pace(s));
    skv_rig_watch(s, WATCH * skv_rig_pace(s));
    found->measured[0] = skv_rig_read(s, meter, 1);
    skv_rig_draw(s);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] =
        skv_theory_buoyancy(condition[C_DENSITY], condition[C_GRAVITY], condition[C_AREA]);
    skv_plot_begin(plot, "theory: weight of the displaced water", SKV_CURVE_THEORY);
    skv_plot_point(plot, WAIT * condition[C_PACE], expected->theory[0]);
    skv_plot_point(plot, (WAIT + WATCH) * condition[C_PACE], expected->theory[0]);
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
            .scatters = true,
        },
    .parameters =
        {
            [SIZE] = {"archimedes.size", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.2",
                      "side of the square body"},
            [DEPTH] = {"archimedes.depth", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.2",
                       "depth of its upper side below the surface"},
        },
    .count = 1,
    .quantities = {{"force upwards", "N", 0.03, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
