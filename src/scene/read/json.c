/* JSON reader (jansson): parses strictly, then visits every value in the order of the text.
 *
 * Invariant: the cursor moves over the text in step with the visit, so that each value's line is
 * known without an index; jansson keeps members in the order of the text and refuses duplicates.
 */
#include "scene/read/json.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "scene/read/json_text.h"

typedef struct visitor {
    skv_draft *draft;
    skv_json_cursor cursor;
    char path[SKV_PATH_SIZE];
    skv_error *error;
} visitor;

/* Appends a key to the path and returns the path's old length. A key that could pass for a longer
 * path ("fluid.law") is quoted, so that no field is called like that. */
static size_t push_key(visitor *v, const char *key)
{
    size_t length = strlen(v->path);
    bool plain = key[0] != '\0' && strpbrk(key, ".[]\"") == NULL;
    skv_format(v->path + length, sizeof v->path - length, plain ? "%s%s" : "%s\"%s\"",
               length > 0 ? "." : "", key);
    return length;
}

static size_t push_index(visitor *v, size_t index)
{
    size_t length = strlen(v->path);
    skv_format(v->path + length, sizeof v->path - length, "[%zu]", index);
    return length;
}

static skv_entry as_entry(const json_t *value)
{
    skv_entry entry = {.kind = SKV_ENTRY_NULL};
    switch (json_typeof(value)) {
    case JSON_OBJECT:
        entry.kind = SKV_ENTRY_OBJECT;
        break;
    case JSON_ARRAY:
        entry.kind = SKV_ENTRY_LIST;
        break;
    case JSON_STRING:
        entry.kind = SKV_ENTRY_TEXT;
        entry.text = json_string_value(value);
        break;
    case JSON_INTEGER:
    case JSON_REAL:
        entry.kind = SKV_ENTRY_NUMBER;
        entry.number = json_number_value(value);
        break;
    case JSON_TRUE:
    case JSON_FALSE:
        entry.kind = SKV_ENTRY_BOOLEAN;
        entry.boolean = json_is_true(value);
        break;
    case JSON_NULL:
        break;
    }
    return entry;
}

/* Hands a value and everything below it to the draft. The draft refuses objects and lists that
 * no field lies below, which bounds the recursion. */
static skv_result visit(visitor *v, const json_t *value)
{
    skv_json_next(&v->cursor);
    skv_entry entry = as_entry(value);
    skv_result result = skv_draft_accept(v->draft, v->path, &entry, v->cursor.line, v->error);
    if (result != SKV_OK)
        return result;
    if (entry.kind == SKV_ENTRY_OBJECT) {
        const char *key;
        json_t *member;
        json_object_foreach((json_t *)value, key, member)
        {
            skv_json_next(&v->cursor);
            size_t length = push_key(v, key);
            result = visit(v, member);
            v->path[length] = '\0';
            if (result != SKV_OK)
                return result;
        }
        skv_json_next(&v->cursor);
    } else if (entry.kind == SKV_ENTRY_LIST) {
        size_t index;
        json_t *member;
        json_array_foreach(value, index, member)
        {
            size_t length = push_index(v, index);
            result = visit(v, member);
            v->path[length] = '\0';
            if (result != SKV_OK)
                return result;
        }
        skv_json_next(&v->cursor);
    }
    return SKV_OK;
}

/* Says in a scene's terms why jansson refused a text. */
static skv_result report(const skv_draft *draft, const char *text, size_t size,
                         const json_error_t *failure, skv_error *error)
{
    skv_origin origin = {SKV_FROM_FILE, failure->line > 0 ? failure->line : 1};
    char path[SKV_PATH_SIZE], allowed[160] = "allowed are finite numbers";
    skv_json_path_at(text, size, (size_t)failure->position, path, sizeof path);
    skv_field_path field;
    int id = -1;
    if (skv_field_parse_path(path, &field))
        id = skv_field_find(skv_scene_fields(NULL), SKV_F_COUNT, field.pattern);
    if (id >= 0)
        skv_field_allowed(&skv_scene_fields(NULL)[id], allowed, sizeof allowed);

    switch (json_error_code(failure)) {
    case json_error_duplicate_key:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "is given twice; allowed is once");
    case json_error_numeric_overflow:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_VALUE,
                              "the number is too large; %s", allowed);
    case json_error_stack_overflow:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is nested too deeply for a scene");
    case json_error_invalid_utf8:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not UTF-8 text; save the file as UTF-8");
    case json_error_null_character:
    case json_error_null_byte_in_key:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "holds the character \\u0000, which no text may have; take it out");
    case json_error_premature_end_of_input:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not JSON: it ends too early; is a \", } or ] missing?");
    case json_error_end_of_input_expected:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not JSON: something follows the last }; take it out");
    case json_error_out_of_memory:
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    default:
        break;
    }
    if (strstr(failure->text, "near 'NaN") != NULL || strstr(failure->text, "near 'Inf") != NULL ||
        strstr(failure->text, "near '-'") != NULL)
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "is not a finite number; %s", allowed);
    return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                          "is not JSON: %s; look for a missing quote, comma or bracket",
                          failure->text);
}

skv_result skv_json_read(skv_draft *draft, const char *text, size_t size, skv_error *error)
{
    if (size == 0)
        return skv_fail(error, SKV_ERROR_FORMAT, "%s: is empty; a scene is { \"water\": [ ... ] }",
                        draft->label);
    if (size > SKV_MAX_JSON)
        return skv_fail(error, SKV_ERROR_LIMIT, "%s: %zu bytes are too many; allowed are %d",
                        draft->label, size, SKV_MAX_JSON);
    /* Some editors put a byte order mark in front. */
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        text += 3;
        size -= 3;
    }
    json_error_t failure;
    json_t *root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &failure);
    if (root == NULL)
        return report(draft, text, size, &failure, error);
    visitor v = {.draft = draft, .cursor = skv_json_cursor_at(text, size), .error = error};
    skv_result result = visit(&v, root);
    json_decref(root);
    return result;
}
