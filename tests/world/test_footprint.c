/* What a world holds for its particles, beside the limits that it is built for; and that the parts
 * it names are all of it. */
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { PARTICLES = 100000 };

/* Bytes that are allocated now; each block carries its size before itself. */
static size_t held;

static void *allocate(size_t bytes, size_t alignment, void *user)
{
    (void)user;
    size_t *block = aligned_alloc(alignment, (bytes + 2 * alignment - 1) / alignment * alignment);
    if (!block)
        return NULL;
    block[0] = bytes;
    held += bytes;
    return (char *)block + alignment;
}

static void release(void *memory, void *user)
{
    (void)user;
    size_t *block = (size_t *)(void *)((char *)memory - 64);
    held -= block[0];
    free(block);
}

static size_t all_of(const skv_memory *memory)
{
    return memory->particles + memory->kept + memory->grid + memory->histograms;
}

/* The pool of the bench, half of the tank, after its first frame. */
static void check(skv_law law, int threads)
{
    skv_world_def def = fixture_def(law, SKV_SOLVER_FAST, 0, 0.00268f, threads);
    def.sleep = true;
    def.substeps = 2;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_memory empty = skv_world_memory(world);
    size_t before = held;
    skv_fill_def fill = skv_default_fill_def();
    fill.y1 = 0.45f;
    fill.limit = PARTICLES;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    double count = skv_world_particle_count(world);
    assert_true(count > 0.98 * PARTICLES);
    fixture_run(world, 1);
    skv_memory memory = skv_world_memory(world);
    assert_true((double)memory.particles <= 128 * count);
    assert_true(memory.kept > 0 && memory.kept <= (size_t)threads * 8000000);
    assert_true((double)memory.grid <= 6 * count);
    assert_true((double)memory.histograms <= 6 * count * threads);
    /* A few hundred bytes a thread are no part of it. */
    size_t grown = held - before, named = all_of(&memory) - all_of(&empty);
    assert_true(grown >= named && grown < named + 1024 * (size_t)threads);
    skv_world_destroy(world);
}

static void memory_keeps_to_its_limits(void **unused)
{
    (void)unused;
    const skv_allocator counting = {allocate, release, NULL};
    skv_set_allocator(&counting);
    check(SKV_LAW_CALIBRATED, 1);
    check(SKV_LAW_CALIBRATED, 16);
    check(SKV_LAW_CLAVET, 16);
    skv_set_allocator(NULL);
    assert_int_equal(held, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_keeps_to_its_limits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
