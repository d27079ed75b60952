/* The lab's options as other languages and older programs have them. */
#include "support/misuse.h"

#include <skvalp/experiments.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Options as a program has them that knows only the settings; and as one has them that knows none.
 */
static void options_are_initialised(void **unused)
{
    (void)unused;
    skv_setting wrong = {"gravty", "3"};
    skv_lab_options known;
    skv_lab_options_init(&known, offsetof(skv_lab_options, setting_count) + sizeof(int));
    known.settings = &wrong;
    known.setting_count = 1;
    assert_int_equal(skv_lab_check(&known, NULL), SKV_ERROR_VALUE);
    static const skv_lab_options none;
    misuse_begin(NULL);
    assert_int_equal(skv_lab_check(&none, NULL), SKV_ERROR_VALUE);
    misuse_end(NULL);
    assert_int_equal(misuses, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(options_are_initialised),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
