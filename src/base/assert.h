/* SKV_ASSERT_OR: a caller's mistake. Reports to the handler of skv_set_assert_handler; if that
 * returns, the surrounding function returns `value`. Always on: the checks guard API boundaries
 * and cost nothing beside the work. */
#ifndef SKV_BASE_ASSERT_H
#define SKV_BASE_ASSERT_H

void skv_assert_failed(const char *condition, const char *file, int line);

/* SKV_ASSERT_TRAPS: for programs that have no handler, and no room for texts that nobody reads. */
#ifdef SKV_ASSERT_TRAPS
#define SKV_ASSERT_FAILED(condition) __builtin_trap()
#else
#define SKV_ASSERT_FAILED(condition) skv_assert_failed(condition, __FILE__, __LINE__)
#endif

#define SKV_ASSERT_OR(condition, ...)                                                              \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            SKV_ASSERT_FAILED(#condition);                                                         \
            return __VA_ARGS__;                                                                    \
        }                                                                                          \
    } while (0)

/* The same in a function that returns nothing. */
#define SKV_ASSERT(condition) SKV_ASSERT_OR(condition, )

#endif
