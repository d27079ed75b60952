/* Saving: words about files, and windows that wait for theirs. Invariant: each file that was asked
 * for is told about once, and a window goes only when all of its files are written or given up. */
#include "saving.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <stdio.h>

#include "words.h"

typedef struct request {
    char *path;
    PlaySaved *done;
    gpointer data;
} request;

typedef struct saving {
    GQueue *asked; /* requests: the stage answers in their order */
    int held;
    bool closed; /* the window, by a person */
} saving;

static saving *saving_of(PlayWindow *window)
{
    return g_object_get_data(G_OBJECT(window), "saving");
}

/* Words. */

void play_saving_tell(PlayWindow *window, const char *path, const char *cause)
{
    char *name = g_filename_display_basename(path);
    char *text =
        cause
            /* Translators: a file, and what the system says: "No space left on device". */
            ? g_strdup_printf(_("%s was not saved: %s. Choose another place."), name, cause)
            : g_strdup_printf(_("%s was saved"), name);
    if (cause)
        play_window_complain(window, text);
    else
        play_window_toast(window, text);
    g_free(text);
    g_free(name);
}

/* Writing. */

static int write_part(const char *part, const void *bytes, gsize size)
{
    FILE *file = g_fopen(part, "wb");
    if (!file)
        return errno;
    int cause = fwrite(bytes, 1, size, file) == size ? 0 : errno;
    return fclose(file) != 0 && cause == 0 ? errno : cause;
}

const char *play_saving_write(const char *path, const void *bytes, gsize size)
{
    char *part = g_strconcat(path, ".part", NULL);
    int cause = write_part(part, bytes, size);
    if (cause == 0 && g_rename(part, path) != 0)
        cause = errno;
    if (cause != 0)
        g_remove(part);
    g_free(part);
    return cause == 0 ? NULL : g_strerror(cause);
}

gboolean play_saving_open(PlayWindow *window, const char *path, const char *title)
{
    char *bytes;
    gsize size;
    GError *error = NULL;
    if (!g_file_get_contents(path, &bytes, &size, &error)) {
        play_window_complain(window, error->message);
        g_error_free(error);
        return FALSE;
    }
    skv_stage_open_memory(play_view_stage(play_window_view(window)), bytes, size, "skv", title,
                          NULL);
    g_free(bytes);
    return TRUE;
}

/* Asking the stage. */

static void on_saved(G_GNUC_UNUSED PlayView *view, const char *cause, PlayWindow *window)
{
    request *answered = g_queue_pop_head(saving_of(window)->asked);
    if (!answered)
        return;
    answered->done(window, answered->path, cause, answered->data);
    g_free(answered->path);
    g_free(answered);
}

void play_saving_ask(PlayWindow *window, const char *path, PlaySaved *done, gpointer data)
{
    request *asked = g_new(request, 1);
    *asked = (request){g_strdup(path), done, data};
    g_queue_push_tail(saving_of(window)->asked, asked);
    skv_stage_save(play_view_stage(play_window_view(window)), path);
}

/* Closing. */

void play_saving_hold(PlayWindow *window)
{
    saving_of(window)->held++;
}

/* Not within the view's news, which it would take along. */
static gboolean destroy(gpointer window)
{
    gtk_window_destroy(window);
    return G_SOURCE_REMOVE;
}

void play_saving_release(PlayWindow *window)
{
    saving *s = saving_of(window);
    if (--s->held == 0 && s->closed)
        g_idle_add_full(G_PRIORITY_DEFAULT, destroy, g_object_ref(window), g_object_unref);
}

static gboolean on_close(PlayWindow *window)
{
    saving *s = saving_of(window);
    s->closed = true;
    if (s->held == 0)
        return GDK_EVENT_PROPAGATE;
    gtk_widget_set_visible(GTK_WIDGET(window), FALSE);
    return GDK_EVENT_STOP;
}

static void free_saving(gpointer data)
{
    saving *s = data;
    request *asked;
    while ((asked = g_queue_pop_head(s->asked))) {
        g_free(asked->path);
        g_free(asked);
    }
    g_queue_free(s->asked);
    g_free(s);
}

/* After what others do when the window closes: some of that is saving. */
void play_saving_add(PlayWindow *window)
{
    saving *s = g_new0(saving, 1);
    s->asked = g_queue_new();
    g_object_set_data_full(G_OBJECT(window), "saving", s, free_saving);
    g_signal_connect_object(play_window_view(window), "saved", G_CALLBACK(on_saved), window, 0);
    g_signal_connect_after(window, "close-request", G_CALLBACK(on_close), NULL);
}
