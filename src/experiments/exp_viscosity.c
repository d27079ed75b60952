/* Viscosity: how fast a whirl dies out in a full box with smooth walls.
 *
 * The flow v = V (sin kx cos ky, -cos kx sin ky), k = pi/L, slides along the walls of a box of side
 * L and is an exact solution of the Navier-Stokes equations: it keeps its shape and decays as
 * exp(-2 nu k^2 t) (Taylor and Green 1937). No gravity, no surface. The particles' velocities are
 * projected on it, and the rate is that of the best line through the logarithm. The same is done
 * without viscosity: what is left is the method's own.
 */
#include "base/exact.h"
#include "experiments/experiment.h"

#include <math.h>

enum { SECONDS = 10, SETTLE = 1 };
enum { SIZE, SPEED, NOMINAL };

/* Amplitudes, as shares of the first, between which the decay counts. */
#define FROM 0.97
#define TO   0.3

static double whirl_x(double k, double x, double y)
{
    return skv_sin(k * x) * skv_cos(k * y);
}

static double whirl_y(double k, double x, double y)
{
    return -skv_cos(k * x) * skv_sin(k * y);
}

static double amplitude(const skv_world *world, double k)
{
    skv_particles p = skv_world_particles(world);
    double sum = 0, norm = 0;
    for (int i = 0; i < p.count; i++) {
        double a = whirl_x(k, (double)p.x[i], (double)p.y[i]);
        double b = whirl_y(k, (double)p.x[i], (double)p.y[i]);
        sum += (double)p.vx[i] * a + (double)p.vy[i] * b;
        norm += a * a + b * b;
    }
    return sum / norm;
}

static void start_whirl(rig *s, double k, double speed)
{
    int count = skv_rig_ok(s) ? skv_world_particle_count(s->world) : 0;
    for (int i = 0; i < count && skv_rig_ok(s); i++) {
        skv_particles p = skv_world_particles(s->world);
        double x = (double)p.x[i], y = (double)p.y[i];
        float vx = (float)(speed * whirl_x(k, x, y)) - p.vx[i];
        float vy = (float)(speed * whirl_y(k, x, y)) - p.vy[i];
        skv_rig_keep(s, skv_world_add_velocity(s->world, i, 1, vx, vy, s->error));
    }
}

/* A line through points. */
typedef struct line {
    double n, t, tt, y, ty;
} line;

static void add_to_line(line *l, double t, double y)
{
    l->n++;
    l->t += t;
    l->tt += t * t;
    l->y += y;
    l->ty += t * y;
}

static double slope_of(const line *l)
{
    double spread = l->n * l->tt - l->t * l->t;
    return spread > 0 ? (l->n * l->ty - l->t * l->y) / spread : 0;
}

/* Lets the whirl die out in a fluid; returns its kinematic viscosity. */
static double decay(rig *s, double viscosity, skv_plot *plot)
{
    double side = skv_rig_length(s, SIZE), k = SKV_PI / side;
    skv_rig_set(s, "fluid.viscosity", viscosity);
    skv_rig_set(s, "fluid.wall_friction", 0);
    rig_plan plan = {.width = side,
                     .height = side,
                     .waters = 1,
                     .water = {skv_shape_box(0, 0, side, side)},
                     .depth = side / 2};
    skv_rig_build(s, &plan);
    skv_rig_wait(s, SETTLE);
    start_whirl(s, k, skv_rig_value(s, SPEED));
    line l = {0};
    double first = 0;
    for (int f = 0; f < SECONDS * 60 && skv_rig_ok(s); f++) {
        skv_rig_wait(s, 1.0 / 60);
        double t = f / 60.0, now = amplitude(s->world, k);
        first = f == 0 ? now : first;
        if (!(now > TO * first))
            break;
        if (f % 6 == 0)
            skv_plot_point(plot, t, now / first);
        if (now <= FROM * first)
            add_to_line(&l, t, skv_log(now));
    }
    return -slope_of(&l) / (2 * k * k);
}

static void measure(rig *s, findings *found)
{
    double nominal = skv_rig_value(s, NOMINAL);
    s->total = 2 * (SETTLE + SECONDS);
    found->condition[0] = nominal;
    found->condition[1] = skv_rig_length(s, SIZE);
    found->foreseen = true;
    skv_plot_begin(&found->plot, "without viscosity", SKV_CURVE_LINE);
    found->measured[1] = decay(s, 0, &found->plot);
    skv_plot_begin(&found->plot, "measured", SKV_CURVE_DOTS);
    found->measured[0] = decay(s, nominal, &found->plot);
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = condition[0];
    expected->theory[1] = 0;
    double rate = 2 * condition[0] * SKV_PI * SKV_PI / (condition[1] * condition[1]);
    skv_plot_begin(plot, "theory", SKV_CURVE_THEORY);
    for (int i = 0; i <= 40; i++)
        skv_plot_point(plot, i * 0.05, skv_exp(-rate * i * 0.05));
}

const experiment skv_exp_viscosity = {
    .info =
        {
            .name = "viscosity",
            .title = "Viscosity of a whirl",
            .description = "A whirl in a closed box dies out by viscosity alone: how viscous the "
                           "fluid really is.",
            .question = "How viscous is this liquid really?",
            .predict = "A whirl dies out. If the viscosity is doubled, how much sooner?",
            .measure =
                "A whirl that fills a closed box dies out, once without and once with viscosity. "
                "The speed that is left is followed for ten seconds.",
            .compare = "Viscosity alone slows them: exp(-2 nu k^2 t) (Taylor and Green). The "
                       "line's slope is the viscosity; what the liquid without viscosity loses is "
                       "the method's own, and is not counted.",
            .x_label = "time (s)",
            .y_label = "speed / speed at the start",
        },
    .parameters =
        SKV_BESIDE_ROWS([SIZE] = {"viscosity.size", SKV_FIELD_NUMBER, "m", 0.1, 4, NULL, "0.8",
                                  "side of the box"},
                        [SPEED] = {"viscosity.speed", SKV_FIELD_NUMBER, "m/s", 0.02, 2, NULL, "0.3",
                                   "highest speed at the start"},
                        [NOMINAL] = {"viscosity.nominal", SKV_FIELD_NUMBER, "m^2/s", 0, 0.05, NULL,
                                     "0.02", "kinematic viscosity that the fluid is given"}),
    .count = 2,
    .quantities = SKV_BESIDE_ROWS({"kinematic viscosity", "m^2/s", 0.25, AS_WRITTEN, 0},
                                  {"without viscosity", "m^2/s", 0.002, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
