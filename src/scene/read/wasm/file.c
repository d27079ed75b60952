/* Files that the host has at hand: those that were dropped on a page, or a program's own. */
#include "scene/read/file.h"
#include "base/memory.h"
#include "base/wasm/host.h"

/* Its size; negative if there is no such file. */
SKV_HOST(file_size) double host_file_size(const char *path);
SKV_HOST(file_read) bool host_file_read(const char *path, uint8_t *to, size_t size);

skv_result skv_file_read(const char *path, size_t most, uint8_t **data, size_t *size,
                         skv_error *error)
{
    double found = host_file_size(path);
    if (found < 0)
        return skv_fail(error, SKV_ERROR_FILE,
                        "%s: cannot be opened: No such file or directory; check the name and the "
                        "folder",
                        path);
    if (found > (double)most)
        return skv_fail(error, SKV_ERROR_LIMIT, "%s: has %.0f bytes; allowed are %zu", path, found,
                        most);
    *size = (size_t)found;
    *data = skv_calloc(*size + 1, 1);
    if (!*data)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", path);
    if (host_file_read(path, *data, *size))
        return SKV_OK;
    skv_free(*data);
    *data = NULL;
    return skv_fail(error, SKV_ERROR_FILE, "%s: cannot be read; try again, or copy it", path);
}
