/* Water poured and taken with a brush that is dragged from frame to frame. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static const float spacing = 0.0085f;

static skv_placed pour(skv_world *world, const skv_area *area, int limit)
{
    skv_fill_def def = skv_default_fill_def();
    skv_placed placed;
    def.area = area;
    def.aligned = true;
    def.limit = limit;
    assert_int_equal(skv_world_fill(world, &def, &placed, NULL), SKV_OK);
    return placed;
}

/* Drags a brush to the right and pours; returns how many particles were added. */
static int drag(skv_world *world, float y, int frames)
{
    int added = 0;
    for (int frame = 0; frame < frames; frame++) {
        float x = 0.3f + 0.01f * (float)frame;
        skv_area stroke = skv_swept_circle(x, y, x + 0.01f, y, 0.04f);
        added += pour(world, &stroke, -1).added;
        fixture_run(world, 1);
    }
    return added;
}

static void swept_circles_hold_what_is_near_their_way(void **state)
{
    (void)state;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, spacing, 1);
    fixture_fill(world, 0.1f, 0.1f, 0.7f, 0.5f);
    const skv_area strokes[] = {
        skv_swept_circle(0.2f, 0.2f, 0.5f, 0.4f, 0.05f),
        skv_swept_circle(0.5f, 0.4f, 0.2f, 0.2f, 0.05f),
        skv_swept_circle(0.3f, 0.3f, 0.3f, 0.3f, 0.05f),
    };
    skv_particles p = skv_world_particles(world);
    for (size_t k = 0; k < sizeof strokes / sizeof *strokes; k++) {
        const skv_area *a = &strokes[k];
        int expected = 0;
        double ux = (double)a->x1 - (double)a->x0, uy = (double)a->y1 - (double)a->y0;
        for (int i = 0; i < p.count; i++) {
            double dx = (double)p.x[i] - (double)a->x0, dy = (double)p.y[i] - (double)a->y0;
            double square = ux * ux + uy * uy;
            double t = square > 0 ? fmin(1, fmax(0, (dx * ux + dy * uy) / square)) : 0;
            double distance = hypot(dx - t * ux, dy - t * uy);
            assert_true(fabs(distance - 0.05) > 1e-7);
            expected += distance < 0.05;
        }
        assert_int_equal(skv_world_query(world, a, NULL, 0), expected);
        assert_true(expected > 90);
    }
    skv_area circle = skv_circle(0.3f, 0.3f, 0.05f), nothing = skv_swept_circle(0, 0, 1, 1, -1);
    assert_int_equal(skv_world_query(world, &circle, NULL, 0),
                     skv_world_query(world, &strokes[2], NULL, 0));
    assert_int_equal(skv_world_query(world, &nothing, NULL, 0), 0);
    int removed, all = p.count, there = skv_world_query(world, &strokes[0], NULL, 0);
    assert_int_equal(skv_world_remove_area(world, &strokes[0], &removed, NULL), SKV_OK);
    assert_int_equal(removed, there);
    assert_int_equal(skv_world_particle_count(world), all - removed);
    skv_world_destroy(world);
}

/* Fills beside each other give what one gives. */
static void aligned_fills_have_no_seam(void **state)
{
    (void)state;
    skv_world *whole = fixture_tank(SKV_LAW_CALIBRATED, spacing, 1);
    skv_world *parts = fixture_tank(SKV_LAW_CALIBRATED, spacing, 1);
    skv_area all = skv_box(0.1f, 0.1f, 0.9f, 0.7f);
    int expected = pour(whole, &all, -1).added, added = 0, left = 0;
    for (int i = 0; i < 7; i++) {
        float x = 0.1f + 0.8f * (float)i / 7,
              next = i == 6 ? 0.9f : 0.1f + 0.8f * (float)(i + 1) / 7;
        skv_area part = skv_box(x, 0.1f, next, 0.7f);
        skv_placed placed = pour(parts, &part, -1);
        added += placed.added;
        left += placed.occupied;
    }
    assert_true(expected > 6500);
    assert_int_equal(added, expected);
    assert_int_equal(left, 0);
    /* Once more finds no place. */
    assert_int_equal(pour(whole, &all, -1).added, 0);
    assert_int_equal(pour(parts, &all, -1).occupied, expected);
    skv_world_destroy(whole);
    skv_world_destroy(parts);
}

/* A brush adds as much as it covers, not what its own water makes room for by flying apart. */
static void dragging_adds_what_the_brush_covers(void **state)
{
    (void)state;
    uint64_t hash[2];
    for (int threads = 1; threads <= 2; threads++) {
        skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, spacing, threads);
        assert_int_equal(skv_world_set_gravity(world, 0, 0, NULL), SKV_OK);
        double covered = 0.04 * 0.04 * 3.14159 + 0.08 * 1.0;
        int places = (int)(covered / (double)(spacing * spacing));
        int added = drag(world, 0.5f, 100);
        assert_in_range(added, places * 95 / 100, places * 130 / 100);
        hash[threads - 1] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

static void full_water_takes_no_more(void **state)
{
    (void)state;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, spacing, 1);
    fixture_fill(world, 0, 0, 1.6f, 0.3f);
    fixture_run(world, 60);
    assert_in_range(drag(world, 0.12f, 60), 0, 20);
    assert_true(skv_world_stats(world).max_speed < 0.5);
    skv_area drop = skv_circle(0.5f, 0.7f, 0.1f), outside = skv_circle(50, 50, 1);
    assert_int_equal(pour(world, &drop, 17).added, 17);
    assert_int_equal(pour(world, &outside, -1).added, 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(swept_circles_hold_what_is_near_their_way),
        cmocka_unit_test(aligned_fills_have_no_seam),
        cmocka_unit_test(dragging_adds_what_the_brush_covers),
        cmocka_unit_test(full_water_takes_no_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
