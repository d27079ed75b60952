/* Same input, same bits: over threads, over restarts, over cuts of the time; and no allocation in a
 * warm step. */
#include "support/fixture.h"
#include "support/host.h"
#include "support/long.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { FRAMES = 30 };

/* The reference solver takes ten times as long. */
static float spacing_of(skv_solver_kind solver)
{
    return solver == SKV_SOLVER_REFERENCE ? 0.02f : 0.014f;
}

static void stir(skv_world *world, int frame)
{
    skv_hand hand = skv_default_hand();
    hand.x = 0.3f + 0.01f * (float)frame;
    hand.y = 0.4f;
    hand.vx = 0.6f;
    assert_int_equal(skv_world_set_hands(world, &hand, frame % 20 < 12, NULL), SKV_OK);
    assert_int_equal(skv_world_set_gravity(world, frame > 20 ? 5.0f : 0, -9.81f, NULL), SKV_OK);
}

static uint64_t stirred_hash_of(const skv_world_def *def)
{
    skv_world *world = fixture_dam_of(def);
    for (int f = 0; f < FRAMES; f++) {
        stir(world, f);
        fixture_run(world, 1);
    }
    uint64_t hash = skv_world_hash(world);
    skv_world_destroy(world);
    return hash;
}

static uint64_t stirred_hash(skv_law law, skv_solver_kind solver, int threads)
{
    /* With viscosity, so that no pass is left out. */
    skv_world_def def = fixture_def(law, solver, 1, spacing_of(solver), threads);
    return stirred_hash_of(&def);
}

static void threads_and_restarts_give_the_same_hash(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
            uint64_t once = stirred_hash((skv_law)law, (skv_solver_kind)solver, 1);
            const int threads[] = {3, 7, 1, 2};
            for (int t = 0; t < (long_tests() ? 4 : 2); t++)
                assert_int_equal(stirred_hash((skv_law)law, (skv_solver_kind)solver, threads[t]),
                                 once);
        }
    }
}

/* A host with another number of threads free each time: none to four. */

static void lend(void *user, int count, void (*member)(void *team), void *team)
{
    int *call = user, threads = ++*call % 5;
    assert_true(threads <= count);
    host_run(threads, member, team);
}

static void a_hosts_threads_give_the_same_hash(void **unused)
{
    (void)unused;
    int calls = 0;
    skv_world_def def =
        fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 1, 0.014f, SKV_MAX_THREADS);
    def.tasks = (skv_task_system){4, lend, &calls};
    uint64_t once = stirred_hash(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 1);
    assert_int_equal(stirred_hash_of(&def), once);
    assert_true(calls >= FRAMES);
}

/* Every instruction set that this machine has gives the same bits. */
static void instruction_sets_give_the_same_hash(void **unused)
{
    (void)unused;
    for (int law = SKV_LAW_CALIBRATED; law <= SKV_LAW_CLAVET; law++) {
        uint64_t best = stirred_hash((skv_law)law, SKV_SOLVER_FAST, 1);
        int sets = 0;
        for (int set = SKV_ISA_SCALAR; set <= SKV_ISA_WASM; set++) {
            skv_world_def def = fixture_def((skv_law)law, SKV_SOLVER_FAST, 1, 0.014f, 1);
            def.instruction_set = (skv_instruction_set)set;
            if (skv_instruction_set_name(def.instruction_set)) {
                assert_int_equal(stirred_hash_of(&def), best);
                sets++;
                continue;
            }
            skv_world *world;
            skv_error error;
            assert_int_equal(skv_world_create(&def, &world, &error), SKV_ERROR_VALUE);
            assert_null(world);
            assert_non_null(strstr(error.text, skv_instruction_set_name(SKV_ISA_BEST)));
        }
        assert_true(sets >= 1 && sets < SKV_ISA_WASM);
    }
    assert_string_equal(skv_instruction_set_name(SKV_ISA_SCALAR), "scalar");
}

static void the_hash_sees_every_particle(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    uint64_t before = skv_world_hash(world);
    int last = skv_world_particle_count(world) - 1;
    assert_int_equal(skv_world_add_velocity(world, last, 1, 0, 1e-6f, NULL), SKV_OK);
    assert_true(skv_world_hash(world) != before);
    skv_world_destroy(world);
}

static void looking_at_a_world_does_not_change_it(void **unused)
{
    (void)unused;
    skv_world *watched = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 2);
    skv_world *alone = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 2);
    int found[10];
    for (int f = 0; f < 20; f++) {
        fixture_run(watched, 1);
        fixture_run(alone, 1);
        skv_world_stats(watched);
        skv_world_profile(watched, f % 2);
        skv_area circle = skv_circle(0.2f, 0.2f, 0.1f);
        skv_world_query(watched, &circle, found, 10);
    }
    assert_int_equal(skv_world_hash(watched), skv_world_hash(alone));
    skv_world_destroy(watched);
    skv_world_destroy(alone);
}

static int allocations;

static void *count_allocate(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    allocations++;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void count_release(void *memory, void *user)
{
    (void)user;
    free(memory);
}

static void a_warm_step_does_not_allocate(void **unused)
{
    (void)unused;
    const skv_allocator hooks = {count_allocate, count_release, NULL};
    skv_set_allocator(&hooks);
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.014f, 2);
    assert_true(allocations > 0);
    fixture_run(world, 1);
    allocations = 0;
    for (int f = 0; f < FRAMES; f++) {
        stir(world, f);
        fixture_run(world, 1);
    }
    assert_int_equal(allocations, 0);
    skv_world_destroy(world);
    skv_set_allocator(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_and_restarts_give_the_same_hash),
        cmocka_unit_test(a_hosts_threads_give_the_same_hash),
        cmocka_unit_test(instruction_sets_give_the_same_hash),
        cmocka_unit_test(the_hash_sees_every_particle),
        cmocka_unit_test(looking_at_a_world_does_not_change_it),
        cmocka_unit_test(a_warm_step_does_not_allocate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
