/* Viscosity: how fast a whirl dies out in a full box with smooth walls.
 *
 * The flow v = V (sin kx cos ky, -cos kx sin ky), k = pi/L, slides along the walls of a box of side
 * L and is an exact solution of the Navier-Stokes equations: it keeps its shape and decays as
 * exp(-2 nu k^2 t) (Taylor and Green 1937). No gravity, no surface. The particles' velocities are
 * projected on it, and the rate is that of the best line through the logarithm. The same is done
 * without viscosity: what is left is the method's own.
 */
#include "experiments/experiment.h"

#include <math.h>

enum { SECONDS = 10, SETTLE = 1 };

/* Amplitudes, as shares of the first, between which the decay counts. */
#define FROM 0.97
#define TO   0.3

#define PI 3.141592653589793

static double whirl_x(double k, double x, double y)
{
    return sin(k * x) * cos(k * y);
}

static double whirl_y(double k, double x, double y)
{
    return -cos(k * x) * sin(k * y);
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

static skv_result start_whirl(skv_world *world, double k, double speed, skv_error *error)
{
    skv_result result = SKV_OK;
    int count = skv_world_particle_count(world);
    for (int i = 0; i < count && result == SKV_OK; i++) {
        skv_particles p = skv_world_particles(world);
        double x = (double)p.x[i], y = (double)p.y[i];
        result = skv_world_add_velocity(world, i, 1, (float)(speed * whirl_x(k, x, y)) - p.vx[i],
                                        (float)(speed * whirl_y(k, x, y)) - p.vy[i], error);
    }
    return result;
}

/* Lets the whirl die out in a fluid and writes its kinematic viscosity. */
static skv_result decay(stage *s, double viscosity, double *measured, skv_plot *plot,
                        skv_error *error)
{
    double side = skv_settings_length(s->settings, PARAM_WHIRL_SIZE), k = PI / side;
    s->fluid.viscosity = (float)viscosity;
    s->fluid.wall_friction = 0;
    skv_stage_choose_spacing(s, side * side, 1);
    stage_plan plan = {.width = side, .height = side, .depth = side / 2};
    skv_result result = skv_stage_build(s, &plan, error);
    if (result == SKV_OK)
        result = skv_stage_fill(s, 0, 0, side, side, NULL, NULL, error);
    if (result == SKV_OK)
        result = skv_stage_wait(s, SETTLE, error);
    if (result == SKV_OK)
        result = start_whirl(s->world, k, s->settings->value[PARAM_WHIRL_SPEED], error);
    double first = 0, n = 0, t1 = 0, t2 = 0, y1 = 0, ty = 0;
    for (int f = 0; f < SECONDS * 60 && result == SKV_OK; f++) {
        result = skv_stage_wait(s, 1.0 / 60, error);
        double t = f / 60.0, now = amplitude(s->world, k);
        first = f == 0 ? now : first;
        if (!(now > TO * first))
            break;
        if (f % 6 == 0)
            skv_plot_point(plot, t, now / first);
        if (now > FROM * first)
            continue;
        double y = log(now);
        n++;
        t1 += t;
        t2 += t * t;
        y1 += y;
        ty += t * y;
    }
    double spread = n * t2 - t1 * t1;
    *measured = spread > 0 ? (t1 * y1 - n * ty) / spread / (2 * k * k) : 0;
    return result;
}

static skv_result measure(stage *s, findings *found, skv_error *error)
{
    double nominal = s->settings->value[PARAM_WHIRL_VISCOSITY];
    s->total = 2 * (SETTLE + SECONDS);
    skv_plot_begin(&found->plot, "without viscosity", CURVE_LINE);
    skv_result result = decay(s, 0, &found->measured[1], &found->plot, error);
    skv_plot_begin(&found->plot, "measured", CURVE_DOTS);
    if (result == SKV_OK)
        result = decay(s, nominal, &found->measured[0], &found->plot, error);
    found->condition[0] = nominal;
    found->condition[1] = skv_settings_length(s->settings, PARAM_WHIRL_SIZE);
    return result;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    expected->theory[0] = condition[0];
    expected->theory[1] = 0;
    double rate = 2 * condition[0] * PI * PI / (condition[1] * condition[1]);
    skv_plot_begin(plot, "theory", CURVE_THEORY);
    for (int i = 0; i <= 40; i++)
        skv_plot_point(plot, i * 0.05, exp(-rate * i * 0.05));
}

const experiment skv_exp_viscosity = {
    .info =
        {"viscosity", "Viscosity of a whirl",
         "A whirl in a closed box dies out by viscosity alone: how viscous the fluid really is."},
    .x_label = "time (s)",
    .y_label = "speed / speed at the start",
    .count = 2,
    .quantities = {{"kinematic viscosity", "m^2/s", 0.25, false, 0},
                   {"without viscosity", "m^2/s", 0.002, false, 0}},
    .measure = measure,
    .expect = expect,
};
