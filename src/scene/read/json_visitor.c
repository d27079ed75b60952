/* From what a parser tells to a draft's entries. Invariant: the cursor moves over the text in step
 * with the visit, so that each value's line is known without an index. */
#include "scene/read/json_visitor.h"

#include <string.h>

/* A key that could pass for a longer path ("fluid.law") is quoted, so that no field is called like
 * that. */
bool skv_json_key(skv_json_visitor *v, const char *key)
{
    skv_json_next(&v->cursor);
    size_t length = v->levels[v->depth - 1].path;
    bool plain = key[0] != '\0' && strpbrk(key, ".[]\"") == NULL;
    skv_format(v->path + length, sizeof v->path - length, plain ? "%s%s" : "%s\"%s\"",
               length > 0 ? "." : "", key);
    return true;
}

bool skv_json_value(skv_json_visitor *v, const skv_entry *entry)
{
    skv_json_level *top = v->depth > 0 ? &v->levels[v->depth - 1] : NULL;
    if (top != NULL && top->list)
        skv_format(v->path + top->path, sizeof v->path - top->path, "[%zu]", top->next++);
    skv_json_next(&v->cursor);
    v->result = skv_draft_accept(v->draft, v->path, entry, v->cursor.line, v->error);
    bool list = entry->kind == SKV_ENTRY_LIST;
    if (v->result != SKV_OK || (!list && entry->kind != SKV_ENTRY_OBJECT))
        return v->result == SKV_OK;
    if (v->depth == SKV_JSON_LEVELS) {
        v->result = skv_draft_fail(v->draft, (skv_origin){SKV_FROM_FILE, v->cursor.line}, "",
                                   v->error, SKV_ERROR_FORMAT, "is nested too deeply for a scene");
        return false;
    }
    v->levels[v->depth++] = (skv_json_level){.path = strlen(v->path), .list = list};
    return true;
}

bool skv_json_close(skv_json_visitor *v)
{
    skv_json_next(&v->cursor);
    v->depth--;
    return true;
}
