/* Paths of fields and the words messages use about them.
 *
 * Invariant: nothing here depends on the locale; a number in a message can be pasted into a scene.
 */
#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/fields.h"

#define MAX_INDEX 1000000

/* Reads "[12]" at `text`; returns what follows it, or null. */
static const char *parse_index(const char *text, int *index)
{
    if (*text != '[' || !isdigit((unsigned char)text[1]))
        return NULL;
    long value = 0;
    for (text++; isdigit((unsigned char)*text); text++) {
        value = value * 10 + (*text - '0');
        if (value > MAX_INDEX)
            return NULL;
    }
    *index = (int)value;
    return *text == ']' ? text + 1 : NULL;
}

bool skv_field_parse_path(const char *text, skv_field_path *path)
{
    size_t length = 0;
    path->index_count = 0;
    while (*text != '\0') {
        if (length + 3 > sizeof path->pattern)
            return false;
        if (*text == '[') {
            if (path->index_count == 3)
                return false;
            text = parse_index(text, &path->index[path->index_count++]);
            if (text == NULL)
                return false;
            path->pattern[length++] = '[';
            path->pattern[length++] = ']';
        } else {
            path->pattern[length++] = *text++;
        }
    }
    path->pattern[length] = '\0';
    return true;
}

int skv_field_find(const char *pattern)
{
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    for (int i = 0; i < count; i++) {
        if (strcmp(fields[i].path, pattern) == 0)
            return i;
    }
    return -1;
}

/* Whether some field's path is `pattern`, then `next`, then more. */
static bool has_below(const char *pattern, const char *next)
{
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    size_t length = strlen(pattern), next_length = strlen(next);
    for (int i = 0; i < count; i++) {
        if (strncmp(fields[i].path, pattern, length) == 0 &&
            strncmp(fields[i].path + length, next, next_length) == 0)
            return true;
    }
    return false;
}

bool skv_field_is_object(const char *pattern)
{
    return pattern[0] == '\0' || has_below(pattern, ".");
}

bool skv_field_is_list(const char *pattern)
{
    return pattern[0] != '\0' && has_below(pattern, "[]");
}

/* Levenshtein distance, both texts cut to SKV_PATH_SIZE - 1 bytes. */
static int edit_distance(const char *a, const char *b)
{
    int row[SKV_PATH_SIZE];
    int width = (int)strnlen(b, SKV_PATH_SIZE - 1), height = (int)strnlen(a, SKV_PATH_SIZE - 1);
    for (int j = 0; j <= width; j++)
        row[j] = j;
    for (int i = 1; i <= height; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= width; j++) {
            int best = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            if (row[j] + 1 < best)
                best = row[j] + 1;
            if (row[j - 1] + 1 < best)
                best = row[j - 1] + 1;
            row[j] = best;
        }
    }
    return row[width];
}

/* What stands after the last point of a path. */
static const char *last_key(const char *path)
{
    const char *point = strrchr(path, '.');
    return point != NULL ? point + 1 : path;
}

/* How far a known path is from what was written. The right key in the wrong place is a small slip
 * as well. */
static int slip(const char *pattern, const char *path)
{
    int whole = edit_distance(pattern, path);
    int key = edit_distance(last_key(pattern), last_key(path)) + 2;
    return whole < key ? whole : key;
}

/* Shortens "water[].x" to "water[]", "water[]" to "water"; false if nothing is left. */
static bool shorten(char *path)
{
    size_t length = strlen(path);
    char *point = strrchr(path, '.');
    if (length > 2 && path[length - 1] == ']')
        path[length - 2] = '\0';
    else if (point != NULL)
        *point = '\0';
    else
        return false;
    return true;
}

/* The known path, of a field or of a group ("fluid"), that is most like `pattern`; "" if none is
 * near. */
static void nearest_path(const char *pattern, char nearest[SKV_PATH_SIZE])
{
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    int best = 2 + (int)strlen(last_key(pattern)) / 4;
    nearest[0] = '\0';
    for (int i = 0; i < count; i++) {
        char path[SKV_PATH_SIZE];
        snprintf(path, sizeof path, "%s", fields[i].path);
        do {
            int distance = slip(pattern, path);
            if (distance < best) {
                best = distance;
                snprintf(nearest, SKV_PATH_SIZE, "%s", path);
            }
        } while (shorten(path));
    }
}

/* "; allowed are a, b, c": the keys that may stand where `pattern`'s last key stands. */
static void list_siblings(const char *pattern, char *text, size_t size)
{
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    size_t parent = (size_t)(last_key(pattern) - pattern);
    char previous[SKV_PATH_SIZE] = "";
    size_t used = 0;
    for (int i = 0; i < count && used < size; i++) {
        if (strncmp(fields[i].path, pattern, parent) != 0)
            continue;
        char key[SKV_PATH_SIZE];
        snprintf(key, sizeof key, "%s", fields[i].path + parent);
        key[strcspn(key, ".[")] = '\0';
        if (strcmp(key, previous) == 0)
            continue;
        memcpy(previous, key, sizeof key);
        used += (size_t)snprintf(text + used, size - used, "%s%s",
                                 used == 0 ? "; allowed are " : ", ", key);
    }
}

void skv_field_suggest(const char *pattern, char *text, size_t size)
{
    char nearest[SKV_PATH_SIZE];
    text[0] = '\0';
    nearest_path(pattern, nearest);
    if (nearest[0] != '\0')
        snprintf(text, size, "; did you mean %s?", nearest);
    else
        list_siblings(pattern, text, size);
}

void skv_field_allowed(const skv_field *field, char *text, size_t size)
{
    char from[32], to[32];
    skv_format_number(field->minimum, from);
    skv_format_number(field->maximum, to);
    const char *space = field->unit[0] != '\0' ? " " : "";
    switch (field->type) {
    case SKV_FIELD_NUMBER:
        snprintf(text, size, "allowed is a number from %s to %s%s%s", from, to, space, field->unit);
        break;
    case SKV_FIELD_INTEGER:
        snprintf(text, size, "allowed is a whole number from %s to %s", from, to);
        break;
    case SKV_FIELD_TEXT:
        snprintf(text, size, "allowed is text of at most %s bytes", to);
        break;
    case SKV_FIELD_CHOICE: {
        size_t used = (size_t)snprintf(text, size, "allowed is ");
        for (const char *c = field->choices; *c != '\0' && used + 5 < size; c++) {
            if (*c == '|')
                used += (size_t)snprintf(text + used, size - used, "%s",
                                         strchr(c + 1, '|') != NULL ? ", " : " or ");
            else
                used += (size_t)snprintf(text + used, size - used, "%c", *c);
        }
        break;
    }
    case SKV_FIELD_BOOLEAN:
        snprintf(text, size, "allowed is true or false");
        break;
    }
}

int skv_field_choice(const char *choices, const char *text)
{
    size_t length = strlen(text);
    for (int index = 0;; index++) {
        size_t span = strcspn(choices, "|");
        if (span == length && memcmp(choices, text, length) == 0)
            return index;
        if (choices[span] == '\0')
            return -1;
        choices += span + 1;
    }
}

void skv_format_number(double value, char text[32])
{
    snprintf(text, 32, "%.9g", value);
    for (char *c = text; *c != '\0'; c++) {
        if (strchr("0123456789+-einfa", *c) == NULL)
            *c = '.';
    }
}

/* Passes over digits; false if there is none. */
static bool skip_digits(const char **at)
{
    const char *start = *at;
    while (isdigit((unsigned char)**at))
        (*at)++;
    return *at > start;
}

bool skv_parse_number(const char *text, double *value)
{
    const char *at = text;
    if (*at == '-' || *at == '+')
        at++;
    if (!skip_digits(&at))
        return false;
    size_t point = 0;
    if (*at == '.') {
        point = (size_t)(at - text);
        at++;
        if (!skip_digits(&at))
            return false;
    }
    if (*at == 'e' || *at == 'E') {
        at++;
        if (*at == '-' || *at == '+')
            at++;
        if (!skip_digits(&at))
            return false;
    }
    if (*at != '\0' || at - text > 60)
        return false;
    /* strtod wants the locale's own decimal point. */
    char local[80];
    const char *separator = localeconv()->decimal_point;
    if (point > 0)
        snprintf(local, sizeof local, "%.*s%.8s%s", (int)point, text, separator, text + point + 1);
    else
        snprintf(local, sizeof local, "%s", text);
    *value = strtod(local, NULL);
    return isfinite(*value);
}
