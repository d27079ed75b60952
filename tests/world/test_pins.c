/* Bodies that turn about pins, and motors: a pendulum swings as theory says, a motor reaches its
 * speed as fast as its torque allows, water turns a wheel, nothing draws a body off its pin, the
 * pin's push is none of the fluid's; the same bits on any threads; and what hosts ask of them. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SPACING 0.0155f
#define EARTH   9.81
#define PI      3.14159265358979

/* A tank of 1.2 x 0.8 m, filled to a depth. */
static skv_world *make_tank(int threads, skv_instruction_set set, float depth, float gravity)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 480;
    terrain.height = 320;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, threads);
    def.instruction_set = set;
    def.gravity_y = gravity;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (depth > 0)
        fixture_fill(world, 0, 0, 1.2f, depth);
    return world;
}

static skv_body_def plank(float width, float height, float x, float y)
{
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(-width / 2, -height / 2, width / 2, height / 2);
    def.x = x;
    def.y = y;
    def.pinned = true;
    def.pin_x = x;
    def.pin_y = y;
    return def;
}

/* A cross of four paddles of 0.12 m about a place, of 0.03 m thickness. */
static skv_body_def wheel(float x, float y)
{
    static const float cross[] = {0.12f,   -0.015f, 0.12f,   0.015f,  0.015f,  0.015f,
                                  0.015f,  0.12f,   -0.015f, 0.12f,   -0.015f, 0.015f,
                                  -0.12f,  0.015f,  -0.12f,  -0.015f, -0.015f, -0.015f,
                                  -0.015f, -0.12f,  0.015f,  -0.12f,  0.015f,  -0.015f};
    skv_body_def def = plank(0.1f, 0.1f, x, y);
    def.shape = skv_polygon(cross, 12);
    return def;
}

/* How far a body whose pin was so far from its centre of mass, in its own axes, is off its pin, m.
 */
static double off_pin(const skv_body *body, double at_x, double at_y)
{
    double c = cos((double)body->angle), s = sin((double)body->angle);
    return hypot((double)body->x - (c * at_x - s * at_y) - (double)body->pin_x,
                 (double)body->y - (s * at_x + c * at_y) - (double)body->pin_y);
}

/* From a small angle, about a point near one end, or beside it as on a rod without weight. */
static void pendulums_swing_as_they_should(void **unused)
{
    (void)unused;
    const double width = 0.06, height = 0.3;
    static const double above[] = {0.13, 0.25};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
        skv_body_def def = plank((float)width, (float)height, 0.6f, 0.4f);
        double start = 0.1;
        def.x = (float)(0.6 + above[k] * sin(start));
        def.y = (float)(0.6 - above[k] * cos(start));
        def.pin_y = 0.6f;
        def.angle = (float)start;
        skv_body_id id = fixture_add_body(world, &def);
        double before = start, first = 0, last = 0;
        int passes = 0;
        for (int f = 1; f <= 600; f++) {
            fixture_run(world, 1);
            skv_body body = fixture_body(world, id);
            double angle = (double)body.angle;
            if (before * angle < 0) {
                last = f - angle / (angle - before);
                first = passes++ ? first : last;
            }
            before = angle;
            assert_true(off_pin(&body, 0, -above[k]) < 1e-6);
        }
        double period = 2 * (last - first) / (passes - 1) / 60;
        double square = (width * width + height * height) / 12 + above[k] * above[k];
        double theory = 2 * PI * sqrt(square / (EARTH * above[k])) * (1 + start * start / 16);
        assert_near(period, theory, 0.003 * theory);
        assert_near((double)fixture_body(world, id).inertia,
                    500 * 0.018 * (square - above[k] * above[k]), 1e-5);
        skv_world_destroy(world);
    }
}

/* In air after inertia times speed over torque; in water later. It holds the speed, lifts no more
 * than its torque does, and brakes. */
static void motors_reach_their_speed(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
    skv_body_def def = wheel(0.6f, 0.4f);
    def.motor_speed = 8;
    def.motor_torque = 0.4f;
    skv_body_id id = fixture_add_body(world, &def);
    double inertia = (double)fixture_body(world, id).inertia;
    int frames = (int)(60 * inertia * 8 / 0.4 + 0.5);
    const int half = frames / 2;
    fixture_run(world, half);
    assert_near((double)fixture_body(world, id).spin, 0.4 / inertia * half / 60, 0.01);
    fixture_run(world, frames);
    assert_near((double)fixture_body(world, id).spin, 8, 1e-4);
    assert_int_equal(skv_world_set_body_motor(world, id, 0, 0.4f, NULL), SKV_OK);
    fixture_run(world, 2 * frames);
    assert_near((double)fixture_body(world, id).spin, 0, 1e-4);
    skv_world_destroy(world);

    /* A plank whose weight, 500 * 0.012 kg/m at 0.15 m, asks for 8.8 N. */
    for (int k = 0; k < 2; k++) {
        world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
        def = plank(0.3f, 0.04f, 0.75f, 0.4f);
        def.pin_x = 0.6f;
        def.motor_torque = k ? 9.5f : 8;
        def.motor_speed = 1;
        id = fixture_add_body(world, &def);
        fixture_run(world, 60);
        assert_true(k ? fixture_body(world, id).angle > 0.5f
                      : fixture_body(world, id).angle < -0.5f);
        skv_world_destroy(world);
    }

    world = make_tank(1, SKV_ISA_BEST, 0.35f, -9.81f);
    def = wheel(0.6f, 0.2f);
    def.motor_speed = 5;
    def.motor_torque = 50;
    id = fixture_add_body(world, &def);
    fixture_run(world, 120);
    assert_near((double)fixture_body(world, id).spin, 5, 0.1);
    assert_true(skv_world_stats(world).kinetic_energy > 1);
    skv_world_destroy(world);
}

/* A jet of 2 m/s hits the paddles on the right. They run as fast as the water there, or slower. */
static void water_turns_a_wheel(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
    skv_body_def def = wheel(0.6f, 0.4f);
    skv_body_id id = fixture_add_body(world, &def);
    skv_emitter jet = {0};
    jet.x = 0.69f;
    jet.y = 0.75f;
    jet.vy = -2;
    jet.width = 0.05f;
    assert_int_equal(skv_world_set_emitters(world, &jet, 1, NULL), SKV_OK);
    fixture_run(world, 60);
    double began = (double)fixture_body(world, id).angle;
    fixture_run(world, 120);
    skv_body body = fixture_body(world, id);
    double spin = ((double)body.angle - began) / 2, fastest = sqrt(4 + 2 * EARTH * 0.35) / 0.09;
    assert_true(spin < -0.2 * fastest && spin > -fastest);
    assert_true(off_pin(&body, 0, 0) < 1e-6);
    assert_int_equal(skv_world_stats(world).not_finite, 0);
    skv_world_destroy(world);
}

/* A hand draws at a hanging plank, water and a falling brick push it, and walls stop it. */
static void nothing_draws_a_body_off_its_pin(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0.3f, -9.81f);
    skv_body_def def = plank(0.06f, 0.3f, 0.2f, 0.3f);
    def.pin_y = 0.42f;
    skv_body_id id = fixture_add_body(world, &def);
    skv_body_def brick = skv_default_body_def();
    brick.x = 0.25f;
    brick.y = 0.7f;
    brick.density = 7850;
    brick.vy = -8;
    skv_body_id falling = fixture_add_body(world, &brick);
    skv_hand hand = skv_default_hand();
    hand.attraction = 300;
    hand.follow = 40;
    double deepest = 0;
    for (int f = 0; f < 240; f++) {
        hand.x = f < 60 ? 1 : 0.1f;
        hand.y = f < 120 ? 0.2f : 0.7f;
        if (f == 0)
            assert_true(skv_world_grasp(world, 0.2f, 0.2f, 0, &hand));
        assert_int_equal(skv_world_set_hands(world, &hand, f < 180 ? 1 : 0, NULL), SKV_OK);
        fixture_run(world, 1);
        skv_body body = fixture_body(world, id), other = fixture_body(world, falling);
        assert_true(off_pin(&body, 0, -0.12) < 1e-6);
        assert_true(fabsf(body.spin) < 60);
        deepest = fmin(deepest, (double)other.y - 0.05);
        for (int c = 0; c < body.corners; c++) {
            float cx = body.outline[2 * c], cy = body.outline[2 * c + 1];
            deepest =
                fmin(deepest, (double)(body.x + cosf(body.angle) * cx - sinf(body.angle) * cy));
        }
    }
    assert_true(deepest > -0.04 && deepest < 1);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

/* Beside a wall a flap hangs down; with its pin in the wall it turns until its corner touches. */
static void a_flap_hangs_at_a_wall(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
        skv_body_def def = plank(0.3f, 0.03f, k ? 0.15f : 0.16f, 0.4f);
        def.pin_x = k ? 0 : 0.02f;
        skv_body_id id = fixture_add_body(world, &def);
        fixture_run(world, 20);
        assert_true(fixture_body(world, id).angle < -0.2f);
        skv_hand hand = skv_default_hand(); /* it stops its swinging */
        hand.x = k ? 0.25f : 0.02f;
        hand.y = k ? 0.3f : 0.15f;
        hand.attraction = 300;
        hand.follow = 40;
        skv_body body = fixture_body(world, id);
        assert_true(skv_world_grasp(world, body.x, body.y, 0, &hand));
        assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
        fixture_run(world, 60);
        assert_int_equal(skv_world_set_hands(world, NULL, 0, NULL), SKV_OK);
        fixture_run(world, 120);
        body = fixture_body(world, id);
        assert_true(k ? body.angle < -0.2f && body.angle > -0.8f
                      : fabs((double)body.angle + PI / 2) < 0.1);
        skv_world_destroy(world);
    }
}

/* Without weight a wheel in the water takes what the water loses, and the pin all of its push. */
static void the_fluid_is_not_told_of_the_pin(void **unused)
{
    (void)unused;
    skv_world *world = fixture_blob(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0);
    skv_body_def def = plank(0.08f, 0.04f, 0.78f, 0.44f);
    def.spin = 4;
    skv_body_id id = fixture_add_body(world, &def);
    double s = (double)skv_world_spacing(world), mass = 1000 * s * s, sum[2] = {0}, given[2] = {0};
    for (int sign = -1; sign <= 1; sign += 2) {
        skv_particles p = skv_world_particles(world);
        for (int i = 0; i < p.count; i++) {
            sum[0] += sign * mass * (double)p.vx[i];
            sum[1] += sign * mass * (double)p.vy[i];
        }
        for (int f = 0; sign < 0 && f < 60; f++) {
            fixture_run(world, 1);
            skv_body body = fixture_body(world, id);
            given[0] += (double)body.force_x / 60;
            given[1] += (double)body.force_y / 60;
        }
    }
    assert_near(sum[0], -given[0], 2e-4);
    assert_near(sum[1], -given[1], 2e-4);
    assert_true(hypot(sum[0], sum[1]) > 1e-3);
    skv_world_destroy(world);
}

static skv_world *make_busy(int threads, skv_instruction_set set)
{
    skv_world *world = make_tank(threads, set, 0.3f, -9.81f);
    skv_body_def def = wheel(0.4f, 0.3f);
    def.motor_speed = -6;
    def.motor_torque = 3;
    fixture_add_body(world, &def);
    def = plank(0.06f, 0.3f, 0.9f, 0.3f);
    def.pin_y = 0.42f;
    def.angle = 1;
    fixture_add_body(world, &def);
    return world;
}

static skv_world *run_busy(int threads, skv_instruction_set set)
{
    skv_world *world = make_busy(threads, set);
    fixture_run(world, 60);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_busy);
}

static void snapshots_hold_pins(void **unused)
{
    (void)unused;
    skv_world *world = make_busy(1, SKV_ISA_BEST), *copy;
    fixture_run(world, 20);
    assert_int_equal(skv_world_copy(world, NULL, &copy, NULL), SKV_OK);
    skv_body body = fixture_body(copy, 1);
    assert_true(body.pinned && body.motor_speed == -6 && body.motor_torque == 3);
    assert_true(body.pin_x == 0.4f && body.pin_y == 0.3f);
    fixture_expect_goes_on(world, 20);
    fixture_saved b = fixture_save(world, false);
    for (size_t cut = b.size - 1; cut > b.size - 200; cut -= 3)
        assert_int_not_equal(skv_world_restore(copy, b.bytes, cut, NULL), SKV_OK);
    free(b.bytes);
    skv_world_destroy(world);
    skv_world_destroy(copy);
}

static void refuse(skv_world *world, const skv_body_def *def, const char *why)
{
    skv_error error = {0};
    assert_int_equal(skv_world_add_body(world, def, NULL, NULL, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, why);
    assert_int_equal(skv_world_body_count(world), 0);
}

static void what_is_no_pin_is_refused(void **unused)
{
    (void)unused;
    static const char *const far_off = "body: its pin is out of range; allowed is -100..100 m",
                             *const no_pin = "body: its motor turns nothing; it takes a pin, and a "
                                             "body that is not fixed",
                             *const too_much = "body: its motor is out of range; allowed is "
                                               "-1000..1000 rad/s and 0..1000000 N m/m";
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0, -9.81f);
    skv_body_def good = wheel(0.6f, 0.4f), def = good;
    def.pin_x = NAN;
    refuse(world, &def, far_off);
    def.pin_x = 101;
    refuse(world, &def, far_off);
    def = good;
    def.motor_torque = -1;
    refuse(world, &def, too_much);
    def.motor_torque = INFINITY;
    refuse(world, &def, too_much);
    def.motor_torque = 1;
    def.motor_speed = NAN;
    refuse(world, &def, too_much);
    def.motor_speed = 1;
    def.fixed = true;
    refuse(world, &def, no_pin);
    def.fixed = def.pinned = false;
    refuse(world, &def, no_pin);

    skv_error error = {0};
    skv_body_id id = fixture_add_body(world, &good);
    assert_int_equal(skv_world_set_body_motor(world, id, 1001, 1, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, too_much);
    assert_int_equal(skv_world_set_body_motor(world, 9, 1, 1, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "none named 9"));
    skv_body_def loose = skv_default_body_def();
    loose.y = 0.2f;
    loose.x = 0.2f;
    skv_body_id other = fixture_add_body(world, &loose);
    assert_int_equal(skv_world_set_body_motor(world, other, 1, 1, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text, no_pin);
    assert_int_equal(skv_world_set_body_motor(world, other, 1, 0, &error), SKV_OK);
    skv_world_destroy(world);
}

/* It is put elsewhere with its pin, its speed follows from its spin, and one that is fixed turns
 * about its pin as it is told. */
static void what_is_pinned_is_put_and_set(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0, 0);
    skv_body_def def = plank(0.3f, 0.04f, 0.75f, 0.4f);
    def.pin_x = 0.6f;
    skv_body_id id = fixture_add_body(world, &def);
    assert_int_equal(skv_world_set_body_velocity(world, id, 3, 3, 2, NULL), SKV_OK);
    assert_near((double)fixture_body(world, id).vx, 0, 1e-6);
    assert_near((double)fixture_body(world, id).vy, 0.3, 1e-6);
    assert_int_equal(skv_world_set_body_pose(world, id, 0.5f, 0.3f, (float)PI / 2, NULL), SKV_OK);
    skv_body body = fixture_body(world, id);
    assert_near((double)body.pin_x, 0.5, 1e-6);
    assert_near((double)body.pin_y, 0.15, 1e-6);
    assert_near((double)body.y, 0.3, 1e-6);
    skv_world_destroy(world);

    world = make_tank(1, SKV_ISA_BEST, 0.3f, -9.81f);
    def.fixed = true;
    def.spin = -1;
    id = fixture_add_body(world, &def);
    fixture_run(world, 60);
    body = fixture_body(world, id);
    assert_near((double)body.angle, -1, 1e-5);
    assert_true(off_pin(&body, 0.15, 0) < 1e-6);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pendulums_swing_as_they_should),
        cmocka_unit_test(motors_reach_their_speed),
        cmocka_unit_test(water_turns_a_wheel),
        cmocka_unit_test(nothing_draws_a_body_off_its_pin),
        cmocka_unit_test(a_flap_hangs_at_a_wall),
        cmocka_unit_test(the_fluid_is_not_told_of_the_pin),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_hold_pins),
        cmocka_unit_test(what_is_no_pin_is_refused),
        cmocka_unit_test(what_is_pinned_is_put_and_set),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
