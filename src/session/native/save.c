/* Saving to the system's files. Invariant: what is written bears another name until it is complete,
 * and is gone if it never is. */
#include "session/save.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"

static skv_result fail(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_FILE, "%s", strerror(errno));
}

static skv_result write_part(const char *part, const void *bytes, size_t size, skv_error *error)
{
    FILE *file = fopen(part, "wb");
    if (!file)
        return fail(error);
    skv_result result = fwrite(bytes, 1, size, file) == size ? SKV_OK : fail(error);
    if (fclose(file) != 0 && result == SKV_OK)
        result = fail(error);
    return result;
}

skv_result skv_file_write(const char *path, const void *bytes, size_t size, skv_error *error)
{
    size_t room = strlen(path) + sizeof ".part";
    char *part = skv_calloc(room, 1);
    if (!part)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory");
    skv_format(part, room, "%s.part", path);
    skv_result result = write_part(part, bytes, size, error);
    if (result == SKV_OK && rename(part, path) != 0)
        result = fail(error);
    if (result != SKV_OK)
        unlink(part);
    skv_free(part);
    return result;
}
