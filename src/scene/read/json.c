/* JSON reader: what a text may be at all, and messages about what is no JSON. Invariant: whichever
 * parser it is, the same texts are read, to the same entries. */
#include "scene/read/json.h"

#include <string.h>

#include "scene/read/json_text.h"

/* Says in a scene's terms why a text is no JSON. */
static skv_result report(const skv_draft *draft, const char *text, size_t size,
                         const skv_json_failure *failure, skv_error *error)
{
    skv_origin origin = {SKV_FROM_FILE, failure->line};
    char path[SKV_PATH_SIZE], allowed[160] = "allowed are finite numbers";
    skv_json_path_at(text, size, failure->position, path, sizeof path);
    skv_field_path field;
    int id = -1;
    if (skv_field_parse_path(path, &field))
        id = skv_scene_find_field(field.pattern);
    if (id >= 0)
        skv_field_allowed(&skv_scene_fields(NULL)[id], allowed, sizeof allowed);

    switch (failure->fault) {
    case SKV_JSON_TWICE:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "is given twice; allowed is once");
    case SKV_JSON_TOO_LARGE:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_VALUE,
                              "the number is too large; %s", allowed);
    case SKV_JSON_TOO_DEEP:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is nested too deeply for a scene");
    case SKV_JSON_NOT_UTF8:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not UTF-8 text; save the file as UTF-8");
    case SKV_JSON_NUL:
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "holds the character \\u0000, which no text may have; take it out");
    case SKV_JSON_ENDS_EARLY:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not JSON: it ends too early; is a \", } or ] missing?");
    case SKV_JSON_GOES_ON:
        return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                              "is not JSON: something follows the last }; take it out");
    case SKV_JSON_NO_MEMORY:
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    case SKV_JSON_OTHER:
        break;
    }
    const char *token = strchr(failure->words, '\'');
    if (token && (strncmp(token, "'NaN", 4) == 0 || strncmp(token, "'Inf", 4) == 0 ||
                  strncmp(token, "'-'", 3) == 0))
        return skv_draft_fail(draft, origin, path, error, SKV_ERROR_FORMAT,
                              "is not a finite number; %s", allowed);
    return skv_draft_fail(draft, origin, "", error, SKV_ERROR_FORMAT,
                          "is not JSON: %s; look for a missing quote, comma or bracket",
                          failure->words);
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
    skv_json_visitor visitor = {
        .draft = draft, .cursor = skv_json_cursor_at(text, size), .error = error};
    skv_json_failure failure = {.fault = SKV_JSON_NOT_UTF8, .line = 1};
    /* Two bytes a character, or no text at all; jansson would pass over it. */
    if (memchr(text, '\0', size) != NULL)
        return report(draft, text, size, &failure, error);
    return skv_json_parse(text, size, &visitor, &failure)
               ? visitor.result
               : report(draft, text, size, &failure, error);
}
