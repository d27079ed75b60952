/* Result codes and one-line messages. Invariant: a message never holds a control character. */
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

skv_result skv_fail(skv_error *error, skv_result code, const char *format, ...)
{
    if (!error)
        return code;
    va_list arguments;
    va_start(arguments, format);
    skv_format_list(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    error->code = code;
    for (char *c = error->text; *c; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
    }
    return code;
}
