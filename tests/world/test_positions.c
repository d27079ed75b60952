/* Particles that a host puts elsewhere: they lie there, awake, and where they were fluid moves in.
 */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void they_lie_where_they_are_put(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 2, 0.04f, 1);
        skv_world *world = fixture_dam_of(&def);
        fixture_run(world, 5);
        uint32_t revision = skv_world_revision(world);
        const skv_particle_id ids[] = {3, 7, 1000000, 9, 7};
        const float x[] = {1.2f, 1.3f, -5, 1.4f, 1.35f}, y[] = {0.7f, 0.7f, NAN, 0.7f, 0.75f};
        float vx = skv_world_particles(world).vx[3];
        assert_int_equal(skv_world_set_positions(world, ids, 5, x, y, NULL), SKV_OK);
        assert_true(skv_world_revision(world) != revision);
        skv_particles p = skv_world_particles(world);
        assert_true(p.x[3] == 1.2f && p.y[3] == 0.7f && p.vx[3] == vx);
        assert_true(p.x[7] == 1.35f && p.y[7] == 0.75f); /* named twice: the last place */
        assert_true(p.x[9] == 1.4f && p.pressure[9] == 0);
        fixture_run(world, 6); /* they fall, and nothing remembers where they were */
        p = skv_world_particles(world);
        assert_near((double)p.y[9], 0.7 - 9.81 / 2 * 0.01, 0.03);
        assert_near((double)p.x[9], 1.4, 0.1);
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        assert_true(skv_world_stats(world).max_speed < 6);
        skv_world_destroy(world);
    }
}

static void a_wrong_place_changes_nothing(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.04f, 1);
    fixture_run(world, 2);
    uint64_t before = skv_world_hash(world);
    uint32_t revision = skv_world_revision(world);
    const skv_particle_id ids[] = {2, 5};
    const struct {
        float x, y;
        const char *said;
    } wrong[] = {{NAN, 0.5f, "particle 5"},
                 {0.5f, INFINITY, "particle 5"},
                 {101, 0.5f, "100 m"},
                 {-0.1f, 0.5f, "in solid or outside"},
                 {0.8f, 2, "choose a free place"}};
    for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
        const float x[] = {1.2f, wrong[w].x}, y[] = {0.7f, wrong[w].y};
        skv_error error;
        assert_int_equal(skv_world_set_positions(world, ids, 2, x, y, &error), SKV_ERROR_VALUE);
        if (!strstr(error.text, wrong[w].said))
            fail_msg("\"%s\" does not say %s", error.text, wrong[w].said);
        assert_true(skv_world_hash(world) == before && skv_world_revision(world) == revision);
    }
    assert_int_equal(skv_world_set_positions(world, NULL, 0, NULL, NULL, NULL), SKV_OK);
    assert_true(skv_world_revision(world) == revision);
    skv_world_destroy(world);
}

/* Out of a sleeping pool and into it: fluid wakes at both places and elsewhere sleeps on. */
static void fluid_wakes_where_they_go_and_come(void **unused)
{
    (void)unused;
    skv_world *world = fixture_sleeping_pool(0.03f, 1);
    skv_area hole = skv_circle(0.4f, 0.1f, 0.08f);
    static int indices[200];
    static skv_particle_id ids[200];
    static float x[200], y[200];
    int count = skv_world_query(world, &hole, indices, 200);
    assert_in_range(count, 10, 200);
    skv_particles p = skv_world_particles(world);
    for (int i = 0; i < count; i++) {
        ids[i] = p.id[indices[i]];
        x[i] = p.x[indices[i]] + 0.8f;
        y[i] = p.y[indices[i]] + 0.6f; /* so high that they wake none below yet */
    }
    assert_int_equal(skv_world_set_positions(world, ids, count, x, y, NULL), SKV_OK);
    fixture_run(world, 1);
    assert_in_range(skv_world_awake_count(world), count + 5, p.count - 50);
    fixture_run(world, 60);
    assert_true(skv_world_query(world, &hole, NULL, 0) > count / 2);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_lie_where_they_are_put),
        cmocka_unit_test(a_wrong_place_changes_nothing),
        cmocka_unit_test(fluid_wakes_where_they_go_and_come),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
