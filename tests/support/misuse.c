/* Counts what the library asserts. Invariant: each report says what and where. */
#include "support/misuse.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "skvalp/base.h"

int misuses;

static void count(const char *condition, const char *file, int line, void *user)
{
    (void)user;
    assert_true(condition && file && line > 0);
    misuses++;
}

int misuse_begin(void **unused)
{
    (void)unused;
    misuses = 0;
    skv_set_assert_handler(count, NULL);
    return 0;
}

int misuse_end(void **unused)
{
    (void)unused;
    skv_set_assert_handler(NULL, NULL);
    return 0;
}
