/* The library's own formatting and reading of numbers: those of a correct snprintf and strtod, in
 * any locale. */
#include "skvalp/base.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/comma_locale.h"

/* Formats with both and compares; called through the macro, so that the compiler checks as well. */
__attribute__((format(printf, 1, 2))) static void compare(const char *format, ...)
{
    char ours[2048], theirs[2048];
    va_list arguments;
    va_start(arguments, format);
    size_t length = skv_format_list(ours, sizeof ours, format, arguments);
    va_end(arguments);
    va_start(arguments, format);
    vsnprintf(theirs, sizeof theirs, format, arguments);
    va_end(arguments);
    if (strcmp(ours, theirs) || length != strlen(theirs))
        fail_msg("format %s gives %s instead of %s", format, ours, theirs);
}

static void integers_and_text(void **unused)
{
    (void)unused;
    const int numbers[] = {0, 1, -1, 9, 10, 255, -4096, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 9; i++) {
        int n = numbers[i];
        compare("%d %i %u %x %X %#x %c|", n, n, (unsigned)n, (unsigned)n, (unsigned)n, (unsigned)n,
                'a' + i);
        compare("%5d|%-7d|%07d|%+d|%.4d|%8.3d|%*d|%-*d|", n, n, n, n, n, n, i, n, i, n);
        compare("%lld %ld %zu %llx %hhx %hd %02x %#10x %lu", (long long)n * 2147483648, (long)n,
                (size_t)n, (unsigned long long)n, (unsigned char)n, (short)n, (unsigned)n,
                (unsigned)n, (unsigned long)n);
    }
    compare("%s and %10s, %-10s| %.3s %.*s 100%%", "one", "two", "three", "fourth", 2, "fifth");
    compare("%.3s", (const char[]){'a', 'b', 'c'});
    compare("%s", "");
    compare("no directive");
}

static void compare_double(double value)
{
    compare("%g %.0f %f %e %.3g %.9g %.17g", value, value, value, value, value, value, value);
    compare("%.1f %.2f %.3f %.20e %.0e %.1g %.0g %12.4g| %-12g| %012g %+g", value, value, value,
            value, value, value, value, value, value, value, value);
}

static void doubles_are_rounded_exactly(void **unused)
{
    (void)unused;
    const double special[] = {0,     -0.0,    1,      0.5,  1.5,    2.5,      0.125,   0.375,
                              1e-5,  1e-4,    9.5,    99.5, 999999, 999999.5, 0.1,     1e15,
                              1e16,  1e17,    1e22,   1e23, 5e-324, 2.3e-308, 1.7e308, 123456,
                              1e300, 1.00005, 0.0995, 0.05, 0.25,   0.75,     1e-300,  1234567};
    for (size_t i = 0; i < sizeof special / sizeof *special; i++) {
        compare_double(special[i]);
        compare_double(-special[i]);
    }
    compare("%g %f %e %5g| %05g|", INFINITY, -INFINITY, INFINITY, INFINITY, -INFINITY);
    uint64_t state = 1;
    for (int i = 0; i < 500; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        uint64_t bits = state ^ state >> 31;
        /* Half of them of everyday size. */
        if (i % 2)
            bits = (bits & ~(0x7ffull << 52)) | (uint64_t)(1003 + i % 40) << 52;
        double value;
        memcpy(&value, &bits, sizeof value);
        if (isfinite(value))
            compare_double(value);
    }
}

static void a_nan_is_a_nan(void **unused)
{
    (void)unused;
    skv_error error;
    skv_fail(&error, SKV_ERROR_VALUE, "%g", (double)NAN);
    assert_non_null(strstr(error.text, "nan"));
}

static void long_text_is_cut(void **unused)
{
    (void)unused;
    char text[9] = "........";
    assert_int_equal(skv_format(text, 8, "%s%d", "longer than eight", 1), 18);
    assert_string_equal(text, "longer ");
    assert_int_equal(text[8], 0);
    assert_int_equal(skv_format(text, 8, "%1000d", 1), 1000);
    assert_string_equal(text, "       ");
    skv_format(text, 8, "%-1000d", 1);
    assert_string_equal(text, "1      ");
    skv_format(text, 1, "%s", "no room");
    assert_string_equal(text, "");
    assert_int_equal(skv_format(NULL, 0, "%d", 123), 3);
}

/* What it does not know is shown, and nothing is read that may not be there. */
static void an_unknown_directive_is_copied(void **unused)
{
    (void)unused;
    const char *unknown[] = {"a%q%s", "a%", "a%5.2", "a%ll"};
    for (int i = 0; i < 4; i++) {
        skv_error error;
        /* Through a pointer, because the compiler rightly refuses such formats. */
        skv_result (*unchecked)(skv_error *, skv_result, const char *, ...) = skv_fail;
        unchecked(&error, SKV_ERROR_VALUE, unknown[i]);
        assert_string_equal(error.text, unknown[i]);
    }
}

/* ---- Reading --------------------------------------------------------------------------------- */

static void numbers_are_read_exactly(void **unused)
{
    (void)unused;
    const char *const texts[] = {
        "0",
        "-0",
        "1",
        "+3",
        "-2.5",
        "1e3",
        "1.25E-2",
        "0.1",
        "9007199254740993",
        "9007199254740992.999999999999999999999999999",
        "9007199254740993.00000000000000000000000000000001",
        "1.7976931348623157e308",
        "17976931348623157000000000000000000000000000000000000000e253",
        "2.2250738585072014e-308",
        "2.2250738585072011e-308",
        "4.9406564584124654e-324",
        "2.4703282292062328e-324",
        "2.4703282292062327e-324",
        "1e-400",
        "0.00000000000000000000000000000000000000000000000001e-270",
        "0e99999",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double value = 7;
        assert_true(skv_parse_number(texts[i], &value));
        if (value != strtod(texts[i], NULL))
            fail_msg("%s is read as %.17g", texts[i], value);
    }
    double zero;
    assert_true(skv_parse_number("-0", &zero) && signbit(zero));
    uint64_t state = 3;
    for (int i = 0; i < 20000; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        uint64_t bits = state ^ state >> 29;
        double value, read;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        char text[40];
        skv_format(text, sizeof text, i % 2 ? "%.17g" : "%.12g", value);
        assert_true(skv_parse_number(text, &read));
        if (read != strtod(text, NULL))
            fail_msg("%s is read as %.17g", text, read);
    }
}

static void what_is_no_number_is_refused(void **unused)
{
    (void)unused;
    const char *const texts[] = {
        "",
        ".5",
        "5.",
        "1,5",
        "0x10",
        "nan",
        "inf",
        "1e999",
        "1e310",
        "1 ",
        " 1",
        "1e",
        "--1",
        "+-1",
        "1.2.3",
        "1e+",
        "1.8e308",
        "-",
        "12345678901234567890123456789012345678901234567890123456789012345",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double value = 7;
        if (skv_parse_number(texts[i], &value) || value != 7)
            fail_msg("'%s' is taken for a number", texts[i]);
    }
}

static void the_locale_does_not_matter(void **unused)
{
    (void)unused;
    set_comma_locale();
    char text[8];
    skv_format(text, sizeof text, "%g", 0.5);
    assert_string_equal(text, "0.5");
    double value;
    assert_true(skv_parse_number("9.5", &value) && value == 9.5);
    assert_false(skv_parse_number("9,5", &value));
    reset_locale();
}

/* ---- Names ----------------------------------------------------------------------------------- */

static void the_nearest_name_is_found(void **unused)
{
    (void)unused;
    const char *const names[] = {"run", "check", "scenes", "bench"};
    assert_string_equal(skv_nearest_name("chekc", names, 4), "check");
    assert_string_equal(skv_nearest_name("scene", names, 4), "scenes");
    assert_string_equal(skv_nearest_name("be", names, 4), "bench");
    assert_null(skv_nearest_name("xyzzy", names, 4));
    assert_null(skv_nearest_name("", names, 4));
    char lengthy[300] = {0};
    memset(lengthy, 'r', sizeof lengthy - 1);
    assert_null(skv_nearest_name(lengthy, names, 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integers_and_text),
        cmocka_unit_test(doubles_are_rounded_exactly),
        cmocka_unit_test(a_nan_is_a_nan),
        cmocka_unit_test(long_text_is_cut),
        cmocka_unit_test(an_unknown_directive_is_copied),
        cmocka_unit_test(numbers_are_read_exactly),
        cmocka_unit_test(what_is_no_number_is_refused),
        cmocka_unit_test(the_locale_does_not_matter),
        cmocka_unit_test(the_nearest_name_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
