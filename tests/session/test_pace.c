/* Pace: which shortfall against real time is called one. */
#include "session/pace.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define FRAME (1.0 / 60)
/* Frames that are stepped at once, at most; a longer stall loses the rest. */
enum { AT_ONCE = 12 };

/* The factor after three pictures, of which one came so many frames too late. */
static double factor_after_losing(int lost)
{
    skv_pace pace = skv_pace_start();
    const int frames[] = {AT_ONCE, AT_ONCE + lost, AT_ONCE};
    for (int i = 0; i < 3; i++)
        assert_int_equal(skv_pace_pass(&pace, frames[i] * FRAME, 1), AT_ONCE);
    return pace.factor;
}

static void a_frame_lost_now_and_then_is_no_lack(void **unused)
{
    (void)unused;
    assert_float_equal(factor_after_losing(0), 1, 0);
    assert_float_equal(factor_after_losing(1), 1, 0);
}

static void more_frames_lost_are(void **unused)
{
    (void)unused;
    assert_float_equal(factor_after_losing(2), 36.0 / 38, 1e-9);
    assert_float_equal(factor_after_losing(3), 36.0 / 39, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_lost_now_and_then_is_no_lack),
        cmocka_unit_test(more_frames_lost_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
