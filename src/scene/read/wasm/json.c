/* JSON by the host. Invariant: of the text nothing is believed but what the host tells; that it
 * tells what jansson would is the host's part (docs/web.md). */
#include "scene/read/json.h"
#include "base/wasm/host.h"

SKV_HOST(parse_json)
bool host_parse_json(const char *text, size_t size, skv_json_visitor *visitor,
                     skv_json_failure *failure);

/* What the host calls meanwhile: as skv_json_key, skv_json_value and skv_json_close, or with what
 * is wrong. `kind` is a skv_entry_kind; `number` is 0 or 1 for a boolean; `text` may be null. */
bool skv_wasm_json_key(skv_json_visitor *visitor, const char *key);
bool skv_wasm_json_value(skv_json_visitor *visitor, int kind, double number, const char *text);
bool skv_wasm_json_close(skv_json_visitor *visitor);
void skv_wasm_json_fail(skv_json_failure *failure, int fault, int line, size_t position,
                        const char *words);

SKV_EXPORT(skv_wasm_json_key)
bool skv_wasm_json_key(skv_json_visitor *visitor, const char *key)
{
    return skv_json_key(visitor, key);
}

SKV_EXPORT(skv_wasm_json_value)
bool skv_wasm_json_value(skv_json_visitor *visitor, int kind, double number, const char *text)
{
    skv_entry entry = {.kind = (skv_entry_kind)kind,
                       .number = number,
                       .boolean = number != 0,
                       .text = text ? text : ""};
    return skv_json_value(visitor, &entry);
}

SKV_EXPORT(skv_wasm_json_close)
bool skv_wasm_json_close(skv_json_visitor *visitor)
{
    return skv_json_close(visitor);
}

SKV_EXPORT(skv_wasm_json_fail)
void skv_wasm_json_fail(skv_json_failure *failure, int fault, int line, size_t position,
                        const char *words)
{
    *failure = (skv_json_failure){(skv_json_fault)fault, line, position, ""};
    skv_format(failure->words, sizeof failure->words, "%s", words);
}

bool skv_json_parse(const char *text, size_t size, skv_json_visitor *visitor,
                    skv_json_failure *failure)
{
    return host_parse_json(text, size, visitor, failure);
}
