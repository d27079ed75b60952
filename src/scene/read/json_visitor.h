/* A visit to the values of a JSON text, told by whatever parser has read it. */
#ifndef SKV_SCENE_JSON_VISITOR_H
#define SKV_SCENE_JSON_VISITOR_H

#include "scene/draft.h"
#include "scene/read/json_text.h"

/* No field lies deeper, so the draft has refused what does. */
#define SKV_JSON_LEVELS 8

/* An object or a list that is open. */
typedef struct skv_json_level {
    size_t path; /* length of its own */
    bool list;
    size_t next; /* index, of a list */
} skv_json_level;

typedef struct skv_json_visitor {
    skv_draft *draft;
    skv_json_cursor cursor;
    char path[SKV_PATH_SIZE];
    skv_json_level levels[SKV_JSON_LEVELS];
    int depth;
    skv_result result;
    skv_error *error;
} skv_json_visitor;

/* What a parser tells, in the order of the text: a member's key before its value; of objects and
 * lists their beginning as a value, and their end. False: no more is wanted. */
bool skv_json_key(skv_json_visitor *visitor, const char *key);
bool skv_json_value(skv_json_visitor *visitor, const skv_entry *entry);
bool skv_json_close(skv_json_visitor *visitor);

#endif
