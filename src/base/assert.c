/* The replaceable assert handler. Invariant: without a handler of its own a program says what is
 * wrong, and aborts. */
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
    if (current) {
        current(condition, file, line, current_user);
        return;
    }
    char text[512];
    size_t length = skv_format(text, sizeof text,
                               "skvalp: %.200s:%d: a caller's mistake; what should hold: %.200s\n",
                               file, line, condition);
    skv_platform_abort(text, length);
}
