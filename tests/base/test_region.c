/* Regions: what lies in a circle, on its way, and in a polygon, convex or not. */
#include "base/region.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void a_slanted_polygon_holds_what_is_inside(void **unused)
{
    (void)unused;
    /* A kite with a notch, whose sides are all slanted. */
    const float corners[] = {0, 0, 4, 1, 2, 2, 3, 5, -1, 3};
    const skv_region kite = {
        .x0 = -1, .y0 = 0, .x1 = 4, .y1 = 5, .radius = -1, .corners = corners, .count = 5};
    const struct {
        float x, y;
        bool inside;
    } cases[] = {
        {0.5f, 1, true},    {2, 1, true},        {3.5f, 1, true},     {1, 3, true},
        {2, 4, true},       {2.4f, 2, false},    {3.5f, 0.5f, false}, {3, 3, false},
        {-0.9f, 1, false},  {-0.8f, 2.9f, true}, {1.9f, 2, true},     {0, 4, false},
        {2.9f, 4.8f, true}, {2.9f, 4.6f, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        if (skv_region_holds(&kite, cases[i].x, cases[i].y) != cases[i].inside)
            fail_msg("case %zu", i);
}

static void a_circle_holds_what_its_way_passes(void **unused)
{
    (void)unused;
    const skv_region swept = {
        .x0 = -1, .y0 = -1, .x1 = 4, .y1 = 5, .radius = 1, .way_x = 3, .way_y = 4};
    assert_true(skv_region_holds(&swept, -0.5f, -0.5f));
    assert_true(skv_region_holds(&swept, 1.5f, 2));
    assert_true(skv_region_holds(&swept, 3.5f, 4.5f));
    assert_true(skv_region_holds(&swept, 2.1f, 1.5f));
    assert_false(skv_region_holds(&swept, 2.6f, 1.5f));
    assert_false(skv_region_holds(&swept, 3.9f, 4.9f));
    assert_false(skv_region_holds(&swept, -0.8f, -0.8f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slanted_polygon_holds_what_is_inside),
        cmocka_unit_test(a_circle_holds_what_its_way_passes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
