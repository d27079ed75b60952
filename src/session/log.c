/* Logs as bytes. Invariant: a log holds whole records whose frames do not descend. */
#include "session/log.h"

#include "base/memory.h"

#include <string.h>

static skv_result reserve(skv_log *log, size_t more, skv_error *error)
{
    size_t wanted = log->size + more;
    if (wanted <= log->capacity)
        return SKV_OK;
    size_t capacity = wanted > 2 * log->capacity ? wanted : 2 * log->capacity;
    capacity = capacity < 4096 ? 4096 : capacity;
    uint8_t *bytes = skv_calloc(capacity, 1);
    if (!bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a log of %zu bytes", wanted);
    if (log->size)
        memcpy(bytes, log->bytes, log->size);
    skv_free(log->bytes);
    log->bytes = bytes;
    log->capacity = capacity;
    return SKV_OK;
}

skv_result skv_log_append(skv_log *log, int64_t frame, const skv_command *command, skv_error *error)
{
    skv_writer count = {NULL, 4};
    skv_command_encode(command, &count);
    skv_result result = reserve(log, count.used, error);
    if (result != SKV_OK)
        return result;
    skv_writer writer = {log->bytes, log->size};
    skv_put(&writer, (uint64_t)frame, 4);
    skv_command_encode(command, &writer);
    log->size = writer.used;
    return SKV_OK;
}

skv_result skv_log_append_bytes(skv_log *log, const uint8_t *bytes, size_t size, skv_error *error)
{
    skv_result result = size ? reserve(log, size, error) : SKV_OK;
    if (result == SKV_OK && size) {
        memcpy(log->bytes + log->size, bytes, size);
        log->size += size;
    }
    return result;
}

int64_t skv_log_frame(const skv_log *log, size_t at)
{
    skv_reader reader = {.bytes = log->bytes, .size = log->size, .at = at};
    int64_t frame = at < log->size ? (int64_t)skv_get(&reader, 4) : -1;
    return reader.failed ? -1 : frame;
}

size_t skv_log_read(const skv_log *log, size_t at, skv_command *command)
{
    if (at >= log->size)
        return 0;
    skv_reader reader = {.bytes = log->bytes, .size = log->size, .at = at};
    skv_get(&reader, 4);
    return skv_command_decode(command, &reader) ? reader.at : 0;
}
