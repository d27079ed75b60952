/* Hands that hold bodies: these follow, hang still, fly on when they are let go, and come through
 * no wall; the same bits on any threads, and from a snapshot on. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define SPACING 0.0155f
#define EARTH   9.81
/* As strong and as quick as those of people (session/tools.c). */
#define STRENGTH 300.0f
#define FOLLOW   40.0f

/* A tank of 1.2 x 0.8 m with water of a depth, and a wall of 5 mm at 0.6 m if asked for. */
static skv_world *make_tank(int threads, skv_instruction_set set, float depth, bool wall)
{
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 480;
    terrain.height = 320;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, threads);
    def.instruction_set = set;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (wall) {
        skv_terrain *painted;
        skv_brush_stroke stroke = {
            .x0 = 0.6f, .x1 = 0.6f, .y0 = -0.1f, .y1 = 0.9f, .radius = 0.0025f};
        assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &stroke, 1, &painted, NULL),
                         SKV_OK);
        assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_OK);
    }
    if (depth > 0)
        fixture_fill(world, 0, 0, 1.2f, depth);
    return world;
}

static skv_world *make_dry(void)
{
    return make_tank(1, SKV_ISA_BEST, 0, false);
}

/* A box of 0.1 m. */
static skv_body_id add(skv_world *world, float x, float y, float density)
{
    skv_body_def def = skv_default_body_def();
    def.x = x;
    def.y = y;
    def.density = density;
    return fixture_add_body(world, &def);
}

static skv_hand grasp(const skv_world *world, float x, float y)
{
    skv_hand hand = skv_default_hand();
    hand.x = x;
    hand.y = y;
    hand.attraction = STRENGTH;
    hand.follow = FOLLOW;
    assert_true(skv_world_grasp(world, x, y, 0, &hand));
    return hand;
}

/* A frame with hands, which move on. */
static void hold(skv_world *world, skv_hand *hands, int count)
{
    assert_int_equal(skv_world_set_hands(world, hands, count, NULL), SKV_OK);
    fixture_run(world, 1);
    for (int i = 0; i < count; i++) {
        hands[i].x += hands[i].vx / 60;
        hands[i].y += hands[i].vy / 60;
    }
}

static void let_go(skv_world *world)
{
    assert_int_equal(skv_world_set_hands(world, NULL, 0, NULL), SKV_OK);
}

/* In the air, at 3 m/s to the right; thrown upwards it rises as high as its speed says. */
static void bodies_follow_and_fly_on(void **unused)
{
    (void)unused;
    static const float densities[] = {10, 500, 7850};
    for (int k = 0; k < 3; k++) {
        skv_world *world = make_dry();
        skv_body_id id = add(world, 0.1f, 0.3f, densities[k]);
        skv_hand hand = grasp(world, 0.1f, 0.3f);
        hand.vx = 2;
        hand.vy = 1;
        for (int f = 0; f < 15; f++) {
            hold(world, &hand, 1);
            skv_body body = fixture_body(world, id);
            double behind = hypot((double)(body.x - hand.x), (double)(body.y - hand.y));
            assert_true(f < 6 || behind < 0.02);
        }
        let_go(world);
        skv_body before = fixture_body(world, id);
        assert_near((double)before.vx, 2, 0.15);
        assert_near((double)before.vy, 1, 0.25);
        fixture_run(world, 6);
        skv_body after = fixture_body(world, id);
        assert_near((double)after.vx, (double)before.vx, 1e-3);
        assert_near((double)after.vy, (double)before.vy - 0.1 * EARTH, 1e-2);
        assert_near((double)(after.x - before.x), 0.1 * (double)before.vx, 1e-3);
        skv_world_destroy(world);
    }
}

/* Held by a corner it hangs below the hand and stops swinging; in water, cork stays down. */
static void what_is_held_hangs_still(void **unused)
{
    (void)unused;
    skv_world *world = make_dry();
    skv_body_id id = add(world, 0.6f, 0.4f, 1900);
    skv_hand hand = grasp(world, 0.64f, 0.44f);
    hand.friction = 10;
    for (int f = 0; f < 240; f++)
        hold(world, &hand, 1);
    skv_body body = fixture_body(world, id);
    assert_near((double)body.x, 0.64, 1e-3);
    /* Its weight stretches the spring. */
    double sag = EARTH / (double)(FOLLOW * FOLLOW) / (1 + 1000.0 / 1900);
    assert_near((double)body.y, 0.44 - 0.04 * sqrt(2) - sag, 5e-4);
    assert_true(hypot((double)body.vx, (double)body.vy) < 1e-3 && fabs((double)body.spin) < 0.01);
    skv_world_destroy(world);

    world = make_tank(1, SKV_ISA_BEST, 0.4f, false);
    id = add(world, 0.6f, 0.5f, 100);
    hand = grasp(world, 0.6f, 0.5f);
    hand.vy = -0.5f;
    for (int f = 0; f < 120; f++) {
        hold(world, &hand, 1);
        if (f == 35)
            hand.vy = 0;
    }
    body = fixture_body(world, id);
    assert_near((double)body.y, 0.2, 0.01);
    let_go(world);
    fixture_run(world, 90);
    assert_true((double)fixture_body(world, id).y > 0.33);
    skv_world_destroy(world);
}

/* To and fro between the two sides of a thin wall, in jumps and as fast as a hand goes, and into
 * floor and corners. */
static void walls_hold_what_is_held(void **unused)
{
    (void)unused;
    static const float densities[] = {10, 500, 7850, 10, 500, 7850}; /* what is dry, and in water */
    static const float places[][2] = {{0.9f, 0.4f},  {1.3f, -0.2f}, {0.3f, -0.5f},
                                      {-0.5f, 0.4f}, {0.3f, 1.5f},  {0.7f, 0.1f}};
    for (int k = 0; k < 6; k++) {
        skv_world *world = make_tank(1, SKV_ISA_BEST, k < 3 ? 0 : 0.3f, true);
        skv_body_id id = add(world, 0.3f, 0.5f, densities[k]);
        skv_hand hand = grasp(world, 0.33f, 0.54f);
        double deepest = 0;
        for (int f = 0; f < 180; f++) {
            const float *to = places[f / 30];
            float x = to[0] - hand.x, y = to[1] - hand.y, way = sqrtf(x * x + y * y);
            float speed = k % 2 ? 10 : 60 * way;
            hand.vx = way > speed / 60 ? speed * x / way : 0;
            hand.vy = way > speed / 60 ? speed * y / way : 0;
            hold(world, &hand, 1);
            skv_body body = fixture_body(world, id);
            assert_true((double)body.x < 0.6);
            for (int c = 0; c < body.corners; c++) {
                float cx = body.outline[2 * c], cy = body.outline[2 * c + 1];
                float px = body.x + cosf(body.angle) * cx - sinf(body.angle) * cy;
                float py = body.y + sinf(body.angle) * cx + cosf(body.angle) * cy;
                double in = fmax(fmax(-(double)px, -(double)py),
                                 fmax((double)px - 0.5975, (double)py - 0.8));
                deepest = fmax(deepest, in);
            }
        }
        assert_true(deepest < 0.003);
        skv_stats stats = skv_world_stats(world);
        assert_int_equal(stats.not_finite, 0);
        assert_int_equal(stats.escaped, 0);
        skv_world_destroy(world);
    }
}

/* Two hands turn one body, which lies between them as they take their turns. */
static void hands_share_a_body(void **unused)
{
    (void)unused;
    skv_world *world = make_dry();
    skv_body_id id = add(world, 0.6f, 0.4f, 500);
    skv_hand hands[2] = {grasp(world, 0.56f, 0.4f), grasp(world, 0.64f, 0.4f)};
    for (int f = 0; f < 120; f++) {
        hands[0].vy = f < 60 ? -0.06f : 0;
        hands[1].vy = f < 60 ? 0.06f : 0;
        hold(world, hands, 2);
    }
    skv_body body = fixture_body(world, id);
    assert_near((double)body.angle, atan(0.06 / 0.04), 0.05);
    assert_near((double)body.x, 0.6, 0.01);
    assert_true(hypot((double)body.vx, (double)body.vy) < 1e-3 && fabs((double)body.spin) < 0.01);
    skv_world_destroy(world);
}

/* A hand that holds a body holds no water, and wakes none. */
static void what_holds_a_body_holds_no_water(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 2, 0.03f, 1);
    def.sleep = true;
    skv_world *world = fixture_dam_of(&def);
    skv_hand hand = skv_default_hand();
    for (int f = 0; f < 2400 && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
    hand.x = 0.5f;
    hand.y = 0.1f;
    hand.body = 7; /* there is none */
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 2);
    assert_int_equal(skv_world_awake_count(world), 0);
    hand.body = 0;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 2);
    assert_true(skv_world_awake_count(world) > 0);
    skv_world_destroy(world);
}

static skv_world *make_busy(int threads, skv_instruction_set set)
{
    skv_world *world = make_tank(threads, set, 0.3f, false);
    add(world, 0.3f, 0.5f, 240);
    add(world, 0.8f, 0.6f, 1900);
    return world;
}

/* Stirs with the one and the other from frame to frame. */
static void stir(skv_world *world, int from, int to)
{
    skv_hand hands[2] = {grasp(world, fixture_body(world, 1).x, fixture_body(world, 1).y),
                         grasp(world, fixture_body(world, 2).x, fixture_body(world, 2).y)};
    for (int f = from; f < to; f++) {
        hands[0].x = 0.3f + 0.004f * (float)f;
        hands[0].y = f % 30 < 15 ? 0.2f : 0.3f;
        hands[1].x = 0.8f - 0.006f * (float)f;
        hands[1].y = 0.2f;
        hold(world, hands, 2);
    }
}

static skv_world *run_busy(int threads, skv_instruction_set set)
{
    skv_world *world = make_busy(threads, set);
    stir(world, 0, 60);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_busy);
}

static void snapshots_hold_what_hands_hold(void **unused)
{
    (void)unused;
    skv_world *world = make_busy(1, SKV_ISA_BEST), *copy;
    stir(world, 0, 20);
    assert_int_equal(skv_world_copy(world, NULL, &copy, NULL), SKV_OK);
    int count;
    const skv_hand *hands = skv_world_hands(copy, &count);
    assert_int_equal(count, 2);
    assert_int_equal(hands[1].body, 2);
    skv_world_destroy(copy);
    fixture_expect_goes_on(world, 20);
    skv_world_destroy(world);
}

static void what_cannot_be_held_is_not(void **unused)
{
    (void)unused;
    skv_world *world = make_dry();
    skv_hand hand = skv_default_hand();
    assert_false(skv_world_grasp(world, 0.5f, 0.5f, 1, &hand));
    skv_body_id id = add(world, 0.5f, 0.5f, 500);
    assert_false(skv_world_grasp(world, 0.56f, 0.5f, 0.005f, &hand));
    assert_int_equal(hand.body, 0);
    assert_true(skv_world_grasp(world, 0.56f, 0.5f, 0.02f, &hand));
    assert_int_equal(hand.body, id);
    assert_near((double)hand.at_x, 0.06, 1e-6);
    assert_true(hand.radius == skv_default_hand().radius);

    assert_false(skv_world_grasp(world, NAN, 0.5f, 1, &hand));
    assert_false(skv_world_grasp(world, 0.5f, -INFINITY, 1, &hand));
    assert_true(skv_world_grasp(world, 0.56f, 0.5f, 0.02f, &hand));

    /* Who holds what has gone does nothing. */
    assert_true(skv_world_remove_body(world, id));
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
    fixture_run(world, 10);

    hand.at_y = NAN;
    skv_error error;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "hand 0: where it holds its body is not finite or beyond 100 m");
    skv_world_destroy(world);
}

/* A fixed plate of 0.05 m to that height. It reaches into the floor: a foot that only touches it
 * lets water through at its corners. */
static skv_body_id add_plate(skv_world *world, float x, float height)
{
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(-0.025f, -0.1f, 0.025f, height);
    def.x = x;
    def.fixed = true;
    return fixture_add_body(world, &def);
}

static int count_left(const skv_world *world, float x)
{
    skv_particles p = skv_world_particles(world);
    int count = 0;
    for (int i = 0; i < p.count; i++)
        count += p.x[i] < x;
    return count;
}

/* A plate goes with the hand and pushes the water, which does not pass below it, stays upright, and
 * stops where it is let go. */
static void what_is_fixed_is_moved(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0.3f, false);
    skv_body_id id = add_plate(world, 0.3f, 0.6f);
    fixture_run(world, 30);
    assert_true(fixture_body(world, id).x == 0.3f);
    int left = count_left(world, 0.3f);
    skv_hand hand = grasp(world, 0.3f, 0.5f);
    hand.vx = 0.3f;
    for (int f = 0; f < 60; f++) {
        hold(world, &hand, 1);
        skv_body body = fixture_body(world, id);
        assert_true(fabsf(body.x - hand.x) < 0.02f && fabsf(body.y - 0.25f) < 0.002f);
        assert_true(body.angle == 0);
    }
    let_go(world);
    skv_body body = fixture_body(world, id);
    fixture_run(world, 30);
    assert_true(fabsf(fixture_body(world, id).x - body.x) < 1e-6f &&
                fixture_body(world, id).vx == 0);
    assert_near((double)body.x, 0.6, 0.02);
    assert_true(abs(count_left(world, body.x) - left) <= left / 50);
    assert_int_equal(skv_world_stats(world).escaped, 0);
    skv_world_destroy(world);
}

/* In a closed room it does not press water through, however far the hand goes, and it holds foam
 * and brick between itself and a wall. */
static void what_is_fixed_crushes_nothing(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_tank(1, SKV_ISA_BEST, k ? 0.1f : 0.5f, false);
        skv_body_id id = add_plate(world, 0.3f, 0.9f), loose[2] = {0};
        if (k) {
            loose[0] = add(world, 0.7f, 0.3f, 10);
            loose[1] = add(world, 0.9f, 0.06f, 1900);
        }
        int left = count_left(world, 0.3f);
        skv_hand hand = grasp(world, 0.3f, 0.6f);
        for (int f = 0; f < 180; f++) {
            hand.vx = f < 60 ? 1.5f : 0;
            hold(world, &hand, 1);
            for (int i = 0; i < 2 && k; i++)
                assert_true(fixture_body(world, loose[i]).x < 1.2f);
        }
        skv_body body = fixture_body(world, id);
        assert_true(body.x > 0.65f && body.x < 1.08f);
        assert_true(abs(count_left(world, body.x) - left) <= left / 50);
        skv_stats stats = skv_world_stats(world);
        assert_int_equal(stats.not_finite, 0);
        assert_int_equal(stats.escaped, 0);
        skv_world_destroy(world);
    }
}

/* A flap that is fixed and pinned turns with the hand, and copies of its world do the same. */
static void what_is_pinned_and_fixed_is_turned(void **unused)
{
    (void)unused;
    skv_world *world = make_tank(1, SKV_ISA_BEST, 0.3f, false), *copy;
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(0, -0.02f, 0.3f, 0.02f);
    def.x = def.pin_x = 0.4f;
    def.y = def.pin_y = 0.2f;
    def.fixed = def.pinned = true;
    skv_body_id id;
    assert_int_equal(skv_world_add_body(world, &def, &id, NULL, NULL), SKV_OK);
    fixture_run(world, 10);
    assert_true(fixture_body(world, id).angle == 0);
    skv_hand hand = grasp(world, 0.69f, 0.2f);
    for (int f = 0; f < 60; f++) {
        hand.vx = -0.2f;
        hand.vy = 0.3f;
        hold(world, &hand, 1);
    }
    assert_near((double)fixture_body(world, id).angle, atan2(0.3, 0.09), 0.1);
    assert_near((double)fixture_body(world, id).pin_x, 0.4, 1e-6);
    assert_int_equal(skv_world_copy(world, NULL, &copy, NULL), SKV_OK);
    skv_world *both[2] = {world, copy};
    for (int i = 0; i < 2; i++) {
        let_go(both[i]);
        fixture_run(both[i], 5);
        assert_true(fixture_body(both[i], id).spin == 0);
    }
    assert_true(skv_world_hash(copy) == skv_world_hash(world));
    skv_world_destroy(world);
    skv_world_destroy(copy);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_follow_and_fly_on),
        cmocka_unit_test(what_is_held_hangs_still),
        cmocka_unit_test(walls_hold_what_is_held),
        cmocka_unit_test(hands_share_a_body),
        cmocka_unit_test(what_holds_a_body_holds_no_water),
        cmocka_unit_test(what_is_fixed_is_moved),
        cmocka_unit_test(what_is_fixed_crushes_nothing),
        cmocka_unit_test(what_is_pinned_and_fixed_is_turned),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_hold_what_hands_hold),
        cmocka_unit_test(what_cannot_be_held_is_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
