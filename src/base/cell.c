/* Cells of tables. Invariant: whatever a cell holds, a reader of RFC 4180 gets one cell and its
 * text. */
#include "skvalp/base.h"

#include <string.h>

#include "base/assert.h"

static bool is_plain(const char *text)
{
    for (; *text; text++)
        if (*text == ',' || *text == '"' || *text == '\r' || *text == '\n')
            return false;
    return true;
}

bool skv_write_cell(const char *text, skv_write *write, void *user)
{
    SKV_ASSERT_OR(text && write, false);
    if (is_plain(text))
        return write(text, strlen(text), user);
    bool written = write("\"", 1, user);
    for (; written && *text; text++)
        written = write(text, 1, user) && (*text != '"' || write("\"", 1, user));
    return written && write("\"", 1, user);
}
