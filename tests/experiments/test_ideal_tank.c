/* An ideal liquid that sloshes: computed here, against what is known of it without computing, and
 * against the table that the lab takes its amplitude from.
 *
 * With SKV_LONG_TESTS=1 at half the table's fineness, and one entry of three at all of it; with
 * SKV_WRITE_COMMITTED=1, too, all of them, which prints the table; else coarsely, with wider bands.
 */
#include "experiments/oscillation.h"
#include "experiments/theory.h"
#include "ideal_tank.h"
#include "mirrored_flow.h"
#include "support/fixture.h"
#include "support/long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#define PI    3.14159265358979323846
#define SMALL 0.001 /* a height as good as none */

enum { MOST_STEPS = 4000, HALF_SWINGS = 4 };

/* ---- The flow -------------------------------------------------------------------------------- */

/* cos(n pi x) cosh(n pi y) has no slope through walls and floor: a flow whose speeds are known.
 * Returns the largest error through an uneven surface, in the largest speed. */
static double error_of_mode(int n, double depth, int elements)
{
    double x[200], y[200], potential[200], through[200], off = 0, most = 0;
    double k = n * PI, top = cosh(k * depth);
    for (int i = 0; i <= elements; i++) {
        x[i] = (double)i / elements;
        y[i] = depth + 0.2 * depth * cos(PI * x[i]);
        potential[i] = cos(k * x[i]) * cosh(k * y[i]) / top;
    }
    assert_true(tank_flow(elements + 1, x, y, potential, through));
    for (int i = 0; i < elements; i++) {
        double at = (i + 0.5) / elements, height = depth + 0.2 * depth * cos(PI * at);
        double slope = -0.2 * depth * PI * sin(PI * at);
        double u = -k * sin(k * at) * cosh(k * height) / top;
        double v = k * cos(k * at) * sinh(k * height) / top;
        double speed = (v - slope * u) / sqrt(1 + slope * slope);
        off = fmax(off, fabs(through[i] - speed));
        most = fmax(most, fabs(speed));
    }
    return off / most;
}

static void known_flows_are_found(void **unused)
{
    (void)unused;
    const double depths[] = {0.05, 0.25, 1};
    for (int i = 0; i < 3; i++)
        for (int n = 1; n <= 2; n++) {
            double coarse = error_of_mode(n, depths[i], 40),
                   fine = error_of_mode(n, depths[i], 160);
            printf("flow %d, depth %.2f: errors %.2g and %.2g\n", n, depths[i], coarse, fine);
            assert_true(coarse < 0.03 && fine < coarse / 10);
        }
}

/* ---- Swings ---------------------------------------------------------------------------------- */

/* The centre of a swing, step by step, and what was lost on the way. */
typedef struct swing {
    double times[MOST_STEPS], centre[MOST_STEPS];
    int count;
    double area_lost, energy_lost; /* shares, at the end; of the energy above that of rest */
} swing;

static double wave_energy(const ideal_surface *tank, double depth)
{
    return ideal_surface_energy(tank) - depth * depth / 2;
}

/* Runs a tank that has begun, for so many periods of small waves. */
static void swing_of(ideal_surface *tank, double depth, double periods, swing *s)
{
    double end = periods * skv_theory_slosh_period(1, 1, depth);
    double area = ideal_surface_area(tank), energy = wave_energy(tank, area);
    s->count = 0;
    do {
        assert_true(s->count < MOST_STEPS);
        s->times[s->count] = tank->time;
        s->centre[s->count++] = ideal_tank_centre(tank);
        assert_true(ideal_surface_step(tank, end));
    } while (tank->time < end - 1e-12);
    s->area_lost = fabs(1 - ideal_surface_area(tank) / area);
    s->energy_lost = fabs(1 - wave_energy(tank, area) / energy);
}

static oscillation read_swing(const swing *s)
{
    return skv_oscillation_read(s->times, s->centre, s->count, 0.5, HALF_SWINGS);
}

/* A surface of the first mode of small height swings with its period and keeps its height. */
static void small_waves_have_their_period(void **unused)
{
    (void)unused;
    static ideal_surface tank;
    static swing s;
    const double depths[] = {0.1, 0.25, 1};
    for (int k = 0; k < 3; k++) {
        ideal_tank_begin(&tank, depths[k], 0, 1);
        for (int i = 0; i < tank.count; i++)
            tank.y[i] += 1e-4 * depths[k] * cos(PI * tank.x[i]);
        swing_of(&tank, depths[k], 2.4, &s);
        oscillation o = read_swing(&s);
        double ratio = o.period / skv_theory_slosh_period(1, 1, depths[k]);
        printf("small wave, depth %.2f: period %.5f of theory's, amplitude %.5f\n", depths[k],
               ratio, o.amplitude1);
        assert_near(ratio, 1, 1e-3);
        assert_near(o.amplitude1, 1, 1e-3);
    }
}

/* Standing waves of finite height (Tadjbakhsh and Keller 1960, J. Fluid Mech. 8, 442): to second
 * order the crest is steeper, and the frequency differs by the square of the height, upwards in
 * shallow water and downwards in deep water. Unlike a slope they keep their height. */
static void a_standing_wave_comes_back(void **unused)
{
    (void)unused;
    static ideal_surface tank;
    static swing s;
    const double depths[] = {0.25, 1};
    for (int k = 0; k < 2; k++) {
        double depth = depths[k], t = tanh(PI * depth), w = sqrt(t), e = 0.15;
        ideal_tank_begin(&tank, depth, 0, 1.5);
        for (int i = 0; i < tank.count; i++)
            tank.y[i] += (e * cos(PI * tank.x[i]) +
                          e * e / 8 * (t + 3 / (t * t * t)) * cos(2 * PI * tank.x[i])) /
                         PI;
        swing_of(&tank, depth, 2.4, &s);
        oscillation o = read_swing(&s);
        double higher = e * e / 64 * (9 * pow(w, -7) - 12 * pow(w, -3) - 3 * w - 2 * pow(w, 5)) / w;
        double found = skv_theory_slosh_period(1, 1, depth) / o.period - 1;
        printf(
            "standing wave, depth %.2f: frequency %+.5f, by second order %+.5f; amplitude %.4f\n",
            depth, found, higher, o.amplitude1);
        assert_near(found / higher, 1, 0.1);
        assert_near(o.amplitude1, 1, 0.003);
    }
}

/* ---- From a slope ---------------------------------------------------------------------------- */

/* The slope that makes a wave so high. */
static double slope_of(double depth, double height)
{
    return height / skv_theory_slosh_height(1, depth, 1);
}

/* What is kept after one period, by the very reading that the lab does. */
static double kept_of(double depth, double slope, double fineness, swing *s)
{
    static ideal_surface tank;
    ideal_tank_begin(&tank, depth, slope, fineness);
    swing_of(&tank, depth, 1.35, s);
    return read_swing(s).amplitude1;
}

/* The lab's tank as it is by default. An expansion to fifth order gives 0.92. */
static void with_finer_elements_less_is_lost(void **unused)
{
    (void)unused;
    static swing coarse, fine;
    double kept = kept_of(0.25, 0.15, 0.7, &coarse), finer = kept_of(0.25, 0.15, 1.4, &fine);
    printf("slope 0.15: kept %.4f and %.4f; lost %.2g and %.2g of the area, %.2g and %.2g of the "
           "energy\n",
           kept, finer, coarse.area_lost, fine.area_lost, coarse.energy_lost, fine.energy_lost);
    assert_near(finer, 0.92, 0.005);
    assert_near(kept, finer, 1e-3);
    assert_true(coarse.area_lost < 2e-4 && fine.area_lost < coarse.area_lost);
    assert_true(coarse.energy_lost < 0.02 && fine.energy_lost < coarse.energy_lost / 3);
}

/* A flat slope is the sum of the odd modes: of each, 1/n^2 is in the surface, and 1/n^2 of that in
 * the centre. */
static void a_flat_slope_is_a_sum_of_modes(void **unused)
{
    (void)unused;
    static swing s;
    for (int k = 0; k < SLOSH_DEPTHS; k++) {
        double depth = skv_theory_slosh_depths[k];
        bool computed = k % 3 == 1;
        double kept = kept_of(depth, 1e-5, computed ? 1 : 0.3, &s);
        for (int i = 0; i < s.count; i++) {
            s.centre[i] = 0.5;
            for (int n = 1; n < 100; n += 2)
                s.centre[i] += cos(sqrt(n * PI * tanh(n * PI * depth)) * s.times[i]) / pow(n, 4);
        }
        double sum = read_swing(&s).amplitude1;
        if (computed)
            assert_near(kept, sum, 1e-3);
        assert_near(skv_theory_slosh_kept[k][0], sum, 1.5e-3);
    }
}

/* ---- The table ------------------------------------------------------------------------------- */

/* From this depth on no wave of the table's heights climbs the wall as a jet thinner than elements,
 * which takes energy with it. */
#define JETLESS 0.1

typedef struct tanks {
    double kept[SLOSH_DEPTHS][SLOSH_HEIGHTS];
    double area_lost, energy_lost; /* the most of any; of energy, of any without a jet */
} tanks;

/* One of so many of the table's entries; the others keep -1. */
static void some_tanks(double fineness, int every, tanks *t)
{
    static swing s;
    t->area_lost = t->energy_lost = 0;
    for (int i = 0; i < SLOSH_DEPTHS; i++)
        for (int k = 0; k < SLOSH_HEIGHTS; k++) {
            t->kept[i][k] = -1;
            if ((i + k) % every != 0)
                continue;
            double depth = skv_theory_slosh_depths[i];
            double height = fmax(skv_theory_slosh_heights[k], SMALL);
            t->kept[i][k] = kept_of(depth, slope_of(depth, height), fineness, &s);
            t->area_lost = fmax(t->area_lost, s.area_lost);
            if (depth >= JETLESS)
                t->energy_lost = fmax(t->energy_lost, s.energy_lost);
        }
}

static void print_table(const tanks *t)
{
    for (int i = 0; i < SLOSH_DEPTHS; i++) {
        for (int k = 0; k < SLOSH_HEIGHTS; k++)
            printf("%s%.3f", k ? ", " : "    {", t->kept[i][k]);
        printf("},\n");
    }
}

/* Says how far from the table they are; returns the largest difference. */
static double off_table(double fineness, const tanks *t)
{
    double most = 0, square = 0;
    int count = 0;
    for (int i = 0; i < SLOSH_DEPTHS; i++)
        for (int k = 0; k < SLOSH_HEIGHTS; k++) {
            double off = t->kept[i][k] - skv_theory_slosh_kept[i][k];
            if (t->kept[i][k] < 0)
                continue;
            assert_false(isnan(off));
            most = fmax(most, fabs(off));
            square += off * off;
            count++;
        }
    printf("fineness %g: at most %.4f from the table, rms %.4f, lost %.2g of the area and %.2g of "
           "the energy\n",
           fineness, most, sqrt(square / count), t->area_lost, t->energy_lost);
    return most;
}

static void the_table_is_what_is_computed(void **unused)
{
    (void)unused;
    if (!long_tests())
        skip();
    static tanks coarse, middle, fine;
    bool whole = getenv("SKV_WRITE_COMMITTED") != NULL;
    some_tanks(0.6, 1, &coarse);
    assert_true(off_table(0.6, &coarse) <= 0.012);
    assert_true(coarse.area_lost <= 0.01 && coarse.energy_lost <= 0.2);
    some_tanks(1, 1, &middle);
    some_tanks(2, whole ? 1 : 3, &fine);
    if (whole)
        print_table(&fine);
    assert_true(off_table(1, &middle) <= 0.003);
    assert_true(off_table(2, &fine) <= 0.0006); /* rounded to three places */
    assert_true(middle.energy_lost < coarse.energy_lost && fine.energy_lost < middle.energy_lost);
    assert_true(fine.area_lost <= 0.004 && fine.energy_lost <= 0.025);
}

/* How far the table is from the ideal liquid at a depth and a height. */
static double off_at(double depth, double height, double fineness)
{
    static swing s;
    const double width = 1.6; /* any */
    double slope = slope_of(depth, height);
    return skv_theory_slosh_amplitude(width, depth * width, slope) -
           kept_of(depth, slope, fineness, &s);
}

static void between_its_entries_the_table_is_near(void **unused)
{
    (void)unused;
    if (!long_tests())
        skip();
    const double at[][2] = {{0.0625, 0.15}, {0.1125, 0.05}, {0.1125, 0.25}, {0.1375, 0.35},
                            {0.225, 0.425}, {0.275, 0.35},  {0.35, 0.15},   {0.5, 0.35},
                            {0.8, 0.25},    {0.2425, 0.367}};
    double most = 0;
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        most = fmax(most, fabs(off_at(at[i][0], at[i][1], 1)));
    printf("between entries: at most %.4f off\n", most);
    assert_true(most <= 0.003);
}

static void beyond_the_table_its_edge_is_taken(void **unused)
{
    (void)unused;
    double deep = off_at(2, 0.3, 0.7), shallow = off_at(0.035, 0.3, 0.5);
    printf("beyond: %+.4f in deep water, %+.4f in shallow water\n", deep, shallow);
    assert_near(deep, 0, 0.002);
    assert_near(shallow, 0, 0.012);
    /* A higher wave would keep less; an ideal liquid's would break. */
    double slope = slope_of(0.25, 0.6);
    assert_near(skv_theory_slosh_amplitude(1.6, 0.4, slope), skv_theory_slosh_kept[7][5], 1e-9);
    assert_near(skv_theory_slosh_amplitude(1.6, 0.4, 0), skv_theory_slosh_kept[7][0], 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_flows_are_found),
        cmocka_unit_test(small_waves_have_their_period),
        cmocka_unit_test(a_standing_wave_comes_back),
        cmocka_unit_test(a_flat_slope_is_a_sum_of_modes),
        cmocka_unit_test(with_finer_elements_less_is_lost),
        cmocka_unit_test(the_table_is_what_is_computed),
        cmocka_unit_test(between_its_entries_the_table_is_near),
        cmocka_unit_test(beyond_the_table_its_edge_is_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
