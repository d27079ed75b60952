/* Logs packed, as replays and links hold them: a quarter of their bytes. */
#ifndef SKV_SESSION_PACKED_LOG_H
#define SKV_SESSION_PACKED_LOG_H

#include "session/log.h"

/* What pointers, speeds and gravity are rounded to, so that they pack well: steps that nobody sees
 * (docs/stage.md). */
typedef struct skv_steps {
    double length;   /* m: a power of two, below 1/4096 of the world's longer side */
    double speed;    /* m/s: about one such step a frame */
    double strength; /* m/s^2, of the gravity of the world's start */
    double gravity;  /* m/s^2 */
} skv_steps;

/* Of a world at its start. */
skv_steps skv_steps_of(const skv_world *world);

double skv_in_steps(double value, double unit);

/* Null if memory is out; else the caller's, to be freed. */
uint8_t *skv_log_pack(const skv_log *log, const skv_steps *steps, size_t *size);

/* Appends what packed bytes hold, whoever wrote them, checks if they are wanted. SKV_ERROR_FORMAT
 * if that is no log of so many frames, SKV_ERROR_LIMIT if it is longer than any person's game. */
skv_result skv_log_unpack(skv_log *log, const uint8_t *bytes, size_t size, int64_t frames,
                          bool checks, skv_error *error);

#endif
