/* Result codes and one-line messages. Invariant: a message is plain (plain.c). */
#include "skvalp/base.h"

#define TEXT_OF(number)  #number
#define VERSION(a, b, c) TEXT_OF(a) "." TEXT_OF(b) "." TEXT_OF(c)

const char *skv_version(void)
{
    return VERSION(SKV_VERSION_MAJOR, SKV_VERSION_MINOR, SKV_VERSION_PATCH);
}

const char *skv_result_text(skv_result result)
{
    switch (result) {
    case SKV_OK:
        return "done";
    case SKV_ERROR_MEMORY:
        return "out of memory";
    case SKV_ERROR_FILE:
        return "file error";
    case SKV_ERROR_FORMAT:
        return "bad format";
    case SKV_ERROR_VALUE:
        return "bad value";
    case SKV_ERROR_LIMIT:
        return "limit exceeded";
    case SKV_ERROR_DEVICE:
        return "device not available";
    case SKV_STOPPED:
        return "stopped";
    }
    return "unknown result";
}

/* A word longer than LONGEST_WORD, a hostile file's name for example, keeps its two ends: what
 * comes after it in a message must not get lost. */
enum { LONGEST_MESSAGE = 6000, LONGEST_WORD = 160, HEAD = 80, TAIL = 60 };

/* The bytes of a character of UTF-8 that stand after its first one. */
static bool is_continuation(char c)
{
    return ((unsigned char)c & 0xC0) == 0x80;
}

typedef struct line {
    char *text;
    size_t room, used;
} line;

static void append(line *l, const char *text, size_t length)
{
    for (size_t i = 0; i < length && l->used + 1 < l->room; i++)
        l->text[l->used++] = text[i];
    l->text[l->used] = '\0';
}

static void shorten(const char *from, char *to, size_t room)
{
    line l = {.text = to, .room = room};
    append(&l, "", 0);
    while (*from) {
        size_t length = 0;
        while (from[length] && from[length] != ' ')
            length++;
        const char *end = from + length;
        if (length > LONGEST_WORD) {
            size_t head = HEAD;
            while (is_continuation(from[head]))
                head--;
            append(&l, from, head);
            append(&l, "...", 3);
            from = end - TAIL;
            while (is_continuation(*from))
                from++;
        }
        append(&l, from, (size_t)(end - from) + (*end == ' '));
        from = end + (*end == ' ');
    }
}

skv_result skv_fail(skv_error *error, skv_result code, const char *format, ...)
{
    if (!error)
        return code;
    va_list arguments;
    va_start(arguments, format);
    char whole[LONGEST_MESSAGE];
    skv_format_list(whole, sizeof whole, format, arguments);
    va_end(arguments);
    shorten(whole, error->text, sizeof error->text);
    /* Last of all: what was cut may end within a character. */
    skv_make_plain(error->text);
    error->code = code;
    return code;
}
