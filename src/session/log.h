/* The log of a player: commands with the frames before which they were given, as bytes. */
#ifndef SKV_SESSION_LOG_H
#define SKV_SESSION_LOG_H

#include "session/command.h"

typedef struct skv_log {
    uint8_t *bytes;
    size_t size, capacity;
} skv_log;

/* A place in a played log: so many frames were stepped, and the records before `at` given. */
typedef struct skv_position {
    int64_t frame;
    size_t at;
} skv_position;

static inline bool skv_before(skv_position a, skv_position b)
{
    return a.frame < b.frame || (a.frame == b.frame && a.at < b.at);
}

/* Appends a record: `u32` frame and the command. Nothing changes on failure. */
skv_result skv_log_append(skv_log *log, int64_t frame, const skv_command *command,
                          skv_error *error);
/* Appends records as they are. */
skv_result skv_log_append_bytes(skv_log *log, const uint8_t *bytes, size_t size, skv_error *error);

/* The frame of the record at `at`; -1 at the end. */
int64_t skv_log_frame(const skv_log *log, size_t at);

/* Reads the record at `at`; returns where the next one begins, or 0 if there is none. */
size_t skv_log_read(const skv_log *log, size_t at, skv_command *command);

#endif
