/* Cells of tables: what would part a table is quoted, and nothing else is. */
#include "skvalp/base.h"
#include "support/kept.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static const char *const cases[][2] = {
    {"", ""},
    {"time (s)", "time (s)"},
    {" kept ", " kept "},
    {"teori, B", "\"teori, B\""},
    {",", "\",\""},
    {"\"", "\"\"\"\""},
    {"a 3\" pipe", "\"a 3\"\" pipe\""},
    {"\"\",\"", "\"\"\"\"\",\"\"\""},
    {"two\nlines", "\"two\nlines\""},
    {"cut\r", "\"cut\r\""},
};

static void what_parts_a_table_is_quoted(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        kept cell = {0};
        kept_add("", 0, &cell);
        assert_true(skv_write_cell(cases[i][0], kept_add, &cell));
        assert_string_equal(cell.bytes, cases[i][1]);
        kept_clear(&cell);
    }
}

/* Wherever a disk is full. */
static void a_cell_that_is_cut_is_told(void **unused)
{
    (void)unused;
    const char *text = "a, \"b\", c";
    kept whole = {0};
    assert_true(skv_write_cell(text, kept_add, &whole));
    for (size_t limit = 1; limit < whole.size; limit++) {
        kept cut = {.limit = limit};
        assert_false(skv_write_cell(text, kept_add, &cut));
        kept_clear(&cut);
    }
    kept_clear(&whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_parts_a_table_is_quoted),
        cmocka_unit_test(a_cell_that_is_cut_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
