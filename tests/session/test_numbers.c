/* Numbers as people read and type them: signs, groups, rounding, and that what was written is read
 * back, in every language. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/numbers.h>

#define SPACE "\u00a0"
#define MINUS "\u2212"
#define DASH  "\u2013"

static const skv_numerals *sv(void)
{
    return skv_numerals_of("sv");
}

static void test_languages(void **state)
{
    (void)state;
    assert_string_equal(skv_numerals_at(0)->language, "en");
    assert_null(skv_numerals_at(-1));
    int count = 0;
    while (skv_numerals_at(count))
        count++;
    assert_true(count >= 2);
    static const char *const swedish[] = {"sv", "sv_SE", "sv-SE", "sv_SE.UTF-8", "sv@x"};
    for (size_t i = 0; i < sizeof swedish / sizeof *swedish; i++)
        assert_string_equal(skv_numerals_of(swedish[i])->decimal, ",");
    static const char *const english[] = {"en", "en_GB", "C", "", "s", "svx", "xx"};
    for (size_t i = 0; i < sizeof english / sizeof *english; i++)
        assert_string_equal(skv_numerals_of(english[i])->decimal, ".");
    assert_ptr_equal(skv_numerals_of(NULL), skv_numerals_at(0));
}

static void test_decimals(void **state)
{
    (void)state;
    static const struct {
        double value;
        int decimals;
        const char *english, *swedish;
    } cases[] = {
        {0, 0, "0", "0"},
        {19.3, 1, "19.3", "19,3"},
        {-9.81, 2, MINUS "9.81", MINUS "9,81"},
        {-0.004, 2, "0.00", "0,00"},
        {-0.005, 2, MINUS "0.01", MINUS "0,01"},
        {999, 0, "999", "999"},
        {1200, 0, "1" SPACE "200", "1" SPACE "200"},
        {12960, 0, "12" SPACE "960", "12" SPACE "960"},
        {-1234567.891, 2, MINUS "1" SPACE "234" SPACE "567.89",
         MINUS "1" SPACE "234" SPACE "567,89"},
        {999.95, 1, "1" SPACE "000.0", "1" SPACE "000,0"},
        {0.25, 1, "0.3", "0,3"}, /* a half: away from 0, as browsers round */
        {2.5, 0, "3", "3"},
        {-0.125, 2, MINUS "0.13", MINUS "0,13"},
        {1e-6, 9, "0.000001000", "0,000001000"},
        {(double)NAN, 1, DASH, DASH},
        {(double)-INFINITY, 1, DASH, DASH},
        {1e15, 0, DASH, DASH},
        {1e30, 9, DASH, DASH},
        {-999999999999999, 9, MINUS "999" SPACE "999" SPACE "999" SPACE "999" SPACE "999.000000000",
         MINUS "999" SPACE "999" SPACE "999" SPACE "999" SPACE "999,000000000"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_string_equal(skv_number(cases[i].value, cases[i].decimals, NULL).text,
                            cases[i].english);
        assert_string_equal(skv_number(cases[i].value, cases[i].decimals, sv()).text,
                            cases[i].swedish);
    }
}

static void test_significant_digits(void **state)
{
    (void)state;
    static const struct {
        double value;
        int digits;
        const char *swedish;
    } cases[] = {
        {0, 4, "0"},
        {0.4321, 2, "0,43"},
        {0.1, 2, "0,1"},
        {0.001, 4, "0,001"},
        {1e-6, 4, "0,000001"},
        {-24525.25, 4, MINUS "24" SPACE "525"}, /* no whole digit goes */
        {9.81, 4, "9,81"},
        {9.9996, 4, "10"},
        {1000, 4, "1" SPACE "000"},
        {120, 1, "120"},
        {1e-12, 4, "0"},
        {(double)NAN, 4, DASH},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_string_equal(skv_number_short(cases[i].value, cases[i].digits, sv()).text,
                            cases[i].swedish);
}

static void test_readings(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *si;
        bool plain;
        const char *number, *unit;
    } cases[] = {
        {2403.45, "Pa m", true, "24,5", "cm of water"},
        {2403.45, "Pa m", false, "2" SPACE "403", "Pa m"},
        {1.204, "m/s", true, "1,20", "m/s"},
        {-0.001, "m/s", true, "0,00", "m/s"},
        {0.314, "m", true, "31,4", "cm"},
        {0.314, "m", false, "0,314", "m"},
        {(double)NAN, "m", true, DASH, "cm"},
        {12, "1/s", true, "12", "1/s"},
        {0.5, "m/s^2", true, "0,5", "m/s²"},
        {0.5, "m^2/s", false, "0,5", "m²/s"},
        {0.5, "m^2", true, "0,5", "m²"},
        {0.5, "", true, "0,5", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_unit unit = skv_unit_of(cases[i].si, cases[i].plain);
        assert_string_equal(unit.name, cases[i].unit);
        assert_string_equal(skv_number_in(cases[i].value, unit, sv()).text, cases[i].number);
    }
}

static void expect_read(const char *typed, const skv_numerals *numerals, const char *wanted)
{
    char plain[64];
    skv_number_read(typed, numerals, plain, sizeof plain);
    assert_string_equal(plain, wanted);
}

static void test_typing(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"9,81", "9.81"},
        {"9.81", "9.81"},
        {MINUS "9,81", "-9.81"},
        {"-9,81", "-9.81"},
        {" 1 200 ", "1200"},
        {"1" SPACE "200,5", "1200.5"},
        {"1\u202f200", "1200"},
        {"0,000001", "0.000001"},
        {"1e-3", "1e-3"},
        {"1,2,3", "1,2,3"},
        {"honey", "honey"},
        {"12 honeys", "12 honeys"},
        {"", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_read(cases[i][0], sv(), cases[i][1]);
    expect_read("1,200", sv(), "1.200");
    expect_read("1,200", NULL, "1,200"); /* a thousand and more, or one and a fifth? */
    expect_read("1,25", NULL, "1.25");
    char longer[100];
    memset(longer, '1', sizeof longer - 1);
    longer[sizeof longer - 1] = '\0';
    char plain[100];
    skv_number_read(longer, NULL, plain, sizeof plain);
    assert_string_equal(plain, longer);
    skv_number_read("1,5", sv(), plain, 2);
    assert_string_equal(plain, "1");
}

static void test_fields(void **state)
{
    (void)state;
    assert_string_equal(skv_number_shown("1e-06", sv()).text, "0,000001");
    assert_string_equal(skv_number_shown("-9.81", sv()).text, MINUS "9,81");
    assert_string_equal(skv_number_shown("1200", NULL).text, "1" SPACE "200");
    assert_string_equal(skv_number_shown("honey", sv()).text, "honey");
}

static void test_what_was_written_is_read(void **state)
{
    (void)state;
    unsigned random = 1;
    for (int i = 0; i < 20000; i++) {
        random = random * 1664525 + 1013904223;
        double value = ldexp((double)random - 2147483648.0, (int)(random >> 3 & 31) - 40);
        const skv_numerals *numerals = skv_numerals_at(i % 2);
        char plain[64];
        skv_digits text = skv_number(value, i % 10, numerals);
        skv_number_read(text.text, numerals, plain, sizeof plain);
        assert_true(fabs(strtod(plain, NULL) - value) <=
                    0.5000001 * pow(10, -(i % 10)) + 1e-9 * fabs(value));
        text = skv_number_short(value, 9, numerals);
        skv_number_read(text.text, numerals, plain, sizeof plain);
        assert_true(fabs(strtod(plain, NULL) - value) <= 1e-8 * fabs(value) + 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_languages),
        cmocka_unit_test(test_decimals),
        cmocka_unit_test(test_significant_digits),
        cmocka_unit_test(test_typing),
        cmocka_unit_test(test_fields),
        cmocka_unit_test(test_readings),
        cmocka_unit_test(test_what_was_written_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
