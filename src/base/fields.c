/* Lists of fields: paths, values, and what messages say of them.
 *
 * Invariant: nothing here depends on the locale; a number in a message can be pasted into a scene.
 */
#include "base/fields.h"

#include <math.h>
#include <string.h>

#include "base/names.h"

int skv_field_find(const skv_field *fields, int count, const char *path)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(fields[i].path, path) == 0)
            return i;
    }
    return -1;
}

/* ---- Unknown paths --------------------------------------------------------------------------- */

/* What stands after the last point of a path. */
static const char *last_key(const char *path)
{
    const char *key = path;
    for (; *path != '\0'; path++)
        key = *path == '.' ? path + 1 : key;
    return key;
}

/* How far a known path is from what was written. The right key in the wrong place is a small slip
 * as well. */
static int slip(const char *written, const char *path)
{
    int whole = skv_edit_distance(written, path);
    int key = skv_edit_distance(last_key(written), last_key(path)) + 2;
    return whole < key ? whole : key;
}

/* Shortens "water[].x" to "water[]", "water[]" to "water"; false if nothing is left. */
static bool shorten(char *path)
{
    size_t length = strlen(path), key = (size_t)(last_key(path) - path);
    if (length > 2 && path[length - 1] == ']')
        path[length - 2] = '\0';
    else if (key > 0)
        path[key - 1] = '\0';
    else
        return false;
    return true;
}

/* The known path, of a field or of a group ("fluid"), that is most like `path`; "" if none is
 * near. */
static void find_nearest(const skv_field *fields, int count, const char *path,
                         char nearest[SKV_PATH_SIZE])
{
    int best = 2 + (int)strlen(last_key(path)) / 4;
    nearest[0] = '\0';
    for (int i = 0; i < count; i++) {
        char known[SKV_PATH_SIZE];
        skv_format(known, sizeof known, "%s", fields[i].path);
        do {
            int distance = slip(path, known);
            if (distance < best) {
                best = distance;
                memcpy(nearest, known, sizeof known);
            }
        } while (shorten(known));
    }
}

/* "; allowed are a, b, c": the keys that may stand where the path's last key stands. */
static void list_siblings(const skv_field *fields, int count, const char *path, char *text,
                          size_t size)
{
    size_t parent = (size_t)(last_key(path) - path), used = 0;
    char previous[SKV_PATH_SIZE] = "";
    for (int i = 0; i < count && used < size; i++) {
        if (strlen(fields[i].path) < parent || memcmp(fields[i].path, path, parent) != 0)
            continue;
        char key[SKV_PATH_SIZE];
        skv_format(key, sizeof key, "%s", fields[i].path + parent);
        size_t end = 0;
        while (key[end] != '\0' && key[end] != '.' && key[end] != '[')
            end++;
        key[end] = '\0';
        if (strcmp(key, previous) == 0)
            continue;
        memcpy(previous, key, sizeof key);
        used +=
            skv_format(text + used, size - used, "%s%s", used == 0 ? "; allowed are " : ", ", key);
    }
}

void skv_field_suggest(const skv_field *fields, int count, const char *path, char *text,
                       size_t size)
{
    char nearest[SKV_PATH_SIZE];
    text[0] = '\0';
    find_nearest(fields, count, path, nearest);
    if (nearest[0] != '\0')
        skv_format(text, size, "; did you mean %s?", nearest);
    else
        list_siblings(fields, count, path, text, size);
}

/* ---- Values ---------------------------------------------------------------------------------- */

void skv_format_number(double value, char text[32])
{
    skv_format(text, 32, "%.9g", value);
}

void skv_format_float(double value, char text[32])
{
    /* The shortest that is the same in single precision: 0.05, not 0.0500000007. */
    bool same = false;
    for (int digits = 6; digits <= 9 && !same; digits++) {
        double read;
        skv_format(text, 32, "%.*g", digits, value);
        same = skv_parse_number(text, &read) && (float)read == (float)value;
    }
}

int skv_field_choices(const char *choices)
{
    int count = 1;
    for (; *choices != '\0'; choices++)
        count += *choices == '|';
    return count;
}

/* "a, b or c" */
static void join_choices(const char *choices, char *text, size_t size)
{
    size_t used = 0;
    int words = skv_field_choices(choices);
    for (const char *c = choices; *c != '\0' && used < size; c++) {
        if (*c == '|')
            words--;
        used += *c == '|' ? skv_format(text + used, size - used, words > 1 ? ", " : " or ")
                          : skv_format(text + used, size - used, "%c", *c);
    }
}

void skv_field_allowed(const skv_field *field, char *text, size_t size)
{
    char from[32], to[32], choices[96] = "";
    skv_format_number(field->minimum, from);
    skv_format_number(field->maximum, to);
    const char *space = field->unit[0] != '\0' ? " " : "";
    switch (field->type) {
    case SKV_FIELD_NUMBER:
        skv_format(text, size, "allowed is a number from %s to %s%s%s", from, to, space,
                   field->unit);
        break;
    case SKV_FIELD_INTEGER:
        skv_format(text, size, "allowed is a whole number from %s to %s", from, to);
        break;
    case SKV_FIELD_TEXT:
        skv_format(text, size, "allowed is text of at most %s bytes", to);
        break;
    case SKV_FIELD_CHOICE:
        join_choices(field->choices, choices, sizeof choices);
        skv_format(text, size, "allowed is %s", choices);
        break;
    case SKV_FIELD_BOOLEAN:
        skv_format(text, size, "allowed is true or false");
        break;
    }
}

/* The length of the first choice. */
static size_t choice_length(const char *choices)
{
    size_t length = 0;
    while (choices[length] != '\0' && choices[length] != '|')
        length++;
    return length;
}

int skv_field_choice(const char *choices, const char *text)
{
    size_t length = strlen(text);
    for (int index = 0;; index++) {
        size_t span = choice_length(choices);
        if (span == length && memcmp(choices, text, length) == 0)
            return index;
        if (choices[span] == '\0')
            return -1;
        choices += span + 1;
    }
}

const char *skv_field_complaint(const skv_field *field, double number)
{
    /* The world keeps single precision, in which 0.05 is a little more than 0.05. */
    if (!((float)number >= (float)field->minimum && (float)number <= (float)field->maximum))
        return "is out of range";
    if (field->type == SKV_FIELD_INTEGER && number != floor(number))
        return "is not a whole number";
    return NULL;
}

const char *skv_field_read(const skv_field *field, const char *text, double *number)
{
    if (text[0] == '\0')
        return "is empty";
    switch (field->type) {
    case SKV_FIELD_NUMBER:
    case SKV_FIELD_INTEGER:
        if (!skv_parse_number(text, number))
            return "is not a number";
        return skv_field_complaint(field, *number);
    case SKV_FIELD_CHOICE:
        *number = skv_field_choice(field->choices, text);
        return *number < 0 ? "is not known" : NULL;
    case SKV_FIELD_BOOLEAN:
        *number = strcmp(text, "true") == 0;
        return *number != 1 && strcmp(text, "false") != 0 ? "is not true or false" : NULL;
    case SKV_FIELD_TEXT:
        break;
    }
    return "is not a number";
}

void skv_field_write(const skv_field *field, double number, char *text, size_t size)
{
    if (field->type == SKV_FIELD_BOOLEAN) {
        skv_format(text, size, "%s", number != 0 ? "true" : "false");
    } else if (field->type == SKV_FIELD_CHOICE) {
        const char *choice = field->choices;
        for (int i = (int)number; i > 0; i--)
            choice += choice_length(choice) + 1;
        skv_format(text, size, "%.*s", (int)choice_length(choice), choice);
    } else if (field->type == SKV_FIELD_INTEGER) {
        skv_format(text, size, "%.0f", number);
    } else {
        char shortest[32];
        skv_format_float(number, shortest);
        skv_format(text, size, "%s", shortest);
    }
}

skv_result skv_field_refuse(const skv_field *field, const char *what, const char *wrong,
                            skv_error *error)
{
    char allowed[160];
    skv_field_allowed(field, allowed, sizeof allowed);
    return skv_fail(error, SKV_ERROR_VALUE, "%s: %.60s %s; %s", field->path, *what ? what : "it",
                    wrong, allowed);
}
