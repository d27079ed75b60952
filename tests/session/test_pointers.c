/* Pointers: which there are, where, and how fast, whatever the device sends. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "session/pointers.h"
#include "support/fixture.h"

static skv_pointer_id finger(uint64_t number)
{
    return (skv_pointer_id){SKV_DEVICE_FINGER, number};
}

static void test_fingers_come_and_go(void **state)
{
    (void)state;
    skv_pointers p = {0};
    assert_non_null(skv_pointers_down(&p, finger(11), 0.1, 0.8, 0));
    skv_pointers_down(&p, finger(22), 0.2, 0.7, 0);
    skv_pointers_down(&p, finger(33), 0.3, 0.6, 0);
    assert_non_null(skv_pointers_move(&p, finger(22), 0.25, 0.65, 0.1));
    assert_null(skv_pointers_move(&p, finger(44), 1, 1, 0.1)); /* never went down */
    assert_int_equal(p.count, 3);
    assert_true(p.list[0].x == 0.1 && p.list[1].x == 0.25 && p.list[2].x == 0.3);
    skv_pointers_up(&p, finger(11));
    skv_pointers_up(&p, finger(44));
    assert_int_equal(p.count, 2);
    assert_true(p.list[0].x == 0.25 && p.list[1].x == 0.3);
}

/* On Wayland the first finger has the number 1, which was the mouse's. */
static void test_a_finger_is_not_the_mouse(void **state)
{
    (void)state;
    skv_pointers p = {0};
    const skv_pointer_id mouse = {SKV_DEVICE_MOUSE, 1};
    skv_pointers_down(&p, mouse, 0.1, 0.1, 0);
    skv_pointers_down(&p, finger(1), 0.5, 0.5, 0);
    assert_int_equal(p.count, 2);
    skv_pointers_up(&p, mouse);
    assert_int_equal(p.count, 1);
    assert_true(p.list[0].x == 0.5);
}

static void test_down_twice_is_one_finger(void **state)
{
    (void)state;
    skv_pointers p = {0};
    skv_pointers_down(&p, finger(1), 0.1, 0.1, 0);
    skv_pointers_move(&p, finger(1), 0.3, 0.1, 0.1);
    skv_pointers_down(&p, finger(1), 0.5, 0.5, 0.2);
    assert_int_equal(p.count, 1);
    assert_true(p.list[0].x == 0.5 && p.list[0].vx == 0);
}

static void test_too_many_fingers_are_ignored(void **state)
{
    (void)state;
    skv_pointers p = {0};
    for (uint64_t i = 0; i < SKV_MAX_HANDS + 4; i++)
        skv_pointers_down(&p, finger(1000 + i), 0.01 * (double)i, 0.1, 0);
    assert_int_equal(p.count, SKV_MAX_HANDS);
    skv_pointers_up(&p, finger(1000 + SKV_MAX_HANDS)); /* was ignored */
    assert_int_equal(p.count, SKV_MAX_HANDS);
}

static void test_events_that_are_not_finite_are_ignored(void **state)
{
    (void)state;
    skv_pointers p = {0};
    assert_null(skv_pointers_down(&p, finger(1), (double)NAN, 0, 0));
    assert_int_equal(p.count, 0);
    skv_pointers_down(&p, finger(1), 0.1, 0.1, 0);
    skv_pointers_move(&p, finger(1), (double)INFINITY, 0, 1);
    skv_pointers_move(&p, finger(1), 0, 0, (double)NAN);
    assert_true(p.list[0].x == 0.1);
}

/* Moves a finger by (vx, vy) m/s for some events. */
static void drag(skv_pointers *p, double vx, double vy, double rate, int events)
{
    *p = (skv_pointers){0};
    skv_pointers_down(p, finger(1), 0.8, 0.4, 0);
    for (int i = 1; i <= events; i++)
        skv_pointers_move(p, finger(1), 0.8 + vx * i / rate, 0.4 + vy * i / rate, i / rate);
}

static void test_velocity_is_measured(void **state)
{
    (void)state;
    const double rates[] = {30, 60, 125, 1000};
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        skv_pointers p;
        drag(&p, 0.6, 0.4, rates[i], (int)(0.3 * rates[i]));
        assert_near(p.list[0].vx, 0.6, 0.01);
        assert_near(p.list[0].vy, 0.4, 0.01);
    }
}

static void test_velocity_is_smooth(void **state)
{
    (void)state;
    /* 1 m/s with a jitter of 2 mm, as touch panels have: 0.24 m/s of noise at 60 Hz. */
    skv_pointers p = {0};
    skv_pointers_down(&p, finger(1), 0, 0.4, 0);
    for (int i = 1; i <= 60; i++) {
        skv_pointers_move(&p, finger(1), i / 60.0 + (i % 2 ? 0.002 : -0.002), 0.4, i / 60.0);
        if (i > 20)
            assert_near(p.list[0].vx, 1, 0.12);
    }
}

static void test_equal_times_do_no_harm(void **state)
{
    (void)state;
    skv_pointers p = {0};
    const skv_pointer *pointer = skv_pointers_down(&p, finger(1), 0.1, 0.1, 5);
    skv_pointers_move(&p, finger(1), 0.11, 0.1, 5);
    skv_pointers_move(&p, finger(1), 0.12, 0.1, 5);
    assert_near(pointer->vx, 0, 1e-9);
    assert_near(pointer->x, 0.12, 1e-9);
    /* The way since the last time stamp counts once the clock moves on. */
    skv_pointers_move(&p, finger(1), 0.13, 0.1, 5.5);
    assert_near(pointer->vx, 0.06, 0.001);
    /* A hair's breadth later: bounded by the smoothing, not 30 mm / 1 us. */
    skv_pointers_move(&p, finger(1), 0.16, 0.1, 5.500001);
    assert_near(pointer->vx, 0.06 + 0.030 / 0.04, 0.01);
    /* A clock that jumps back starts a new measurement. */
    skv_pointers_move(&p, finger(1), 0.17, 0.1, 1);
    skv_pointers_move(&p, finger(1), 0.17, 0.1, 2);
    assert_near(pointer->vx, 0, 0.001);
}

static void test_velocity_fades_at_rest(void **state)
{
    (void)state;
    skv_pointers p;
    drag(&p, 1, 0, 100, 50);
    skv_pointers_pass(&p, 1.0 / 60); /* between two events of a slow device: kept */
    assert_near(p.list[0].vx, 1, 0.02);
    for (int i = 0; i < 30; i++)
        skv_pointers_pass(&p, 1.0 / 60);
    assert_near(p.list[0].vx, 0, 0.001);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fingers_come_and_go),
        cmocka_unit_test(test_a_finger_is_not_the_mouse),
        cmocka_unit_test(test_down_twice_is_one_finger),
        cmocka_unit_test(test_too_many_fingers_are_ignored),
        cmocka_unit_test(test_events_that_are_not_finite_are_ignored),
        cmocka_unit_test(test_velocity_is_measured),
        cmocka_unit_test(test_velocity_is_smooth),
        cmocka_unit_test(test_equal_times_do_no_harm),
        cmocka_unit_test(test_velocity_fades_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
