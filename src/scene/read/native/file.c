/* Whole files into memory.
 *
 * Invariant: what is no regular file (a directory, a pipe, a device) is refused before it is
 * opened, and no more is read than the size that was found and allowed.
 */
#include "scene/read/file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"

/* What could help where a file cannot be opened. */
static const char *remedy(int cause)
{
    return cause == ENOENT || cause == ENOTDIR ? "check the name and the folder"
           : cause == EACCES                   ? "allow reading it, or copy it"
                                               : "name another file";
}

static skv_result fail_to_open(const char *path, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_FILE, "%s: cannot be opened: %s; %s", path, strerror(errno),
                    remedy(errno));
}

static skv_result read_open(FILE *file, const char *path, size_t size, uint8_t **data,
                            skv_error *error)
{
    uint8_t *bytes = skv_calloc(size + 1, 1);
    if (bytes == NULL)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", path);
    if (fread(bytes, 1, size, file) != size) {
        skv_free(bytes);
        return skv_fail(error, SKV_ERROR_FILE, "%s: cannot be read: %s; try again, or copy it",
                        path, ferror(file) ? strerror(errno) : "it became shorter");
    }
    *data = bytes;
    return SKV_OK;
}

skv_result skv_file_read(const char *path, size_t most, uint8_t **data, size_t *size,
                         skv_error *error)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return fail_to_open(path, error);
    if (S_ISDIR(status.st_mode))
        return skv_fail(error, SKV_ERROR_FILE, "%s: is a directory; a file is needed", path);
    if (!S_ISREG(status.st_mode))
        return skv_fail(error, SKV_ERROR_FILE,
                        "%s: is not a regular file; copy what it holds into one", path);
    if (status.st_size > (long long)most)
        return skv_fail(error, SKV_ERROR_LIMIT, "%s: has %lld bytes; allowed are %zu", path,
                        (long long)status.st_size, most);
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return fail_to_open(path, error);
    *size = (size_t)status.st_size;
    skv_result result = read_open(file, path, *size, data, error);
    fclose(file);
    return result;
}
