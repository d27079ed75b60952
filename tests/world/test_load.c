/* Substeps follow the load: fewer where water is shallow and slow, more at once where it is not,
 * and the water does not feel it. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

static double rms_speed(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    double sum = 0;
    for (int i = 0; i < p.count; i++)
        sum += (double)(p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]);
    return sqrt(sum / p.count);
}

static skv_world *make_tank(float spacing, int substeps, int threads)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, spacing, threads);
    def.substeps = substeps;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    return world;
}

/* Settled water at rest, which has been given as many substeps as it needs. */
static skv_world *make_calm(float spacing, float depth)
{
    skv_world *world = make_tank(spacing, 0, 1);
    fixture_fill(world, 0, 0, 1.6f, depth);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, 300);
    assert_true(rms_speed(world) < 0.01);
    return world;
}

static void a_dam_that_has_broken_takes_fewer(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.0095f, 1);
    int most = skv_world_substeps_per_frame(world);
    for (int f = 0; f < 600; f++) {
        fixture_run(world, 1);
        assert_in_range(skv_world_substeps_per_frame(world), 1, most);
    }
    assert_true(10 * skv_world_substeps_per_frame(world) <= 7 * most);
    assert_true((double)skv_world_substep_count(world) < 600 * 0.85 * most);
    /* It stands in the whole tank, no denser than so many substeps would make it. */
    double level = 2 * skv_world_stats(world).centre_y;
    assert_near(level * 1.6, 0.4 * 0.7, 0.04 * 0.4 * 0.7);
    skv_world_destroy(world);
}

/* What the rule expects is there, and nothing can be spared. */
static void a_deep_pool_keeps_its_substeps(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(0.02f, 0, 1);
    int most = skv_world_substeps_per_frame(world);
    fixture_fill(world, 0, 0, 1.6f, 0.85f);
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, 180);
    assert_int_equal(skv_world_substeps_per_frame(world), most);
    skv_world_destroy(world);
}

/* Three quarters of the rule's substeps start from what the last one has pushed, and so are as
 * stiff as all of them. */
static void warm_substeps_compress_no_more(void **unused)
{
    (void)unused;
    skv_world *warm = make_tank(0.0135f, 0, 1);
    skv_world *both[2] = {warm, make_tank(0.0135f, warm->load.most, 1)};
    assert_in_range(4 * skv_world_substeps_per_frame(warm), 3 * warm->load.most,
                    3 * warm->load.most + 3);
    double volume[2];
    for (int k = 0; k < 2; k++) {
        fixture_fill(both[k], 0, 0, 1.6f, 0.85f);
        assert_int_equal(skv_world_settle(both[k], NULL), SKV_OK);
        fixture_run(both[k], 240);
        volume[k] = fixture_packing(both[k]).volume_ratio;
    }
    assert_near(volume[0], volume[1], 0.002);
    skv_world_destroy(both[0]);
    skv_world_destroy(both[1]);
}

/* Fluids with less margin start cold, and no iteration applies more than it may: a dam would fly
 * apart as its wave breaks. Even at the ends of what may be set it does not. */
static void lively_fluids_hold_together(void **unused)
{
    (void)unused;
    const struct {
        float relaxation, radius_ratio;
        int iterations;
    } fluids[] = {{0.35f, 4, 2}, {0.35f, 3, 1}, {0.4f, 3.5f, 2}, {0.4f, 4, 4}};
    for (int k = 0; k < 4; k++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.0115f, 1);
        def.fluid.relaxation = fluids[k].relaxation;
        def.fluid.radius_ratio = fluids[k].radius_ratio;
        def.fluid.iterations = fluids[k].iterations;
        skv_world *world;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        fixture_fill(world, 0, 0, 0.8f, 0.8f);
        assert_int_equal(skv_world_substeps_per_frame(world), world->load.most);
        double most = 0;
        /* With one iteration it flies apart anyway, at some spacings. */
        for (int f = 0; f < 120 && fluids[k].iterations > 1; f++) {
            fixture_run(world, 1);
            most = fmax(most, rms_speed(world));
        }
        assert_true(most < 2);
        skv_world_destroy(world);
    }
}

/* A change of substeps that came at once would let the water breathe, and the breath bring the next
 * change: 0.1 to 0.2 m/s for ever, in this pool. */
static void water_becomes_calm_while_they_change(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(0.0155f, 0, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.45f);
    int before = skv_world_substeps_per_frame(world), first = before;
    for (int f = 0; f < FIXTURE_SWING(7); f++) {
        fixture_run(world, 1);
        int now = skv_world_substeps_per_frame(world);
        assert_true(f < 120 || now <= before);
        before = now;
    }
    assert_true(before < first);
    assert_true(rms_speed(world) < 0.007);
    skv_world_destroy(world);
}

/* A settled pool that needs fewer substeps than it begins with stays as calm as with all that the
 * rule asks for, which are given, and so start cold. */
static void calm_water_stays_calm(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(0.0135f, 0, 1);
    int first = skv_world_substeps_per_frame(world);
    skv_world *both[2] = {world, make_tank(0.0135f, world->load.most, 1)};
    double most[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        fixture_fill(both[k], 0, 0, 1.6f, 0.3f);
        assert_int_equal(skv_world_settle(both[k], NULL), SKV_OK);
        for (int f = 0; f < 240; f++) {
            fixture_run(both[k], 1);
            most[k] = fmax(most[k], rms_speed(both[k]));
        }
    }
    assert_true(skv_world_substeps_per_frame(world) < first);
    assert_true(most[0] < 1.1 * most[1]);
    skv_world_destroy(both[0]);
    skv_world_destroy(both[1]);
}

/* Settled water begins with what its own depth asks for, unless a force will press it. */
static void settled_water_begins_with_what_it_needs(void **unused)
{
    (void)unused;
    for (int forced = 0; forced < 2; forced++) {
        skv_world *world = make_tank(0.0135f, 0, 1);
        skv_force force = {.area = skv_box(0, 0, 1.6f, 0.9f), .ax = 300};
        assert_int_equal(skv_world_set_forces(world, &force, forced, NULL), SKV_OK);
        fixture_fill(world, 0, 0, 1.6f, 0.3f);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        int needed = skv_substep_rule(&world->fluid, skv_load_of_depth(9.81f, 0.3f, 0));
        if (forced)
            assert_int_equal(world->load.wanted, world->load.most);
        else
            assert_in_range(world->load.wanted, needed, world->load.most - 1);
        skv_world_destroy(world);
    }
}

/* A column is put on calm water: it takes more substeps before its weight has come, and splashes no
 * more than with all of them. */
static void added_weight_is_expected(void **unused)
{
    (void)unused;
    skv_world *world = make_calm(0.0135f, 0.15f);
    int before = skv_world_substeps_per_frame(world);
    fixture_fill(world, 0, 0.16f, 1.6f, 0.45f);
    assert_true(skv_world_substeps_per_frame(world) > before);
    skv_world *all = make_tank(0.0135f, world->load.most, 1);
    fixture_fill(all, 0, 0, 1.6f, 0.15f);
    assert_int_equal(skv_world_settle(all, NULL), SKV_OK);
    fixture_run(all, 300);
    fixture_fill(all, 0, 0.16f, 1.6f, 0.45f);
    double most = 0, most_of_all = 0;
    for (int f = 0; f < 60; f++) {
        fixture_run(world, 1);
        fixture_run(all, 1);
        most = fmax(most, rms_speed(world));
        most_of_all = fmax(most_of_all, rms_speed(all));
    }
    assert_true(most < 1.15 * most_of_all);
    skv_world_destroy(all);
    skv_world_destroy(world);
}

/* What falls is expected while it falls. */
static void falling_water_is_met_with_more(void **unused)
{
    (void)unused;
    skv_world *world = make_calm(0.0155f, 0.1f);
    int before = skv_world_substeps_per_frame(world);
    skv_fill_def drop = skv_default_fill_def();
    skv_area disc = skv_circle(0.8f, 0.7f, 0.1f);
    drop.area = &disc;
    assert_int_equal(skv_world_fill(world, &drop, NULL, NULL), SKV_OK);
    int most = before;
    for (int f = 0; f < 30; f++) {
        fixture_run(world, 1);
        int now = skv_world_substeps_per_frame(world);
        most = now > most ? now : most;
    }
    assert_true(most > before);
    fixture_run(world, 600);
    assert_in_range(skv_world_substeps_per_frame(world), 1, most - 1);
    skv_world_destroy(world);
}

/* The load of a gravity that is four times as strong is four times as much, and is expected at
 * once. */
static void stronger_gravity_is_expected(void **unused)
{
    (void)unused;
    skv_world *world = make_calm(0.0155f, 0.2f);
    int before = skv_world_substeps_per_frame(world);
    assert_int_equal(skv_world_set_gravity(world, 0, -4 * 9.81f, NULL), SKV_OK);
    assert_true(skv_world_substeps_per_frame(world) > before);
    double most = 0;
    for (int f = 0; f < 60; f++) {
        fixture_run(world, 1);
        most = fmax(most, rms_speed(world));
    }
    assert_true(most < 0.15);
    skv_world_destroy(world);
}

static void given_ones_and_clavet_s_stay(void **unused)
{
    (void)unused;
    for (int clavet = 0; clavet < 2; clavet++) {
        skv_world_def def =
            fixture_def(clavet ? SKV_LAW_CLAVET : SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.02f, 1);
        def.substeps = clavet ? 0 : 11;
        skv_world *world = fixture_dam_of(&def);
        int given = skv_world_substeps_per_frame(world);
        for (int f = 0; f < 180; f++) {
            fixture_run(world, 1);
            assert_int_equal(skv_world_substeps_per_frame(world), given);
        }
        skv_world_destroy(world);
    }
}

/* A world goes on from any moment as if it had not been interrupted, on any number of threads. */
static void the_load_is_part_of_the_state(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    int first = skv_world_substeps_per_frame(world);
    for (int f = 0; f < 600 && skv_world_substeps_per_frame(world) == first; f++)
        fixture_run(world, 1);
    fixture_run(world, 2);
    for (int part = 0; part < 20; part++) {
        size_t size = skv_world_snapshot_size(world, true);
        void *bytes = malloc(size);
        assert_non_null(bytes);
        assert_int_equal(skv_world_save(world, true, bytes, size, NULL), SKV_OK);
        skv_world *other;
        assert_int_equal(skv_world_load(bytes, size, fixture_host(1 + part % 3), &other, NULL),
                         SKV_OK);
        free(bytes);
        fixture_run(world, 7);
        fixture_run(other, 7);
        assert_int_equal(skv_world_substeps_per_frame(other), skv_world_substeps_per_frame(world));
        assert_true(skv_world_hash(other) == skv_world_hash(world));
        skv_world_destroy(other);
    }
    assert_true(skv_world_substeps_per_frame(world) < first);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dam_that_has_broken_takes_fewer),
        cmocka_unit_test(a_deep_pool_keeps_its_substeps),
        cmocka_unit_test(warm_substeps_compress_no_more),
        cmocka_unit_test(lively_fluids_hold_together),
        cmocka_unit_test(water_becomes_calm_while_they_change),
        cmocka_unit_test(calm_water_stays_calm),
        cmocka_unit_test(settled_water_begins_with_what_it_needs),
        cmocka_unit_test(added_weight_is_expected),
        cmocka_unit_test(falling_water_is_met_with_more),
        cmocka_unit_test(stronger_gravity_is_expected),
        cmocka_unit_test(given_ones_and_clavet_s_stay),
        cmocka_unit_test(the_load_is_part_of_the_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
