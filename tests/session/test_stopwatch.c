/* The stopwatch: start, laps and stop in the world's time, and what becomes of them when that goes
 * back, on, or another way. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <skvalp/stopwatch.h>

static void expect(const skv_stopwatch *watch, int64_t moment, bool running, int64_t frames,
                   int laps, int64_t lap)
{
    skv_stopwatch_reading is = skv_stopwatch_read(watch, moment);
    if (is.running != running || is.frames != frames || is.laps != laps || is.lap != lap)
        fail_msg("at %d: %s, %d frames, %d laps, %d", (int)moment, is.running ? "runs" : "stands",
                 (int)is.frames, is.laps, (int)is.lap);
}

static void test_start_laps_stop(void **state)
{
    (void)state;
    skv_stopwatch watch = {0};
    expect(&watch, 5, false, 0, 0, 0);
    skv_stopwatch_press(&watch, 5, true); /* a lap of nothing */
    skv_stopwatch_press(&watch, 10, false);
    expect(&watch, 10, true, 0, 0, 0);
    skv_stopwatch_press(&watch, 40, true);
    skv_stopwatch_press(&watch, 60, true);
    expect(&watch, 70, true, 60, 2, 20);
    skv_stopwatch_press(&watch, 100, false);
    expect(&watch, 500, false, 90, 2, 20);
    skv_stopwatch_press(&watch, 600, false); /* from 0 */
    expect(&watch, 610, true, 10, 0, 0);
}

/* Every moment shows what it showed; what is cut off was never pressed. */
static void test_it_goes_back(void **state)
{
    (void)state;
    skv_stopwatch watch = {0};
    skv_stopwatch_press(&watch, 10, false);
    skv_stopwatch_press(&watch, 40, true);
    skv_stopwatch_press(&watch, 100, false);
    expect(&watch, 9, false, 0, 0, 0);
    expect(&watch, 39, true, 29, 0, 0);
    expect(&watch, 50, true, 40, 1, 30);
    expect(&watch, 100, false, 90, 1, 30);
    skv_stopwatch_cut(&watch, 100);
    expect(&watch, 200, false, 90, 1, 30);
    skv_stopwatch_cut(&watch, 50);
    expect(&watch, 200, true, 190, 1, 30);
    skv_stopwatch_press(&watch, 30, false); /* in the past: stops it there */
    expect(&watch, 200, false, 20, 0, 0);
    skv_stopwatch_cut(&watch, 0);
    expect(&watch, 200, false, 0, 0, 0);
}

static void test_many_presses(void **state)
{
    (void)state;
    skv_stopwatch watch = {0};
    skv_stopwatch_press(&watch, 7, false);
    for (int i = 1; i <= 5 * SKV_MOST_PRESSES; i++)
        skv_stopwatch_press(&watch, 7 + i, true);
    skv_stopwatch_reading is = skv_stopwatch_read(&watch, 1000);
    assert_true(is.running && is.frames == 993 && is.laps > 0);
    for (int i = 0; i < 5 * SKV_MOST_PRESSES; i++)
        skv_stopwatch_press(&watch, 1000 + i, false);
    assert_in_range(watch.count, 1, SKV_MOST_PRESSES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_start_laps_stop),
        cmocka_unit_test(test_it_goes_back),
        cmocka_unit_test(test_many_presses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
