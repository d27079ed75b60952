/* Floating: how deep bodies of three densities lie in water.
 *
 * Three flat blocks are let go when half of each is under water, and left alone for eight seconds
 * of scale 1. Then their heights and the level between them are watched for four: a block's draught
 * is the level above its underside.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"
#include "skvalp/bodies.h"

#include <math.h>

enum { BLOCKS = 3, GAUGES = BLOCKS + 1, WAIT = 8, WATCH = 4 };
enum { LENGTH, HEIGHT, DEPTH, MIDDLE };
enum { C_WATER, C_HEIGHT, C_DENSITIES };

/* Width of the pool in lengths of a block: gaps are longer than blocks. */
#define WIDTH 8.0
/* Of the first and the last block, kg/m^2. */
#define LIGHT 100
#define HEAVY 900
/* What a draught may be off by: 1 mm where the spacing is 15.5 mm, in spacings. */
#define BOUND (1 / 15.5)

typedef struct pool {
    double length, height, depth, top; /* of a block, of the water, of the world */
    double densities[BLOCKS];
} pool;

/* The middle of a block at the start. */
static double place_of(const pool *p, int i)
{
    return WIDTH * p->length * (i + 0.5) / BLOCKS;
}

/* The pool, with a notch for the lower half of each block. */
static shape water_around(const pool *p)
{
    double half = p->length / 2, low = p->depth - p->height / 2, right = WIDTH * p->length;
    shape water = skv_shape_box(0, 0, right, p->depth);
    for (int i = BLOCKS - 1; i >= 0; i--) {
        double x = place_of(p, i);
        const double xs[4] = {x + half, x + half, x - half, x - half};
        const double ys[4] = {p->depth, low, low, p->depth};
        for (int k = 0; k < 4; k++) {
            water.x[water.corners - 1] = xs[k];
            water.y[water.corners - 1] = ys[k];
            water.corners++;
        }
    }
    water.x[water.corners - 1] = 0;
    water.y[water.corners - 1] = p->depth;
    return water;
}

static void build(rig *s, const pool *p)
{
    double half = p->length / 2, low = p->depth - p->height / 2;
    rig_plan plan = {.width = WIDTH * p->length,
                     .height = p->top,
                     .waters = 1,
                     .water = {water_around(p)},
                     .depth = p->depth,
                     .gravity_y = -skv_rig_gravity(s),
                     .bodies = BLOCKS};
    for (int i = 0; i < BLOCKS; i++) {
        double x = place_of(p, i);
        shape block = skv_shape_box(x - half, low, x + half, low + p->height);
        plan.body[i] = (plan_body){block, p->densities[i]};
    }
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
}

static skv_body look(const rig *s, int i)
{
    skv_body body = {0};
    if (skv_rig_ok(s))
        skv_world_body_at(s->world, i, &body);
    return body;
}

/* In the middle of what lies between two blocks, or a block and a wall. */
static void add_gauges(rig *s, const pool *p, skv_instrument *gauges)
{
    double half = p->length / 2;
    for (int i = 0; i < GAUGES; i++) {
        double left = i > 0 ? (double)look(s, i - 1).x + half : 0;
        double right = i < BLOCKS ? (double)look(s, i).x - half : WIDTH * p->length;
        double x = (left + right) / 2;
        gauges[i] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, 0, x, p->top, 0);
    }
}

static void measure(rig *s, findings *found)
{
    double pace = skv_rig_pace(s), draughts[BLOCKS] = {0};
    pool p = {.length = skv_rig_length(s, LENGTH),
              .height = skv_rig_length(s, HEIGHT),
              .depth = skv_rig_length(s, DEPTH),
              .densities = {LIGHT, skv_rig_value(s, MIDDLE), HEAVY}};
    p.top = p.depth + 3 * p.height;
    skv_rig_require(s, p.depth >= 1.5 * p.height && p.length >= 2 * p.height,
                    "float.height: it must not exceed two thirds of the depth and half the length");
    s->total = (WAIT + WATCH) * pace;
    build(s, &p);
    skv_rig_wait(s, WAIT * pace);
    skv_instrument gauges[GAUGES];
    add_gauges(s, &p, gauges);
    int frames = (int)(WATCH * pace * 60);
    for (int f = 0; f < frames; f++) {
        skv_rig_watch(s, 1 / 60.0);
        double level = skv_rig_mean_level(s, gauges, GAUGES);
        for (int i = 0; i < BLOCKS; i++)
            draughts[i] += (level - ((double)look(s, i).y - p.height / 2)) / frames;
    }
    found->condition[C_WATER] = skv_rig_density(s);
    found->condition[C_HEIGHT] = p.height;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < BLOCKS; i++) {
        found->condition[C_DENSITIES + i] = p.densities[i];
        found->measured[i] = draughts[i];
        skv_plot_point(&found->plot, p.densities[i] / skv_rig_density(s), draughts[i] / p.height);
    }
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double water = condition[C_WATER], height = condition[C_HEIGHT];
    for (int i = 0; i < BLOCKS; i++)
        expected->theory[i] = skv_theory_draught(water, condition[C_DENSITIES + i], height);
    skv_plot_begin(plot, "theory: Archimedes", SKV_CURVE_THEORY);
    skv_plot_point(plot, 0, 0);
    skv_plot_point(plot, 1, skv_theory_draught(water, water, height) / height);
}

const experiment skv_exp_float = {
    .info =
        {
            .name = "float",
            .title = "Floating blocks",
            .description = "Three flat blocks of different weight float in a pool: how deep each "
                           "of them lies.",
            .question = "How deep does a block lie in water that is a tenth, half or nine tenths "
                        "as heavy as water?",
            .predict = "Draw the three blocks with the water's level across them. How much of "
                       "each is below it?",
            .measure = "The blocks are let go half under water and left alone until they are calm. "
                       "Gauges between them read the level; how far a block's underside is below "
                       "it is its draught.",
            .compare = "A block that floats displaces as much water as it weighs itself "
                       "(Archimedes). So the share of it that is under water is its density over "
                       "that of water: a tenth, half, nine tenths, whatever its size.",
            .x_label = "density / that of water",
            .y_label = "draught / height",
        },
    .parameters = SKV_BESIDE_ROWS([LENGTH] = {"float.length", SKV_FIELD_NUMBER, "m", 0.1, 0.5, NULL,
                                              "0.3", "length of each block"},
                                  [HEIGHT] = {"float.height", SKV_FIELD_NUMBER, "m", 0.05, 0.25,
                                              NULL, "0.1", "height of each block"},
                                  [DEPTH] = {"float.depth", SKV_FIELD_NUMBER, "m", 0.1, 1, NULL,
                                             "0.2", "depth of the water at the start"},
                                  [MIDDLE] = {"float.density", SKV_FIELD_NUMBER, "kg/m^2", 20, 980,
                                              NULL, "500", "density of the block in the middle"}),
    .count = BLOCKS,
    .quantities = SKV_BESIDE_ROWS({"draught, a tenth as heavy", "m", BOUND, IN_SPACINGS, 0},
                                  {"draught, half as heavy", "m", BOUND, IN_SPACINGS, 0},
                                  {"draught, nine tenths as heavy", "m", BOUND, IN_SPACINGS, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
