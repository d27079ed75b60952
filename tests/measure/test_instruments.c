/* Instruments on worlds that are moved by hand: gates, averages, histories, stopwatch, CSV; and the
 * force meter on a pool that has settled. */
#include "rest.h"
#include "support/failing_memory.h"
#include "support/fixture.h"
#include "support/kept.h"
#include "support/misuse.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/comma_locale.h"

static skv_instrument add_as(skv_lab *lab, skv_instrument_kind kind, const char *name, double x0,
                             double y0, double x1, double y1)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    strcpy(def.name, name);
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    def.window = 0;
    skv_instrument id;
    assert_int_equal(skv_lab_add(lab, &def, &id, NULL), SKV_OK);
    assert_true(id != 0);
    return id;
}

static skv_instrument add(skv_lab *lab, skv_instrument_kind kind, double x0, double y0, double x1,
                          double y1)
{
    return add_as(lab, kind, "", x0, y0, x1, y1);
}

static skv_lab *new_lab(void)
{
    skv_lab *lab;
    assert_int_equal(skv_lab_create(&lab, NULL), SKV_OK);
    return lab;
}

static void sample(skv_lab *lab, const skv_world *world)
{
    assert_int_equal(skv_lab_sample(lab, world, NULL), SKV_OK);
}

/* Particles whose x lies in [x0, x1), of those below y. */
static int particles_between(const skv_world *world, double x0, double x1, double y)
{
    skv_particles p = skv_world_particles(world);
    int count = 0;
    for (int i = 0; i < p.count; i++)
        count += (double)p.x[i] >= x0 && (double)p.x[i] < x1 && (double)p.y[i] < y;
    return count;
}

static void gates_count_what_passes(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    /* Looking up from the floor, left is -x: forward is to the right. */
    skv_instrument gate = add(lab, SKV_INSTRUMENT_GATE, 0.8, 0, 0.8, 0.3);
    skv_instrument turned = add(lab, SKV_INSTRUMENT_GATE, 0.8, 0.3, 0.8, 0);
    sample(lab, world);
    assert_true(isnan(skv_lab_reading(lab, gate, 0)));
    int expected = particles_between(world, 0.75, 0.8, 0.3);
    assert_in_range(expected, 30, 50);
    rest_shift(world, 0.05f, 0, 0.1);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, gate, 3), expected / 0.1, 1e-6);
    assert_near(skv_lab_reading(lab, gate, 4), 0, 1e-12);
    assert_near(skv_lab_reading(lab, gate, 0), expected * 0.0004 / 0.1, 1e-6);
    assert_near(skv_lab_reading(lab, turned, 0), -expected * 0.0004 / 0.1, 1e-6);
    assert_near(skv_lab_reading(lab, turned, 4), expected / 0.1, 1e-6);
    /* And back again, in two strides: in all, nobody has passed. */
    int back = 0;
    for (int i = 0; i < 2; i++) {
        rest_shift(world, -0.025f, 0, 0.05);
        sample(lab, world);
        back += (int)lround(skv_lab_reading(lab, gate, 4) * 0.05);
        assert_near(skv_lab_reading(lab, gate, 3), 0, 1e-12);
    }
    assert_int_equal(back, expected);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Two gates that meet: a particle that passes their common end is counted by one of them. */
static void gates_share_their_common_end(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    assert_int_equal(skv_world_add_particle(world, 0.75f, 0.25f, 0, 0, NULL), SKV_OK);
    skv_lab *lab = new_lab();
    skv_instrument low = add(lab, SKV_INSTRUMENT_GATE, 0.8125, 0, 0.8125, 0.25);
    skv_instrument high = add(lab, SKV_INSTRUMENT_GATE, 0.8125, 0.25, 0.8125, 0.5);
    sample(lab, world);
    rest_shift(world, 0.125f, 0, 0.5);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, low, 3), 0, 0);
    assert_near(skv_lab_reading(lab, high, 3), 2, 1e-9);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void gates_know_particles_by_their_ids(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument gate = add(lab, SKV_INSTRUMENT_GATE, 0.8, -1, 0.8, 2);
    sample(lab, world);
    /* The first to be taken out, so that every index changes; nobody moves. */
    for (int i = 0; i < 100; i++)
        rest_remove(world, 0);
    assert_int_equal(skv_world_add_particle(world, 0.9f, 0.7f, 0, 0, NULL), SKV_OK);
    rest_shift(world, 0, 0, 0.1);
    sample(lab, world);
    assert_near(skv_lab_reading(lab, gate, 3), 0, 1e-12);
    assert_near(skv_lab_reading(lab, gate, 4), 0, 1e-12);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void readings_are_means_over_the_window(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = 0.8;
    def.y0 = 0.25;
    def.window = 0.5;
    def.capacity = 8;
    skv_instrument probe, dry;
    assert_int_equal(skv_lab_add(lab, &def, &probe, NULL), SKV_OK);
    def.y0 = 0.8;
    assert_int_equal(skv_lab_add(lab, &def, &dry, NULL), SKV_OK);
    for (int i = 0; i < 12; i++) {
        rest_set_pressure(world, i * i, 0, 0);
        sample(lab, world);
        rest_shift(world, 0, 0, 0.1);
    }
    /* Samples 7..11, the five of the last half second. */
    double expected = (49 + 64 + 81 + 100 + 121) / 5.0;
    assert_near(skv_lab_reading(lab, probe, 0), expected, 1e-3);
    assert_true(isnan(skv_lab_reading(lab, dry, 0)));
    assert_true(isnan(skv_lab_reading(lab, probe, 2)));
    assert_true(isnan(skv_lab_reading(lab, 77, 0)));
    double times[20], values[20];
    assert_int_equal(skv_lab_history(lab, probe, 0, times, values, 20), 8);
    for (int i = 0; i < 8; i++) {
        assert_near(times[i], 0.1 * (i + 4), 1e-6);
        assert_near(values[i], (i + 4) * (i + 4), 1e-3);
    }
    assert_int_equal(skv_lab_history(lab, probe, 0, NULL, values, 2), 8);
    assert_near(values[0], 100, 1e-3);
    assert_near(values[1], 121, 1e-3);
    assert_int_equal(skv_lab_history(lab, probe, 5, NULL, values, 2), 0);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Every sample of the window counts and none besides, also where frames are short. */
static void windows_are_exact(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = 0.8;
    def.y0 = 0.25;
    def.window = 0.25;
    skv_instrument probe, watch;
    assert_int_equal(skv_lab_add(lab, &def, &probe, NULL), SKV_OK);
    def.kind = SKV_INSTRUMENT_STOPWATCH;
    def.watched = probe;
    def.threshold = 10;
    def.above = true;
    def.hold = 0.25;
    assert_int_equal(skv_lab_add(lab, &def, &watch, NULL), SKV_OK);
    for (int i = 0; i <= 40; i++) {
        rest_set_pressure(world, i, 0, 0);
        sample(lab, world);
        /* Fifteen samples: the mean of i-14..i is above 10 from i = 18 on, and has been for a
         * quarter of a second at i = 33. */
        bool stopped = !isnan(skv_lab_reading(lab, watch, 0));
        assert_true(stopped == (i >= 33));
        rest_shift(world, 0, 0, (double)(1 / 60.0f));
    }
    assert_near(skv_lab_reading(lab, probe, 0), 33, 1e-3);
    assert_near(skv_lab_reading(lab, watch, 0), 18 / 60.0, 1e-6);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void a_clock_that_goes_back_starts_anew(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument ruler = add(lab, SKV_INSTRUMENT_RULER, 0.1, 0.2, 0.4, 0.6);
    for (int i = 0; i < 5; i++) {
        sample(lab, world);
        rest_shift(world, 0, 0, 0.1);
    }
    assert_near(skv_lab_reading(lab, ruler, 0), 0.5, 1e-12);
    assert_near(skv_lab_reading(lab, ruler, 3), atan2(0.4, 0.3), 1e-12);
    rest_shift(world, 0, 0, -0.4);
    sample(lab, world);
    assert_int_equal(skv_lab_history(lab, ruler, 0, NULL, NULL, 9), 1);
    assert_int_equal(skv_lab_move(lab, ruler, 0, 0, 0, 2, NULL), SKV_OK);
    assert_true(isnan(skv_lab_reading(lab, ruler, 0)));
    sample(lab, world);
    assert_near(skv_lab_reading(lab, ruler, 0), 2, 1e-12);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void a_stopwatch_waits_for_the_condition_to_hold(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument energy = add(lab, SKV_INSTRUMENT_ENERGY, 0, 0, 0, 0);
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_STOPWATCH);
    def.watched = energy;
    def.channel = 2;
    def.threshold = 0.3;
    skv_instrument at_once, held;
    assert_int_equal(skv_lab_add(lab, &def, &at_once, NULL), SKV_OK);
    def.hold = 0.25;
    assert_int_equal(skv_lab_add(lab, &def, &held, NULL), SKV_OK);
    const double spin[] = {2, 1, 0.1, 1, 0.1, 0.1, 0.1, 0.1, 2};
    for (int i = 0; i < 9; i++) {
        rest_set_velocity(world, 0.8, 0.25, spin[i], 0);
        sample(lab, world);
        if (i == 1)
            assert_true(isnan(skv_lab_reading(lab, at_once, 0)));
        rest_shift(world, 0, 0, 0.1);
    }
    assert_near(skv_lab_reading(lab, at_once, 0), 0.2, 1e-6);
    assert_near(skv_lab_reading(lab, held, 0), 0.4, 1e-6);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void sums_agree_with_the_world(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    rest_set_pressure(world, 3000, 0, -2000);
    rest_set_velocity(world, 0.8, 0.25, 1.5, 0.2);
    skv_lab *lab = new_lab();
    skv_instrument energy = add(lab, SKV_INSTRUMENT_ENERGY, 0, 0, 0, 0);
    skv_instrument all = add(lab, SKV_INSTRUMENT_REGION, -1, -1, 3, 3);
    skv_instrument part = add(lab, SKV_INSTRUMENT_REGION, 0.8, 0.3, 0.75, 0); /* any corners */
    skv_instrument level = add(lab, SKV_INSTRUMENT_LEVEL, 0.8, 0.1, 0.8, 0.9);
    skv_instrument velocity = add(lab, SKV_INSTRUMENT_VELOCITY, 0.8, 0.35, 0, 0);
    sample(lab, world);
    skv_stats stats = skv_world_stats(world);
    assert_near(skv_lab_reading(lab, energy, 0) / stats.kinetic_energy, 1, 1e-9);
    assert_near(skv_lab_reading(lab, energy, 1) / stats.potential_energy, 1, 1e-6);
    assert_near(skv_lab_reading(lab, energy, 2), stats.rms_speed, 1e-9);
    assert_near(skv_lab_reading(lab, all, 0), stats.particles, 0);
    assert_near(skv_lab_reading(lab, all, 1), stats.particles * 0.0004, 1e-6);
    assert_near(skv_lab_reading(lab, all, 2), stats.centre_x, 1e-9);
    assert_near(skv_lab_reading(lab, all, 3), stats.centre_y, 1e-9);
    assert_near(skv_lab_reading(lab, all, 6), 3000 - 2000 * stats.centre_y, 1e-2);
    assert_near(skv_lab_reading(lab, all, 7), stats.rms_speed, 1e-9);
    assert_near(skv_lab_reading(lab, part, 0), particles_between(world, 0.75, 0.8, 0.3), 0);
    assert_near(skv_lab_reading(lab, level, 2), 0.5, 0.01);
    assert_near(skv_lab_reading(lab, level, 2), skv_lab_reading(lab, level, 0) + 0.1, 1e-9);
    assert_near(skv_lab_reading(lab, level, 1), 0.8, 1e-9);
    assert_near(skv_lab_reading(lab, velocity, 0), -1.5 * 0.1, 1e-5);
    assert_near(skv_lab_reading(lab, velocity, 2), hypot(0.15, 0.02), 1e-5);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* The floor carries the weight, the side walls half the pressure at the floor each. */
static void the_floor_carries_the_weight(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.025f, 0.4f);
    skv_lab *lab = new_lab();
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_FORCE);
    def.window = 1;
    const double boxes[4][4] = {{-0.1, -0.05, 1.7, 0.05},  /* floor */
                                {-0.05, -0.05, 0.05, 0.9}, /* left */
                                {1.55, -0.05, 1.65, 0.9},  /* right */
                                {-0.1, -0.1, 1.7, 1}};     /* all of it */
    skv_instrument ids[4];
    for (int i = 0; i < 4; i++) {
        def.x0 = boxes[i][0];
        def.y0 = boxes[i][1];
        def.x1 = boxes[i][2];
        def.y1 = boxes[i][3];
        assert_int_equal(skv_lab_add(lab, &def, &ids[i], NULL), SKV_OK);
    }
    fixture_run(world, 180);
    for (int i = 0; i < 61; i++) {
        fixture_run(world, 1);
        sample(lab, world);
    }
    double weight = skv_world_particle_count(world) * 0.025 * 0.025 * 1000 * 9.81;
    assert_near(skv_lab_reading(lab, ids[0], 1) / weight, -1, 0.02);
    assert_near(skv_lab_reading(lab, ids[3], 1) / weight, -1, 0.01);
    assert_near(skv_lab_reading(lab, ids[3], 0) / weight, 0, 0.01);
    double side = 1000 * 9.81 * 0.4 * 0.4 / 2;
    assert_near(skv_lab_reading(lab, ids[1], 0) / side, -1, 0.15);
    assert_near(skv_lab_reading(lab, ids[2], 0) / side, 1, 0.15);
    /* Symmetric: no torque about the middle. */
    assert_near(skv_lab_reading(lab, ids[0], 2) / (weight * 0.8), 0, 0.02);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* Water that sleeps, and is not stepped, weighs on its floor; at once, when a meter is set there.
 */
static void sleeping_water_weighs(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    skv_lab *lab = new_lab();
    skv_instrument floor = add(lab, SKV_INSTRUMENT_FORCE, -0.1, -0.1, 1.7, 1);
    double weight = skv_world_particle_count(world) * 0.03 * 0.03 * 1000 * 9.81;
    sample(lab, world);
    assert_near(skv_lab_reading(lab, floor, 1) / weight, -1, 0.05);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

/* The force on a floor is the sum of those on its parts, also where a breaking dam flows across the
 * cut: each part sees all the fluid that its own depends on. */
static void forces_add_up(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_lab *lab = new_lab();
    skv_instrument floor = add(lab, SKV_INSTRUMENT_FORCE, -0.1, -0.05, 1.7, 0.05);
    skv_instrument left = add(lab, SKV_INSTRUMENT_FORCE, -0.1, -0.05, 0.2, 0.05);
    skv_instrument right = add(lab, SKV_INSTRUMENT_FORCE, 0.2, -0.05, 1.7, 0.05);
    for (int i = 0; i < 5; i++) {
        fixture_run(world, 4);
        sample(lab, world);
        double whole = skv_lab_reading(lab, floor, 1);
        double parts = skv_lab_reading(lab, left, 1) + skv_lab_reading(lab, right, 1);
        assert_true(whole < -100 && skv_lab_reading(lab, left, 1) / whole < 0.9);
        assert_near(parts / whole, 1, 1e-12);
    }
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void histories_are_written_as_csv(void **unused)
{
    (void)unused;
    skv_world *world = rest_pool(0.02f, 0.5f);
    skv_lab *lab = new_lab();
    skv_instrument probe = add_as(lab, SKV_INSTRUMENT_PRESSURE, "floor", 0.8, 0.25, 0, 0);
    /* No depth without gravity: an empty field. */
    assert_int_equal(skv_world_set_gravity(world, 0, 0, NULL), SKV_OK);
    rest_set_pressure(world, 250, 0, 0);
    sample(lab, world);
    rest_shift(world, 0, 0, 0.5);
    skv_instrument gate = add(lab, SKV_INSTRUMENT_GATE, 0.8, 0, 0.8, 1);
    sample(lab, world);
    kept all = {0}, one = {0}, full = {.limit = 20};
    set_comma_locale(); /* of a host such as GTK; files are the same in all of them */
    assert_int_equal(skv_lab_write_csv(lab, 0, kept_add, &all, NULL), SKV_OK);
    reset_locale();
    assert_string_equal(all.bytes,
                        "t [s],floor pressure [Pa m],floor density g depth [Pa m],flow gate flow "
                        "[m^2/s],flow gate forward "
                        "[m^2/s],flow gate back [m^2/s],flow gate particles forward [1/s],flow "
                        "gate particles back [1/s]\n0.500000,250,,0,0,0,0,0\n");
    assert_int_equal(skv_lab_write_csv(lab, probe, kept_add, &one, NULL), SKV_OK);
    assert_string_equal(
        one.bytes,
        "t [s],floor pressure [Pa m],floor density g depth [Pa m]\n0.000000,250,\n0.500000,250,\n");
    assert_int_equal(skv_lab_write_csv(lab, 0, kept_add, &full, NULL), SKV_ERROR_FILE);
    skv_lab_remove(lab, probe);
    skv_lab_remove(lab, probe);
    assert_int_equal(skv_lab_instrument(lab, 0), gate);
    assert_int_equal(skv_lab_instrument(lab, 1), 0);
    assert_null(skv_lab_def(lab, probe));
    assert_int_equal(skv_lab_def(lab, gate)->kind, SKV_INSTRUMENT_GATE);
    assert_int_equal(skv_lab_write_csv(lab, probe, kept_add, &all, NULL), SKV_ERROR_VALUE);
    kept_clear(&all);
    kept_clear(&one);
    kept_clear(&full);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void every_channel_has_a_name_and_a_unit(void **unused)
{
    (void)unused;
    int kind = 0;
    for (const char *name; (name = skv_instrument_kind_name((skv_instrument_kind)kind)); kind++) {
        assert_true(strlen(name) > 3);
        const skv_channel *channel;
        int count = 0;
        while ((channel = skv_instrument_channel((skv_instrument_kind)kind, count))) {
            assert_true(*channel->name);
            assert_non_null(channel->unit);
            /* Theory speaks of what stands before it, in its unit. */
            const skv_channel *of = skv_instrument_channel((skv_instrument_kind)kind, count - 1);
            assert_true(!channel->theory ||
                        (of && !of->theory && strcmp(of->unit, channel->unit) == 0));
            count++;
        }
        assert_in_range(count, 1, SKV_MAX_CHANNELS);
    }
    assert_int_equal(kind, SKV_INSTRUMENT_STOPWATCH + 1);
    assert_null(skv_instrument_channel((skv_instrument_kind)kind, 0));
    assert_null(skv_instrument_channel(SKV_INSTRUMENT_PRESSURE, -1));
}

static void expect_refused(skv_lab *lab, skv_instrument_def def)
{
    skv_instrument id = 9;
    skv_error error = {0};
    assert_int_equal(skv_lab_add(lab, &def, &id, &error), SKV_ERROR_VALUE);
    assert_int_equal(id, 0);
    assert_true(strlen(error.text) > 10);
}

static void bad_definitions_are_refused(void **unused)
{
    (void)unused;
    skv_lab *lab = new_lab();
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = NAN;
    expect_refused(lab, def);
    def = skv_default_instrument_def(SKV_INSTRUMENT_GATE); /* without length */
    expect_refused(lab, def);
    def = skv_default_instrument_def(SKV_INSTRUMENT_STOPWATCH);
    expect_refused(lab, def);
    def = skv_default_instrument_def((skv_instrument_kind)77);
    expect_refused(lab, def);
    def = skv_default_instrument_def(SKV_INSTRUMENT_RULER);
    strcpy(def.name, "a,b");
    expect_refused(lab, def);
    def.name[1] = 'x';
    def.capacity = 0;
    expect_refused(lab, def);
    def.capacity = 10;
    def.window = -1;
    expect_refused(lab, def);
    assert_int_equal(skv_lab_move(lab, 5, 0, 0, 1, 1, NULL), SKV_ERROR_VALUE);
    skv_lab_destroy(lab);
    skv_lab_destroy(NULL);
}

static void uninitialised_definitions_are_asserted(void **unused)
{
    (void)unused;
    skv_lab *lab = new_lab();
    misuse_begin(NULL);
    skv_instrument_def def = {.x0 = 1};
    skv_instrument id;
    assert_int_equal(skv_lab_add(lab, &def, &id, NULL), SKV_ERROR_VALUE);
    misuse_end(NULL);
    assert_int_equal(misuses, 1);
    skv_lab_destroy(lab);
}

static skv_lab *lab_with_everything(void)
{
    skv_lab *lab = new_lab();
    for (int kind = 0; kind < SKV_INSTRUMENT_STOPWATCH; kind++)
        add(lab, (skv_instrument_kind)kind, 0.5, 0.01, 0.5, 0.9);
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_STOPWATCH);
    def.watched = skv_lab_instrument(lab, 0);
    skv_instrument id;
    assert_int_equal(skv_lab_add(lab, &def, &id, NULL), SKV_OK);
    return lab;
}

static void a_warm_sample_allocates_nothing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_lab *lab = lab_with_everything();
    fixture_run(world, 30);
    sample(lab, world);
    fixture_run(world, 60);
    sample(lab, world);
    failing_memory memory;
    failing_memory_start(&memory, -1);
    for (int i = 0; i < 5; i++) {
        fixture_run(world, 1);
        sample(lab, world);
    }
    failing_memory_stop();
    assert_int_equal(memory.calls, 0);
    skv_lab_destroy(lab);
    skv_world_destroy(world);
}

static void failing_memory_is_survived(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.04f, 1);
    fixture_run(world, 2);
    bool done = false;
    for (int at = 0; !done; at++) {
        failing_memory memory;
        failing_memory_start(&memory, at);
        skv_lab *lab;
        done = skv_lab_create(&lab, NULL) == SKV_OK;
        if (done) {
            skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_FORCE);
            def.x1 = def.y1 = 1;
            skv_instrument id;
            done = skv_lab_add(lab, &def, &id, NULL) == SKV_OK &&
                   skv_lab_sample(lab, world, NULL) == SKV_OK;
            skv_lab_destroy(lab);
        }
        failing_memory_stop();
        assert_int_equal(memory.live, 0);
        assert_true(at < 40);
    }
    skv_world_destroy(world);
}

static void measuring_changes_nothing_and_repeats(void **unused)
{
    (void)unused;
    skv_world *a = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_world *b = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 2);
    skv_world *alone = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_lab *lab_a = lab_with_everything(), *lab_b = lab_with_everything();
    for (int i = 0; i < 40; i++) {
        fixture_run(a, 1);
        fixture_run(b, 1);
        fixture_run(alone, 1);
        sample(lab_a, a);
        sample(lab_b, b);
    }
    assert_true(skv_world_hash(a) == skv_world_hash(alone));
    for (int i = 0; skv_lab_instrument(lab_a, i); i++) {
        for (int c = 0; c < SKV_MAX_CHANNELS; c++) {
            double x = skv_lab_reading(lab_a, skv_lab_instrument(lab_a, i), c);
            double y = skv_lab_reading(lab_b, skv_lab_instrument(lab_b, i), c);
            assert_true(memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y)));
        }
    }
    assert_true(skv_survey_at(skv_lab_survey(lab_a), 0.3, 0.1).wet);
    skv_lab_destroy(lab_a);
    skv_lab_destroy(lab_b);
    skv_world_destroy(a);
    skv_world_destroy(b);
    skv_world_destroy(alone);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gates_count_what_passes),
        cmocka_unit_test(gates_share_their_common_end),
        cmocka_unit_test(gates_know_particles_by_their_ids),
        cmocka_unit_test(readings_are_means_over_the_window),
        cmocka_unit_test(windows_are_exact),
        cmocka_unit_test(a_clock_that_goes_back_starts_anew),
        cmocka_unit_test(a_stopwatch_waits_for_the_condition_to_hold),
        cmocka_unit_test(sums_agree_with_the_world),
        cmocka_unit_test(the_floor_carries_the_weight),
        cmocka_unit_test(sleeping_water_weighs),
        cmocka_unit_test(forces_add_up),
        cmocka_unit_test(histories_are_written_as_csv),
        cmocka_unit_test(every_channel_has_a_name_and_a_unit),
        cmocka_unit_test(bad_definitions_are_refused),
        cmocka_unit_test(uninitialised_definitions_are_asserted),
        cmocka_unit_test(a_warm_sample_allocates_nothing),
        cmocka_unit_test(failing_memory_is_survived),
        cmocka_unit_test(measuring_changes_nothing_and_repeats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
