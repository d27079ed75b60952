/* Springs in snapshots: a world that goes on from one gives the same bits, and springs that cannot
 * be are refused. */
#include "base/bytes.h"
#include "world/jelly.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void snapshots_keep_springs(void **unused)
{
    (void)unused;
    skv_world *world = jelly_medley(SKV_SOLVER_FAST, 1, SKV_ISA_BEST), *copy;
    fixture_run(world, 31);
    assert_int_equal(skv_world_copy(world, fixture_host(2), &copy, NULL), SKV_OK);
    assert_int_equal(skv_world_spring_count(copy), skv_world_spring_count(world));
    skv_world_destroy(copy);
    fixture_expect_goes_on(world, 30);
    skv_world_destroy(world);
}

/* A snapshot whose springs have been changed is refused, or is of springs that can be. */
static void springs_that_cannot_be_are_refused(void **unused)
{
    (void)unused;
    skv_world_def def = jelly_def(jelly_numbers, SKV_SOLVER_FAST, JELLY_SPACING);
    skv_world *world = jelly_block(&def, 0.3f);
    fixture_run(world, 2);
    fixture_saved b = fixture_save(world, false), bad = {malloc(b.size), b.size};
    uint8_t first[8];
    skv_writer w = {first, 0};
    skv_put(&w, (uint64_t)skv_world_spring_count(world), 4);
    skv_put(&w, 0, 4);
    size_t at = 0;
    while (memcmp(b.bytes + at, first, 8) != 0)
        at++;
    at += 4;
    static const struct {
        int spring, offset;
        uint32_t value;
    } sins[] = {
        {0, 4, 0},          /* from 0 to itself */
        {0, 4, 99999},      /* to nobody */
        {0, 0, 99999},      /* from nobody */
        {1, 4, 1},          /* twice to the same */
        {2, 0, 0x7f000000}, /* to a lower number */
        {0, 8, 0},          /* without length */
        {0, 8, 0x7fc00000}, /* of none that is a number */
        {0, 8, 0x40000000}, /* of 2 m */
    };
    for (size_t i = 0; i < sizeof sins / sizeof *sins; i++) {
        memcpy(bad.bytes, b.bytes, b.size);
        size_t place = at + 12 * (size_t)sins[i].spring + (size_t)sins[i].offset;
        skv_put(&(skv_writer){bad.bytes, place}, sins[i].value, 4);
        fixture_seal(bad);
        uint64_t hash = skv_world_hash(world);
        assert_int_equal(skv_world_restore(world, bad.bytes, bad.size, NULL), SKV_ERROR_VALUE);
        assert_true(skv_world_hash(world) == hash);
    }
    for (size_t size = 0; size < b.size; size += 97)
        assert_int_not_equal(skv_world_restore(world, b.bytes, size, NULL), SKV_OK);
    memcpy(bad.bytes, b.bytes, b.size);
    skv_put(&(skv_writer){bad.bytes, at - 4}, 0xffffffff, 4);
    fixture_seal(bad);
    assert_int_not_equal(skv_world_restore(world, bad.bytes, bad.size, NULL), SKV_OK);
    assert_int_equal(skv_world_restore(world, b.bytes, b.size, NULL), SKV_OK);
    free(b.bytes);
    free(bad.bytes);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snapshots_keep_springs),
        cmocka_unit_test(springs_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
