/* What must not be left behind when the program is stopped: half-written files, ffmpeg, and the
 * progress line. */
#ifndef CLI_CLEANUP_H
#define CLI_CLEANUP_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* From here on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXCPU tidy up and end the program with 128 +
 * signal, and a file that grows beyond its limit is an error instead of a signal. */
void cleanup_install(void);

/* Creates an empty temporary file in `folder` and remembers it. Returns its descriptor, or -1 with
 * errno; *slot names it in the calls below. What programs that were killed have left there goes: a
 * file is locked as long as its program lives. */
int cleanup_create_file(const char *folder, int *slot);
const char *cleanup_path(int slot);
/* Forgets a file that has been renamed or unlinked. */
void cleanup_forget_file(int slot);

/* A process to be killed; 0 for none. */
void cleanup_set_child(pid_t child);

/* Whether a progress line of at most CLEANUP_LINE columns stands on stderr. */
#define CLEANUP_LINE 78
void cleanup_set_line(bool shown);

#endif
