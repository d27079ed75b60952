/* Key frames that are dropped: of the last half minute evenly, of what is older the more. */
#include "session/history.h"
#include "support/fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { EVERY = 30, KEYS = 301, KEPT = 60 };

static int64_t gap_after(const skv_history *history, int i)
{
    return history->list[i + 1].position.frame - history->list[i].position.frame;
}

static void the_older_the_wider_apart(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.1f, 1);
    fixture_fill(world, 0.2f, 0.2f, 0.4f, 0.4f);
    skv_history history = {0};
    for (int i = 0; i < KEYS; i++)
        assert_int_equal(
            skv_history_add(&history, world, (skv_position){.frame = (int64_t)i * EVERY}, NULL),
            SKV_OK);
    size_t each = history.bytes / KEYS;
    while (history.count > KEPT)
        assert_true(skv_history_thin(&history));
    assert_int_equal(history.bytes, KEPT * each);
    /* The first and the last always stay. */
    assert_int_equal(history.list[0].position.frame, 0);
    assert_int_equal(history.list[KEPT - 1].position.frame, (KEYS - 1) * EVERY);
    /* 150 s: at their beginning six times as wide apart as at the end, (9000 + 1800) / 1800. */
    double first = 0, last = 0;
    for (int i = 0; i < 4; i++) {
        first += (double)gap_after(&history, i) / 4;
        last += (double)gap_after(&history, KEPT - 2 - i) / 4;
    }
    assert_near(first / last, 6, 2);
    skv_history_free(&history);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_older_the_wider_apart)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
