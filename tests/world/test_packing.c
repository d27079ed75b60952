/* How a fluid is packed, what asking costs, and that asking for plain statistics costs nothing. */
#include "support/failing_memory.h"
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* On the hexagonal lattice with one particle per spacing^2, 6 + 6 + 6 + 12 others lie within the
 * three spacings of h; fewer at walls and at the surface, where one in twenty lies. */
static void a_lattice_is_packed_as_it_was_laid(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.0155f, 1);
    skv_packing empty = fixture_packing(world);
    assert_true(empty.neighbours == 0 && empty.volume_ratio == 1);
    fixture_fill(world, 0, 0, 1.6f, 0.8f);
    skv_packing packing = fixture_packing(world);
    assert_near(packing.neighbours, 29, 1);
    assert_near(packing.volume_ratio, 1, 0.01);
    skv_world_destroy(world);
}

static void statistics_take_no_memory_and_packing_says_if_it_has_none(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.02f, 1);
    failing_memory memory;
    failing_memory_start(&memory, -1);
    assert_true(skv_world_stats(world).particles > 0);
    assert_int_equal(memory.calls, 0);
    fixture_packing(world);
    int calls = memory.calls;
    assert_true(calls > 0);
    for (int fail_at = 0; fail_at < calls; fail_at++) {
        failing_memory_start(&memory, fail_at);
        skv_packing packing;
        skv_error error = {0};
        assert_int_equal(skv_world_packing(world, &packing, &error), SKV_ERROR_MEMORY);
        assert_true(error.text[0]);
        assert_int_equal(memory.live, 0);
    }
    failing_memory_stop();
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lattice_is_packed_as_it_was_laid),
        cmocka_unit_test(statistics_take_no_memory_and_packing_says_if_it_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
