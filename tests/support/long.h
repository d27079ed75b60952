/* Whether the long forms of the tests are asked for: CONTRIBUTING.md says which there are. */
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

#endif
