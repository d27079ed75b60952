/* Reads the values of a sweep.
 *
 * Invariant: a value is its text. Two texts of one number become the same text, and no value stands
 * in a sweep twice, so that a run's name follows from its values and no two runs share one.
 */
#include "experiments/sweep.h"

#include "base/fields.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* Values in a list: each is compared with all before it. */
enum { LONGEST_LIST = 1000 };

#define HOW "say FROM:TO:NUMBER or VALUE,VALUE,..."

void skv_exact_number(double value, char text[VALUE_SIZE])
{
    double back = 0;
    text[0] = '\0';
    if (fabs(value) < 1e15 && value == floor(value)) {
        skv_format(text, VALUE_SIZE, "%.0f", value);
        return;
    }
    for (int digits = 1; digits <= 17 && isfinite(value); digits++) {
        skv_format(text, VALUE_SIZE, "%.*g", digits, value);
        if (skv_parse_number(text, &back) && back == value)
            return;
    }
}

static bool is_number(const skv_field *field)
{
    return field->type == SKV_FIELD_NUMBER || field->type == SKV_FIELD_INTEGER;
}

skv_result skv_value_write(const skv_field *field, const char *value, char text[VALUE_SIZE],
                           skv_error *error)
{
    double number = 0;
    const char *wrong = skv_field_read(field, value, &number);
    if (wrong)
        return skv_field_refuse(field, value, wrong, error);
    if (is_number(field))
        skv_exact_number(number + 0.0, text); /* of -0, 0 */
    else
        skv_format(text, VALUE_SIZE, "%s", value);
    return SKV_OK;
}

static skv_result out_of_memory(const skv_field *field, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", field->path);
}

/* Takes a value that none before it, from number `first` on, may equal. */
static skv_result take(sweep *s, const char *value, int first, skv_error *error)
{
    char *text = s->values[s->count];
    skv_result result = skv_value_write(s->field, value, text, error);
    for (int i = first; i < s->count && result == SKV_OK; i++)
        if (strcmp(s->values[i], text) == 0)
            result = skv_fail(error, SKV_ERROR_VALUE,
                              "%s: %s comes twice in its sweep; take each value once, or fewer",
                              s->field->path, text);
    s->count += result == SKV_OK;
    return result;
}

/* Copies what stands before `end`; false if it is longer than any value. */
static bool copy_piece(const char *text, const char *end, char piece[64])
{
    size_t length = (size_t)(end - text);
    if (length >= 64)
        return false;
    memcpy(piece, text, length);
    piece[length] = '\0';
    return true;
}

static skv_result read_list(sweep *s, const char *text, skv_error *error)
{
    int count = 1;
    for (const char *at = text; (at = strchr(at, ',')); at++)
        count++;
    if (count > LONGEST_LIST)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%s: a list of %d values, and %d are allowed; say FROM:TO:NUMBER",
                        s->field->path, count, LONGEST_LIST);
    s->values = skv_calloc((size_t)count, sizeof *s->values);
    if (!s->values)
        return out_of_memory(s->field, error);
    skv_result result = SKV_OK;
    while (result == SKV_OK && s->count < count) {
        char piece[64];
        const char *end = text + strcspn(text, ",");
        if (!copy_piece(text, end, piece))
            return skv_fail(error, SKV_ERROR_VALUE, "%s: '%s' is no list of values; " HOW,
                            s->field->path, text);
        result = take(s, piece, 0, error);
        text = end + 1;
    }
    return result;
}

/* Between the ends, to as many digits as people write: 0.02, not 0.020000000000000004. */
static void write_between(const skv_field *field, double from, double to, double share,
                          char text[VALUE_SIZE])
{
    double value = from + (to - from) * share;
    if (field->type == SKV_FIELD_INTEGER)
        skv_format(text, VALUE_SIZE, "%.0f", floor(value + 0.5));
    else
        skv_format(text, VALUE_SIZE, "%.12g", value);
}

static skv_result fill_range(sweep *s, const char *from, const char *to, int count,
                             skv_error *error)
{
    double low = 0, high = 0;
    char ends[2][VALUE_SIZE];
    skv_result result = skv_value_write(s->field, from, ends[0], error);
    if (result == SKV_OK)
        result = skv_value_write(s->field, to, ends[1], error);
    if (result != SKV_OK)
        return result;
    s->values = skv_calloc((size_t)count, sizeof *s->values);
    if (!s->values)
        return out_of_memory(s->field, error);
    skv_parse_number(ends[0], &low);
    skv_parse_number(ends[1], &high);
    while (s->count < count && result == SKV_OK) {
        char between[VALUE_SIZE];
        int i = s->count;
        write_between(s->field, low, high, (double)i / (count - 1), between);
        /* They grow or fall: only the one before can be the same. */
        result = take(s,
                      i == 0           ? ends[0]
                      : i == count - 1 ? ends[1]
                                       : between,
                      i ? i - 1 : 0, error);
    }
    return result;
}

static skv_result read_range(sweep *s, const char *text, int most, skv_error *error)
{
    const skv_field *field = s->field;
    const char *first = strchr(text, ':'), *second = strchr(first + 1, ':');
    char from[64], to[64];
    double count = 0;
    if (!is_number(field))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: '%s' is a range, and it is no number; list its values: VALUE,VALUE",
                        field->path, text);
    if (!second || !copy_piece(text, first, from) || !copy_piece(first + 1, second, to))
        return skv_fail(error, SKV_ERROR_VALUE, "%s: '%s' is no range; " HOW, field->path, text);
    if (!skv_parse_number(second + 1, &count) || count != floor(count) || count < 2)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: '%s' is no number of values in a range; say a whole number from 2 on",
                        field->path, second + 1);
    if (count > most)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%s: %s runs, and %d are allowed in a study; take fewer values",
                        field->path, second + 1, most);
    return fill_range(s, from, to, (int)count, error);
}

skv_result skv_sweep_read(sweep *s, const skv_field *field, const char *text, int most,
                          skv_error *error)
{
    *s = (sweep){.field = field};
    return strchr(text, ':') ? read_range(s, text, most, error) : read_list(s, text, error);
}

void skv_sweep_free(sweep *s)
{
    skv_free(s->values);
    *s = (sweep){0};
}
