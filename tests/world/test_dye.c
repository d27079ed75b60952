/* Dye: it goes where its particles go, disturbs nothing, and is part of the state. */
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static int count_of(const skv_world *world, int dye)
{
    skv_particles p = skv_world_particles(world);
    int count = 0;
    for (int i = 0; i < p.count; i++)
        count += p.dye[i] == dye;
    return count;
}

static skv_world *make_dam(skv_solver_kind solver, int dye)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, solver, 0, 0.03f, 1);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_fill_def fill = skv_default_fill_def();
    fill.x1 = 0.4f;
    fill.y1 = 0.6f;
    fill.dye = dye;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    return world;
}

static void colours_are_given_by_area_and_by_particle(void **unused)
{
    (void)unused;
    skv_world *world = make_dam(SKV_SOLVER_FAST, 0);
    skv_area lower = skv_box(0, 0, 0.4f, 0.3f);
    int all = skv_world_particle_count(world), inside = skv_world_query(world, &lower, NULL, 0);
    uint32_t revision = skv_world_revision(world);
    int dyed = -1;
    assert_int_equal(count_of(world, 0), all);
    assert_int_equal(skv_world_dye_area(world, &lower, 2, &dyed, NULL), SKV_OK);
    assert_true(inside > 50 && inside < all && dyed == inside);
    assert_int_equal(count_of(world, 2), inside);
    assert_int_equal(skv_world_dye_area(world, &lower, 2, &dyed, NULL), SKV_OK);
    assert_int_equal(dyed, 0);
    const uint8_t two[2] = {1, SKV_DYES};
    assert_int_equal(skv_world_set_dyes(world, all - 2, 2, two, NULL), SKV_OK);
    skv_particles p = skv_world_particles(world);
    assert_true(p.dye[all - 2] == 1 && p.dye[all - 1] == SKV_DYES);
    assert_int_equal(skv_world_revision(world), revision);

    /* What is wrong changes nothing. */
    uint64_t hash = skv_world_hash(world);
    const uint8_t wrong[2] = {3, SKV_DYES + 1};
    skv_error error;
    assert_int_equal(skv_world_set_dyes(world, 0, 2, wrong, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, "there is no dye 5; allowed is 0..4");
    assert_int_equal(skv_world_set_dyes(world, all - 1, 2, two, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_set_dyes(world, -1, 1, two, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_dye_area(world, &lower, -1, NULL, NULL), SKV_ERROR_VALUE);
    skv_fill_def fill = skv_default_fill_def();
    fill.dye = SKV_DYES + 1;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_ERROR_VALUE);
    skv_emitter tap = {.vx = 1, .width = 0.1f, .dye = -1};
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_ERROR_VALUE);
    assert_true(skv_world_hash(world) == hash);
    skv_world_destroy(world);
}

static void every_colour_has_a_name(void **unused)
{
    (void)unused;
    for (int i = 0; i <= SKV_DYES; i++)
        for (int k = 0; k < i; k++)
            assert_string_not_equal(skv_dye_name(i), skv_dye_name(k));
    assert_null(skv_dye_name(SKV_DYES + 1));
    assert_null(skv_dye_name(-1));
}

/* A dyed world goes the same way as a clear one; only the hash tells them apart. */
static void dye_moves_nothing(void **unused)
{
    (void)unused;
    const skv_solver_kind solvers[] = {SKV_SOLVER_FAST, SKV_SOLVER_REFERENCE};
    for (int k = 0; k < 2; k++) {
        skv_world *clear = make_dam(solvers[k], 0), *dyed = make_dam(solvers[k], 3);
        fixture_run(clear, 20);
        fixture_run(dyed, 20);
        skv_particles a = skv_world_particles(clear), b = skv_world_particles(dyed);
        assert_memory_equal(a.x, b.x, (size_t)a.count * sizeof *a.x);
        assert_memory_equal(a.vy, b.vy, (size_t)a.count * sizeof *a.vy);
        assert_int_equal(count_of(dyed, 3), b.count);
        assert_true(skv_world_hash(clear) != skv_world_hash(dyed));
        skv_area all = skv_box(-100, -100, 100, 100);
        assert_int_equal(skv_world_dye_area(dyed, &all, 0, NULL, NULL), SKV_OK);
        assert_true(skv_world_hash(clear) == skv_world_hash(dyed));
        skv_world_destroy(clear);
        skv_world_destroy(dyed);
    }
}

/* Who sleeps sleeps on. */
static void dye_wakes_nobody(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    skv_area half = skv_box(0, 0, 0.8f, 1);
    int dyed;
    assert_int_equal(skv_world_dye_area(world, &half, 1, &dyed, NULL), SKV_OK);
    assert_true(dyed > 0);
    fixture_run(world, 2);
    assert_int_equal(skv_world_awake_count(world), 0);
    skv_world_destroy(world);
}

/* The colour stays with its id when others go, in copies, and in what emitters give. */
static void dye_goes_with_its_particle(void **unused)
{
    (void)unused;
    skv_world *copy, *world = make_dam(SKV_SOLVER_FAST, 0);
    int all = skv_world_particle_count(world);
    uint8_t *dyes = malloc((size_t)all);
    for (int i = 0; i < all; i++)
        dyes[i] = (uint8_t)(i % (SKV_DYES + 1));
    assert_int_equal(skv_world_set_dyes(world, 0, all, dyes, NULL), SKV_OK);
    free(dyes);
    skv_emitter tap = {.x = 1, .y = 0.5f, .vx = 1, .width = 0.1f, .dye = 4};
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_OK);
    skv_area some = skv_circle(0.2f, 0.2f, 0.1f);
    assert_int_equal(skv_world_remove_area(world, &some, NULL, NULL), SKV_OK);
    fixture_run(world, 10);
    assert_int_equal(skv_world_copy(world, fixture_host(1), &copy, NULL), SKV_OK);
    fixture_run(world, 10);
    fixture_run(copy, 10);
    assert_true(skv_world_hash(world) == skv_world_hash(copy));
    skv_particles p = skv_world_particles(copy);
    int emitted = 0;
    for (int i = 0; i < p.count; i++) {
        bool old = (int)p.id[i] < all;
        emitted += !old;
        assert_int_equal(p.dye[i], old ? p.id[i] % (SKV_DYES + 1) : 4);
    }
    assert_true(emitted > 30);

    /* Another colour is no other emitter: the flow has no gap. */
    int64_t before = skv_world_flow(world).emitted;
    tap.dye = 1;
    assert_int_equal(skv_world_set_emitters(world, &tap, 1, NULL), SKV_OK);
    fixture_run(world, 10);
    fixture_run(copy, 10);
    assert_int_equal(skv_world_flow(world).emitted, skv_world_flow(copy).emitted);
    assert_int_equal(count_of(world, 1) - count_of(copy, 1),
                     skv_world_flow(world).emitted - before);
    skv_world_destroy(world);
    skv_world_destroy(copy);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_are_given_by_area_and_by_particle),
        cmocka_unit_test(every_colour_has_a_name),
        cmocka_unit_test(dye_moves_nothing),
        cmocka_unit_test(dye_wakes_nobody),
        cmocka_unit_test(dye_goes_with_its_particle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
