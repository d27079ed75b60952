/* A locale that writes numbers with a comma. Debian's bare system has none, but it has localedef:
 * the locale is compiled from the few lines that matter, into a folder of its own. */
#include "support/comma_locale.h"

#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char source[] = "LC_NUMERIC\n"
                             "decimal_point \"<U002C>\"\n"
                             "thousands_sep \"\"\n"
                             "grouping -1\n"
                             "END LC_NUMERIC\n";
static const char characters[] = "<code_set_name> TINY\n"
                                 "<comment_char> %\n"
                                 "<escape_char> /\n"
                                 "<mb_cur_min> 1\n"
                                 "<mb_cur_max> 1\n"
                                 "CHARMAP\n"
                                 "<U0000> /x00 NUL\n"
                                 "<U002C> /x2c COMMA\n"
                                 "<U002E> /x2e FULL STOP\n"
                                 "END CHARMAP\n";

static void write_text(const char *folder, const char *name, const char *text)
{
    char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

void set_comma_locale(void)
{
    char folder[] = "/tmp/skvalp-locale-XXXXXX", command[256], half[8];
    assert_non_null(mkdtemp(folder));
    write_text(folder, "source", source);
    write_text(folder, "characters", characters);
    /* It warns about the categories that are left out, and its status counts warnings. */
    snprintf(command, sizeof command,
             "localedef -c -i %s/source -f %s/characters %s/comma >%s/log 2>&1", folder, folder,
             folder, folder);
    (void)!system(command);
    setenv("LOCPATH", folder, 1);
    const char *set = setlocale(LC_NUMERIC, "comma");
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
    assert_non_null(set);
    snprintf(half, sizeof half, "%g", 0.5);
    assert_string_equal(half, "0,5");
}

void reset_locale(void)
{
    setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");
}
