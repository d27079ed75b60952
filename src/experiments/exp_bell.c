/* Diving bells: how much water rises into vessels full of air that are held upside down under
 * water, at three depths.
 *
 * Three bells begin full of air at the pressure of the atmosphere. So water rushes in and swings;
 * after ten seconds of scale 1 it is watched for four. Gauges in each bell read the level, and
 * others the level outside. How deep the water in a bell lies below that says what presses on its
 * air, and how high it stands says how much room the air has. Beside them stands what the air
 * itself pushes.
 */
#include "experiments/experiment.h"
#include "experiments/theory.h"
#include "skvalp/air.h"

#include <math.h>

enum { BELLS = 3, INSIDE = 5, OUTSIDE = 5, POCKETS = 64, WAIT = 10, WATCH = 4 };
enum { SIDE, DEPTH, PRESSURE };
enum { C_GRAVITY, C_DENSITY, C_PRESSURE, C_VOLUME, C_DEPTHS };

/* Of the bells' walls and of the gaps between them, in sides of a bell. */
#define WALL 0.24
#define GAP  0.4
/* What readings may be off by. Gauges see a level to a quarter of a spacing, which is 6 mm with
 * 2000 particles. It is 3 % of the air in the deepest bell, and of the first bell's depth. */
#define BOUND 0.03

typedef struct tank {
    double side, depth, pressure; /* of a bell inside; of the water; of the atmosphere */
    double width, height;
    skv_instrument inside[BELLS][INSIDE], outside[OUTSIDE];
} tank;

typedef struct bell {
    double left, right, mouth, ceiling; /* of its inside, m */
} bell;

/* Each mouth is a third of the depth lower than the one before, and the last is off the floor. */
static bell bell_at(const tank *t, int i)
{
    double apart = (1 + 2 * WALL + GAP) * t->side, left = (GAP + WALL) * t->side + i * apart;
    double mouth = t->depth - (i + 1) * (t->depth - GAP * t->side) / BELLS;
    return (bell){left, left + t->side, mouth, mouth + t->side};
}

static shape walls_of(const tank *t, const bell *b)
{
    double thick = WALL * t->side;
    const double xs[] = {b->left,          b->left - thick, b->left - thick, b->right + thick,
                         b->right + thick, b->right,        b->right,        b->left};
    const double ys[] = {b->mouth, b->mouth, b->ceiling + thick, b->ceiling + thick,
                         b->mouth, b->mouth, b->ceiling,         b->ceiling};
    shape walls = {.corners = 8};
    for (int k = 0; k < walls.corners; k++) {
        walls.x[k] = xs[k];
        walls.y[k] = ys[k];
    }
    return walls;
}

/* All but the insides of bells, to each of which a slit leads from above. */
static shape water_around(const tank *t)
{
    shape water = skv_shape_box(0, 0, t->width, t->depth);
    water.corners = 3;
    for (int i = BELLS - 1; i >= 0; i--) {
        bell b = bell_at(t, i);
        double slit = (b.left + b.right) / 2;
        const double xs[] = {slit, slit, b.right, b.right, b.left, b.left, slit, slit};
        const double ys[] = {t->depth, b.ceiling, b.ceiling, b.mouth,
                             b.mouth,  b.ceiling, b.ceiling, t->depth};
        for (int k = 0; k < 8; k++) {
            water.x[water.corners] = xs[k];
            water.y[water.corners++] = ys[k];
        }
    }
    water.x[water.corners] = 0;
    water.y[water.corners++] = t->depth;
    return water;
}

static void build(rig *s, tank *t)
{
    t->width = (BELLS * (1 + 2 * WALL + GAP) + GAP) * t->side;
    t->height = t->depth + t->side;
    rig_plan plan = {.width = t->width,
                     .height = t->height,
                     .solids = BELLS,
                     .waters = 1,
                     .water = {water_around(t)},
                     .depth = t->depth,
                     .gravity_y = -skv_rig_gravity(s),
                     .air = t->pressure};
    for (int i = 0; i < BELLS; i++) {
        bell b = bell_at(t, i);
        plan.solid[i] = walls_of(t, &b);
    }
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, SIDE, 1);
}

/* The level outside is read above the bells that are all under water. */
static void add_gauges(rig *s, tank *t)
{
    double seconds = WATCH * skv_rig_pace(s);
    for (int i = 0; i < BELLS; i++) {
        bell b = bell_at(t, i);
        for (int k = 0; k < INSIDE; k++) {
            double x = b.left + (k + 1) * t->side / (INSIDE + 1);
            t->inside[i][k] = skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, b.mouth - GAP * t->side, x,
                                          b.ceiling, seconds);
        }
    }
    double from = bell_at(t, 1).left, to = bell_at(t, BELLS - 1).right;
    for (int k = 0; k < OUTSIDE; k++) {
        double x = from + k * (to - from) / (OUTSIDE - 1);
        t->outside[k] =
            skv_rig_add(s, SKV_INSTRUMENT_LEVEL, x, t->depth - t->side / 2, x, t->height, seconds);
    }
}

/* What the pockets in a bell have: volume, m^2, and what they would at the atmosphere's pressure.
 */
typedef struct content {
    double volume, amount;
} content;

static content look_into(const rig *s, const tank *t, int i)
{
    bell b = bell_at(t, i);
    content all = {0, 0};
    skv_pocket pockets[POCKETS];
    int count = skv_rig_ok(s) ? skv_world_pockets(s->world, pockets, POCKETS) : 0;
    for (int k = 0; k < count && k < POCKETS; k++) {
        double x = (double)pockets[k].x, y = (double)pockets[k].y;
        double volume = (double)pockets[k].volume;
        if (x < b.left || x > b.right || y < b.mouth - t->side / 2 || y > b.ceiling)
            continue;
        all.volume += volume;
        all.amount += volume * (1 + (double)pockets[k].pressure / t->pressure);
    }
    return all;
}

static double amount_in_all(const rig *s, const tank *t)
{
    double sum = 0;
    for (int i = 0; i < BELLS; i++)
        sum += look_into(s, t, i).amount;
    return sum;
}

static void measure(rig *s, findings *found)
{
    double pace = skv_rig_pace(s), pushes[BELLS] = {0};
    tank t = {.side = skv_rig_length(s, SIDE),
              .depth = skv_rig_length(s, DEPTH),
              .pressure = skv_rig_length(s, PRESSURE)};
    skv_rig_require(s, t.depth >= 3 * t.side, "bell.side: it must not exceed a third of the depth");
    s->total = (WAIT + WATCH) * pace;
    build(s, &t);
    skv_rig_wait(s, 1 / 60.0);
    double held = amount_in_all(s, &t);
    skv_rig_wait(s, WAIT * pace);
    add_gauges(s, &t);
    int frames = (int)(WATCH * pace * 60);
    for (int f = 0; f < frames; f++) {
        skv_rig_watch(s, 1 / 60.0);
        for (int i = 0; i < BELLS; i++) {
            content in = look_into(s, &t, i);
            pushes[i] += t.pressure * (in.amount / in.volume - 1) / frames;
        }
    }
    double outside = skv_rig_mean_level(s, t.outside, OUTSIDE);
    found->condition[C_GRAVITY] = skv_rig_gravity(s);
    found->condition[C_DENSITY] = skv_rig_density(s);
    found->condition[C_PRESSURE] = t.pressure;
    found->condition[C_VOLUME] = t.side * t.side;
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    for (int i = 0; i < BELLS; i++) {
        double level = skv_rig_mean_level(s, t.inside[i], INSIDE);
        found->condition[C_DEPTHS + i] = outside - level;
        found->measured[i] = t.side * (bell_at(&t, i).ceiling - level);
        found->measured[BELLS + i] = pushes[i];
        skv_plot_point(&found->plot, outside - level, found->measured[i] / (t.side * t.side));
    }
    found->measured[2 * BELLS] = amount_in_all(s, &t) / held;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    enum { POINTS = 30 };
    double pressure = condition[C_PRESSURE], volume = condition[C_VOLUME], deepest = 0;
    for (int i = 0; i < BELLS; i++) {
        double depth = condition[C_DEPTHS + i];
        double weight = skv_theory_pressure(condition[C_DENSITY], condition[C_GRAVITY], depth);
        expected->theory[i] = skv_theory_boyle(pressure, volume, pressure + weight);
        expected->theory[BELLS + i] = weight;
        deepest = fmax(deepest, depth);
    }
    expected->theory[2 * BELLS] = 1;
    skv_plot_begin(plot, "theory: Boyle", SKV_CURVE_THEORY);
    for (int i = 0; i <= POINTS; i++) {
        double depth = i * deepest / POINTS;
        double weight = skv_theory_pressure(condition[C_DENSITY], condition[C_GRAVITY], depth);
        skv_plot_point(plot, depth, skv_theory_boyle(pressure, 1, pressure + weight));
    }
}

const experiment skv_exp_bell = {
    .info =
        {
            .name = "bell",
            .title = "Diving bells",
            .description = "Three vessels full of air are held upside down under water, each "
                           "deeper than the one before: how far the water rises in them.",
            .question = "An upturned vessel full of air is held under water. How much of it stays "
                        "dry, and how does that change with the depth?",
            .predict = "Draw the three bells with the water's level in each. In which of them "
                       "does it stand highest above the rim?",
            .measure = "The bells begin full of air at the atmosphere's pressure, which is that of "
                       "a metre of water. Water rises in them and swings until it is calm. Gauges "
                       "read the level in each bell and outside; how much air there is follows "
                       "from the one, what presses on it from both.",
            .compare = "Air that is pressed together keeps the product of its pressure and its "
                       "volume (Boyle). So below a metre of water, where the pressure is twice "
                       "that of the atmosphere, half of the bell stays dry.",
            .x_label = "depth of the water in the bell (m)",
            .y_label = "air / that at the start",
            .scatters = true,
        },
    .parameters =
        SKV_BESIDE_ROWS([SIDE] = {"bell.side", SKV_FIELD_NUMBER, "m", 0.1, 1, NULL, "0.25",
                                  "width and height of each bell inside"},
                        [DEPTH] = {"bell.depth", SKV_FIELD_NUMBER, "m", 0.3, 3, NULL, "1",
                                   "depth of the water, in which the bells hang at three heights"},
                        [PRESSURE] = {"bell.pressure", SKV_FIELD_NUMBER, "Pa m", 1000, 20000, NULL,
                                      "10000",
                                      "pressure of the atmosphere; the scale multiplies it, too"}),
    .count = 2 * BELLS + 1,
    .quantities =
        SKV_BESIDE_ROWS({"air, shallow bell", "m^2", BOUND, AS_WRITTEN, 0},
                        {"air, middle bell", "m^2", BOUND, AS_WRITTEN, 0},
                        {"air, deep bell", "m^2", BOUND, AS_WRITTEN, 0},
                        {"pressure of the air, shallow bell", "Pa m", BOUND, AS_WRITTEN, 0},
                        {"pressure of the air, middle bell", "Pa m", BOUND, AS_WRITTEN, 0},
                        {"pressure of the air, deep bell", "Pa m", BOUND, AS_WRITTEN, 0},
                        {"air kept", "", 0.01, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
