/* Growing memory. Invariant: it depends on no test framework, for the fuzz targets use it, too. */
#include "support/kept.h"

#include <stdlib.h>
#include <string.h>

bool kept_add(const char *bytes, size_t size, void *user)
{
    kept *k = user;
    if (k->limit > 0 && k->size + size > k->limit)
        return false;
    char *grown = realloc(k->bytes, k->size + size + 1);
    if (!grown)
        return false;
    memcpy(grown + k->size, bytes, size);
    k->bytes = grown;
    k->size += size;
    k->bytes[k->size] = '\0';
    return true;
}

void kept_clear(kept *k)
{
    free(k->bytes);
    k->bytes = NULL;
    k->size = 0;
}
