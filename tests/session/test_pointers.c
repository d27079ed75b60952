/* Several fingers at once, below every toolkit: which hands there are, where, and how fast. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <skvalp/session.h>

/* The pool is 1.6 x 0.9 m: at this view 1000 pixels are a metre. */
#define VIEW_WIDTH  1600
#define VIEW_HEIGHT 900

static int setup(void **state)
{
    skv_session *session;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 800;
    if (skv_session_create(1, &session, NULL) != SKV_OK)
        return -1;
    *state = session;
    skv_session_set_view(session, VIEW_WIDTH, VIEW_HEIGHT);
    return skv_session_open(session, "pool", &options, NULL) == SKV_OK ? 0 : -1;
}

static int teardown(void **state)
{
    skv_session_destroy(*state);
    return 0;
}

static skv_hand only_hand(const skv_session *session)
{
    skv_hand hand;
    assert_int_equal(skv_session_hands(session, &hand, 1), 1);
    return hand;
}

static void assert_near(double value, double wanted, double tolerance)
{
    if (fabs(value - wanted) > tolerance)
        fail_msg("%g is not within %g of %g", value, tolerance, wanted);
}

static void test_fingers_come_and_go(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 11, 100, 800, 0);
    skv_session_pointer_down(session, 22, 200, 700, 0);
    skv_session_pointer_down(session, 33, 300, 600, 0);
    skv_session_pointer_move(session, 22, 250, 650, 0.1);
    skv_session_pointer_move(session, 44, 1, 1, 0.1); /* never went down */
    assert_int_equal(skv_session_pointer_count(session), 3);

    skv_hand hands[3];
    assert_int_equal(skv_session_hands(session, hands, 3), 3);
    assert_near(hands[0].x, 0.1, 1e-6);
    assert_near(hands[0].y, 0.1, 1e-6);
    assert_near(hands[1].x, 0.25, 1e-6);
    assert_near(hands[1].y, 0.25, 1e-6);
    assert_near(hands[2].x, 0.3, 1e-6);

    skv_session_pointer_up(session, 11);
    skv_session_pointer_up(session, 44);
    assert_int_equal(skv_session_hands(session, hands, 3), 2);
    assert_near(hands[0].x, 0.25, 1e-6);
    assert_near(hands[1].x, 0.3, 1e-6);

    skv_session_pointer_cancel_all(session);
    assert_int_equal(skv_session_pointer_count(session), 0);
    assert_int_equal(skv_session_hands(session, NULL, 0), 0);
}

static void test_down_twice_is_one_finger(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 1, 100, 100, 0);
    skv_session_pointer_move(session, 1, 300, 100, 0.1);
    skv_session_pointer_down(session, 1, 500, 500, 0.2);
    skv_hand hand = only_hand(session);
    assert_near(hand.x, 0.5, 1e-6);
    assert_near(hand.vx, 0, 1e-9);
}

static void test_too_many_fingers_are_ignored(void **state)
{
    skv_session *session = *state;
    for (uint64_t i = 0; i < SKV_MAX_HANDS + 4; i++)
        skv_session_pointer_down(session, 1000 + i, 10.0 * (double)i, 10, 0);
    assert_int_equal(skv_session_pointer_count(session), SKV_MAX_HANDS);
    skv_session_pointer_up(session, 1000 + SKV_MAX_HANDS); /* was ignored */
    assert_int_equal(skv_session_pointer_count(session), SKV_MAX_HANDS);

    /* More room asked for than given: only what fits is written. */
    skv_hand two[2];
    assert_int_equal(skv_session_hands(session, two, 2), SKV_MAX_HANDS);
    int frames = 0;
    assert_int_equal(skv_session_advance(session, 1.0 / 60, &frames, NULL), SKV_OK);
    assert_int_equal(frames, 1);
}

static void test_events_that_are_not_finite_are_ignored(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 1, NAN, 0, 0);
    assert_int_equal(skv_session_pointer_count(session), 0);
    skv_session_pointer_down(session, 1, 100, 100, 0);
    skv_session_pointer_move(session, 1, INFINITY, 0, 1);
    skv_session_pointer_move(session, 1, 0, 0, NAN);
    assert_near(only_hand(session).x, 0.1, 1e-6);
}

/* Moves pointer 1 by (px, py) pixels a second for some events. */
static double drag(skv_session *session, double px, double py, double rate, int events)
{
    double time = 0, x = 800, y = 450;
    skv_session_pointer_down(session, 1, x, y, time);
    for (int i = 0; i < events; i++) {
        time += 1 / rate;
        skv_session_pointer_move(session, 1, x + px * time, y + py * time, time);
    }
    return time;
}

static void test_velocity_is_measured(void **state)
{
    skv_session *session = *state;
    const double rates[] = {30, 60, 125, 1000};
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        drag(session, 600, -400, rates[i], (int)(0.3 * rates[i]));
        skv_hand hand = only_hand(session);
        assert_near(hand.vx, 0.6, 0.01);
        assert_near(hand.vy, 0.4, 0.01); /* up in the world is up on the screen */
    }
}

static void test_velocity_is_smooth(void **state)
{
    skv_session *session = *state;
    /* 1 m/s with a jitter of two pixels, as touch panels have: 0.24 m/s of noise at 60 Hz. */
    skv_session_pointer_down(session, 1, 0, 450, 0);
    for (int i = 1; i <= 60; i++) {
        double x = 1000 * i / 60.0 + (i % 2 ? 2 : -2);
        skv_session_pointer_move(session, 1, x, 450, i / 60.0);
        if (i > 20)
            assert_near(only_hand(session).vx, 1, 0.12);
    }
}

static void test_equal_times_do_no_harm(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 1, 100, 100, 5);
    skv_session_pointer_move(session, 1, 110, 100, 5);
    skv_session_pointer_move(session, 1, 120, 100, 5);
    assert_near(only_hand(session).vx, 0, 1e-9);
    assert_near(only_hand(session).x, 0.12, 1e-6);
    /* The way since the last time stamp counts once the clock moves on. */
    skv_session_pointer_move(session, 1, 130, 100, 5.5);
    assert_near(only_hand(session).vx, 0.06, 0.001);
    /* A hair's breadth later: bounded by the smoothing, not 30 mm / 1 us. */
    skv_session_pointer_move(session, 1, 160, 100, 5.500001);
    assert_near(only_hand(session).vx, 0.06 + 0.030 / 0.04, 0.01);
    /* A clock that jumps back starts a new measurement. */
    skv_session_pointer_move(session, 1, 170, 100, 1);
    skv_session_pointer_move(session, 1, 170, 100, 2);
    assert_near(only_hand(session).vx, 0, 0.001);
}

static void test_velocity_fades_at_rest(void **state)
{
    skv_session *session = *state;
    drag(session, 1000, 0, 100, 50);
    assert_near(only_hand(session).vx, 1, 0.02);
    assert_int_equal(skv_session_advance(session, 1.0 / 60, NULL, NULL),
                     SKV_OK); /* between two events of a slow device: kept */
    assert_near(only_hand(session).vx, 1, 0.02);
    for (int i = 0; i < 30; i++)
        assert_int_equal(skv_session_advance(session, 1.0 / 60, NULL, NULL), SKV_OK);
    assert_near(only_hand(session).vx, 0, 0.001);
}

static void test_velocity_in_slow_motion(void **state)
{
    skv_session *session = *state;
    drag(session, 200, 0, 100, 50);
    skv_session_set_speed(session, 0.25);
    assert_near(only_hand(session).vx, 0.8, 0.02); /* 0.2 m/s, four times as much for the fluid */
    skv_session_set_speed(session, 0.05);
    drag(session, 3000, 4000, 100, 50);
    skv_hand hand = only_hand(session);
    assert_near(hypot(hand.vx, hand.vy), 10, 1e-3); /* cut, in the same direction */
    assert_near(hand.vx / -hand.vy, 0.75, 1e-3);
}

static void test_finger_stays_put_when_the_view_changes(void **state)
{
    skv_session *session = *state;
    skv_session_pointer_down(session, 1, 800, 450, 0);
    assert_near(only_hand(session).x, 0.8, 1e-6);
    skv_session_set_view(session, 800, 450);
    assert_near(only_hand(session).x, 1.6, 1e-6); /* the same pixel is elsewhere in the world */
}

static void test_grip(void **state)
{
    skv_session *session = *state;
    assert_near(skv_session_grip(session), 0.16, 1e-6);
    skv_session_set_grip(session, 0.05);
    skv_session_pointer_down(session, 1, 800, 450, 0);
    assert_near(only_hand(session).radius, 0.05, 1e-6);
    skv_session_set_grip(session, 0);
    assert_near(skv_session_grip(session), 0.16, 1e-6);
}

static double mean_height_near(const skv_world *world, double x, double reach)
{
    skv_particles particles = skv_world_particles(world);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < particles.count; i++)
        if (fabs(particles.x[i] - x) < reach) {
            sum += particles.y[i];
            count++;
        }
    return sum / count;
}

/* Two fingers lift two chunks, and the fluid falls back when they let go. */
static void test_two_fingers_lift_fluid(void **state)
{
    skv_session *session = *state;
    const skv_world *world = skv_session_world(session);
    double before = mean_height_near(world, 0.4, 0.1), middle = mean_height_near(world, 0.8, 0.1);
    skv_session_pointer_down(session, 1, 400, 500, 0);
    skv_session_pointer_down(session, 2, 1200, 500, 0);
    for (int i = 1; i <= 40; i++) {
        double y = fmax(500 - 8 * i, 300);
        skv_session_pointer_move(session, 1, 400, y, i / 60.0);
        skv_session_pointer_move(session, 2, 1200, y, i / 60.0);
        assert_int_equal(skv_session_advance(session, 1.0 / 60, NULL, NULL), SKV_OK);
    }
    double left = mean_height_near(world, 0.4, 0.1), right = mean_height_near(world, 1.2, 0.1);
    assert_true(left > before + 0.03);
    assert_true(right > before + 0.03);
    assert_true(mean_height_near(world, 0.8, 0.1) < middle + 0.02);

    skv_session_pointer_up(session, 1);
    skv_session_pointer_up(session, 2);
    /* Eight seconds, until the waves have passed: they are as high as what is asserted. */
    for (int i = 0; i < 480; i++)
        assert_int_equal(skv_session_advance(session, 1.0 / 60, NULL, NULL), SKV_OK);
    assert_near(mean_height_near(world, 0.4, 0.1), before, 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_fingers_come_and_go, setup, teardown),
        cmocka_unit_test_setup_teardown(test_down_twice_is_one_finger, setup, teardown),
        cmocka_unit_test_setup_teardown(test_too_many_fingers_are_ignored, setup, teardown),
        cmocka_unit_test_setup_teardown(test_events_that_are_not_finite_are_ignored, setup,
                                        teardown),
        cmocka_unit_test_setup_teardown(test_velocity_is_measured, setup, teardown),
        cmocka_unit_test_setup_teardown(test_velocity_is_smooth, setup, teardown),
        cmocka_unit_test_setup_teardown(test_equal_times_do_no_harm, setup, teardown),
        cmocka_unit_test_setup_teardown(test_velocity_fades_at_rest, setup, teardown),
        cmocka_unit_test_setup_teardown(test_velocity_in_slow_motion, setup, teardown),
        cmocka_unit_test_setup_teardown(test_finger_stays_put_when_the_view_changes, setup,
                                        teardown),
        cmocka_unit_test_setup_teardown(test_grip, setup, teardown),
        cmocka_unit_test_setup_teardown(test_two_fingers_lift_fluid, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
