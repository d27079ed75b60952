/* JSON reader: visits the entries of a JSON scene in order. */
#ifndef SKV_SCENE_JSON_H
#define SKV_SCENE_JSON_H

#include "scene/draft.h"

/* The most JSON text that is parsed: a scene has few kilobytes, and a parser needs up to fifty
 * times the text in memory. */
#define SKV_MAX_JSON (4 * 1024 * 1024)

/* Parses `text` (not terminated) and hands every entry to the draft. */
skv_result skv_json_read(skv_draft *draft, const char *text, size_t size, skv_error *error);

#endif
