/* The textbook's formulas against other ways to the same numbers, and the readings of swings. */
#include "experiments/oscillation.h"
#include "experiments/theory.h"
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define PI 3.14159265358979323846

static void pressure_is_the_weight_above(void **unused)
{
    (void)unused;
    /* 0.3 m of water: a column of 300 kg on a square metre. */
    assert_near(skv_theory_pressure(1000, 9.81, 0.3), 300 * 9.81, 1e-9);
    /* 0.2 m of oil, and then 0.1 m of water below it. */
    assert_near(skv_theory_layered_pressure(900, 1000, 9.81, 0.2, 0.1), 90 * 9.81, 1e-9);
    assert_near(skv_theory_layered_pressure(900, 1000, 9.81, 0.2, 0.3), 280 * 9.81, 1e-9);
    assert_near(skv_theory_draught(1000, 900, 0.1), 0.09, 1e-12);
}

/* The volume changes as -V dp/p, in small steps to twice the pressure. */
static void air_is_pressed_as_boyle_says(void **unused)
{
    (void)unused;
    const int steps = 10000;
    double volume = 0.3;
    for (int i = 0; i < steps; i++)
        volume -= volume / (steps + i + 0.5);
    assert_near(skv_theory_boyle(50000, 0.3, 100000) / volume, 1, 1e-4);
}

/* The strain of each of a thousand slices, by what lies above it. */
static void a_block_sags_slice_by_slice(void **unused)
{
    (void)unused;
    double sag = 0;
    for (int i = 0; i < 1000; i++)
        sag += 0.2 / 1000 * 1000 * 9.81 * 0.2 * (i + 0.5) / 1000 / (4 * 4000.0);
    assert_near(skv_theory_sag(1000, 9.81, 0.2, 4000), sag, 1e-9);
}

static void heavy_on_light_grows_as_rayleigh_says(void **unused)
{
    (void)unused;
    double k = 2 * PI / 0.4, square = 9.81 * k * tanh(k * 0.1) / 3;
    assert_near(skv_theory_growth(skv_theory_atwood(1000, 500), 9.81, 0.4, 0.1), sqrt(square),
                1e-9);
}

/* x'' = -(2g/L) x, integrated by small steps from x = 1 to the first zero: a quarter period. */
static double quarter_period(double gravity, double length)
{
    const double dt = 1e-6;
    double x = 1, v = 0, t = 0;
    while (x > 0) {
        v -= dt * 2 * gravity / length * x;
        x += dt * v;
        t += dt;
    }
    return t;
}

static void a_column_swings_as_its_equation_says(void **unused)
{
    (void)unused;
    assert_near(skv_theory_u_tube_period(9.81, 1.7), 4 * quarter_period(9.81, 1.7), 1e-4);
    assert_near(skv_theory_u_tube_period(3.7, 0.4), 4 * quarter_period(3.7, 0.4), 1e-4);
}

static void inertial_length_of_slim_and_wide_tubes(void **unused)
{
    (void)unused;
    /* Slim arms: the centre line. */
    double slim = skv_theory_inertial_length(0.01, 0.6, 0.6);
    assert_near(slim / (2 * (0.6 - 0.005) + 0.6), 1, 0.005);
    /* A right-angled corner between straight pieces counts 0.559 of its square (the resistance of a
     * bent strip of a conductor, which obeys the same equation). */
    const double arms[] = {0.24, 0.12, 0.06};
    for (int i = 0; i < 3; i++) {
        double arm = arms[i], gap = 0.96 - arm;
        double expected = 2 * (0.7 - arm) + (gap - arm) + 2 * 0.559 * arm;
        assert_near(skv_theory_inertial_length(arm, gap, 0.7) / expected, 1, 1e-3);
    }
    /* A longer arm adds its own length, once for each side. */
    double longer = skv_theory_inertial_length(0.12, 0.6, 0.7);
    assert_near(longer - skv_theory_inertial_length(0.12, 0.6, 0.6), 0.2, 1e-3);
    /* Sizes that are no multiple of the cells. */
    double odd = skv_theory_inertial_length(0.12, 0.6, 0.6037);
    assert_near(odd - skv_theory_inertial_length(0.12, 0.6, 0.6), 2 * 0.0037, 1e-3);
}

static void sloshing_in_shallow_and_deep_water(void **unused)
{
    (void)unused;
    /* A long wave runs at sqrt(g d): there and back. */
    assert_near(skv_theory_slosh_period(9.81, 2, 0.01) / (4 / sqrt(9.81 * 0.01)), 1, 1e-3);
    /* In deep water the floor does not matter: T = sqrt(4 pi W / g). */
    assert_near(skv_theory_slosh_period(9.81, 1, 5) / sqrt(4 * PI / 9.81), 1, 1e-6);
    /* 0.4 m in 1.6 m, by hand. */
    assert_near(skv_theory_slosh_period(9.81, 1.6, 0.4), 1.7679, 1e-4);
}

static void a_sloshing_wave_has_a_height(void **unused)
{
    (void)unused;
    /* In shallow water the rise at a wall over the depth, in deep water k times the rise. */
    assert_near(skv_theory_slosh_height(2, 0.02, 0.006), 0.006 / 0.02, 1e-3);
    assert_near(skv_theory_slosh_height(2, 8, 0.2), PI / 2 * 0.2, 1e-6);
    /* All sizes are alike. An ideal liquid in the lab's tank, by an expansion to fifth order. */
    assert_near(skv_theory_slosh_amplitude(1.6, 0.4, 0.15), 0.92, 0.005);
    assert_near(skv_theory_slosh_amplitude(0.4, 0.1, 0.15) /
                    skv_theory_slosh_amplitude(1.6, 0.4, 0.15),
                1, 1e-9);
}

static void jets_and_bodies(void **unused)
{
    (void)unused;
    double speed = skv_theory_jet_speed(9.81, 0.7);
    assert_near(speed * speed / 2, 9.81 * 0.7, 1e-9);
    assert_near(skv_theory_contraction(), 0.611, 5e-4);
    /* The difference of the pressures on a square's lower and upper side. */
    double below = skv_theory_pressure(1000, 9.81, 0.4),
           above = skv_theory_pressure(1000, 9.81, 0.2);
    assert_near(skv_theory_buoyancy(1000, 9.81, 0.04), (below - above) * 0.2, 1e-9);
}

/* What a bore swallows and what stops it, for a stream that is as fast as it is to be. */
static void bores_keep_mass_and_momentum(void **unused)
{
    (void)unused;
    assert_near(skv_theory_conjugate(1), 1, 1e-12);
    assert_near(skv_theory_conjugate(sqrt(3)), 2, 1e-12);
    for (int i = 1; i <= 40; i++) {
        double gravity = 9.81, depth = 0.13, speed = 0.1 * i * sqrt(gravity * depth);
        double deeper = depth * skv_theory_bore(0.1 * i), bore = speed * depth / (deeper - depth);
        assert_near((speed + bore) * speed * depth / (gravity / 2), deeper * deeper - depth * depth,
                    1e-9);
        assert_near(depth * skv_theory_conjugate((speed + bore) / sqrt(gravity * depth)), deeper,
                    1e-9);
    }
}

/* Points that somebody else read off the figure of the paper (series a = 2.25 in). */
static void the_dam_agrees_with_another_reading_of_the_figure(void **unused)
{
    (void)unused;
    const double times[] = {0.832, 1.219, 1.997, 2.547}, fronts[] = {1.217, 1.474, 2.292, 2.995};
    for (int k = 0; k < 4; k++) {
        int i = 1;
        while (skv_theory_dam[i].time < times[k])
            i++;
        const dam_point *a = &skv_theory_dam[i - 1], *b = &skv_theory_dam[i];
        double share = (times[k] - a->time) / (b->time - a->time);
        assert_near(a->measured + share * (b->measured - a->measured), fronts[k], 0.07);
    }
    for (int i = 1; i < DAM_POINTS; i++) {
        assert_true(skv_theory_dam[i].time > skv_theory_dam[i - 1].time);
        assert_true(skv_theory_dam[i].measured > skv_theory_dam[i - 1].measured);
    }
}

static void swings_are_read(void **unused)
{
    (void)unused;
    enum { COUNT = 600 };
    double times[COUNT], values[COUNT];
    for (int i = 0; i < COUNT; i++) {
        times[i] = 3 + i / 60.0;
        double t = i / 60.0;
        values[i] = 0.7 + 0.2 * exp(-0.1 * t) * cos(2 * PI * t / 1.3);
    }
    oscillation o = skv_oscillation_read(times, values, COUNT, 0.7, 4);
    assert_near(o.period, 1.3, 1e-3);
    assert_near(o.amplitude1, exp(-0.13), 2e-3);
    assert_near(o.first_crossing, 3 + 1.3 / 4, 0.01);
    o = skv_oscillation_read(times, values, 30, 0.7, 4);
    assert_true(isnan(o.period) && isnan(o.amplitude1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressure_is_the_weight_above),
        cmocka_unit_test(air_is_pressed_as_boyle_says),
        cmocka_unit_test(a_block_sags_slice_by_slice),
        cmocka_unit_test(heavy_on_light_grows_as_rayleigh_says),
        cmocka_unit_test(a_column_swings_as_its_equation_says),
        cmocka_unit_test(inertial_length_of_slim_and_wide_tubes),
        cmocka_unit_test(sloshing_in_shallow_and_deep_water),
        cmocka_unit_test(a_sloshing_wave_has_a_height),
        cmocka_unit_test(jets_and_bodies),
        cmocka_unit_test(bores_keep_mass_and_momentum),
        cmocka_unit_test(the_dam_agrees_with_another_reading_of_the_figure),
        cmocka_unit_test(swings_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
