/* Filling: every place is asked about once, occupied places are skipped and counted, and failure
 * changes nothing. */
#include "support/failing_memory.h"
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* No two particles closer than 0.7 spacings, none in a wall. */
static void expect_apart(const skv_world *world)
{
    skv_particles p = skv_world_particles(world);
    float least = 0.7f * skv_world_spacing(world);
    for (int i = 0; i < p.count; i++) {
        assert_true(skv_terrain_distance(skv_world_terrain(world), p.x[i], p.y[i]) > 0);
        for (int j = 0; j < i; j++) {
            float dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j];
            assert_true(dx * dx + dy * dy >= least * least);
        }
    }
}

/* Says yes to a third of the places, at random: another third each time it is asked. */
static bool whim(float x, float y, void *user)
{
    (void)x;
    (void)y;
    uint32_t *state = user;
    *state = *state * 1664525u + 1013904223u;
    return *state >> 30 == 0;
}

static void a_whimsical_callback_is_asked_once(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    uint32_t state = 1;
    skv_fill_def def = skv_default_fill_def();
    def.inside = whim;
    def.user = &state;
    skv_placed placed;
    assert_int_equal(skv_world_fill(world, &def, &placed, NULL), SKV_OK);
    assert_int_equal(placed.added, skv_world_particle_count(world));
    assert_in_range(placed.added, 500, 1500);
    expect_apart(world);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

static void a_second_fill_skips_what_is_taken(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_fill_def def = skv_default_fill_def();
    def.x1 = def.y1 = 0.4f;
    skv_placed first, second, third;
    assert_int_equal(skv_world_fill(world, &def, &first, NULL), SKV_OK);
    assert_int_equal(first.occupied, 0);
    assert_true(first.added > 300);
    assert_int_equal(skv_world_fill(world, &def, &second, NULL), SKV_OK);
    assert_int_equal(second.added, 0);
    assert_int_equal(second.occupied, first.added);
    assert_int_equal(second.first, SKV_NO_PARTICLE);
    /* Half beside it, and not quite on its lattice. */
    def.x1 = 0.8f;
    def.x0 = 0.013f;
    assert_int_equal(skv_world_fill(world, &def, &third, NULL), SKV_OK);
    assert_true(third.occupied > 200 && third.added > 300);
    assert_int_equal(third.first, first.added);
    expect_apart(world);
    skv_world_destroy(world);
}

static void places_at_walls_are_counted(void **unused)
{
    (void)unused;
    uint8_t coverage[100 * 50];
    memset(coverage, 0, sizeof coverage);
    for (int y = 0; y < 50; y++)
        memset(coverage + (ptrdiff_t)y * 100, 255, 40); /* the left 0.4 m are solid */
    skv_terrain_def picture = skv_default_terrain_def();
    picture.width = 100;
    picture.height = 50;
    picture.pixel_size = 0.01f;
    picture.coverage = coverage;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    skv_world *world;
    assert_int_equal(skv_terrain_create(&picture, &def.terrain, NULL), SKV_OK);
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_fill_def fill = skv_default_fill_def();
    skv_placed placed;
    assert_int_equal(skv_world_fill(world, &fill, &placed, NULL), SKV_OK);
    float places = 1.0f * 0.5f / (0.02f * 0.02f);
    assert_in_range(placed.blocked, (int)(0.37f * places), (int)(0.47f * places));
    assert_in_range(placed.added + placed.blocked, (int)(0.95f * places), (int)(1.05f * places));
    skv_world_destroy(world);
}

static void too_many_and_no_memory_change_nothing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.0008f, 1);
    skv_fill_def def = skv_default_fill_def();
    skv_error error;
    assert_int_equal(skv_world_fill(world, &def, NULL, &error), SKV_ERROR_LIMIT);
    assert_non_null(strstr(error.text, "2000000"));
    assert_int_equal(skv_world_particle_count(world), 0);
    skv_world_destroy(world);

    world = fixture_dam(SKV_LAW_CALIBRATED, 0.01f, 1);
    int before = skv_world_particle_count(world), failures = 0;
    uint64_t hash = skv_world_hash(world);
    skv_result result = SKV_ERROR_MEMORY;
    for (; result != SKV_OK; failures++) {
        failing_memory memory;
        failing_memory_start(&memory, failures);
        result = skv_world_fill(world, &def, NULL, NULL);
        failing_memory_stop();
        if (result != SKV_OK) {
            assert_int_equal(result, SKV_ERROR_MEMORY);
            assert_int_equal(skv_world_particle_count(world), before);
            assert_int_equal(skv_world_hash(world), hash);
        }
    }
    assert_true(failures > 4);
    assert_true(skv_world_particle_count(world) > 2 * before);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_whimsical_callback_is_asked_once),
        cmocka_unit_test(a_second_fill_skips_what_is_taken),
        cmocka_unit_test(places_at_walls_are_counted),
        cmocka_unit_test(too_many_and_no_memory_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
