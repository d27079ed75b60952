/* Hydrostatics: the pressure in a pool at rest grows with the depth, and the pool keeps its volume.
 *
 * The pool is filled and left alone for six seconds of scale 1, then watched for three: six layers
 * of equal thickness, away from the side walls by four smoothing radii, give their mean pressure
 * and mean depth below the surface that the level gauges see.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { LAYERS = 6, GAUGES = 9, WAIT = 6, WATCH = 3 };
enum { WIDTH, DEPTH };

/* Conditions: the layers' depths first. */
enum { C_DENSITY = LAYERS, C_GRAVITY, C_FILLED };

typedef struct pool {
    double width, depth, watch;
    skv_instrument gauges[GAUGES], layers[LAYERS];
} pool;

static void build(rig *s, pool *p)
{
    s->total = WAIT * skv_rig_pace(s) + p->watch;
    rig_plan plan = {.width = p->width,
                     .height = 1.4 * p->depth,
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, p->width, p->depth)},
                     .depth = p->depth,
                     .gravity_y = -skv_rig_gravity(s)};
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
    skv_rig_check_passage(s, WIDTH, 0.2);
    for (int i = 0; i < GAUGES; i++) {
        double x = p->width * (0.25 + 0.5 * i / (GAUGES - 1));
        p->gauges[i] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, 1.4 * p->depth, p->watch);
    }
}

/* Layers need to know the level, so they are set up when the water is calm. */
static void add_layers(rig *s, pool *p)
{
    skv_rig_sample(s);
    double thickness = skv_rig_mean_level(s, p->gauges, GAUGES) / LAYERS,
           away = fmin(4 * s->h, 0.4 * p->width);
    for (int i = 0; i < LAYERS; i++)
        p->layers[i] = skv_rig_add(s, SKV_INSTRUMENT_REGION, away, i * thickness, p->width - away,
                                   (i + 1) * thickness, p->watch);
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    const pool *p = set_up;
    double surface = skv_rig_mean_level(s, p->gauges, GAUGES);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < LAYERS; i++) {
        /* From the surface down. */
        skv_instrument layer = p->layers[LAYERS - 1 - i];
        found->measured[i] = skv_rig_read(s, layer, 6);
        found->condition[i] = surface - skv_rig_read(s, layer, 3);
        skv_plot_point(&found->plot, found->condition[i], found->measured[i]);
    }
}

static void measure(rig *s, findings *found)
{
    pool p = {.width = skv_rig_length(s, WIDTH),
              .depth = skv_rig_length(s, DEPTH),
              .watch = WATCH * skv_rig_pace(s)};
    build(s, &p);
    skv_rig_wait(s, WAIT * skv_rig_pace(s));
    add_layers(s, &p);
    found->condition[C_FILLED] = skv_rig_area(s);
    found->condition[C_DENSITY] = skv_rig_density(s);
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    found->foreseen = true;
    skv_rig_show(s, draw, &p);
    skv_rig_watch(s, p.watch);
    skv_rig_draw(s);
    found->measured[LAYERS] = skv_rig_mean_level(s, p.gauges, GAUGES) * p.width;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    skv_plot_begin(plot, "theory: density g z", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, 0);
    for (int i = 0; i < LAYERS; i++) {
        expected->theory[i] =
            skv_theory_pressure(condition[C_DENSITY], condition[C_GRAVITY], condition[i]);
        skv_plot_point(plot, condition[i], expected->theory[i]);
    }
    expected->theory[LAYERS] = condition[C_FILLED];
}

const experiment skv_exp_hydrostatics = {
    .info =
        {
            .name = "hydrostatics",
            .title = "Pressure in a pool",
            .description =
                "A pool at rest: the pressure in six layers, and the volume of the whole.",
            .question = "How does the pressure in still water grow with the depth?",
            .predict = "Sketch pressure against depth from the surface to the floor. Is it twice "
                       "as large at twice the depth? Would a wider pool change it?",
            .measure =
                "A pool stands until it is calm. Six layers read the mean pressure and the mean "
                "height of their water over three seconds; nine level gauges read the surface.",
            .compare = "The weight of the water above a point, spread over the area that carries "
                       "it, is density times gravity times depth: a straight line through the "
                       "surface, whatever the pool's width. The points should lie on it; the layer "
                       "at the floor is the hardest, since half of its neighbours are wall.",
            .x_label = "depth below the surface (m)",
            .y_label = "pressure (Pa m)",
        },
    .parameters =
        {
            [WIDTH] = {"hydrostatics.width", SKV_FIELD_NUMBER, "m", 0.2, 4, NULL, "1",
                       "width of the pool"},
            [DEPTH] = {"hydrostatics.depth", SKV_FIELD_NUMBER, "m", 0.1, 2, NULL, "0.5",
                       "depth of the pool"},
        },
    .count = LAYERS + 1,
    .quantities = {{"pressure, layer 1", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"pressure, layer 2", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"pressure, layer 3", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"pressure, layer 4", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"pressure, layer 5", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"pressure, layer 6", "Pa m", 0.02, AS_WRITTEN, 0},
                   {"volume kept", "m^2", 0.01, AS_WRITTEN, 0}},
    .measure = measure,
    .expect = expect,
};
