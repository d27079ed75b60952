/* JSON by jansson. Invariant: it keeps members in the order of the text and refuses duplicates. */
#include <jansson.h>

#include "scene/read/json.h"

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

/* A value and everything below it; that the visitor stops early bounds the recursion. */
static bool visit(skv_json_visitor *visitor, const json_t *value)
{
    skv_entry entry = as_entry(value);
    if (!skv_json_value(visitor, &entry))
        return false;
    if (json_is_object(value)) {
        const char *key;
        json_t *member;
        json_object_foreach((json_t *)value, key, member)
        {
            if (!skv_json_key(visitor, key) || !visit(visitor, member))
                return false;
        }
    } else if (json_is_array(value)) {
        size_t index;
        json_t *member;
        json_array_foreach(value, index, member)
        {
            if (!visit(visitor, member))
                return false;
        }
    } else {
        return true;
    }
    return skv_json_close(visitor);
}

static skv_json_fault fault_of(const json_error_t *error)
{
    switch (json_error_code(error)) {
    case json_error_duplicate_key:
        return SKV_JSON_TWICE;
    case json_error_numeric_overflow:
        return SKV_JSON_TOO_LARGE;
    case json_error_stack_overflow:
        return SKV_JSON_TOO_DEEP;
    case json_error_invalid_utf8:
        return SKV_JSON_NOT_UTF8;
    case json_error_null_character:
    case json_error_null_byte_in_key:
        return SKV_JSON_NUL;
    case json_error_premature_end_of_input:
        return SKV_JSON_ENDS_EARLY;
    case json_error_end_of_input_expected:
        return SKV_JSON_GOES_ON;
    case json_error_out_of_memory:
        return SKV_JSON_NO_MEMORY;
    default:
        return SKV_JSON_OTHER;
    }
}

bool skv_json_parse(const char *text, size_t size, skv_json_visitor *visitor,
                    skv_json_failure *failure)
{
    json_error_t error;
    json_t *root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
    if (root == NULL) {
        failure->fault = fault_of(&error);
        failure->line = error.line > 0 ? error.line : 1;
        failure->position = (size_t)error.position;
        skv_format(failure->words, sizeof failure->words, "%s", error.text);
        return false;
    }
    visit(visitor, root);
    json_decref(root);
    return true;
}
