/* Arrays that grow together: what is kept, what is zero, where they lie, and all or nothing. */
#include "base/arrays.h"
#include "base/memory.h"
#include "support/failing_memory.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

typedef struct pair {
    float *x;
    uint8_t *flag;
    void *block;
} pair;

static bool grow(pair *p, size_t room, size_t kept)
{
    const skv_array arrays[] = {SKV_ARRAY(p->x, room, kept), SKV_ARRAY(p->flag, room, kept)};
    return skv_arrays_grow(&p->block, arrays, 2);
}

static void growing_keeps_what_was_there(void **unused)
{
    (void)unused;
    pair p = {0};
    assert_true(grow(&p, 10, 0));
    for (int i = 0; i < 10; i++) {
        assert_true(p.x[i] == 0 && p.flag[i] == 0);
        p.x[i] = (float)i;
        p.flag[i] = (uint8_t)(200 + i);
    }
    assert_true(grow(&p, 5000, 7));
    for (int i = 0; i < 5000; i++) {
        assert_true(p.x[i] == (i < 7 ? (float)i : 0.0f));
        assert_int_equal(p.flag[i], i < 7 ? 200 + i : 0);
    }
    skv_free(p.block);
}

static void running_out_of_memory_changes_nothing(void **unused)
{
    (void)unused;
    pair p = {0};
    assert_true(grow(&p, 10, 0));
    p.x[3] = 5;
    const pair before = p;
    failing_memory memory;
    failing_memory_start(&memory, 0);
    assert_false(grow(&p, 100, 10));
    /* More than there are addresses, with and without overflow of a sum. */
    assert_false(grow(&p, SIZE_MAX / 2, 10));
    assert_false(grow(&p, SIZE_MAX / 8, 10));
    failing_memory_stop();
    assert_memory_equal(&p, &before, sizeof p);
    assert_true(p.x[3] == 5);
    skv_free(p.block);
}

/* Each on a cache line, and no two at the same place of a page. */
static void arrays_keep_out_of_each_others_way(void **unused)
{
    (void)unused;
    for (size_t room = 1; room < 5000; room += 511) {
        float *a[8];
        void *block = NULL;
        skv_array arrays[8];
        for (int i = 0; i < 8; i++)
            arrays[i] = (skv_array)SKV_ARRAY(a[i], room, 0);
        assert_true(skv_arrays_grow(&block, arrays, 8));
        assert_true(skv_arrays_bytes(arrays, 8) >= 8 * room * sizeof(float));
        for (int i = 0; i < 8; i++) {
            assert_int_equal((uintptr_t)a[i] % SKV_ALIGNMENT, 0);
            for (int j = 0; j < i; j++)
                assert_int_not_equal((uintptr_t)a[i] % 4096, (uintptr_t)a[j] % 4096);
        }
        skv_free(block);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(growing_keeps_what_was_there),
        cmocka_unit_test(running_out_of_memory_changes_nothing),
        cmocka_unit_test(arrays_keep_out_of_each_others_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
