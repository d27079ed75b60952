/* What a world holds for its particles, beside the limits that it is built for; and that the parts
 * it names are all of it. */
#include "support/fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { MOST_BYTES = 128 };

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

/* A world of half a tank, or of a block that breaks, that is about to take its first frame. */
typedef struct setup {
    skv_law law;
    bool viscous, sleeps, breaks;
    int particles, threads;
} setup;

static skv_memory memory_of(const setup *t)
{
    float area = t->breaks ? 0.32f : 0.72f;
    skv_world_def def = fixture_def(t->law, SKV_SOLVER_FAST, t->viscous ? 30 : 0,
                                    sqrtf(area / (float)t->particles), t->threads);
    def.sleep = t->sleeps;
    def.substeps = 2;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_memory empty = skv_world_memory(world);
    size_t before = held;
    skv_fill_def fill = skv_default_fill_def();
    fill.x1 = t->breaks ? 0.5333f : 1.6f;
    fill.y1 = t->breaks ? 0.6f : 0.45f;
    fill.limit = t->particles;
    assert_int_equal(skv_world_fill(world, &fill, NULL, NULL), SKV_OK);
    double count = skv_world_particle_count(world);
    assert_true(count > 0.98 * t->particles);
    fixture_run(world, 1);
    skv_memory memory = skv_world_memory(world);
    assert_true((double)memory.particles <= MOST_BYTES * count);
    assert_true(memory.kept > 0);
    /* A few hundred bytes a thread are no part of it. */
    size_t grown = held - before, named = all_of(&memory) - all_of(&empty);
    assert_true(grown >= named && grown < named + 1024 * (size_t)t->threads);
    skv_world_destroy(world);
    return memory;
}

static void every_kind_of_world_keeps_to_the_limit(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < 16; kind++) {
        const setup t = {.law = kind & 1 ? SKV_LAW_CALIBRATED : SKV_LAW_CLAVET,
                         .viscous = kind & 2,
                         .sleeps = kind & 4,
                         .breaks = kind & 8,
                         .particles = 20000,
                         .threads = 1};
        memory_of(&t);
    }
}

static void threads_keep_to_theirs(void **unused)
{
    (void)unused;
    for (int law = 0; law < 2; law++) {
        const setup t = {(skv_law)law, true, true, true, 100000, 16};
        skv_memory memory = memory_of(&t);
        assert_true(memory.kept <= (size_t)t.threads * 8000000);
        assert_true(memory.grid <= (size_t)(12 * t.particles));
        assert_true(memory.histograms <= (size_t)(12 * t.particles * t.threads));
    }
}

static int count_allocations(void **unused)
{
    (void)unused;
    const skv_allocator counting = {allocate, release, NULL};
    skv_set_allocator(&counting);
    return 0;
}

static int expect_none_left(void **unused)
{
    (void)unused;
    skv_set_allocator(NULL);
    return held == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_kind_of_world_keeps_to_the_limit),
                                       cmocka_unit_test(threads_keep_to_theirs)};
    return cmocka_run_group_tests(tests, count_allocations, expect_none_left);
}
