/* Layers: the pressure through a liquid that lies on a heavier one, oil on water and water on
 * mercury.
 *
 * One tank after the other is filled, left alone for six seconds of scale 1, then watched for
 * three. Of each liquid an upper and a lower layer give their mean pressure and mean depth below
 * the surface that the level gauges see. They keep two spacings away from the interface, whose
 * height is twice that of the lower liquid's centre.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"
#include "skvalp/query.h"

#include <math.h>
#include <string.h>

enum { TANKS = 2, LIQUIDS = 2, HALVES = 2, ZONES = LIQUIDS * HALVES };
enum { GAUGES = 9, WAIT = 6, WATCH = 3 };
enum { WIDTH, DEPTH, OIL };

/* In spacings: how far from the interface the layers end. */
#define OFF 2.0

/* Each tank has its densities, how deep its interface lies, and where its layers are. */
enum { C_GRAVITY, C_FIRST };
enum { C_UPPER, C_LOWER, C_INTERFACE, C_ZONES, PER_TANK = C_ZONES + ZONES };
_Static_assert(C_FIRST + TANKS * PER_TANK <= MAX_CONDITIONS, "layers has too many conditions");

typedef struct tank {
    double width, depth; /* of each liquid */
    bool mercury;        /* below water; else oil on it */
    skv_instrument gauges[GAUGES], zones[ZONES];
} tank;

static double density_of(const char *name)
{
    const skv_material *material = skv_material_info(0);
    for (int i = 1; material && strcmp(material->name, name) != 0; i++)
        material = skv_material_info(i);
    return material ? (double)material->density : (double)NAN;
}

/* What is not water is the second of the fluids. */
static void build(rig *s, tank *t, double density)
{
    double width = t->width, middle = t->depth, top = 2 * t->depth;
    rig_plan plan = {
        .width = width,
        .height = 1.4 * top,
        .waters = LIQUIDS,
        .water = {skv_shape_box(0, middle, width, top), skv_shape_box(0, 0, width, middle)},
        .depth = top,
        .gravity_y = -skv_rig_gravity(s),
        .fluids = 1,
        .fluid = {{t->mercury ? "mercury" : "oil", density, 0}}};
    plan.fluid_of[t->mercury] = 1;
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
    skv_rig_check_passage(s, WIDTH, 0.2);
    for (int i = 0; i < GAUGES; i++) {
        double x = width * (0.25 + 0.5 * i / (GAUGES - 1));
        t->gauges[i] =
            skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, plan.height, WATCH * skv_rig_pace(s));
    }
}

static double height_of_interface(const rig *s, const tank *t)
{
    return skv_rig_ok(s) ? 2 * skv_world_fluid_stats(s->world, t->mercury).centre_y : (double)NAN;
}

/* From the surface down. */
static void add_zones(rig *s, tank *t)
{
    skv_rig_sample(s);
    double interface = height_of_interface(s, t), off = OFF * s->spacing;
    double away = fmin(4 * s->h, 0.4 * t->width);
    double top[LIQUIDS] = {skv_rig_mean_level(s, t->gauges, GAUGES), interface - off};
    double bottom[LIQUIDS] = {interface + off, 0};
    for (int i = 0; i < ZONES; i++) {
        int liquid = i / HALVES, half = i % HALVES;
        double thickness = (top[liquid] - bottom[liquid]) / HALVES;
        double high = top[liquid] - half * thickness;
        t->zones[i] = skv_rig_add(s, SKV_INSTRUMENT_REGION, away, high - thickness, t->width - away,
                                  high, WATCH * skv_rig_pace(s));
    }
}

static const char *const labels[TANKS] = {PLOT_LABEL("oil on water"),
                                          PLOT_LABEL("water on mercury")};

static void measure_tank(rig *s, tank *t, double density, int k, findings *found)
{
    build(s, t, density);
    skv_rig_wait(s, WAIT * skv_rig_pace(s));
    add_zones(s, t);
    skv_rig_watch(s, WATCH * skv_rig_pace(s));
    double surface = skv_rig_mean_level(s, t->gauges, GAUGES);
    double *condition = found->condition + C_FIRST + k * PER_TANK;
    condition[C_UPPER] = t->mercury ? skv_rig_density(s) : density;
    condition[C_LOWER] = t->mercury ? density : skv_rig_density(s);
    condition[C_INTERFACE] = surface - height_of_interface(s, t);
    skv_plot_begin(&found->plot, labels[k], k ? SKV_CURVE_RINGS : SKV_CURVE_DOTS);
    for (int i = 0; i < ZONES; i++) {
        found->measured[k * ZONES + i] = skv_rig_read(s, t->zones[i], 6);
        condition[C_ZONES + i] = surface - skv_rig_read(s, t->zones[i], 3);
        skv_plot_point(&found->plot, condition[C_ZONES + i], found->measured[k * ZONES + i]);
    }
}

static void measure(rig *s, findings *found)
{
    s->total = TANKS * (WAIT + WATCH) * skv_rig_pace(s);
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    for (int k = 0; k < TANKS; k++) {
        tank t = {
            .width = skv_rig_length(s, WIDTH), .depth = skv_rig_length(s, DEPTH), .mercury = k};
        measure_tank(s, &t, k ? density_of("mercury") : skv_rig_value(s, OIL), k, found);
    }
}

static double theory_at(const double *condition, int k, double depth)
{
    const double *c = condition + C_FIRST + k * PER_TANK;
    return skv_theory_layered_pressure(c[C_UPPER], c[C_LOWER], condition[C_GRAVITY], c[C_INTERFACE],
                                       depth);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    /* One line up through the first tank and down through the second. */
    skv_plot_begin(plot, "theory: the weight above", SKV_CURVE_THEORY);
    for (int k = 0; k < TANKS; k++) {
        const double *c = condition + C_FIRST + k * PER_TANK;
        for (int i = 0; i < ZONES; i++)
            expected->theory[k * ZONES + i] = theory_at(condition, k, c[C_ZONES + i]);
        for (int i = 0; i <= LIQUIDS; i++) {
            double depth = (k ? i : LIQUIDS - i) * c[C_INTERFACE];
            skv_plot_point(plot, depth, theory_at(condition, k, depth));
        }
    }
}

const experiment skv_exp_layers = {
    .info =
        {
            .name = "layers",
            .title = "Layers of liquids",
            .description = "Oil that lies on water, and water that lies on mercury: the pressure "
                           "in both liquids.",
            .question = "How does the pressure grow through a liquid that lies on a heavier one?",
            .predict = "Sketch pressure against depth, first for oil on water, then for water on "
                       "mercury. What happens to the line where one liquid ends?",
            .measure = "A tank is filled with a layer of each liquid and stands until it is calm. "
                       "In each liquid an upper and a lower zone read the mean pressure and the "
                       "mean height over three seconds. Then the other two liquids follow.",
            .compare = "Each liquid adds its own weight: the pressure is density times gravity "
                       "times thickness, summed over the layers above. So the line is straight in "
                       "each liquid and bends where they meet. Oil is a tenth lighter than water, "
                       "and the bend is hard to see; mercury is 13.5 times as heavy.",
            .x_label = "depth below the surface (m)",
            .y_label = "pressure (Pa m)",
        },
    .parameters = SKV_BESIDE_ROWS([WIDTH] = {"layers.width", SKV_FIELD_NUMBER, "m", 0.2, 4, NULL,
                                             "1", "width of the tank"},
                                  [DEPTH] = {"layers.depth", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL,
                                             "0.2", "depth of each liquid"},
                                  [OIL] = {"layers.oil", SKV_FIELD_NUMBER, "kg/m^2", 10, 990, NULL,
                                           "900", "density of the oil"}),
    .count = TANKS * ZONES,
    /* The zones are half as thick as those of a pool; mercury's weight is to be nearer. */
    .quantities =
        SKV_BESIDE_ROWS({"oil on water, high in the oil", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"oil on water, low in the oil", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"oil on water, high in the water", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"oil on water, low in the water", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"water on mercury, high in the water", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"water on mercury, low in the water", "Pa m", 0.03, AS_WRITTEN, 0},
                        {"water on mercury, high in the mercury", "Pa m", 0.02, AS_WRITTEN, 0},
                        {"water on mercury, low in the mercury", "Pa m", 0.02, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
