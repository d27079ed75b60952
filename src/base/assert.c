/* The replaceable assert handler. Invariant: without a handler of its own a program aborts. */
#include "base/assert.h"

#include "base/platform.h"
#include "skvalp/base.h"

static skv_assert_handler *current;
static void *current_user;

void skv_set_assert_handler(skv_assert_handler *handler, void *user)
{
    current = handler;
    current_user = user;
}

void skv_assert_failed(const char *condition, const char *file, int line)
{
    if (!current)
        skv_platform_abort();
    current(condition, file, line, current_user);
}
