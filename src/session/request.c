/* Requests, each in one block of memory. Invariant: a copy points into its own block alone. */
#include <string.h>

#include "base/memory.h"
#include "session/mailbox.h"

/* Where the parts of a request lie in its block of memory. */
typedef struct packer {
    char *bytes; /* null: only counted */
    size_t used;
} packer;

static const void *pack(packer *p, const void *data, size_t size)
{
    size_t at = p->used;
    p->used += (size + 15) & ~(size_t)15;
    if (p->bytes && size)
        memcpy(p->bytes + at, data, size);
    return p->bytes ? p->bytes + at : NULL;
}

static const char *pack_text(packer *p, const char *text)
{
    return text ? pack(p, text, strlen(text) + 1) : NULL;
}

/* Writes a request and all that it points at to `bytes`; returns how much that takes. */
static size_t pack_request(char *bytes, const skv_request *from)
{
    packer p = {.bytes = bytes};
    skv_request request = *from;
    pack(&p, &request, sizeof request);
    request.name = pack_text(&p, from->name);
    request.text = pack_text(&p, from->text);
    request.data = from->data ? pack(&p, from->data, from->size) : NULL;
    int count = from->options.setting_count;
    size_t at = p.used;
    pack(&p, from->options.settings, (size_t)count * sizeof(skv_setting));
    skv_setting *settings = bytes ? (void *)(bytes + at) : NULL;
    for (int i = 0; i < count; i++) {
        const char *path = pack_text(&p, from->options.settings[i].path);
        const char *value = pack_text(&p, from->options.settings[i].value);
        if (settings)
            settings[i] = (skv_setting){path, value};
    }
    request.options.settings = settings;
    if (bytes)
        memcpy(bytes, &request, sizeof request);
    return p.used;
}

skv_request *skv_request_copy(const skv_request *from)
{
    char *block = skv_calloc(pack_request(NULL, from), 1);
    if (block)
        pack_request(block, from);
    return (void *)block;
}
