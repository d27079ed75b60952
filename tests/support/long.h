/* How much of itself a test runs: whether the long forms are asked for (CONTRIBUTING.md says which
 * there are), and what is left to builds without a sanitizer. */
#ifndef SKV_TEST_LONG_H
#define SKV_TEST_LONG_H

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static inline bool long_tests(void)
{
    const char *wish = getenv("SKV_LONG_TESTS");
    return wish && strcmp(wish, "1") == 0;
}

/* Of many inputs, frames or places that go through the same lines, a sanitizer sees one of so many:
 * it notices what a line does, which it makes ten times slower, and the other builds go over all.
 * A prime, or it would always meet the same byte of numbers that lie side by side. */
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
enum { ONE_OF = 7 };
#else
enum { ONE_OF = 1 };
#endif

#endif
