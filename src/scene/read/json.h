/* JSON reader: visits the entries of a JSON scene in order. */
#ifndef SKV_SCENE_JSON_H
#define SKV_SCENE_JSON_H

#include "scene/read/json_visitor.h"

/* The most JSON text that is parsed: a scene has few kilobytes, and a parser needs up to fifty
 * times the text in memory. */
#define SKV_MAX_JSON (4 * 1024 * 1024)

/* Parses `text` (not terminated) and hands every entry to the draft. */
skv_result skv_json_read(skv_draft *draft, const char *text, size_t size, skv_error *error);

/* ---- What parses ----------------------------------------------------------------------------- */

/* What is wrong with a text that is no JSON. */
typedef enum skv_json_fault {
    SKV_JSON_OTHER, /* a missing comma, say: `words` tells */
    SKV_JSON_TWICE, /* a key, in one object */
    SKV_JSON_TOO_LARGE,
    SKV_JSON_TOO_DEEP,
    SKV_JSON_NOT_UTF8,
    SKV_JSON_NUL,
    SKV_JSON_ENDS_EARLY,
    SKV_JSON_GOES_ON,
    SKV_JSON_NO_MEMORY
} skv_json_fault;

typedef struct skv_json_failure {
    skv_json_fault fault;
    int line;        /* from 1 */
    size_t position; /* bytes up to the end of what is wrong */
    char words[160]; /* the parser's own, with "near '...'" */
} skv_json_failure;

/* native/ has it from jansson, wasm/ from the host. Parses strictly (RFC 8259, an object or a list,
 * no key twice, no \u0000, at most 2048 levels), the whole text first; then tells the visitor what
 * it holds, as long as that wants to know. False, and `*failure`, if it is no JSON. */
bool skv_json_parse(const char *text, size_t size, skv_json_visitor *visitor,
                    skv_json_failure *failure);

#endif
