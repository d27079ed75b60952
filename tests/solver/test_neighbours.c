/* Neighbour lists against a search over all pairs; what happens outside the grid. */
#include "solver/reference/neighbours.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { N = 700 };

static float xs[N], ys[N];

static void scatter(float from, float to)
{
    uint32_t r = 12345;
    for (int i = 0; i < N; i++) {
        r = r * 1664525u + 1013904223u;
        xs[i] = from + (to - from) * (float)(r >> 8) / 16777216.0f;
        r = r * 1664525u + 1013904223u;
        ys[i] = from + (to - from) * (float)(r >> 8) / 16777216.0f;
    }
}

static void build(skv_neighbours *lists, float h)
{
    assert_int_equal(skv_neighbours_create(lists, 0, 0, 1, 1, h, NULL, NULL), SKV_OK);
    for (int round = 0; round < 2; round++) {
        assert_int_equal(skv_neighbours_reserve(lists, N, NULL), SKV_OK);
        skv_neighbours_build(lists, xs, ys, N, h);
    }
}

static void check_against_all_pairs(const skv_neighbours *lists, float h)
{
    for (int i = 0; i < N; i++) {
        bool listed[N] = {false};
        for (int k = lists->start[i]; k < lists->start[i + 1]; k++) {
            assert_false(listed[lists->list[k]]);
            listed[lists->list[k]] = true;
        }
        for (int j = 0; j < N; j++) {
            float dx = xs[j] - xs[i], dy = ys[j] - ys[i];
            bool near = j != i && dx * dx + dy * dy < h * h;
            assert_int_equal(listed[j], near);
        }
    }
}

static void lists_hold_exactly_the_pairs_within_h(void **unused)
{
    (void)unused;
    const float radii[] = {0.02f, 0.1f, 0.37f};
    for (int r = 0; r < 3; r++) {
        /* The second round leaves the grid on all sides. */
        for (int outside = 0; outside < 2; outside++) {
            scatter(outside ? -0.05f : 0, outside ? 1.05f : 1);
            skv_neighbours lists;
            build(&lists, radii[r]);
            check_against_all_pairs(&lists, radii[r]);
            skv_neighbours_destroy(&lists);
        }
    }
}

/* More pairs than there is room for: the lists are cut, nothing is written past them, and the next
 * reserve makes room. */
static void a_list_that_does_not_fit_is_cut(void **unused)
{
    (void)unused;
    scatter(0, 0.01f);
    skv_neighbours lists;
    assert_int_equal(skv_neighbours_create(&lists, 0, 0, 1, 1, 0.1f, NULL, NULL), SKV_OK);
    assert_int_equal(skv_neighbours_reserve(&lists, N, NULL), SKV_OK);
    skv_neighbours_build(&lists, xs, ys, N, 0.1f);
    assert_true(lists.start[N] <= lists.list_capacity);
    assert_true(lists.wanted == N * (N - 1));
    assert_int_equal(skv_neighbours_reserve(&lists, N, NULL), SKV_OK);
    skv_neighbours_build(&lists, xs, ys, N, 0.1f);
    check_against_all_pairs(&lists, 0.1f);
    skv_neighbours_destroy(&lists);
}

static void not_a_number_is_survived(void **unused)
{
    (void)unused;
    scatter(0, 1);
    xs[3] = NAN;
    ys[5] = INFINITY;
    xs[7] = -INFINITY;
    skv_neighbours lists;
    build(&lists, 0.1f);
    assert_int_equal(lists.start[4] - lists.start[3], 0);
    skv_neighbours_destroy(&lists);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lists_hold_exactly_the_pairs_within_h),
        cmocka_unit_test(a_list_that_does_not_fit_is_cut),
        cmocka_unit_test(not_a_number_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
