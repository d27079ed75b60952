/* Walk over a JSON text.
 *
 * Invariant: the cursor never leaves the text and always moves on, whatever the bytes are; on a
 * valid text it yields exactly the tokens in the order in which a parser meets them.
 */
#include "scene/read/json_text.h"

#include <stdbool.h>
#include <string.h>

#include "skvalp/base.h"

#define MAX_DEPTH 8

skv_json_cursor skv_json_cursor_at(const char *text, size_t size)
{
    return (skv_json_cursor){.at = text, .end = text + size, .token = text, .line = 1};
}

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

char skv_json_next(skv_json_cursor *cursor)
{
    const char *at = cursor->at, *end = cursor->end;
    for (; at < end && (is_space(*at) || *at == ',' || *at == ':'); at++)
        cursor->line += *at == '\n';
    cursor->token = at;
    if (at == end) {
        cursor->at = at;
        return 0;
    }
    char first = *at++;
    if (first == '"') {
        while (at < end && *at != '"' && *at != '\n')
            at += *at == '\\' && end - at > 1 ? 2 : 1;
        at += at < end && *at == '"';
    } else if (strchr("{}[]", first) == NULL || first == 0) {
        while (at < end && !is_space(*at) && strchr("{}[],:\"", *at) == NULL)
            at++;
    }
    cursor->at = at;
    return first != 0 ? first : '?';
}

/* One level of nesting on the way to a position. */
typedef struct level {
    bool list;
    int index;       /* of the current element of a list */
    const char *key; /* of the current member of an object, without quotes; null before the first */
    int key_length;
} level;

/* Whether the cursor's token is a key: a string, closed, that a colon follows. */
static bool is_key(const skv_json_cursor *cursor)
{
    const char *at = cursor->at;
    if (*cursor->token != '"' || at - cursor->token < 2 || at[-1] != '"')
        return false;
    while (at < cursor->end && is_space(*at))
        at++;
    return at < cursor->end && *at == ':';
}

static void write_path(const level *levels, int depth, char *path, size_t capacity)
{
    size_t used = 0;
    path[0] = '\0';
    for (int i = 0; i < depth && used < capacity; i++) {
        if (levels[i].list)
            used += skv_format(path + used, capacity - used, "[%d]", levels[i].index);
        else if (levels[i].key != NULL)
            used += skv_format(path + used, capacity - used, "%s%.*s", used > 0 ? "." : "",
                               levels[i].key_length, levels[i].key);
    }
}

void skv_json_path_at(const char *text, size_t size, size_t position, char *path, size_t capacity)
{
    level levels[MAX_DEPTH];
    int depth = 0;
    skv_json_cursor cursor = skv_json_cursor_at(text, size);
    const char *target = text + (position < size ? position : size);
    path[0] = '\0';
    for (char c = skv_json_next(&cursor); c != 0; c = skv_json_next(&cursor)) {
        level *top = depth > 0 ? &levels[depth - 1] : NULL;
        if (top != NULL && !top->list && is_key(&cursor)) {
            top->key = cursor.token + 1;
            top->key_length = (int)(cursor.at - cursor.token) - 2;
        }
        if (top != NULL && top->list && c != ']')
            top->index++;
        if (cursor.at >= target)
            break;
        if (c == '{' || c == '[') {
            if (depth == MAX_DEPTH)
                return;
            levels[depth++] = (level){.list = c == '[', .index = -1};
        } else if ((c == '}' || c == ']') && depth > 0) {
            depth--;
        }
    }
    write_path(levels, depth, path, capacity);
}
