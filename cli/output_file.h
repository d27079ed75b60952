/* A file that appears under its name only when it is complete. */
#ifndef CLI_OUTPUT_FILE_H
#define CLI_OUTPUT_FILE_H

#include <stdio.h>

#include "skvalp/base.h"

/* All zero is a file that is not wanted; every function below accepts it. */
typedef struct output_file {
    const char *name; /* as the user wrote it */
    FILE *stream;
    char *target; /* what the temporary file becomes; null if it is written directly */
    int slot;     /* of cleanup.h, if target is not null */
} output_file;

/* Opens `name` for writing: a temporary file beside it, or, for "-" and for what is no regular
 * file (/dev/null, a pipe), the thing itself. Fails where the final rename could not succeed. */
skv_result output_file_open(output_file *file, const char *name, skv_error *error);

/* Whether two files would end under the same name. */
bool output_file_same(const output_file *a, const output_file *b);

/* Whether writing to `name` would replace the file `other`: links lead to the same one, too. */
bool output_is_file(const char *name, const char *other);

/* An skv_write into an output_file that is open; what fails is told by the next two. */
bool output_file_take(const char *text, size_t length, void *file);

/* Fails if anything written so far got lost, with the system's reason. */
skv_result output_file_check(output_file *file, skv_error *error);

/* Closes the file and gives it its name. On failure nothing is left. */
skv_result output_file_commit(output_file *file, skv_error *error);

/* Closes and removes what was written. */
void output_file_discard(output_file *file);

/* Makes a folder, or makes sure that files can be written into the one that is there; `option` is
 * the one that named it. */
skv_result output_folder_make(const char *folder, const char *option, skv_error *error);

#endif
