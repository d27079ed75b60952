/* What lies on each other: that a stack comes to rest, in air and under water, and goes on from a
 * snapshot with what its contacts bear; the same bits on any threads; that nothing is left of a
 * contact which has ended. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#define EARTH 9.81

enum { BRICKS = 5 };

/* Bricks on each other in the middle of a tank 0.4 m wide that is filled to a depth. */
static skv_world *make_stack(float depth, int threads, skv_instruction_set set)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.025f, threads);
    skv_terrain_def terrain = skv_default_terrain_def();
    terrain.width = 160;
    terrain.height = 320;
    def.instruction_set = set;
    assert_int_equal(skv_terrain_create(&terrain, &def.terrain, NULL), SKV_OK);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    if (depth > 0)
        fixture_fill(world, 0, 0, 0.4f, depth);
    skv_body_def brick = skv_default_body_def();
    brick.density = 1900;
    brick.x = 0.2f;
    for (int i = 0; i < BRICKS; i++) {
        brick.y = 0.0502f + (float)i * 0.1002f;
        fixture_add_body(world, &brick);
    }
    return world;
}

/* From the tenth to the twelfth second a stack's mean speed is below 0.1 mm/s. */
static void stacks_lie_still(void **unused)
{
    (void)unused;
    static const float depths[] = {0, 0.7f};
    for (int k = 0; k < 2; k++) {
        skv_world *world = make_stack(depths[k], 1, SKV_ISA_BEST);
        fixture_run(world, 600);
        fixture_expect_goes_on(world, 2);
        double sum = 0;
        for (int frame = 0; frame < 120; frame++) {
            fixture_run(world, 1);
            for (int i = 0; i < BRICKS; i++) {
                skv_body b;
                assert_true(skv_world_body_at(world, i, &b));
                sum += hypot((double)b.vx, (double)b.vy) / (120 * BRICKS);
                assert_near((double)b.y, 0.05 + 0.1 * i, 0.001);
            }
        }
        if (!(sum < 1e-4))
            fail_msg("in %g m of water: %g m/s", (double)depths[k], sum);
        skv_world_destroy(world);
    }
}

static skv_world *run_stack(int threads, skv_instruction_set set)
{
    skv_world *world = make_stack(0.4f, threads, set);
    fixture_run(world, 60);
    return world;
}

static void bits_are_the_same(void **unused)
{
    (void)unused;
    fixture_expect_same_bits(run_stack);
}

/* Speed of the uppermost brick after a frame, put so much higher and stopped before. */
static double speed_from(skv_world *world, float higher)
{
    skv_body b;
    assert_true(skv_world_body_at(world, BRICKS - 1, &b));
    assert_int_equal(skv_world_set_body_pose(world, b.id, b.x, b.y + higher, b.angle, NULL),
                     SKV_OK);
    assert_int_equal(skv_world_set_body_velocity(world, b.id, 0, 0, 0, NULL), SKV_OK);
    fixture_run(world, 1);
    b = fixture_body(world, b.id);
    return hypot((double)b.vx, (double)b.vy);
}

/* What a contact bore pushes nothing that is no longer there: lifted off the others, a brick falls
 * as if it had never lain. */
static void contacts_end(void **unused)
{
    (void)unused;
    skv_world *world = make_stack(0, 1, SKV_ISA_BEST);
    fixture_run(world, 300);
    assert_near(speed_from(world, 0), 0, 1e-4);
    assert_near(speed_from(world, 0.1f), EARTH / 60, 1e-4);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stacks_lie_still),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(contacts_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
