/* Ringing: two drops without gravity, one of half the other's area, swing about the circle.
 *
 * Each starts as a slightly flattened ellipse. What swings is the difference of the second moments
 * along x and y over their sum. The period of four half swings gives the surface tension after
 * Rayleigh 1879, for a cylinder: omega^2 = n (n^2 - 1) sigma / (rho R^3), n = 2. The pressure in
 * the middle, averaged over the same time, gives it by another way, after Laplace: sigma / R. And
 * of the two drops, of the same fluid, the smaller one rings faster by (R2/R1)^(3/2).
 */
#include "base/exact.h"
#include "experiments/experiment.h"
#include "experiments/oscillation.h"

#include <math.h>

enum { DROPS = 2, LONGEST = 60, MOST = LONGEST * 60 + 1, HALF_SWINGS = 4 };
enum { RADIUS, ASPECT };
enum { C_PRESSURE, C_RADIUS, C_DENSITY, C_START, C_TIME };

#define ROOT2 1.4142135623730951

typedef struct drop {
    double x, y, radius;
    skv_instrument core;
    double swing[MOST];
    int rises; /* how often it has gone through the circle */
} drop;

/* The larger drop first. */
typedef struct pair {
    drop drops[DROPS];
    double between; /* x of the middle of the gap */
    double times[MOST];
    int count;
} pair;

static void build(rig *s, pair *p)
{
    double large = skv_rig_length(s, RADIUS), small = large / ROOT2;
    double stretch = sqrt(skv_rig_value(s, ASPECT)), gap = large;
    p->between = 3.5 * large;
    p->drops[0] = (drop){.x = 2 * large, .y = 2 * large, .radius = large};
    p->drops[1] = (drop){.x = p->between + gap / 2 + small, .y = 2 * large, .radius = small};
    s->total = LONGEST;
    rig_plan plan = {.width = p->drops[1].x + small + large,
                     .height = 4 * large,
                     .waters = DROPS,
                     .depth = 2 * large};
    for (int i = 0; i < DROPS; i++) {
        const drop *d = &p->drops[i];
        plan.water[i] = skv_shape_ellipse(d->x, d->y, d->radius * stretch, d->radius / stretch);
    }
    skv_rig_build(s, &plan);
    skv_rig_check_passage(s, RADIUS, 1 / ROOT2);
    for (int i = 0; i < DROPS; i++) {
        drop *d = &p->drops[i];
        double half = 0.4 * d->radius;
        d->core = skv_rig_add(s, SKV_INSTRUMENT_REGION, d->x - half, d->y - half, d->x + half,
                              d->y + half, LONGEST);
    }
}

/* How much wider than high the particles on one side are: (xx - yy) / (xx + yy). */
static double swing_of(const skv_particles *p, double between, bool right)
{
    double n = 0, x = 0, y = 0, xx = 0, yy = 0;
    for (int i = 0; i < p->count; i++) {
        double px = (double)p->x[i], py = (double)p->y[i];
        if ((px > between) != right)
            continue;
        n++;
        x += px;
        y += py;
        xx += px * px;
        yy += py * py;
    }
    xx -= x * x / n;
    yy -= y * y / n;
    return (xx - yy) / (xx + yy);
}

static void read_swings(const rig *s, pair *p)
{
    skv_particles particles = skv_world_particles(s->world);
    int now = p->count++;
    p->times[now] = now / 60.0;
    for (int i = 0; i < DROPS; i++) {
        drop *d = &p->drops[i];
        d->swing[now] = swing_of(&particles, p->between, i == 1);
        d->rises += now > 0 && (d->swing[now] < 0) != (d->swing[now - 1] < 0);
    }
}

static void draw(const rig *s, const void *set_up, findings *found)
{
    (void)s;
    static const char *const labels[DROPS] = {PLOT_LABEL("larger drop"),
                                              PLOT_LABEL("smaller drop")};
    const pair *p = set_up;
    for (int i = 0; i < DROPS; i++) {
        skv_plot_begin(&found->plot, labels[i], i ? SKV_CURVE_DOTS : SKV_CURVE_LINE);
        for (int k = 0; k < p->count; k += i ? 6 : 1)
            skv_plot_point(&found->plot, p->times[k], p->drops[i].swing[k]);
    }
}

static void measure(rig *s, findings *found)
{
    pair p = {.count = 0};
    build(s, &p);
    skv_rig_show(s, draw, &p);
    while (skv_rig_ok(s) && p.count < MOST && p.drops[0].rises <= HALF_SWINGS) {
        read_swings(s, &p);
        skv_rig_watch(s, 1 / 60.0);
    }
    double omega[DROPS];
    for (int i = 0; i < DROPS; i++) {
        drop *d = &p.drops[i];
        oscillation o = skv_oscillation_read(p.times, d->swing, p.count, 0, HALF_SWINGS);
        omega[i] = 2 * SKV_PI / o.period;
    }
    skv_rig_draw(s);
    double radius = p.drops[0].radius, density = skv_rig_density(s);
    found->measured[0] = density * radius * radius * radius * omega[0] * omega[0] / 6;
    found->measured[1] = omega[1] / omega[0];
    found->condition[C_PRESSURE] = skv_rig_read(s, p.drops[0].core, 6);
    found->condition[C_RADIUS] = radius;
    found->condition[C_DENSITY] = density;
    found->condition[C_START] = p.drops[0].swing[0];
    found->condition[C_TIME] = p.count / 60.0;
}

static void expect(const double *condition, expectation *expected, skv_plot *plot)
{
    double radius = condition[C_RADIUS], tension = condition[C_PRESSURE] * radius;
    expected->theory[0] = tension;
    expected->theory[1] = sqrt(2 * ROOT2);
    double omega = sqrt(6 * tension / (condition[C_DENSITY] * radius * radius * radius));
    skv_plot_swing(plot, "Rayleigh, with Laplace's tension", condition[C_START], 2 * SKV_PI / omega,
                   condition[C_TIME]);
}

const experiment skv_exp_ringing = {
    .info =
        {
            .name = "ringing",
            .title = "Ringing drops",
            .description = "Two drops without gravity ring: their surface tension, and whether "
                           "size matters as "
                           "it should.",
            .question = "How fast does a drop ring, and what does that say of its surface tension?",
            .predict = "Two drops, one half as large in area as the other: which rings faster, and "
                       "how many times?",
            .measure = "Two slightly elongated drops ring without gravity. Their shapes' half "
                       "swings give the frequencies, the pressure in the larger one its tension.",
            .compare = "Rayleigh (1879), in two dimensions: omega^2 = 6 tension / (density R^3). "
                       "The tension found from the ringing should be that of the pressure inside, "
                       "tension = p R (Laplace), and the frequencies go as R to the power -3/2.",
            .x_label = "time (s)",
            .y_label = "shape, (xx - yy) / (xx + yy)",
            .scatters = true,
        },
    .parameters =
        SKV_BESIDE_ROWS([RADIUS] = {"ringing.radius", SKV_FIELD_NUMBER, "m", 0.05, 1, NULL, "0.25",
                                    "radius of the larger drop; the other has half its area"},
                        [ASPECT] = {"ringing.aspect", SKV_FIELD_NUMBER, "", 1.05, 1.5, NULL, "1.2",
                                    "length over width at the start"}),
    .count = 2,
    .quantities = SKV_BESIDE_ROWS({"surface tension", "N", 0.15, AS_WRITTEN, 0},
                                  {"frequency, smaller / larger drop", "", 0.05, AS_WRITTEN, 0}),
    .measure = SKV_BESIDE(measure),
    .expect = SKV_BESIDE(expect),
};
