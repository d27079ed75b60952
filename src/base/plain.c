/* Which characters are plain. Invariant: this is the one place that decides it, for what is refused
 * and for what is replaced.
 *
 * Not plain are the controls of ASCII and of Latin-1 (C0, DEL, C1: a terminal obeys them), those
 * that turn the direction of writing (Unicode's Bidi_Control: a text then reads otherwise than it
 * is), the separators of lines and paragraphs, and bytes that are no character of UTF-8.
 */
#include "base/plain.h"

#include "base/assert.h"
#include "skvalp/base.h"

#include <string.h>

/* What a character of UTF-8 takes, and what it is. */
typedef struct character {
    int bytes; /* 0: the byte here begins none */
    uint32_t code;
} character;

static character character_at(const char *text)
{
    static const uint32_t least[5] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned first = (unsigned char)text[0];
    int bytes = first < 0x80                    ? 1
                : first >= 0xc2 && first < 0xe0 ? 2
                : first >= 0xe0 && first < 0xf0 ? 3
                : first >= 0xf0 && first < 0xf5 ? 4
                                                : 0;
    uint32_t code = bytes > 1 ? first & (0x7fu >> bytes) : first;
    for (int i = 1; i < bytes; i++) {
        unsigned next = (unsigned char)text[i];
        if ((next & 0xc0) != 0x80)
            return (character){0};
        code = code << 6 | (next & 0x3f);
    }
    bool surrogate = code >= 0xd800 && code < 0xe000;
    if (bytes == 0 || code < least[bytes] || surrogate || code > 0x10ffff)
        return (character){0};
    return (character){bytes, code};
}

static bool is_control(uint32_t c)
{
    bool turns = c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) ||
                 (c >= 0x2066 && c <= 0x2069);
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029 || turns;
}

const char *skv_plain_complaint(const char *text)
{
    for (; *text; text += character_at(text).bytes) {
        character c = character_at(text);
        if (c.bytes == 0)
            return "is not UTF-8";
        if (is_control(c.code))
            return "holds a control character";
    }
    return NULL;
}

void skv_make_plain(char *text)
{
    SKV_ASSERT(text);
    char *to = text;
    while (*text) {
        character c = character_at(text);
        int bytes = c.bytes ? c.bytes : 1;
        if (c.bytes == 0 || is_control(c.code)) {
            *to++ = '?';
        } else {
            memmove(to, text, (size_t)bytes);
            to += bytes;
        }
        text += bytes;
    }
    *to = '\0';
}
