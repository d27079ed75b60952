/* Runs the real skvalp, and other programs, from a test. */
#ifndef TESTS_CLI_PROGRAM_H
#define TESTS_CLI_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

typedef struct program_result {
    int status; /* exit status, or -signal */
    char *out;  /* all of stdout, zero-terminated; owned */
    char *err;  /* all of stderr, likewise */
    size_t out_size;
} program_result;

/* Runs a program to its end, without a shell, in `folder` (null: here). arguments[0] "skvalp" is
 * the program of this build; the list ends with null. */
program_result program_run(const char *folder, const char *const *arguments);

/* The same for skvalp with the arguments written out: SKVALP(folder, "run", "pool"). */
#define SKVALP(folder, ...)                                                                        \
    program_run((folder), (const char *const[]){"skvalp", __VA_ARGS__, NULL})

void program_free(program_result *result);

/* Starts skvalp in a process group of its own, as a shell with a terminal does, and returns at
 * once; its output goes to /dev/null. */
pid_t program_start(const char *folder, const char *const *arguments);
/* Waits for its end; exit status, or -signal. */
int program_wait(pid_t pid);

/* A fresh folder under the system's place for temporary files; setup and teardown of cmocka. */
int folder_setup(void **state);
int folder_teardown(void **state);

/* Number of entries of a folder, hidden ones included. */
int folder_entries(const char *folder);
/* Waits until there are so many or more. */
void folder_await(const char *folder, int entries);
bool file_exists(const char *folder, const char *name);
/* A whole file, zero-terminated; null if it is not there. Owned by the caller. */
char *file_read(const char *folder, const char *name);
void file_write(const char *folder, const char *name, const char *text);

int count_lines(const char *text);

#endif
