/* Strokes: a wall that is drawn has its edge where the brush had its own, on all sides, and goes
 * when it is erased. */
#include "shapes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 64 };
#define PIXEL 0.01f

static skv_terrain *paint(const skv_terrain *terrain, bool erase)
{
    const skv_brush_stroke stroke = {
        .x0 = 0.25f, .y0 = 0.32f, .x1 = 0.39f, .y1 = 0.32f, .radius = 0.08f, .erase = erase};
    skv_terrain *painted;
    assert_int_equal(skv_terrain_paint(terrain, &stroke, 1, &painted, NULL), SKV_OK);
    return painted;
}

static void a_wall_lies_where_it_was_drawn(void **unused)
{
    (void)unused;
    static const uint8_t air[SIDE * SIDE];
    skv_terrain *empty = make_terrain(SIDE, SIDE, air, PIXEL, 0);
    skv_terrain *drawn = paint(empty, false), *erased = paint(drawn, true);
    /* On the brush's edge: left, right, below, above. */
    const float edge[4][2] = {{0.17f, 0.32f}, {0.47f, 0.32f}, {0.32f, 0.24f}, {0.32f, 0.4f}};
    for (int i = 0; i < 4; i++) {
        float distance = skv_terrain_distance(drawn, edge[i][0], edge[i][1]);
        if (!(fabsf(distance) < 0.15f * PIXEL))
            fail_msg("edge %d: %g m from it", i, (double)distance);
    }
    assert_true(skv_terrain_distance(drawn, 0.32f, 0.32f) < -0.05f);
    assert_true(skv_terrain_distance(empty, 0.32f, 0.32f) > 0.05f);
    assert_true(skv_terrain_distance(erased, 0.32f, 0.32f) > 0.05f);
    skv_terrain_destroy(empty);
    skv_terrain_destroy(drawn);
    skv_terrain_destroy(erased);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_wall_lies_where_it_was_drawn)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
