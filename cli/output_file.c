/* Files that are complete or absent.
 *
 * Invariant: while `target` is set, the data lives in a temporary file of the same folder that
 * cleanup.h knows; rename() is the only way it gets its name.
 */
#define _XOPEN_SOURCE 700 /* realpath */

#include "output_file.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cleanup.h"

static skv_result cannot_write(const char *name, int reason, skv_error *error)
{
    const char *remedy = reason == ENOENT || reason == ENOTDIR ? "name a folder that exists"
                         : reason == EISDIR                    ? "name a file, not a folder"
                         : reason == ENOSPC || reason == EFBIG || reason == EDQUOT
                             ? "make room or write elsewhere"
                             : "name a place that may be written to";
    return skv_fail(error, SKV_ERROR_FILE, "%s: cannot be written: %s; %s",
                    strcmp(name, "-") == 0 ? "standard output" : name, strerror(reason), remedy);
}

/* Where a regular file is or will be, with every link of its folder followed; null with errno if
 * that is not there. The caller frees it. */
static char *resolve(const char *name, bool exists)
{
    char folder[PATH_MAX];
    if (exists)
        return realpath(name, NULL);
    const char *slash = strrchr(name, '/');
    const char *base = slash ? slash + 1 : name;
    size_t length = slash ? (size_t)(base - name) : 0;
    if (length >= sizeof folder) {
        errno = ENAMETOOLONG;
        return NULL;
    }
    memcpy(folder, name, length);
    folder[length] = '\0';
    char *real = realpath(length ? folder : ".", NULL);
    size_t size = real ? strlen(real) + strlen(base) + 2 : 0;
    char *path = real ? malloc(size) : NULL;
    if (path)
        snprintf(path, size, "%s/%s", strcmp(real, "/") == 0 ? "" : real, base);
    int reason = errno;
    free(real);
    errno = reason;
    return path;
}

/* Creates the temporary file beside file->target and opens it; false with errno. */
static bool open_beside(output_file *file)
{
    char folder[PATH_MAX];
    size_t length = (size_t)(strrchr(file->target, '/') - file->target);
    if (length + 1 >= sizeof folder) {
        errno = ENAMETOOLONG;
        return false;
    }
    memcpy(folder, file->target, length);
    folder[length] = '\0';
    int descriptor = cleanup_create_file(folder, &file->slot);
    if (descriptor == -1)
        return false;
    file->stream = fdopen(descriptor, "wb");
    if (!file->stream) {
        int reason = errno;
        close(descriptor);
        unlink(cleanup_path(file->slot));
        cleanup_forget_file(file->slot);
        errno = reason;
        return false;
    }
    return true;
}

skv_result output_file_open(output_file *file, const char *name, skv_error *error)
{
    *file = (output_file){.name = name};
    if (strcmp(name, "-") == 0) {
        file->stream = stdout;
        return SKV_OK;
    }
    struct stat status;
    bool exists = stat(name, &status) == 0;
    if (exists ? S_ISDIR(status.st_mode) : name[strlen(name) - 1] == '/')
        return cannot_write(name, EISDIR, error);
    if (!exists && readlink(name, &(char){0}, 1) != -1)
        return skv_fail(error, SKV_ERROR_FILE,
                        "%s: it is a link that leads nowhere; remove it or name another file",
                        name);
    if (exists && access(name, W_OK) != 0)
        return cannot_write(name, errno, error);
    if (exists && !S_ISREG(status.st_mode)) {
        file->stream = fopen(name, "wb");
        return file->stream ? SKV_OK : cannot_write(name, errno, error);
    }
    file->target = resolve(name, exists);
    if (!file->target || !open_beside(file)) {
        int reason = errno;
        free(file->target);
        *file = (output_file){0};
        return cannot_write(name, reason, error);
    }
    return SKV_OK;
}

bool output_file_same(const output_file *a, const output_file *b)
{
    return a->target && b->target && strcmp(a->target, b->target) == 0;
}

bool output_is_file(const char *name, const char *other)
{
    struct stat a, b;
    return strcmp(name, "-") != 0 && stat(name, &a) == 0 && stat(other, &b) == 0 &&
           a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool output_file_take(const char *text, size_t length, void *file)
{
    return fwrite(text, 1, length, ((output_file *)file)->stream) == length;
}

skv_result output_file_check(output_file *file, skv_error *error)
{
    if (!file->stream)
        return SKV_OK;
    /* A write that failed before has left its reason, a flush that fails now brings one. */
    int reason = ferror(file->stream) ? errno : 0;
    if (fflush(file->stream) != 0)
        reason = errno;
    if (reason || ferror(file->stream))
        return cannot_write(file->name, reason ? reason : EIO, error);
    return SKV_OK;
}

skv_result output_file_commit(output_file *file, skv_error *error)
{
    skv_result result = output_file_check(file, error);
    if (result || !file->stream) {
        output_file_discard(file);
        return result;
    }
    int reason = 0;
    if (file->stream != stdout && fclose(file->stream) != 0)
        reason = errno;
    file->stream = NULL;
    if (!reason && file->target && rename(cleanup_path(file->slot), file->target) != 0)
        reason = errno;
    if (reason) {
        result = cannot_write(file->name, reason, error);
    } else if (file->target) {
        cleanup_forget_file(file->slot);
        free(file->target);
        file->target = NULL;
    }
    output_file_discard(file);
    return result;
}

void output_file_discard(output_file *file)
{
    if (file->stream && file->stream != stdout)
        fclose(file->stream);
    if (file->target) {
        unlink(cleanup_path(file->slot));
        cleanup_forget_file(file->slot);
        free(file->target);
    }
    *file = (output_file){0};
}

skv_result output_folder_make(const char *folder, const char *option, skv_error *error)
{
    struct stat found;
    bool usable = mkdir(folder, 0777) == 0;
    if (!usable && errno == EEXIST && stat(folder, &found) == 0) {
        usable = S_ISDIR(found.st_mode) && access(folder, W_OK | X_OK) == 0;
        errno = S_ISDIR(found.st_mode) ? errno : ENOTDIR;
    }
    if (usable)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_FILE, "%s: %s; name another folder with --%s", folder,
                    strerror(errno), option);
}
