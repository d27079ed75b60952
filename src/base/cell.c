/* Cells of tables. Invariant: whatever a cell holds, a reader of RFC 4180 gets one cell and its
 * text. */
#include "skvalp/base.h"

#include <string.h>

#include "base/assert.h"

bool skv_write_cell(const char *text, skv_write *write, void *user)
{
    SKV_ASSERT_OR(text && write, false);
    if (!text[strcspn(text, ",\"\r\n")])
        return write(text, strlen(text), user);
    bool written = write("\"", 1, user);
    for (const char *at = text; written && *at;) {
        size_t plain = strcspn(at, "\"");
        bool quote = at[plain] == '"';
        written = write(at, plain + quote, user) && (!quote || write("\"", 1, user));
        at += plain + quote;
    }
    return written && write("\"", 1, user);
}
