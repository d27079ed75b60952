/* Sleep of bodies: that a stack falls asleep, in air and under water, and so does what floats; what
 * wakes them; that snapshots and any threads go on with the same bits. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { BRICKS = FIXTURE_BRICKS, LONGEST = 1800 };

static void wait_for_rest(skv_world *world)
{
    for (int f = 0; f < LONGEST && skv_world_awake_count(world) > 0; f++)
        fixture_run(world, 1);
    assert_int_equal(skv_world_awake_count(world), 0);
}

static skv_world *make_sleeping_stack(float depth)
{
    skv_world *world = fixture_shaft(depth, true, 1, SKV_ISA_BEST);
    fixture_add_stack(world);
    wait_for_rest(world);
    return world;
}

/* And the fluid around it; then nothing changes, and bodies go on feeling what they felt. */
static void stacks_fall_asleep(void **unused)
{
    (void)unused;
    static const float depths[] = {0, 0.7f};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_sleeping_stack(depths[k]);
        uint64_t hash = skv_world_hash(world);
        skv_body before = fixture_body(world, 1);
        fixture_run(world, 60);
        assert_true(skv_world_hash(world) == hash);
        assert_int_equal(skv_world_awake_count(world), 0);
        skv_body after = fixture_body(world, 1);
        assert_true(after.force_y == before.force_y);
        assert_true(depths[k] > 0 ? after.force_y > 0 : after.force_y == 0);
        fixture_expect_goes_on(world, 2);
        skv_world_destroy(world);
    }
}

static void what_floats_falls_asleep(void **unused)
{
    (void)unused;
    skv_world *world = fixture_shaft(0.4f, true, 1, SKV_ISA_BEST);
    skv_body_id id = fixture_add_brick(world, 0.2f, 0.4f, 500);
    wait_for_rest(world);
    skv_body b = fixture_body(world, id);
    assert_near((double)b.force_y / (9.81 * (double)b.mass), 1, 0.05);
    skv_world_destroy(world);
}

/* ---- What wakes ------------------------------------------------------------------------------ */

static void turn_gravity(skv_world *world)
{
    assert_int_equal(skv_world_set_gravity(world, 3, -9, NULL), SKV_OK);
}

static void take_the_lowest_away(skv_world *world)
{
    assert_true(skv_world_remove_body(world, 1));
}

static void put_the_lowest_away(skv_world *world)
{
    assert_int_equal(skv_world_set_body_pose(world, 1, 0.07f, 0.05f, 0, NULL), SKV_OK);
}

static void spur_the_lowest(skv_world *world)
{
    assert_int_equal(skv_world_set_body_velocity(world, 1, 0.5f, 0, 0, NULL), SKV_OK);
}

static void throw_a_brick(skv_world *world)
{
    fixture_add_brick(world, 0.2f, 0.65f, 1900);
}

static void draw_at_the_middle_one(skv_world *world)
{
    skv_hand hand = skv_default_hand();
    assert_true(skv_world_grasp(world, 0.2f, 0.25f, 0, &hand));
    hand.x = 0.3f;
    hand.y = 0.4f;
    assert_int_equal(skv_world_set_hands(world, &hand, 1, NULL), SKV_OK);
}

/* Erases the middle of the floor that a body lies on. */
static void dig(skv_world *world)
{
    const skv_brush_stroke stroke = {0.2f, 0.05f, 0.2f, 0.05f, 0.08f, true};
    skv_terrain *dug;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &stroke, 1, &dug, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, dug, NULL, NULL), SKV_OK);
}

/* Whether the uppermost of the first bricks has moved after half a second. */
static bool moves_after(skv_world *world, void (*stir)(skv_world *world))
{
    skv_body before = fixture_body(world, BRICKS);
    if (stir)
        stir(world);
    fixture_run(world, 30);
    skv_body after = fixture_body(world, BRICKS);
    skv_world_destroy(world);
    return hypot((double)(after.x - before.x), (double)(after.y - before.y)) > 1e-6;
}

static void bodies_wake(void **unused)
{
    (void)unused;
    static void (*const stirs[])(skv_world *) = {
        turn_gravity,    take_the_lowest_away, put_the_lowest_away,
        spur_the_lowest, throw_a_brick,        draw_at_the_middle_one,
    };
    assert_false(moves_after(make_sleeping_stack(0), NULL));
    for (size_t k = 0; k < sizeof stirs / sizeof *stirs; k++)
        if (!moves_after(make_sleeping_stack(0), stirs[k]))
            fail_msg("what %d does wakes nobody", (int)k);
}

/* A floor of painted wall, 0.1 m high, on which a brick sleeps. */
static void digging_wakes(void **unused)
{
    (void)unused;
    skv_world *world = fixture_shaft(0, true, 1, SKV_ISA_BEST);
    const skv_brush_stroke floor = {0, 0, 0.4f, 0, 0.1f, false};
    skv_terrain *painted;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &floor, 1, &painted, NULL),
                     SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_OK);
    skv_body_id id = fixture_add_brick(world, 0.2f, 0.151f, 1900);
    wait_for_rest(world);
    double y = (double)fixture_body(world, id).y;
    assert_near(y, 0.15, 0.002);
    dig(world);
    fixture_run(world, 30);
    assert_true((double)fixture_body(world, id).y < y - 0.02);
    skv_world_destroy(world);
}

/* Water that falls into sleeping water wakes the stack in it. */
static void water_wakes(void **unused)
{
    (void)unused;
    skv_world *world = make_sleeping_stack(0.3f);
    float x = 0.05f, y = 0.45f;
    for (int k = 0; k < 12; k++)
        assert_int_equal(skv_world_add_particle(world, x, y + (float)k * 0.025f, 0, -1, NULL),
                         SKV_OK);
    skv_body before = fixture_body(world, 1);
    fixture_run(world, 60);
    skv_body after = fixture_body(world, 1);
    assert_true(before.x != after.x || before.y != after.y);
    skv_world_destroy(world);
}

/* A world is awake as long as a body falls, though it is dry or all its water sleeps. */
static void what_falls_is_awake(void **unused)
{
    (void)unused;
    skv_world *world = fixture_shaft(0.1f, true, 1, SKV_ISA_BEST);
    wait_for_rest(world);
    skv_body_id id = fixture_add_brick(world, 0.2f, 0.7f, 1900);
    assert_int_equal(skv_world_awake_count(world), 1);
    fixture_run(world, 6);
    assert_int_equal(skv_world_awake_count(world), 1);
    assert_true((double)fixture_body(world, id).y < 0.68);
    skv_world_destroy(world);
}

/* What swings is at no moment taken for resting, whatever its period is. */
static void what_swings_is_awake(void **unused)
{
    (void)unused;
    skv_world *world = fixture_shaft(0, true, 1, SKV_ISA_BEST);
    for (int k = 0; k < 5; k++) {
        skv_body_def def = skv_default_body_def();
        def.shape = skv_box(-0.02f, -0.02f, 0.02f, 0.02f);
        def.x = 0.2f;
        def.y = 0.2f + 0.12f * (float)k;
        def.pinned = true;
        def.pin_x = 0.2f;
        def.pin_y = def.y + 0.05f + 0.005f * (float)k;
        def.angle = 0;
        def.x += 0.01f;
        fixture_add_body(world, &def);
    }
    for (int f = 0; f < 600; f++) {
        fixture_run(world, 1);
        assert_int_equal(skv_world_awake_count(world), 5);
    }
    skv_world_destroy(world);
}

/* ---- Bits ------------------------------------------------------------------------------------ */

/* A stack that sleeps with its water, and a brick that comes down beside it. */
static skv_world *run_partly(int threads, skv_instruction_set set)
{
    skv_world *world = fixture_shaft(0.2f, true, threads, set);
    fixture_add_stack(world);
    wait_for_rest(world);
    fixture_add_brick(world, 0.07f, 0.7f, 700);
    fixture_run(world, 30);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_partly);
}

/* From the fall of a stack on until it sleeps. */
static void snapshots_go_on(void **unused)
{
    (void)unused;
    skv_world *world = fixture_shaft(0.2f, true, 1, SKV_ISA_BEST);
    fixture_add_stack(world);
    for (int k = 0; k < 30 && skv_world_awake_count(world) > 0; k++)
        fixture_expect_goes_on(world, 31);
    wait_for_rest(world);
    throw_a_brick(world);
    for (int k = 0; k < 4; k++)
        fixture_expect_goes_on(world, 9);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stacks_fall_asleep),   cmocka_unit_test(what_floats_falls_asleep),
        cmocka_unit_test(bodies_wake),          cmocka_unit_test(digging_wakes),
        cmocka_unit_test(water_wakes),          cmocka_unit_test(what_falls_is_awake),
        cmocka_unit_test(what_swings_is_awake), cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(snapshots_go_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
