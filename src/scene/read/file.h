/* Whole files into memory: native/ reads them from the system, wasm/ gets them from the host. */
#ifndef SKV_SCENE_FILE_H
#define SKV_SCENE_FILE_H

#include "skvalp/base.h"

#define SKV_MAX_FILE (64 * 1024 * 1024) /* of a scene */

/* Reads a regular file of at most `most` bytes. `*data` is freed with skv_free; it is never null on
 * success, even if the file is empty. */
skv_result skv_file_read(const char *path, size_t most, uint8_t **data, size_t *size,
                         skv_error *error);

#endif
