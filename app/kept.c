/* Kept: the numbered places in the user's folder for states where windows keep their worlds.
 * Invariant: only the window that holds the lock of a place, a byte of one file, writes there.
 * Locks go with their process, however it ends, so a world at a place that nobody holds was left
 * behind. Where nothing can be locked, windows share a place.
 */
#include "kept.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <stdbool.h>
#include <stdio.h>
#include <unistd.h>

#define MOST_LEFT 8 /* worlds; of those left behind earlier nobody remembers which is which */

struct PlayKept {
    char *folder, *path;
    int locks; /* the file of locks */
    int own;   /* place */
    GArray *had;
};

typedef struct left {
    int place;
    struct timespec time;
} left;

static char *file_at(const PlayKept *kept, int place, const char *kind)
{
    char *name = g_strdup_printf("kept-%d.%s", place, kind);
    char *path = g_build_filename(kept->folder, name, NULL);
    g_free(name);
    return path;
}

char *play_kept_path_at(const PlayKept *kept, int place)
{
    return file_at(kept, place, "skv");
}

static bool lock(const PlayKept *kept, int place, short type)
{
    struct flock byte = {.l_type = type, .l_whence = SEEK_SET, .l_start = place, .l_len = 1};
    return fcntl(kept->locks, F_SETLK, &byte) == 0 || (errno != EACCES && errno != EAGAIN);
}

gboolean play_kept_hold(const PlayKept *kept, int place)
{
    return lock(kept, place, F_WRLCK);
}

/* What was left behind. */

static bool was_had(const PlayKept *kept, int place)
{
    for (guint i = 0; i < kept->had->len; i++)
        if (g_array_index(kept->had, int, i) == place)
            return true;
    return false;
}

static gint newest_first(gconstpointer a, gconstpointer b)
{
    const struct timespec *one = &((const left *)a)->time, *other = &((const left *)b)->time;
    if (one->tv_sec != other->tv_sec)
        return one->tv_sec < other->tv_sec ? 1 : -1;
    return one->tv_nsec < other->tv_nsec ? 1 : one->tv_nsec > other->tv_nsec ? -1 : 0;
}

/* All that nobody holds, but what this window has had. */
static GArray *find_left(const PlayKept *kept)
{
    GArray *found = g_array_new(FALSE, FALSE, sizeof(left));
    GDir *folder = g_dir_open(kept->folder, 0, NULL);
    const char *name;
    while (folder && (name = g_dir_read_name(folder))) {
        left one = {0};
        char more, *path = g_build_filename(kept->folder, name, NULL);
        struct stat about;
        if (sscanf(name, "kept-%9d.sk%c", &one.place, &more) == 2 &&
            g_str_has_suffix(name, ".skv") && one.place != kept->own && !was_had(kept, one.place) &&
            g_stat(path, &about) == 0 && lock(kept, one.place, F_WRLCK)) {
            lock(kept, one.place, F_UNLCK);
            one.time = about.st_mtim;
            g_array_append_val(found, one);
        }
        g_free(path);
    }
    if (folder)
        g_dir_close(folder);
    g_array_sort(found, newest_first);
    return found;
}

int play_kept_left(const PlayKept *kept)
{
    GArray *found = find_left(kept);
    int place = found->len > 0 ? g_array_index(found, left, 0).place : 0;
    g_array_free(found, TRUE);
    return place;
}

static void forget(const PlayKept *kept, int place)
{
    if (!play_kept_hold(kept, place))
        return;
    char *path = play_kept_path_at(kept, place), *title = file_at(kept, place, "title");
    g_remove(path);
    g_remove(title);
    lock(kept, place, F_UNLCK);
    g_free(path);
    g_free(title);
}

static void tidy(const PlayKept *kept)
{
    GArray *found = find_left(kept);
    for (guint i = MOST_LEFT; i < found->len; i++)
        forget(kept, g_array_index(found, left, i).place);
    g_array_free(found, TRUE);
}

/* The window's own place. */

const char *play_kept_path(const PlayKept *kept)
{
    return kept->path;
}

static void settle_at(PlayKept *kept, int place)
{
    kept->own = place;
    g_free(kept->path);
    kept->path = play_kept_path_at(kept, place);
}

PlayKept *play_kept_new(void)
{
    PlayKept *kept = g_new0(PlayKept, 1);
    kept->folder = g_build_filename(g_get_user_state_dir(), "skvalp", NULL);
    kept->had = g_array_new(FALSE, FALSE, sizeof(int));
    g_mkdir_with_parents(kept->folder, 0700);
    char *locks = g_build_filename(kept->folder, "kept.lock", NULL);
    kept->locks = g_open(locks, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    g_free(locks);
    tidy(kept);
    for (int place = 1; kept->own == 0; place++) {
        if (!play_kept_hold(kept, place))
            continue;
        settle_at(kept, place);
        if (g_file_test(kept->path, G_FILE_TEST_EXISTS)) {
            kept->own = 0;
            lock(kept, place, F_UNLCK);
        }
    }
    return kept;
}

void play_kept_free(PlayKept *kept)
{
    if (kept->locks >= 0)
        close(kept->locks);
    g_array_free(kept->had, TRUE);
    g_free(kept->folder);
    g_free(kept->path);
    g_free(kept);
}

void play_kept_move(PlayKept *kept, int place)
{
    lock(kept, kept->own, F_UNLCK);
    settle_at(kept, place);
    g_array_append_val(kept->had, place);
}

/* Titles. */

void play_kept_name(const PlayKept *kept, const char *title)
{
    char *path = file_at(kept, kept->own, "title");
    g_file_set_contents(path, title, -1, NULL);
    g_free(path);
}

char *play_kept_title_at(const PlayKept *kept, int place)
{
    char *path = file_at(kept, place, "title"), *title = NULL;
    g_file_get_contents(path, &title, NULL, NULL);
    g_free(path);
    return title ? title : g_strdup("");
}

char *play_kept_set_aside(const PlayKept *kept, int place)
{
    char *path = play_kept_path_at(kept, place);
    char *aside = g_build_filename(kept->folder, "damaged.skv", NULL);
    g_rename(path, aside);
    forget(kept, place);
    g_free(path);
    return aside;
}
