/* Prints JSON on stdout.
 *
 * Invariant: whatever comes in (a file name with stray bytes, a NaN), what goes out is valid JSON
 * in UTF-8.
 */
#include "output_json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Doubles beyond this may be whole without being exact. */
#define LARGEST_WHOLE 1e15

json_t *output_text(const char *text)
{
    json_t *made = json_string(text);
    if (made)
        return made;
    /* It is no UTF-8: what is beyond ASCII is lost. */
    static const char unknown[] = "\xEF\xBF\xBD";
    char *clean = malloc(3 * strlen(text) + 1);
    if (!clean)
        return NULL;
    size_t length = 0;
    for (const char *c = text; *c; c++) {
        bool plain = (unsigned char)*c < 0x80;
        memcpy(clean + length, plain ? c : unknown, plain ? 1 : 3);
        length += plain ? 1 : 3;
    }
    made = json_stringn(clean, length);
    free(clean);
    return made;
}

json_t *output_number(double value)
{
    if (!isfinite(value))
        return json_null();
    return floor(value) == value && fabs(value) < LARGEST_WHOLE ? json_integer((json_int_t)value)
                                                                : json_real(value);
}

static skv_result print(const char *before, json_t *value, const char *after, skv_error *error)
{
    if (!value)
        return skv_fail(error, SKV_ERROR_MEMORY, "standard output: out of memory");
    fputs(before, stdout);
    bool memory = json_dumpf(value, stdout, JSON_REAL_PRECISION(12)) == 0 || ferror(stdout);
    json_decref(value);
    if (!memory)
        return skv_fail(error, SKV_ERROR_MEMORY, "standard output: out of memory");
    fputs(after, stdout);
    return SKV_OK;
}

skv_result output_json(json_t *value, skv_error *error)
{
    return print("", value, "\n", error);
}

void output_list_begin(void)
{
    putchar('[');
}

skv_result output_list_add(int number, json_t *value, skv_error *error)
{
    return print(number ? ",\n " : "\n ", value, "", error);
}

void output_list_end(void)
{
    puts("\n]");
}
