/* Whole files out of memory: native/ writes them, wasm/ hands them to the host. */
#ifndef SKV_SESSION_SAVE_H
#define SKV_SESSION_SAVE_H

#include "skvalp/base.h"

/* Writes a file, which appears when it is complete. The message is the cause alone. */
skv_result skv_file_write(const char *path, const void *bytes, size_t size, skv_error *error);

#endif
