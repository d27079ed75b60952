/* Plain text: what a terminal or a message must not get is found, and replaced, whatever it is. */
#include "base/plain.h"
#include "skvalp/base.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define CONTROL "holds a control character"
#define BROKEN  "is not UTF-8"

static const struct {
    const char *text, *plain, *complaint;
} cases[] = {
    {"", "", NULL},
    {"Dam break", "Dam break", NULL},
    {"sm\xc3\xb6rg\xc3\xa5s, \xe6\xb0\xb4, \xf0\x9f\x8c\x8a",
     "sm\xc3\xb6rg\xc3\xa5s, \xe6\xb0\xb4, \xf0\x9f\x8c\x8a", NULL},
    {"\xd7\x9e\xd7\x99\xd7\x9d", "\xd7\x9e\xd7\x99\xd7\x9d", NULL}, /* Hebrew turns by itself */
    {"a\xc2\xa0z", "a\xc2\xa0z", NULL},                             /* a no-break space */
    {"a\nz", "a?z", CONTROL},
    {"a\x1b[2Jz", "a?[2Jz", CONTROL},
    {"a\x7fz", "a?z", CONTROL},
    {"a\xc2\x80z", "a?z", CONTROL}, /* U+0080, the first of C1 */
    {"a\xc2\x9b"
     "2Jz",
     "a?2Jz", CONTROL},                         /* U+009B: what ESC [ is */
    {"a\xc2\x9fz", "a?z", CONTROL},             /* U+009F, the last */
    {"a\xd8\x9cz", "a?z", CONTROL},             /* U+061C */
    {"a\xe2\x80\x8ez", "a?z", CONTROL},         /* U+200E */
    {"a\xe2\x80\x8fz", "a?z", CONTROL},         /* U+200F */
    {"a\xe2\x80\xa8z", "a?z", CONTROL},         /* U+2028, a line's end */
    {"a\xe2\x80\xa9z", "a?z", CONTROL},         /* U+2029, a paragraph's */
    {"a\xe2\x80\xaaz", "a?z", CONTROL},         /* U+202A */
    {"gnp.\xe2\x80\xaez", "gnp.?z", CONTROL},   /* U+202E: what follows reads backwards */
    {"a\xe2\x81\xa6z", "a?z", CONTROL},         /* U+2066 */
    {"a\xe2\x81\xa9z", "a?z", CONTROL},         /* U+2069 */
    {"a\xe2\x80\x90z", "a\xe2\x80\x90z", NULL}, /* their neighbours: U+2010, */
    {"a\xe2\x80\xafz", "a\xe2\x80\xafz", NULL}, /* U+202F, a narrow space */
    {"a\x9bz", "a?z", BROKEN},                  /* C1 of a terminal that is not in UTF-8 */
    {"a\xc0\x9bz", "a??z", BROKEN},             /* ESC in two bytes */
    {"a\xe0\x82\x9bz", "a???z", BROKEN},        /* U+009B in three */
    {"a\xed\xa0\x80z", "a???z", BROKEN},        /* half of a pair of UTF-16 */
    {"a\xf4\x90\x80\x80z", "a????z", BROKEN},   /* beyond U+10FFFF */
    {"a\xff", "a?", BROKEN},
    {"cut \xe2\x80", "cut ??", BROKEN},
    {"cut \xc3", "cut ?", BROKEN},
};

static void every_text_becomes_plain(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *complaint = skv_plain_complaint(cases[i].text);
        if (!complaint != !cases[i].complaint ||
            (complaint && strcmp(complaint, cases[i].complaint) != 0))
            fail_msg("case %zu: %s", i, complaint ? complaint : "no complaint");
        char text[64];
        skv_format(text, sizeof text, "%s", cases[i].text);
        skv_make_plain(text);
        assert_string_equal(text, cases[i].plain);
        assert_null(skv_plain_complaint(text));
        skv_error error;
        skv_fail(&error, SKV_ERROR_VALUE, "%s", cases[i].text);
        assert_string_equal(error.text, cases[i].plain);
    }
}

/* A message that is cut to fit ends with a whole character. */
static void a_cut_message_is_plain(void **unused)
{
    (void)unused;
    for (int shift = 0; shift < 3; shift++) {
        char text[1000] = "";
        skv_format(text, sizeof text, "%.*s", shift, "aa");
        while (strlen(text) < 900)
            strcat(text, "\xe6\xb0\xb4 ");
        skv_error error;
        skv_fail(&error, SKV_ERROR_VALUE, "%s", text);
        assert_null(skv_plain_complaint(error.text));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_text_becomes_plain),
        cmocka_unit_test(a_cut_message_is_plain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
