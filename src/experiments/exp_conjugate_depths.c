/* Conjugate depths: streams run against a wall, and what stands before it grows as a bore that runs
 * back: how deep it is, and how fast.
 *
 * Three streams, each in a channel of its own, fill it from end to end and start with the speed
 * that makes a bore of the Froude number wanted. At the other end the stream leaves its wall, and
 * thins out from there on. Before that meets the bore a stretch of the stream is read where it
 * would, and a stretch beside the wall, where the water stands. A stretch's depth is what it
 * contains over its length. Cells on the bore's way tell when it came to them.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"

#include <math.h>

enum { BORES = 3, CELLS = 20, MAX_SAMPLES = 2000 };
enum { DEPTH, LENGTH };

#define FRAME (1 / 60.0) /* s between readings */

/* Each stream has its depth and its speed. */
enum { C_GRAVITY, C_FIRST };
enum { C_DEPTH, C_SPEED, PER_BORE };

/* Of the bores: a weak one, whose front is a row of waves, one that breaks, and one that rolls. */
static const double froude[BORES] = {1.5, 2, 2.5};

/* In depths: how high the water may splash at the wall, twice what a stone reaches that is thrown
 * up as fast as the strongest stream. */
#define ROOM 5.0
/* In lengths: the stretch that reads the stream, upstream from where bore and thinning meet. */
#define STREAM 0.06
/* In depths: the length of a cell. A bore is several depths long. */
#define CELL 2.0
/* Of the time until bore and thinning meet: all that is watched. */
#define UNTIL 0.8
/* In that time and in what the bore will have come by then: from when on it has formed, which takes
 * it five to ten depths, and where the last of the cells is. */
#define FORMED 0.45
#define PASSED 0.9
/* In the same: the stretch that stands, and from when on it is read. */
#define STILL  0.5
#define STANDS 0.75

typedef struct channel {
    double length, depth;
    double speed, bore; /* of the stream and of the bore by theory, m/s */
    double meet, until; /* where bore and thinning meet, m; what is watched, s */
    skv_instrument stream, stands, cells[CELLS];
    double far[CELLS]; /* of the cells' middles from the wall, m */
} channel;

static channel channel_at(const rig *s, int k)
{
    channel c = {.length = skv_rig_length(s, LENGTH), .depth = skv_rig_length(s, DEPTH)};
    double wave = sqrt(skv_rig_gravity(s) * c.depth);
    /* Water runs into the bore with F wave, and out of it with what the bore has. */
    c.bore = froude[k] * wave / skv_theory_conjugate(froude[k]);
    c.speed = froude[k] * wave - c.bore;
    double time = c.length / (c.speed + wave + c.bore);
    c.meet = c.length - c.bore * time;
    c.until = UNTIL * time;
    return c;
}

static void build(rig *s, const channel *c)
{
    rig_plan plan = {
        .width = c->length,
        .height = ROOM * c->depth,
        .waters = 1,
        .water = {skv_shape_box(0, 0, c->length, c->depth)},
        .depth = skv_theory_conjugate(froude[BORES - 1]) * c->depth,
        .gravity_y = -skv_rig_gravity(s),
        /* The stream is the shallowest thing here: eight spacings with 2000 particles. */
        .share = 4};
    plan.water[0].vx = c->speed;
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, DEPTH, 1);
}

static void add_instruments(rig *s, channel *c)
{
    double high = ROOM * c->depth, way = c->bore * c->until, half = CELL * c->depth / 2;
    c->stream = skv_rig_add(s, SKV_INSTRUMENT_REGION, c->meet - STREAM * c->length, 0, c->meet,
                            high, (1 - FORMED) * c->until);
    c->stands = skv_rig_add(s, SKV_INSTRUMENT_REGION, c->length - STILL * way, 0, c->length, high,
                            (1 - STANDS) * c->until);
    for (int i = 0; i < CELLS; i++) {
        c->far[i] = way * (FORMED + (PASSED - FORMED) * (i + 1) / (CELLS + 1));
        double x = c->length - c->far[i];
        c->cells[i] = skv_rig_add(s, SKV_INSTRUMENT_REGION, x - half, 0, x + half, high, 0);
    }
}

/* When the bore came to a cell: as long before the end as the cell has held more than an area.
 * Splashes that a bore throws ahead, and the troughs behind, move that by no more than they last.
 */
static double when_passed(const rig *s, skv_instrument cell, double area)
{
    double times[MAX_SAMPLES], areas[MAX_SAMPLES];
    int count = skv_rig_history(s, cell, 1, times, areas, MAX_SAMPLES), above = 0;
    for (int i = 0; i < count; i++)
        above += areas[i] > area;
    return -above * FRAME;
}

/* The slope of the straight line through points. */
static double slope(const double *x, const double *y, int count)
{
    double mean_x = 0, mean_y = 0, products = 0, squares = 0;
    for (int i = 0; i < count; i++) {
        mean_x += x[i] / count;
        mean_y += y[i] / count;
    }
    for (int i = 0; i < count; i++) {
        products += (x[i] - mean_x) * (y[i] - mean_y);
        squares += (x[i] - mean_x) * (x[i] - mean_x);
    }
    return products / squares;
}

static void measure_bore(rig *s, int k, findings *found)
{
    channel c = channel_at(s, k);
    build(s, &c);
    skv_rig_wait(s, FORMED * c.until);
    add_instruments(s, &c);
    skv_rig_watch(s, (1 - FORMED) * c.until);
    double before = skv_rig_read(s, c.stream, 1) / (STREAM * c.length);
    double behind = skv_rig_read(s, c.stands, 1) / (STILL * c.bore * c.until);
    double speed = skv_rig_read(s, c.stream, 4), when[CELLS];
    for (int i = 0; i < CELLS; i++)
        when[i] = when_passed(s, c.cells[i], (before + behind) / 2 * CELL * c.depth);
    double bore = slope(when, c.far, CELLS);
    double *condition = found->condition + C_FIRST + k * PER_BORE;
    condition[C_DEPTH] = before;
    condition[C_SPEED] = speed;
    found->measured[k] = behind / before;
    found->measured[BORES + k] = bore;
    if (k == 0)
        skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    skv_plot_point(&found->plot, (speed + bore) / sqrt(skv_rig_gravity(s) * before),
                   behind / before);
}

static void measure(rig *s, findings *found)
{
    skv_rig_require(s, skv_rig_length(s, LENGTH) >= 60 * skv_rig_length(s, DEPTH),
                    "conjugate-depths.length: it must be 60 depths or more");
    s->total = 0;
    for (int k = 0; k < BORES; k++)
        s->total += channel_at(s, k).until;
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    for (int k = 0; k < BORES; k++)
        measure_bore(s, k, found);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    enum { POINTS = 30 };
    for (int k = 0; k < BORES; k++) {
        const double *c = condition + C_FIRST + k * PER_BORE;
        double ratio = skv_theory_bore(c[C_SPEED] / sqrt(condition[C_GRAVITY] * c[C_DEPTH]));
        expected->theory[k] = ratio;
        expected->theory[BORES + k] = c[C_SPEED] / (ratio - 1);
    }
    skv_plot_begin(plot, "theory: (sqrt(1 + 8 F^2) - 1) / 2", SKV_CURVE_THEORY);
    for (int i = 0; i <= POINTS; i++) {
        double f = 1 + 2.0 * i / POINTS;
        skv_plot_point(plot, f, skv_theory_conjugate(f));
    }
}

const experiment skv_exp_conjugate_depths = {
    .info =
        {
            .name = "conjugate-depths",
            .title = "Bores",
            .description = "Three streams run against a wall: how deep the water before it "
                           "becomes, and how fast its step runs back.",
            .question = "A stream runs against a wall. How high does the water rise there?",
            .predict = "Does the step run back as fast as the stream came, faster or slower? Is "
                       "it higher before a faster stream?",
            .measure = "A stretch reads how deep and how fast the stream is, another how deep the "
                       "water stands at the wall, and others when the step comes.",
            .compare = "The step swallows as much water as runs into it, and the pressure behind "
                       "stops that water. So the depths are as (sqrt(1 + 8 F^2) - 1) / 2 to 1, "
                       "where F is the speed of stream and step together over sqrt(g depth) "
                       "(Belanger).",
            .x_label = "Froude number",
            .y_label = "depth behind / depth before",
            .scatters = true,
        },
    .parameters = SKV_BESIDE_ROWS([DEPTH] = {"conjugate-depths.depth", SKV_FIELD_NUMBER, "m", 0.02,
                                             0.2, NULL, "0.065", "depth of the streams"},
                                  [LENGTH] = {"conjugate-depths.length", SKV_FIELD_NUMBER, "m", 1,
                                              16, NULL, "7.8", "length of the channel"}),
    .count = 2 * BORES,
    .quantities = SKV_BESIDE_ROWS({"depth ratio, weak bore", "", 0.05, AS_WRITTEN, 0},
                                  {"depth ratio, middle bore", "", 0.05, AS_WRITTEN, 0},
                                  {"depth ratio, strong bore", "", 0.05, AS_WRITTEN, 0},
                                  {"speed, weak bore", "m/s", 0.05, AS_WRITTEN, 0},
                                  {"speed, middle bore", "m/s", 0.05, AS_WRITTEN, 0},
                                  {"speed, strong bore", "m/s", 0.05, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
