/* Numbers for people. Invariant: whatever is written here is read back (skv_number_read) as the
 * number that was rounded. web/page/ui/numbers.ts does the same in the page's own thread. */
#include "skvalp/numbers.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/unit.h"

#define NO_BREAK_SPACE "\u00a0"
#define MINUS          "\u2212"
#define MOST_DECIMALS  9
#define TOO_LARGE      1e15 /* doubles have no more than 15 sure digits */

static const skv_numerals numerals_table[] = {
    {"en", ".", NO_BREAK_SPACE, MINUS},
    {"sv", ",", NO_BREAK_SPACE, MINUS},
};
#define LANGUAGES ((int)(sizeof numerals_table / sizeof *numerals_table))

const skv_numerals *skv_numerals_at(int i)
{
    return i >= 0 && i < LANGUAGES ? &numerals_table[i] : NULL;
}

const skv_numerals *skv_numerals_of(const char *language)
{
    language = language ? language : "";
    size_t length = strcspn(language, "_-.@\n");
    for (int i = 0; i < LANGUAGES; i++) {
        const char *known = numerals_table[i].language;
        if (strlen(known) == length && memcmp(known, language, length) == 0)
            return &numerals_table[i];
    }
    return &numerals_table[0];
}

static void add(skv_digits *to, const char *text, size_t length)
{
    size_t used = strlen(to->text);
    SKV_ASSERT(used + length < sizeof to->text);
    memcpy(to->text + used, text, length);
    to->text[used + length] = '\0';
}

/* `plain` is unsigned: "1234.5". */
static skv_digits localise(const char *plain, bool negative, const skv_numerals *numerals)
{
    skv_digits number = {""};
    const skv_numerals *signs = numerals ? numerals : &numerals_table[0];
    size_t whole = strcspn(plain, ".");
    if (negative && plain[strspn(plain, "0.")])
        add(&number, signs->minus, strlen(signs->minus));
    for (size_t i = 0; i < whole; i++) {
        if (i > 0 && (whole - i) % 3 == 0)
            add(&number, signs->group, strlen(signs->group));
        add(&number, plain + i, 1);
    }
    if (plain[whole]) {
        add(&number, signs->decimal, strlen(signs->decimal));
        add(&number, plain + whole + 1, strlen(plain + whole + 1));
    }
    return number;
}

static skv_digits write(double value, int decimals, bool trimmed, const skv_numerals *numerals)
{
    char plain[32];
    double size = fabs(value), last = size; /* in units of the last decimal */
    if (!(size < TOO_LARGE))
        return (skv_digits){"\u2013"};
    for (int i = 0; i < decimals; i++)
        last *= 10;
    /* A half is made a little more: skv_format would round it to the even digit. */
    skv_format(plain, sizeof plain, "%.*f", decimals,
               last < TOO_LARGE ? nextafter(size, INFINITY) : size);
    size_t length = strlen(plain);
    while (trimmed && decimals > 0 && plain[length - 1] == '0')
        plain[--length] = '\0';
    if (plain[length - 1] == '.')
        plain[length - 1] = '\0';
    return localise(plain, value < 0, numerals);
}

skv_digits skv_number(double value, int decimals, const skv_numerals *numerals)
{
    SKV_ASSERT_OR(decimals >= 0 && decimals <= MOST_DECIMALS, (skv_digits){""});
    return write(value, decimals, false, numerals);
}

skv_digits skv_number_short(double value, int digits, const skv_numerals *numerals)
{
    SKV_ASSERT_OR(digits >= 1 && digits <= MOST_DECIMALS, (skv_digits){""});
    double size = fabs(value);
    int decimals = digits - 1;
    for (double power = 10; decimals > 0 && size >= power; power *= 10)
        decimals--;
    for (double power = 1; decimals < MOST_DECIMALS && size < power; power /= 10)
        decimals++;
    return write(value, decimals, true, numerals);
}

/* ---- Units ----------------------------------------------------------------------------------- */

static const struct {
    const char *si;
    skv_unit known;
} units[] = {
    {"Pa m", {"cm of water", 1000 * 9.81 / 100, 1}}, {"m", {"cm", 0.01, 1}}, {"m/s", {"m/s", 1, 2}},
    {"m^2/s", {"L/s per metre", 0.001, 2}},          {"s", {"s", 1, 2}},
};

skv_unit skv_unit_of(const char *si, bool plain)
{
    SKV_ASSERT_OR(si, ((skv_unit){"", 1, -1}));
    for (size_t i = 0; plain && i < sizeof units / sizeof *units; i++)
        if (strcmp(si, units[i].si) == 0)
            return units[i].known;
    skv_unit same = {"", 1, -1};
    skv_spell_unit(si, same.name, sizeof same.name);
    return same;
}

skv_digits skv_number_in(double value, skv_unit unit, const skv_numerals *numerals)
{
    return unit.decimals < 0 ? skv_number_short(value / unit.size, 4, numerals)
                             : skv_number(value / unit.size, unit.decimals, numerals);
}

/* ---- Typing ---------------------------------------------------------------------------------- */

/* The length of a sign at the beginning of a text, or 0. */
static size_t space_at(const char *text)
{
    static const char *const spaces[] = {" ", "\t", NO_BREAK_SPACE, "\u202f", "\u2009"};
    for (size_t i = 0; i < sizeof spaces / sizeof *spaces; i++)
        if (strncmp(text, spaces[i], strlen(spaces[i])) == 0)
            return strlen(spaces[i]);
    return 0;
}

/* "1,200" where decimals come after a point. */
static bool parts_thousands(const char *comma, const skv_numerals *signs)
{
    return signs->decimal[0] == '.' && strspn(comma + 1, "0123456789") == 3 && !comma[4];
}

void skv_number_read(const char *typed, const skv_numerals *numerals, char *plain, size_t size)
{
    SKV_ASSERT(typed && plain && size > 0);
    const skv_numerals *signs = numerals ? numerals : &numerals_table[0];
    char text[64];
    size_t used = 0;
    double value;
    for (const char *c = typed; *c && used < sizeof text - 1;) {
        if (strncmp(c, MINUS, strlen(MINUS)) == 0) {
            text[used++] = '-';
            c += strlen(MINUS);
        } else if (space_at(c)) {
            c += space_at(c);
        } else {
            text[used++] = *c == ',' && !parts_thousands(c, signs) ? '.' : *c;
            c++;
        }
    }
    text[used] = '\0';
    skv_format(plain, size, "%s", skv_parse_number(text, &value) ? text : typed);
}

skv_digits skv_number_shown(const char *plain, const skv_numerals *numerals)
{
    SKV_ASSERT_OR(plain, (skv_digits){""});
    double value;
    skv_digits same;
    skv_format(same.text, sizeof same.text, "%s", plain);
    return skv_parse_number(plain, &value) ? skv_number_short(value, MOST_DECIMALS, numerals)
                                           : same;
}
