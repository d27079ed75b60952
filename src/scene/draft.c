/* A draft: checks entries against the registry and keeps them as plain values.
 *
 * Invariant: a value that is stored has its field's type and lies within its range, wherever it
 * came from; only what concerns several fields at once is left to the builder.
 */
#include "scene/draft.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "base/memory.h"
#include "base/plain.h"

skv_result skv_draft_fail(const skv_draft *draft, skv_origin origin, const char *path,
                          skv_error *error, skv_result code, const char *format, ...)
{
    char message[400];
    va_list arguments;
    va_start(arguments, format);
    skv_format_list(message, sizeof message, format, arguments);
    va_end(arguments);
    if (origin.source == SKV_FROM_SETTING)
        return skv_fail(error, code, "--set %s: %s", path, message);
    if (origin.source == SKV_FROM_OPTION)
        return skv_fail(error, code, "--%s: %s", path, message);
    const char *colon = path[0] != '\0' ? ": " : "";
    if (origin.line > 0)
        return skv_fail(error, code, "%s:%d: %s%s%s", draft->label, origin.line, path, colon,
                        message);
    return skv_fail(error, code, "%s: %s%s%s", draft->label, path, colon, message);
}

/* Replaces a text; false if memory is out. */
static bool set_text(char **text, const char *source)
{
    char *copy = skv_calloc(strlen(source) + 1, 1);
    if (copy == NULL)
        return false;
    memcpy(copy, source, strlen(source));
    skv_free(*text);
    *text = copy;
    return true;
}

/* ---- Defaults -------------------------------------------------------------------------------- */

static void set_default(skv_value *value, const skv_field *field)
{
    value->origin = (skv_origin){SKV_FROM_DEFAULT, 0};
    if (field->type == SKV_FIELD_TEXT || field->default_text[0] == '\0' ||
        skv_field_read(field, field->default_text, &value->number) != NULL)
        value->number = 0.0;
}

skv_result skv_draft_begin(skv_draft *draft, const char *label, const char *folder,
                           skv_error *error)
{
    *draft = (skv_draft){.label = label, .folder = folder};
    skv_values *values = &draft->values;
    const skv_field *fields = skv_scene_fields(NULL);
    for (int i = 0; i < SKV_F_SINGLE; i++)
        set_default(&values->value[i], &fields[i]);
    for (int i = 0; i < SKV_LISTS; i++) {
        skv_shape_list *list = &values->list[i];
        list->shapes = skv_calloc((size_t)skv_scene_list((skv_list)i)->most, sizeof *list->shapes);
        if (list->shapes == NULL) {
            skv_draft_end(draft);
            return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
        }
    }
    return SKV_OK;
}

static void free_shapes(skv_shape_list *list)
{
    for (int i = 0; i < list->count; i++) {
        skv_free(list->shapes[i].points);
        for (int k = 0; k < SKV_MOST_FIELDS; k++)
            skv_free(list->shapes[i].value[k].text);
    }
    skv_free(list->shapes);
    *list = (skv_shape_list){0};
}

void skv_draft_end(skv_draft *draft)
{
    for (int i = 0; i < SKV_F_SINGLE; i++)
        skv_free(draft->values.value[i].text);
    for (int i = 0; i < SKV_LISTS; i++)
        free_shapes(&draft->values.list[i]);
}

/* ---- One value ------------------------------------------------------------------------------- */

/* Quotes a text, cut after 40 bytes between two characters of UTF-8. */
static void quote(const char *source, char text[64])
{
    size_t length = strlen(source), cut = length;
    if (length > 40) {
        for (cut = 40; cut > 36 && ((unsigned char)source[cut] & 0xc0) == 0x80; cut--)
            continue;
    }
    skv_format(text, 64, "\"%.*s%s\"", (int)cut, source, cut < length ? "..." : "");
}

static bool is_empty(const skv_entry *entry)
{
    return entry->kind == SKV_ENTRY_TEXT && entry->text[0] == '\0';
}

/* Names an entry in a message: "null", "3.5", "\"abc\"", "a list". */
static void describe(const skv_entry *entry, char text[64])
{
    switch (entry->kind) {
    case SKV_ENTRY_NULL:
        skv_format(text, 64, "null");
        break;
    case SKV_ENTRY_BOOLEAN:
        skv_format(text, 64, "%s", entry->boolean ? "true" : "false");
        break;
    case SKV_ENTRY_NUMBER:
        skv_format_number(entry->number, text);
        break;
    case SKV_ENTRY_TEXT:
        if (is_empty(entry))
            skv_format(text, 64, "it");
        else
            quote(entry->text, text);
        break;
    case SKV_ENTRY_LIST:
        skv_format(text, 64, "a list");
        break;
    case SKV_ENTRY_OBJECT:
        skv_format(text, 64, "an object");
        break;
    }
}

/* What is wrong with an entry for a field; null if nothing is. */
static const char *complaint(const skv_field *field, const skv_entry *entry)
{
    if (is_empty(entry) && field->type != SKV_FIELD_TEXT)
        return "is empty";
    switch (field->type) {
    case SKV_FIELD_NUMBER:
    case SKV_FIELD_INTEGER:
        return entry->kind == SKV_ENTRY_NUMBER ? skv_field_complaint(field, entry->number)
                                               : "is not a number";
    case SKV_FIELD_BOOLEAN:
        return entry->kind == SKV_ENTRY_BOOLEAN ? NULL : "is not true or false";
    case SKV_FIELD_CHOICE:
        if (entry->kind != SKV_ENTRY_TEXT)
            return "is not text";
        return skv_field_choice(field->choices, entry->text) < 0 ? "is not known" : NULL;
    case SKV_FIELD_TEXT:
        if (entry->kind != SKV_ENTRY_TEXT)
            return "is not text";
        if ((double)strlen(entry->text) > field->maximum)
            return "is too long";
        return skv_plain_complaint(entry->text);
    }
    return NULL;
}

/* Checks an entry and stores it in `value`. */
static skv_result store(const skv_draft *draft, int id, const char *path, const skv_entry *entry,
                        skv_origin origin, skv_value *value, skv_error *error)
{
    const skv_field *field = &skv_scene_fields(NULL)[id];
    const char *wrong = complaint(field, entry);
    if (wrong != NULL) {
        char what[64], allowed[160];
        describe(entry, what);
        skv_field_allowed(field, allowed, sizeof allowed);
        bool many = id == SKV_F_PARTICLES && entry->kind == SKV_ENTRY_NUMBER &&
                    entry->number > field->maximum;
        return skv_draft_fail(draft, origin, path, error, many ? SKV_ERROR_LIMIT : SKV_ERROR_VALUE,
                              "%s %s; %s", what, wrong, allowed);
    }
    if (field->type == SKV_FIELD_TEXT) {
        if (!set_text(&value->text, entry->text))
            return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    } else if (field->type == SKV_FIELD_CHOICE) {
        value->number = skv_field_choice(field->choices, entry->text);
    } else if (field->type == SKV_FIELD_BOOLEAN) {
        value->number = entry->boolean;
    } else {
        value->number = entry->number;
    }
    value->origin = origin;
    return SKV_OK;
}

/* ---- Lists of shapes ------------------------------------------------------------------------- */

/* The element `index` of a list, made if it is the next one. Null: `*result` says why. */
static skv_shape_values *element(skv_draft *draft, skv_list id, const skv_field_path *path,
                                 skv_origin origin, const char *text, skv_result *result,
                                 skv_error *error)
{
    skv_shape_list *list = &draft->values.list[id];
    const skv_list_fields *own = skv_scene_list(id);
    const char *name = own->name;
    int index = path->index[0];
    if (index < list->count)
        return &list->shapes[index];
    if (index >= own->most) {
        *result = skv_draft_fail(draft, origin, text, error, SKV_ERROR_LIMIT,
                                 "too many; allowed are %d", own->most);
        return NULL;
    }
    if (index > list->count) {
        *result = skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE,
                                 "there is no %s[%d]; the next free one is %s[%d]", name, index,
                                 name, list->count);
        return NULL;
    }
    skv_shape_values *shape = &list->shapes[list->count++];
    for (int i = 0; i < own->count; i++)
        set_default(&shape->value[i], &skv_scene_fields(NULL)[own->first + i]);
    shape->origin = origin;
    return shape;
}

/* Makes room for point number `index`; its coordinates are NaN until they are given. */
static skv_result reserve_point(const skv_draft *draft, skv_shape_list *list,
                                skv_shape_values *shape, int index, skv_origin origin,
                                const char *path, skv_error *error)
{
    if (index < shape->point_count)
        return SKV_OK;
    if (index >= SKV_MAX_POINTS || list->total_points >= SKV_MAX_TOTAL_POINTS)
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_LIMIT,
                              "too many points; allowed are %d in a shape and %d in all",
                              SKV_MAX_POINTS, SKV_MAX_TOTAL_POINTS);
    if (index > shape->point_count)
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_VALUE,
                              "there is no point %d; the next free one is %d", index,
                              shape->point_count);
    if (shape->points == NULL)
        shape->points = skv_calloc(SKV_MAX_POINTS, 2 * sizeof *shape->points);
    if (shape->points == NULL)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    shape->points[2 * index] = (double)NAN;
    shape->points[2 * index + 1] = (double)NAN;
    shape->point_count++;
    list->total_points++;
    return SKV_OK;
}

/* The list that a path leads into. */
static skv_list list_of(const skv_field_path *path)
{
    int list = 0;
    size_t length = strcspn(path->pattern, "[");
    while (list < SKV_LISTS - 1 &&
           (strlen(skv_scene_list((skv_list)list)->name) != length ||
            strncmp(path->pattern, skv_scene_list((skv_list)list)->name, length) != 0))
        list++;
    return (skv_list)list;
}

#ifndef SKV_WITHOUT_BODIES
/* Stores a coordinate of a body's pin. */
static skv_result store_pin(const skv_draft *draft, const skv_field_path *path, int id,
                            const char *text, const skv_entry *entry, skv_origin origin,
                            skv_shape_values *shape, skv_error *error)
{
    int which = path->index[1];
    if (which > 1)
        return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE,
                              "one value too many; a pin is a pair [x, y]");
    return store(draft, id, text, entry, origin, &shape->pin[which], error);
}
#endif

/* Accepts an entry at or below an element of a list. `id` is -1 for one of its lists. */
static skv_result accept_shape(skv_draft *draft, const skv_field_path *path, int id,
                               const char *text, const skv_entry *entry, skv_origin origin,
                               skv_error *error)
{
    skv_list list = list_of(path);
    skv_result result = SKV_OK;
    skv_shape_values *shape = element(draft, list, path, origin, text, &result, error);
    if (shape == NULL)
        return result;
#ifndef SKV_WITHOUT_BODIES
    if (id == SKV_F_BODIES + SKV_BODY_PIN)
        return store_pin(draft, path, id, text, entry, origin, shape, error);
#endif
    if (path->index_count >= 2) {
        result = reserve_point(draft, &draft->values.list[list], shape, path->index[1], origin,
                               text, error);
        if (result != SKV_OK)
            return result;
    }
    if (id < 0)
        return SKV_OK;
    skv_value *value = &shape->value[id - skv_scene_list(list)->first];
    if (path->index_count == 3 && path->index[2] > 1)
        return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE,
                              "one value too many; a point is a pair [x, y]");
    result = store(draft, id, text, entry, origin, value, error);
    if (result == SKV_OK && path->index_count == 3)
        shape->points[2 * path->index[1] + path->index[2]] = value->number;
    return result;
}

/* ---- Entries --------------------------------------------------------------------------------- */

/* Accepts an object or a list where one has its place. */
static skv_result accept_opening(skv_draft *draft, const skv_field_path *path, const char *text,
                                 const skv_entry *entry, skv_origin origin, skv_error *error)
{
    if (path->index_count > 0)
        return accept_shape(draft, path, -1, text, entry, origin, error);
    if (entry->kind == SKV_ENTRY_LIST)
        draft->values.list[list_of(path)].given = true;
    return SKV_OK;
}

/* Accepts an entry where no field is: an object or a list, or a mistake. */
static skv_result accept_group(skv_draft *draft, const skv_field_path *path, const char *text,
                               const skv_entry *entry, skv_origin origin, skv_error *error)
{
    bool object = skv_field_is_object(path->pattern), list = skv_field_is_list(path->pattern);
    if (!object && !list) {
        char hint[200];
        if (strchr(text, '"') != NULL)
            skv_format(hint, sizeof hint, "; a key is one word, a group is { ... }");
        else
            skv_scene_suggest(path->pattern, hint, sizeof hint);
        return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE, "unknown field%s", hint);
    }
    if (entry->kind == (list ? SKV_ENTRY_LIST : SKV_ENTRY_OBJECT))
        return accept_opening(draft, path, text, entry, origin, error);
    char what[64];
    describe(entry, what);
    if (origin.source == SKV_FROM_SETTING)
        return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE,
                              "holds several values; set one of them");
    return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE, "%s %s; %s", what,
                          list ? "is not a list" : "is not an object",
                          list ? "allowed is [ ... ]" : "allowed is { \"name\": value, ... }");
}

static skv_result accept(skv_draft *draft, const char *text, const skv_entry *entry,
                         skv_origin origin, skv_error *error)
{
    skv_field_path path;
    if (!skv_field_parse_path(text, &path))
        return skv_draft_fail(draft, origin, text, error, SKV_ERROR_VALUE, "unknown field");
    int id = skv_scene_find_field(path.pattern);
    if (id < 0)
        return accept_group(draft, &path, text, entry, origin, error);
    if (id == SKV_F_AIR_PRESSURE)
        return store(draft, id, text, entry, origin, &draft->values.air_pressure, error);
    if (id >= SKV_F_SINGLE)
        return accept_shape(draft, &path, id, text, entry, origin, error);
    return store(draft, id, text, entry, origin, &draft->values.value[id], error);
}

skv_result skv_draft_accept(skv_draft *draft, const char *path, const skv_entry *entry, int line,
                            skv_error *error)
{
    return accept(draft, path, entry, (skv_origin){SKV_FROM_FILE, line}, error);
}

skv_result skv_draft_set(skv_draft *draft, const skv_setting *setting, skv_error *error)
{
    skv_field_path path;
    const skv_field *fields = skv_scene_fields(NULL);
    skv_entry entry = {.kind = SKV_ENTRY_TEXT, .text = setting->value};
    int id = -1;
    if (skv_field_parse_path(setting->path, &path))
        id = skv_scene_find_field(path.pattern);
    bool number =
        id >= 0 && (fields[id].type == SKV_FIELD_NUMBER || fields[id].type == SKV_FIELD_INTEGER);
    if (number && skv_parse_number(setting->value, &entry.number)) {
        entry.kind = SKV_ENTRY_NUMBER;
    } else if (id >= 0 && fields[id].type == SKV_FIELD_BOOLEAN &&
               skv_field_read(&fields[id], setting->value, &entry.number) == NULL) {
        entry.kind = SKV_ENTRY_BOOLEAN;
        entry.boolean = entry.number != 0.0;
    }
    return accept(draft, setting->path, &entry, (skv_origin){SKV_FROM_SETTING, 0}, error);
}

skv_result skv_draft_options(skv_draft *draft, const skv_scene_options *options, skv_error *error)
{
    for (int i = 0; i < options->setting_count; i++) {
        skv_result result = skv_draft_set(draft, &options->settings[i], error);
        if (result != SKV_OK)
            return result;
    }
    if (options->particles == 0)
        return SKV_OK;
    skv_entry entry = {.kind = SKV_ENTRY_NUMBER, .number = options->particles};
    return accept(draft, "particles", &entry, (skv_origin){SKV_FROM_OPTION, 0}, error);
}
