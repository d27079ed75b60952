/* Fingers: which of them are hands, and which a gesture; that of a gesture no tool hears, and that
 * nothing is left down, whatever comes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <skvalp/fingers.h>

#include "support/fixture.h"

static skv_pointer_event event_at(skv_phase phase, uint64_t pointer, double px, double py,
                                  double time)
{
    return (skv_pointer_event){.phase = phase,
                               .device = SKV_DEVICE_FINGER,
                               .pointer = pointer,
                               .px = px,
                               .py = py,
                               .time = time};
}

static skv_gesture down(skv_fingers *f, uint64_t pointer, double px, double py, double time)
{
    const skv_pointer_event event = event_at(SKV_PHASE_DOWN, pointer, px, py, time);
    return skv_fingers_event(f, &event);
}

static skv_gesture move(skv_fingers *f, uint64_t pointer, double px, double py, double time)
{
    const skv_pointer_event event = event_at(SKV_PHASE_MOVE, pointer, px, py, time);
    return skv_fingers_event(f, &event);
}

static skv_gesture up(skv_fingers *f, uint64_t pointer, double px, double py, double time)
{
    const skv_pointer_event event = event_at(SKV_PHASE_UP, pointer, px, py, time);
    return skv_fingers_event(f, &event);
}

static void expect_event(const skv_gesture *g, int i, skv_phase phase, uint64_t pointer, double px)
{
    assert_true(i < g->event_count);
    assert_int_equal(g->events[i].phase, phase);
    assert_int_equal(g->events[i].pointer, pointer);
    assert_near(g->events[i].px, px, 1e-9);
}

static void expect_nothing(const skv_gesture *g)
{
    assert_int_equal(g->event_count, 0);
    assert_true(g->dx == 0 && g->dy == 0 && g->factor == 1 && !g->undo);
}

/* It waits until it moves; from where it came down, so that nothing of its way is lost. */
static void test_a_finger_that_moves_is_a_hand(void **state)
{
    (void)state;
    skv_fingers f = {0};
    skv_gesture g = down(&f, 1, 100, 100, 5);
    expect_nothing(&g);
    assert_near(g.wait, 0.15, 1e-9);
    g = move(&f, 1, 105, 100, 5.05); /* it trembles */
    expect_nothing(&g);
    assert_near(g.wait, 0.10, 1e-9);
    g = move(&f, 1, 120, 100, 5.08);
    assert_int_equal(g.event_count, 2);
    expect_event(&g, 0, SKV_PHASE_DOWN, 1, 105);
    expect_event(&g, 1, SKV_PHASE_MOVE, 1, 120);
    assert_true(g.wait == 0);
    g = up(&f, 1, 125, 100, 5.5);
    assert_int_equal(g.event_count, 1);
    expect_event(&g, 0, SKV_PHASE_UP, 1, 125);
}

static void test_a_finger_that_rests_is_a_hand_soon(void **state)
{
    (void)state;
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    skv_gesture g = skv_fingers_wait(&f);
    assert_int_equal(g.event_count, 1);
    expect_event(&g, 0, SKV_PHASE_DOWN, 1, 100);
    g = skv_fingers_wait(&f); /* told twice */
    expect_nothing(&g);
    g = up(&f, 1, 100, 100, 5.2);
    expect_event(&g, 0, SKV_PHASE_UP, 1, 100);
    g = skv_fingers_wait(&f); /* nobody is down */
    expect_nothing(&g);

    /* Where nobody told, the next event does. */
    down(&f, 1, 100, 100, 6);
    g = move(&f, 1, 101, 100, 6.2);
    assert_int_equal(g.event_count, 2);
    expect_event(&g, 0, SKV_PHASE_DOWN, 1, 100);
    expect_event(&g, 1, SKV_PHASE_MOVE, 1, 101);
}

static void test_a_tap_is_down_and_up(void **state)
{
    (void)state;
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    skv_gesture g = up(&f, 1, 101, 100, 5.06);
    assert_int_equal(g.event_count, 2);
    expect_event(&g, 0, SKV_PHASE_DOWN, 1, 100);
    expect_event(&g, 1, SKV_PHASE_UP, 1, 101);
    assert_true(g.wait == 0 && f.count == 0);
}

/* A second finger beside one that acts already, and all that follow while one is down. */
static void test_a_later_finger_is_one_more_hand(void **state)
{
    (void)state;
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    skv_gesture g = down(&f, 2, 300, 100, 5.4);
    assert_int_equal(g.event_count, 2);
    expect_event(&g, 0, SKV_PHASE_DOWN, 1, 100);
    expect_event(&g, 1, SKV_PHASE_DOWN, 2, 300);
    g = move(&f, 1, 60, 100, 5.5);
    assert_true(g.event_count == 1 && g.dx == 0 && g.factor == 1);
    g = up(&f, 1, 60, 100, 5.6);
    expect_event(&g, 0, SKV_PHASE_UP, 1, 60);
    g = down(&f, 3, 200, 100, 5.65);
    expect_event(&g, 0, SKV_PHASE_DOWN, 3, 200);
    g = up(&f, 2, 300, 100, 5.7);
    g = up(&f, 3, 200, 100, 5.7);
    expect_event(&g, 0, SKV_PHASE_UP, 3, 200);
    assert_false(g.undo);

    /* Soon after the first, which has moved by then. */
    down(&f, 1, 100, 100, 7);
    move(&f, 1, 140, 100, 7.05);
    g = down(&f, 2, 300, 100, 7.06);
    assert_int_equal(g.event_count, 1);
    expect_event(&g, 0, SKV_PHASE_DOWN, 2, 300);
}

/* Applies what comes out to a camera, as a front end does; no tool hears of it. */
static void apply(skv_camera *camera, const skv_gesture *g)
{
    assert_int_equal(g->event_count, 0);
    assert_false(g->undo);
    skv_camera_pan(camera, g->dx, g->dy);
    if (g->factor != 1)
        skv_camera_zoom(camera, g->factor, g->px, g->py);
}

static void expect_under(const skv_camera *camera, double px, double py, double x, double y)
{
    double at_x, at_y;
    skv_camera_to_world(camera, px, py, &at_x, &at_y);
    assert_near(at_x, x, 1e-6);
    assert_near(at_y, y, 1e-6);
}

static void test_two_fingers_zoom_and_pan(void **state)
{
    (void)state;
    skv_fingers f = {0};
    skv_camera camera = skv_camera_fit(1600, 900, 1.6, 0.9);
    skv_gesture g = down(&f, 1, 700, 400, 5);
    g = down(&f, 2, 900, 500, 5.1);
    expect_nothing(&g);
    assert_true(g.wait == 0);
    double x[2], y[2];
    skv_camera_to_world(&camera, 700, 400, &x[0], &y[0]);
    skv_camera_to_world(&camera, 900, 500, &x[1], &y[1]);
    g = move(&f, 1, 692, 396, 5.2); /* it trembles */
    expect_nothing(&g);
    move(&f, 1, 700, 400, 5.2);
    for (int i = 1; i <= 20; i++) { /* apart, and along: each keeps the point under it */
        g = move(&f, 1, 700 - 15 * i, 400 - 10 * i, 5.2 + 0.02 * i);
        apply(&camera, &g);
        g = move(&f, 2, 900 + 25 * i, 500 + 10 * i, 5.21 + 0.02 * i);
        apply(&camera, &g);
    }
    assert_near(camera.zoom, hypot(1000, 500) / hypot(200, 100), 0.2);
    skv_camera_to_world(&camera, 400, 200, &x[0], &y[0]);
    skv_camera_to_world(&camera, 1400, 700, &x[1], &y[1]);

    /* One that is lifted changes nothing; the other moves the picture. */
    g = up(&f, 2, 1400, 700, 6);
    expect_nothing(&g);
    expect_under(&camera, 400, 200, x[0], y[0]);
    g = move(&f, 1, 420, 230, 6.1);
    apply(&camera, &g);
    expect_under(&camera, 420, 230, x[0], y[0]);
    g = down(&f, 3, 800, 230, 6.2); /* a gesture still */
    expect_nothing(&g);
    g = move(&f, 3, 990, 230, 6.3);
    assert_near(g.factor, 1.5, 1e-9);
    up(&f, 1, 420, 230, 6.4);
    g = up(&f, 3, 990, 230, 6.4);
    expect_nothing(&g);

    /* The next one is a hand again. */
    down(&f, 1, 100, 100, 7);
    g = move(&f, 1, 140, 100, 7.02);
    assert_int_equal(g.event_count, 2);
}

/* Exactly what was under each finger stays under it, if both move the same way or mirrored. */
static void test_points_stay_under_the_fingers(void **state)
{
    (void)state;
    skv_fingers f = {0};
    skv_camera camera = skv_camera_at(1600, 900, 1.6, 0.9, 0.8, 0.45, 4);
    double x[2], y[2];
    skv_camera_to_world(&camera, 700, 450, &x[0], &y[0]);
    skv_camera_to_world(&camera, 900, 450, &x[1], &y[1]);
    down(&f, 1, 700, 450, 5);
    down(&f, 2, 900, 450, 5.01);
    skv_gesture g = move(&f, 1, 650, 450, 5.1);
    apply(&camera, &g);
    g = move(&f, 2, 1000, 450, 5.1);
    apply(&camera, &g);
    expect_under(&camera, 650, 450, x[0], y[0]);
    expect_under(&camera, 1000, 450, x[1], y[1]);
    assert_near(camera.zoom, 7, 1e-9);
}

/* Puts three fingers down and lifts them; whether that undoes. */
static bool tap_of_three(double between, double lifted, double way, skv_phase last)
{
    skv_fingers f = {0};
    for (int i = 0; i < 3; i++) {
        skv_gesture g = down(&f, 11 + (uint64_t)i, 100 + 80 * i, 100, 5 + between * i);
        assert_false(g.undo);
    }
    skv_gesture g = {0};
    if (way > 0)
        move(&f, 12, 180, 100 + way, 5 + lifted);
    for (int i = 0; i < 3; i++) {
        skv_pointer_event event =
            event_at(i < 2 ? SKV_PHASE_UP : last, 11 + (uint64_t)i, 100, 100, 5 + lifted);
        assert_false(g.undo);
        g = skv_fingers_event(&f, &event);
        if (between < 0.15)
            assert_int_equal(g.event_count, 0);
    }
    assert_int_equal(f.count, 0);
    return g.undo;
}

static void test_three_taps_undo(void **state)
{
    (void)state;
    assert_true(tap_of_three(0.03, 0.25, 0, SKV_PHASE_UP));
    assert_true(tap_of_three(0.03, 0.25, 8, SKV_PHASE_UP)); /* trembling */
    assert_false(tap_of_three(0.03, 0.25, 30, SKV_PHASE_UP));
    assert_false(tap_of_three(0.03, 0.80, 0, SKV_PHASE_UP)); /* that was held */
    assert_false(tap_of_three(0.03, 0.25, 0, SKV_PHASE_LEAVE));
    assert_false(tap_of_three(0.20, 0.45, 0, SKV_PHASE_UP)); /* these are hands */
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    down(&f, 2, 200, 100, 5);
    up(&f, 1, 100, 100, 5.1);
    assert_false(up(&f, 2, 200, 100, 5.1).undo); /* two are not enough */
    for (uint64_t i = 1; i <= 4; i++)
        down(&f, i, 100, 100, 6);
    for (uint64_t i = 1; i <= 4; i++)
        assert_false(up(&f, i, 100, 100, 6.1).undo); /* and four are too many */
}

static void test_how_much_trembles_is_the_views(void **state)
{
    (void)state;
    skv_fingers f = {.tremble = 24};
    down(&f, 1, 100, 100, 5);
    skv_gesture g = move(&f, 1, 123, 100, 5.01);
    expect_nothing(&g);
    g = move(&f, 1, 125, 100, 5.02);
    assert_int_equal(g.event_count, 2);
}

static void test_mouse_and_pen_go_through(void **state)
{
    (void)state;
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    skv_pointer_event mouse = event_at(SKV_PHASE_DOWN, 1, 300, 300, 5.05);
    mouse.device = SKV_DEVICE_MOUSE;
    skv_gesture g = skv_fingers_event(&f, &mouse);
    assert_int_equal(g.event_count, 1);
    assert_int_equal(g.events[0].device, SKV_DEVICE_MOUSE);
    assert_near(g.wait, 0.10, 1e-9); /* the finger waits on */
    mouse.time = 5.3;
    g = skv_fingers_event(&f, &mouse);
    assert_int_equal(g.event_count, 2);
    assert_int_equal(g.events[0].device, SKV_DEVICE_FINGER);
    assert_int_equal(g.events[1].device, SKV_DEVICE_MOUSE);
}

static void test_a_finger_that_is_cancelled_does_nothing(void **state)
{
    (void)state;
    skv_fingers f = {0};
    down(&f, 1, 100, 100, 5);
    const skv_pointer_event leave = event_at(SKV_PHASE_LEAVE, 1, 100, 100, 5.05);
    skv_gesture g = skv_fingers_event(&f, &leave);
    expect_nothing(&g);
    assert_true(g.wait == 0 && f.count == 0);
    down(&f, 1, 100, 100, 6);
    skv_fingers_wait(&f);
    g = skv_fingers_event(&f, &leave);
    assert_int_equal(g.event_count, 1); /* the session knows it */
    expect_event(&g, 0, SKV_PHASE_LEAVE, 1, 100);
}

static void test_strange_events_do_no_harm(void **state)
{
    (void)state;
    skv_fingers f = {0};
    skv_gesture g = down(&f, 1, (double)NAN, 100, 5);
    expect_nothing(&g);
    g = move(&f, 7, 100, 100, 5);
    expect_nothing(&g);
    g = up(&f, 7, 100, 100, 5);
    expect_nothing(&g);
    for (uint64_t i = 0; i < SKV_MAX_HANDS + 4; i++)
        down(&f, i, 100 + 10 * (double)i, 100, 5);
    assert_int_equal(f.count, SKV_MAX_HANDS);
    for (uint64_t i = 0; i < SKV_MAX_HANDS + 4; i++)
        up(&f, i, 100, 100, 5.1);
    assert_int_equal(f.count, 0);
    down(&f, 1, 100, 100, 6); /* down twice */
    g = down(&f, 1, 400, 100, 6.05);
    assert_int_equal(g.event_count, 0);
    assert_near(g.wait, 0.15, 1e-9);
    g = down(&f, 2, 500, 100, 3); /* a clock that went back */
    expect_nothing(&g);
    /* Two in one place, and apart from there. */
    g = move(&f, 2, 400, 100, 6.1);
    g = move(&f, 2, 500, 100, 6.1);
    assert_true(isfinite(g.factor) && g.factor == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_finger_that_moves_is_a_hand),
        cmocka_unit_test(test_a_finger_that_rests_is_a_hand_soon),
        cmocka_unit_test(test_a_tap_is_down_and_up),
        cmocka_unit_test(test_a_later_finger_is_one_more_hand),
        cmocka_unit_test(test_two_fingers_zoom_and_pan),
        cmocka_unit_test(test_points_stay_under_the_fingers),
        cmocka_unit_test(test_three_taps_undo),
        cmocka_unit_test(test_how_much_trembles_is_the_views),
        cmocka_unit_test(test_mouse_and_pen_go_through),
        cmocka_unit_test(test_a_finger_that_is_cancelled_does_nothing),
        cmocka_unit_test(test_strange_events_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
