/* Hydrostatics: the pressure in a pool at rest grows with the depth, and the pool keeps its volume.
 *
 * The pool is filled and left alone for six seconds, then watched for three: six layers of equal
 * thickness, away from the side walls by four smoothing radii, give their mean pressure and mean
 * depth below the surface that the level gauges see.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>
#include <stdio.h>

enum { LAYERS = 6, GAUGES = 9, WAIT = 6, WATCH = 3 };

/* Conditions: the layers' depths first. */
enum { C_DENSITY = LAYERS, C_GRAVITY, C_FILLED };

typedef struct pool {
    double width, depth;
    skv_instrument gauges[GAUGES], layers[LAYERS];
} pool;

static skv_result build(stage *s, pool *p, skv_error *error)
{
    skv_stage_choose_spacing(s, p->width * p->depth, 1);
    stage_plan plan = {.width = p->width,
                       .height = 1.4 * p->depth,
                       .depth = p->depth,
                       .gravity_y = -s->settings->value[PARAM_GRAVITY]};
    s->total = WAIT + WATCH;
    skv_result result = skv_stage_check_passage(s, "hydrostatics.depth", p->depth, error);
    if (result == SKV_OK)
        result = skv_stage_check_passage(s, "hydrostatics.width", p->width / 5, error);
    if (result == SKV_OK)
        result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, p->width, p->depth, NULL, NULL, error);
    for (int i = 0; i < GAUGES && result == SKV_OK; i++) {
        double x = p->width * (0.25 + 0.5 * i / (GAUGES - 1));
        result = skv_stage_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, 1.4 * p->depth, WATCH,
                               &p->gauges[i], error);
    }
    return result;
}

/* Layers need to know the level, so they are set up when the water is calm. */
static skv_result add_layers(stage *s, pool *p, skv_error *error)
{
    skv_result result = skv_lab_sample(s->lab, s->world, error);
    double thickness = skv_stage_mean_level(s, p->gauges, GAUGES) / LAYERS,
           away = fmin(4 * s->h, 0.4 * p->width);
    for (int i = 0; i < LAYERS && result == SKV_OK; i++)
        result = skv_stage_add(s, SKV_INSTRUMENT_REGION, away, i * thickness, p->width - away,
                               (i + 1) * thickness, WATCH, &p->layers[i], error);
    return result;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    pool p = {.width = skv_settings_length(s->settings, PARAM_POOL_WIDTH),
              .depth = skv_settings_length(s->settings, PARAM_POOL_DEPTH)};
    skv_result result = build(s, &p, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, WAIT, error);
    if (result == SKV_OK)
        result = add_layers(s, &p, error);
    for (int i = 0; i < WATCH * 60 && result == SKV_OK; i++)
        result = skv_stage_frame(s, error);
    if (result != SKV_OK)
        return result;
    double surface = skv_stage_mean_level(s, p.gauges, GAUGES);
    skv_plot_begin(&found->plot, "measured", CURVE_DOTS);
    for (int i = 0; i < LAYERS; i++) {
        /* From the surface down. */
        skv_instrument layer = p.layers[LAYERS - 1 - i];
        found->measured[i] = skv_lab_reading(s->lab, layer, 6);
        found->condition[i] = surface - skv_lab_reading(s->lab, layer, 3);
        skv_plot_point(&found->plot, found->condition[i], found->measured[i]);
    }
    int particles = skv_world_particle_count(s->world);
    found->measured[LAYERS] = surface * p.width;
    found->condition[C_FILLED] = particles * s->spacing * s->spacing;
    found->condition[C_DENSITY] = s->settings->value[PARAM_DENSITY];
    found->condition[C_GRAVITY] = s->settings->value[PARAM_GRAVITY];
    return SKV_OK;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    skv_plot_begin(plot, "theory: density g z", CURVE_THEORY);
    skv_plot_point(plot, 0, 0);
    for (int i = 0; i < LAYERS; i++) {
        expected->theory[i] =
            skv_theory_pressure(condition[C_DENSITY], condition[C_GRAVITY], condition[i]);
        skv_plot_point(plot, condition[i], expected->theory[i]);
    }
    expected->theory[LAYERS] = condition[C_FILLED];
}

const experiment skv_exp_hydrostatics = {
    .info = {"hydrostatics", "Pressure in a pool",
             "A pool at rest: the pressure in six layers, and the volume of the whole."},
    .x_label = "depth below the surface (m)",
    .y_label = "pressure (Pa m)",
    .count = LAYERS + 1,
    .quantities = {{"pressure, layer 1", "Pa m", 0.06, false, 0},
                   {"pressure, layer 2", "Pa m", 0.06, false, 0},
                   {"pressure, layer 3", "Pa m", 0.06, false, 0},
                   {"pressure, layer 4", "Pa m", 0.06, false, 0},
                   {"pressure, layer 5", "Pa m", 0.06, false, 0},
                   {"pressure, layer 6", "Pa m", 0.06, false, 0},
                   {"volume kept", "m^2", 0.05, false, 0}},
    .measure = measure,
    .expect = expect,
};
