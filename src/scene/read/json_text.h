/* A walk over a JSON text for what the parser does not tell: on which line a value stands, and
 * which field stands at a position. */
#ifndef SKV_SCENE_JSON_TEXT_H
#define SKV_SCENE_JSON_TEXT_H

#include <stddef.h>

typedef struct skv_json_cursor {
    const char *at, *end;
    const char *token; /* where the last token began */
    int line;          /* on which line, from 1 */
} skv_json_cursor;

skv_json_cursor skv_json_cursor_at(const char *text, size_t size);

/* Moves to the next token and returns its first character: a bracket or brace, '"' for a string
 * (key or value), another for a number or name; 0 at the end. Commas and colons are passed over.
 * Safe on any bytes. */
char skv_json_next(skv_json_cursor *cursor);

/* Writes the path of the value or key at a byte position, such as "fluid.law" or "water[1].x0", as
 * far as it can be told; "" otherwise. Safe on any bytes. */
void skv_json_path_at(const char *text, size_t size, size_t position, char *path, size_t capacity);

#endif
