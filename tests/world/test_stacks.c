/* What lies on each other: that a stack comes to rest, in air and under water, and goes on from a
 * snapshot with what its contacts bear, and from an older one without; the same bits on any
 * threads; that nothing is left of a contact which has ended. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define EARTH 9.81

enum { BRICKS = FIXTURE_BRICKS };

static skv_world *make_stack(float depth, int threads, skv_instruction_set set)
{
    skv_world *world = fixture_shaft(depth, false, threads, set);
    fixture_add_stack(world);
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

/* Where a snapshot of a dry world without terrain says what contacts bear: at its end, but for the
 * two numbers of a world without particles. Returns where, and how many in `count`. */
static size_t find_touches(const fixture_saved *state, int *count)
{
    enum { TAIL = 8, TOUCH = 26 };
    for (*count = 1; TAIL + 4 + (size_t)*count * TOUCH < state->size; ++*count) {
        size_t at = state->size - TAIL - 4 - (size_t)*count * TOUCH;
        const uint8_t *b = state->bytes + at;
        if (b[0] + 256 * b[1] == *count && b[2] == 0 && b[3] == 0)
            return at;
    }
    fail_msg("no contacts are found in the snapshot");
    return 0;
}

/* Makes of a snapshot one of before contacts were kept. */
static void age(fixture_saved *state)
{
    enum { FLAGS = 12, SIZE = 16, WITH_TOUCHES = 64 /* of the second byte */ };
    int count;
    size_t at = find_touches(state, &count), less = 4 + 26 * (size_t)count;
    assert_true(state->bytes[FLAGS + 1] & WITH_TOUCHES);
    state->bytes[FLAGS + 1] &= (uint8_t)~WITH_TOUCHES;
    memmove(state->bytes + at, state->bytes + at + less, state->size - at - less);
    state->size -= less;
    for (int i = 0; i < 8; i++)
        state->bytes[SIZE + i] = (uint8_t)((uint64_t)state->size >> (8 * i));
    fixture_seal(*state);
}

/* Older snapshots say nothing of contacts: these begin with none, and bear the stack. */
static void older_snapshots_go_on(void **unused)
{
    (void)unused;
    skv_world *world = make_stack(0, 1, SKV_ISA_BEST);
    fixture_run(world, 300);
    fixture_saved state = fixture_save(world, false);
    uint64_t hash = skv_world_hash(world);
    age(&state);
    skv_error error = {0};
    if (skv_world_restore(world, state.bytes, state.size, &error) != SKV_OK)
        fail_msg("%s", error.text);
    assert_true(skv_world_hash(world) != hash); /* of which they are a part */
    fixture_run(world, 300);
    for (int i = 0; i < BRICKS; i++) {
        skv_body b;
        assert_true(skv_world_body_at(world, i, &b));
        assert_near((double)b.y, 0.05 + 0.1 * i, 0.001);
        assert_near(hypot((double)b.vx, (double)b.vy), 0, 1e-4);
    }
    free(state.bytes);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stacks_lie_still),
        cmocka_unit_test(bits_are_the_same),
        cmocka_unit_test(contacts_end),
        cmocka_unit_test(older_snapshots_go_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
