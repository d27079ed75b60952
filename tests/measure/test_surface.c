/* The surface as lines: where they lie, how they are joined, where they end. */
#include "support/failing_memory.h"
#include "support/fixture.h"

#include "skvalp/measure.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define PI 3.14159265358979323846

/* Looks for the surface of a world as it is. */
static skv_surface *surface_of(const skv_world *world, const skv_surface_def *def)
{
    skv_survey *survey;
    skv_surface *surface;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_surface_create(&surface, NULL), SKV_OK);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    assert_int_equal(skv_surface_find(surface, survey, def, NULL), SKV_OK);
    skv_survey_destroy(survey);
    return surface;
}

/* The area inside a closed line, positive if the fluid on its left is inside. */
static double area_of(const skv_point *p, int count)
{
    double area = 0;
    for (int i = 0; i < count; i++) {
        skv_point q = p[(i + 1) % count];
        area += ((double)p[i].x * (double)q.y - (double)q.x * (double)p[i].y) / 2;
    }
    return area;
}

static void a_pool_has_one_line_from_wall_to_wall(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.4f);
    skv_surface *surface = surface_of(world, NULL);
    assert_int_equal(skv_surface_line_count(surface), 1);
    int count;
    bool closed = true;
    const skv_point *p = skv_surface_line(surface, 0, &count, &closed);
    assert_false(closed);
    assert_in_range(count, 80, 100);
    /* The fluid is on the left of one who goes from the right wall to the left one. */
    assert_near((double)p[0].x, 1.6, 1e-4);
    assert_near((double)p[count - 1].x, 0, 1e-4);
    for (int i = 0; i < count; i++)
        assert_near((double)p[i].y, 0.4,
                    0.02); /* a spacing: the rows begin in turn beside the wall */
    assert_null(skv_surface_line(surface, 1, &count, NULL));
    assert_int_equal(count, 0);
    skv_surface_destroy(surface);

    skv_surface_def def = skv_default_surface_def();
    def.closed = true;
    surface = surface_of(world, &def);
    assert_int_equal(skv_surface_line_count(surface), 1);
    p = skv_surface_line(surface, 0, &count, &closed);
    assert_true(closed);
    assert_near(area_of(p, count), 1.6 * 0.4, 0.02);
    skv_surface_destroy(surface);
    skv_world_destroy(world);
}

typedef struct ring {
    float outer, inner;
} ring;

static bool inside_ring(float x, float y, void *user)
{
    const ring *r = user;
    float d = hypotf(x - 0.8f, y - 0.45f);
    return d < r->outer && d > r->inner;
}

static void a_ring_has_two_round_ones(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.01f, 1);
    ring r = {0.3f, 0.12f};
    skv_fill_def fill = skv_default_fill_def();
    fill.inside = inside_ring;
    fill.user = &r;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    skv_surface *surface = surface_of(world, NULL);
    assert_int_equal(skv_surface_line_count(surface), 2);
    for (int i = 0; i < 2; i++) {
        int count;
        bool closed;
        const skv_point *p = skv_surface_line(surface, i, &count, &closed);
        double area = area_of(p, count), radius = sqrt(fabs(area) / PI);
        assert_true(closed);
        assert_near(radius, (double)(area > 0 ? r.outer : r.inner), 0.005);
        for (int k = 0; k < count; k++)
            assert_near(hypot((double)p[k].x - 0.8, (double)p[k].y - 0.45), radius, 0.01);
        assert_true(hypotf(p[0].x - p[count - 1].x, p[0].y - p[count - 1].y) < 0.02f);
    }
    skv_surface_destroy(surface);
    skv_world_destroy(world);
}

static void a_drop_shows_at_a_lower_level(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    assert_int_equal(skv_world_add_particle(world, 0.8f, 0.5f, 0, 0, NULL), SKV_OK);
    skv_surface_def def = skv_default_surface_def();
    skv_surface *surface = surface_of(world, &def);
    assert_int_equal(skv_surface_line_count(surface), 0);
    skv_surface_destroy(surface);
    def.level = 0.1;
    surface = surface_of(world, &def);
    assert_int_equal(skv_surface_line_count(surface), 1);
    int count;
    const skv_point *p = skv_surface_line(surface, 0, &count, NULL);
    assert_true(area_of(p, count) > 0 && area_of(p, count) < 9 * 0.02 * 0.02);
    skv_surface_destroy(surface);
    skv_world_destroy(world);
}

/* Whatever the fluid does: lines end at walls alone, and closed ones hold its area. */
static void splashing_fluid_has_lines_that_end_at_walls(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.012f, 1);
    const skv_terrain *terrain = skv_world_terrain(world);
    double fluid = skv_world_particle_count(world) * 0.012 * 0.012;
    for (int frame = 0; frame < 60; frame += 10) {
        fixture_run(world, 10);
        skv_surface_def def = skv_default_surface_def();
        skv_surface *open = surface_of(world, &def);
        for (int i = 0; i < skv_surface_line_count(open); i++) {
            int count;
            bool closed;
            const skv_point *p = skv_surface_line(open, i, &count, &closed);
            assert_true(count >= 2);
            for (int k = 1; k < count; k++)
                assert_true(hypotf(p[k].x - p[k - 1].x, p[k].y - p[k - 1].y) < 0.02f);
            if (!closed) {
                assert_near((double)skv_terrain_distance(terrain, p[0].x, p[0].y), 0, 1e-4);
                assert_near((double)skv_terrain_distance(terrain, p[count - 1].x, p[count - 1].y),
                            0, 1e-4);
            }
        }
        skv_surface_destroy(open);
        def.closed = true;
        skv_surface *whole = surface_of(world, &def);
        double area = 0;
        for (int i = 0; i < skv_surface_line_count(whole); i++) {
            int count;
            bool closed;
            const skv_point *p = skv_surface_line(whole, i, &count, &closed);
            assert_true(closed);
            area += area_of(p, count);
        }
        assert_near(area / fluid, 1, 0.1);
        skv_surface_destroy(whole);
    }
    skv_world_destroy(world);
}

static void a_warm_surface_allocates_nothing_and_misuse_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_survey *survey;
    skv_surface *surface;
    assert_int_equal(skv_survey_create(&survey, NULL), SKV_OK);
    assert_int_equal(skv_surface_create(&surface, NULL), SKV_OK);
    assert_int_equal(skv_surface_find(surface, survey, NULL, NULL), SKV_OK);
    assert_int_equal(skv_surface_line_count(surface), 0);
    assert_int_equal(skv_survey_take(survey, world, NULL), SKV_OK);
    failing_memory memory;
    skv_result result = SKV_ERROR_MEMORY;
    for (int fail_at = 0; result != SKV_OK; fail_at++) {
        failing_memory_start(&memory, fail_at);
        result = skv_surface_find(surface, survey, NULL, NULL);
        failing_memory_stop();
        assert_true((result == SKV_OK) == (skv_surface_line_count(surface) > 0));
    }
    failing_memory_start(&memory, 0);
    assert_int_equal(skv_surface_find(surface, survey, NULL, NULL), SKV_OK);
    failing_memory_stop();
    skv_surface_def def = skv_default_surface_def();
    const double bad[] = {NAN, -1, 1e-5};
    for (int i = 0; i < 3; i++) {
        def.step = bad[i];
        assert_int_equal(skv_surface_find(surface, survey, &def, NULL), SKV_ERROR_VALUE);
        assert_int_equal(skv_surface_line_count(surface), 0);
    }
    def = skv_default_surface_def();
    def.level = NAN;
    assert_int_equal(skv_surface_find(surface, survey, &def, NULL), SKV_ERROR_VALUE);
    skv_surface_destroy(surface);
    skv_surface_destroy(NULL);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pool_has_one_line_from_wall_to_wall),
        cmocka_unit_test(a_ring_has_two_round_ones),
        cmocka_unit_test(a_drop_shows_at_a_lower_level),
        cmocka_unit_test(splashing_fluid_has_lines_that_end_at_walls),
        cmocka_unit_test(a_warm_surface_allocates_nothing_and_misuse_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
