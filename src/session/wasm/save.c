/* Saving through the host, which offers what it is handed as a file. */
#include "session/save.h"
#include "base/wasm/host.h"

/* Copies the bytes before it returns. */
SKV_HOST(file_write) bool host_file_write(const char *path, const void *bytes, size_t size);

skv_result skv_file_write(const char *path, const void *bytes, size_t size, skv_error *error)
{
    return host_file_write(path, bytes, size)
               ? SKV_OK
               : skv_fail(error, SKV_ERROR_FILE, "there is no place for it");
}
