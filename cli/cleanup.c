/* Ends the program tidily on a signal, at once, whatever it is doing.
 *
 * Invariant: everything the handler reads is static and is complete before the flag that announces
 * it is set; the handler itself calls async-signal-safe functions only. Ending inside the handler,
 * instead of setting a flag for the loop to find, keeps Ctrl-C instant in a step that takes long.
 */
#include "cleanup.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SLOTS = 8 };

/* What names of temporary files begin with, before mkstemp's letters. */
#define PREFIX "/.skvalp-"

static struct {
    volatile sig_atomic_t used;
    char path[PATH_MAX];
    int lock; /* a descriptor that keeps the file locked until it bears another name */
} files[SLOTS];

static volatile sig_atomic_t child_process;
static volatile sig_atomic_t line_shown;

static void stop(int signal_number)
{
    if (child_process > 0) {
        /* Wait for its end, or it could create the file anew after it was unlinked. */
        kill(child_process, SIGKILL);
        while (waitpid(child_process, NULL, 0) == -1 && errno == EINTR) {
        }
    }
    for (int i = 0; i < SLOTS; i++)
        if (files[i].used)
            unlink(files[i].path);
    if (line_shown) {
        char blank[CLEANUP_LINE + 2];
        blank[0] = blank[CLEANUP_LINE + 1] = '\r';
        for (int i = 1; i <= CLEANUP_LINE; i++)
            blank[i] = ' ';
        ssize_t ignored = write(STDERR_FILENO, blank, sizeof blank);
        (void)ignored;
    }
    _exit(128 + signal_number);
}

void cleanup_install(void)
{
    /* SIGINT is taken even where it was ignored: a script's background job starts that way, and an
     * explicit `kill -INT` should still stop it. nohup's SIGHUP stays ignored. */
    static const int signals[] = {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGXCPU};
    struct sigaction action = {.sa_handler = stop}, old;
    sigfillset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        if (signals[i] == SIGHUP && sigaction(SIGHUP, NULL, &old) == 0 && old.sa_handler == SIG_IGN)
            continue;
        sigaction(signals[i], &action, NULL);
    }
    /* Beyond the largest size allowed for files a write then fails, which is told and tidied up. */
    action = (struct sigaction){.sa_handler = SIG_IGN};
    sigaction(SIGXFSZ, &action, NULL);
}

/* Removes a file of ours that no program holds any more. */
static void sweep_file(const char *path)
{
    struct stat status;
    int descriptor = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor == -1)
        return;
    bool ours =
        fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
    if (ours && flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        unlink(path);
    close(descriptor);
}

static void sweep(const char *folder)
{
    const size_t prefix = sizeof PREFIX - 2, letters = sizeof "XXXXXX" - 1;
    DIR *list = opendir(folder);
    for (struct dirent *entry; list && (entry = readdir(list));) {
        char path[PATH_MAX];
        if (strncmp(entry->d_name, &PREFIX[1], prefix) == 0 &&
            strlen(entry->d_name) == prefix + letters &&
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) < PATH_MAX)
            sweep_file(path);
    }
    if (list)
        closedir(list);
}

/* Makes a file's name and the file, locked. Somebody who swept between the two has removed it:
 * again. */
static int create_locked(char *path, const char *folder)
{
    for (;;) {
        struct stat status;
        snprintf(path, PATH_MAX, "%s" PREFIX "XXXXXX", folder);
        int descriptor = mkstemp(path);
        if (descriptor == -1)
            return -1;
        flock(descriptor, LOCK_SH); /* where there are no locks, nobody sweeps either */
        if (fstat(descriptor, &status) == 0 && status.st_nlink > 0)
            return descriptor;
        close(descriptor);
    }
}

int cleanup_create_file(const char *folder, int *slot)
{
    *slot = 0;
    while (*slot < SLOTS && files[*slot].used)
        ++*slot;
    if (*slot == SLOTS) {
        errno = EMFILE;
        return -1;
    }
    char *path = files[*slot].path;
    if (strlen(folder) + sizeof PREFIX "XXXXXX" > PATH_MAX) {
        errno = ENAMETOOLONG;
        return -1;
    }
    sweep(folder);
    /* No signal between the file's creation and its flag. */
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    int descriptor = create_locked(path, folder);
    int reason = errno;
    files[*slot].used = descriptor != -1;
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (descriptor != -1) {
        /* mkstemp makes private files; ours get the mode that any new file would have. */
        mode_t mask = umask(0);
        umask(mask);
        fchmod(descriptor, 0666 & ~mask);
        fcntl(descriptor, F_SETFD, FD_CLOEXEC);
        files[*slot].lock = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    }
    errno = reason;
    return descriptor;
}

const char *cleanup_path(int slot)
{
    return files[slot].path;
}

void cleanup_forget_file(int slot)
{
    files[slot].used = 0;
    if (files[slot].lock != -1)
        close(files[slot].lock);
}

void cleanup_set_child(pid_t child)
{
    child_process = (sig_atomic_t)child;
}

void cleanup_set_line(bool shown)
{
    line_shown = shown;
}
