/* Files: what is opened and written. Invariant: a dialog that is closed, and a file that cannot be
 * written, change nothing; whatever failed is said in the window. */
#include "files.h"

#include <glib/gstdio.h>
#include <string.h>

#include "dialogs.h"
#include "recorder.h"
#include "saving.h"
#include "settings.h"
#include "words.h"

#define VIDEO_SECONDS 10.0
#define MOST_RECENT   6

/* Dialogs. */

typedef void use_path(PlayWindow *window, const char *path);

typedef struct question {
    PlayWindow *window;
    use_path *use;
} question;

static void on_answer(GtkNativeDialog *dialog, int response, question *asked)
{
    if (response == GTK_RESPONSE_ACCEPT) {
        char *path = play_chosen_path(dialog);
        if (path)
            asked->use(asked->window, path);
        else
            play_window_complain(asked->window,
                                 _("This place is not on this computer: choose another one."));
        g_free(path);
    }
    g_free(asked);
    g_object_unref(dialog);
}

static GtkFileChooser *ask(PlayWindow *window, const char *title, const char *name, use_path *use)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(
        title, GTK_WINDOW(window),
        name ? GTK_FILE_CHOOSER_ACTION_SAVE : GTK_FILE_CHOOSER_ACTION_OPEN,
        name ? _("_Save") : _("_Open"), _("_Cancel"));
    question *asked = g_new(question, 1);
    *asked = (question){window, use};
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    if (name)
        gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), name);
    g_signal_connect(dialog, "response", G_CALLBACK(on_answer), asked);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
    return GTK_FILE_CHOOSER(dialog);
}

static void add_filter(GtkFileChooser *chooser, const char *name, const char *const *suffixes)
{
    GtkFileFilter *filter = gtk_file_filter_new();
    gtk_file_filter_set_name(filter, name);
    for (int i = 0; suffixes[i]; i++)
        gtk_file_filter_add_suffix(filter, suffixes[i]);
    gtk_file_chooser_add_filter(chooser, filter);
    g_object_unref(filter);
}

/* "dam-break.png" of what is open. To be freed. */
static char *name_with(PlayWindow *window, const char *suffix)
{
    const skv_picture *picture = play_view_picture(play_window_view(window));
    char *base = g_path_get_basename(*picture->name ? picture->name : "skvalp");
    char *dot = strrchr(base, '.');
    if (dot)
        *dot = '\0';
    char *name = g_strconcat(base, suffix, NULL);
    g_free(base);
    return name;
}

/* Opening. */

static void on_open(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer window)
{
    GtkFileChooser *chooser = ask(window, _("Open a Scene or a Picture"), NULL, play_window_open);
    add_filter(chooser, _("All that can be opened"),
               (const char *const[]){"json", "png", "skv", "skvr", NULL});
    add_filter(chooser, _("Scenes (JSON)"), (const char *const[]){"json", NULL});
    add_filter(chooser, _("Pictures (PNG)"), (const char *const[]){"png", NULL});
    add_filter(chooser, _("Saved states and replays"), (const char *const[]){"skv", "skvr", NULL});
}

static void on_open_scene(G_GNUC_UNUSED GSimpleAction *action, GVariant *name, gpointer window)
{
    play_window_open(window, g_variant_get_string(name, NULL));
}

static void on_open_uri(G_GNUC_UNUSED GSimpleAction *action, GVariant *uri, gpointer window)
{
    GFile *file = g_file_new_for_uri(g_variant_get_string(uri, NULL));
    play_window_open_file(window, file);
    g_object_unref(file);
}

/* What was opened lately: the settings hold their URIs, the last first, a line each. */

static void fill_recent(GMenu *section)
{
    char *kept = play_settings_text("recent", ""), **uris = g_strsplit(kept, "\n", -1);
    g_menu_remove_all(section);
    for (int i = 0; uris[i] && *uris[i]; i++) {
        GFile *file = g_file_new_for_uri(uris[i]);
        char *name = g_file_get_basename(file), *label = g_strdelimit(g_strdup(name), "_", ' ');
        GMenuItem *item = g_menu_item_new(label, NULL);
        g_menu_item_set_action_and_target(item, "win.open-uri", "s", uris[i]);
        g_menu_append_item(section, item);
        g_object_unref(item);
        g_free(label);
        g_free(name);
        g_object_unref(file);
    }
    g_strfreev(uris);
    g_free(kept);
}

static void remember(const char *uri)
{
    char *kept = play_settings_text("recent", ""), **uris = g_strsplit(kept, "\n", -1);
    GString *list = g_string_new(uri);
    int count = 1;
    for (int i = 0; uris[i] && count < MOST_RECENT; i++)
        if (*uris[i] && !g_str_equal(uris[i], uri)) {
            g_string_append_printf(list, "\n%s", uris[i]);
            count++;
        }
    play_settings_set_text("recent", list->str);
    g_string_free(list, TRUE);
    g_strfreev(uris);
    g_free(kept);
}

/* A scene that is a file has one; a built-in one has none. */
static void on_opened(PlayView *view, GMenu *section)
{
    const skv_picture *picture = play_view_picture(view);
    const char *path = picture->scene ? skv_scene_file(picture->scene, 0) : picture->name;
    if (path && g_file_test(path, G_FILE_TEST_IS_REGULAR)) {
        GFile *file = g_file_new_for_path(path);
        char *uri = g_file_get_uri(file);
        remember(uri);
        g_free(uri);
        g_object_unref(file);
    }
    fill_recent(section);
}

void play_files_show_recent(PlayWindow *window, GMenu *section)
{
    fill_recent(section);
    g_signal_connect_object(play_window_view(window), "opened", G_CALLBACK(on_opened), section, 0);
}

/* Saving. */

static void on_saved(PlayWindow *window, const char *path, const char *cause,
                     G_GNUC_UNUSED gpointer data)
{
    play_saving_tell(window, path, cause);
    play_saving_release(window);
}

static void save(PlayWindow *window, const char *path)
{
    bool known = g_str_has_suffix(path, ".skv") || g_str_has_suffix(path, ".skvr");
    char *whole = known ? g_strdup(path) : g_strconcat(path, ".skvr", NULL);
    play_saving_hold(window);
    play_saving_ask(window, whole, on_saved, NULL);
    g_free(whole);
}

static void on_save(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer window)
{
    char *name = name_with(window, ".skvr");
    GtkFileChooser *chooser = ask(window, _("Save What Happened"), name, save);
    add_filter(chooser, _("Replays: all from the start"), (const char *const[]){"skvr", NULL});
    add_filter(chooser, _("States: this moment alone"), (const char *const[]){"skv", NULL});
    g_free(name);
}

/* The picture as it is shown, with all that lies over it; NULL when none is drawn. */
static GskRenderNode *drawn(GtkWidget *stage)
{
    GdkPaintable *paintable = gtk_widget_paintable_new(stage);
    GtkSnapshot *snapshot = gtk_snapshot_new();
    gdk_paintable_snapshot(paintable, snapshot, gtk_widget_get_width(stage),
                           gtk_widget_get_height(stage));
    g_object_unref(paintable);
    return gtk_snapshot_free_to_node(snapshot);
}

typedef struct {
    PlayWindow *window;
    char *path;
} picture_to_save;

static void forget_picture(gpointer to_save, G_GNUC_UNUSED GClosure *closure)
{
    g_free(((picture_to_save *)to_save)->path);
    g_free(to_save);
}

static void save_drawn(GdkFrameClock *clock, picture_to_save *to_save)
{
    GtkWidget *stage = GTK_WIDGET(play_window_worlds(to_save->window)); /* both, of two */
    GskRenderNode *node = drawn(stage);
    if (!node)
        return;
    GskRenderer *renderer = gtk_native_get_renderer(gtk_widget_get_native(stage));
    GdkTexture *texture = gsk_renderer_render_texture(renderer, node, NULL);
    GBytes *png = gdk_texture_save_to_png_bytes(texture);
    play_saving_tell(
        to_save->window, to_save->path,
        play_saving_write(to_save->path, g_bytes_get_data(png, NULL), g_bytes_get_size(png)));
    g_bytes_unref(png);
    g_object_unref(texture);
    gsk_render_node_unref(node);
    g_signal_handlers_disconnect_by_data(clock, to_save);
}

/* After the next frame: from when something in it is to change until it is drawn again, the stage
 * has no picture. */
static void save_picture(PlayWindow *window, const char *path)
{
    picture_to_save *to_save = g_new(picture_to_save, 1);
    *to_save = (picture_to_save){.window = window, .path = g_strdup(path)};
    GClosure *closure = g_cclosure_new(G_CALLBACK(save_drawn), to_save, forget_picture);
    g_object_watch_closure(G_OBJECT(window), closure);
    g_signal_connect_closure(gtk_widget_get_frame_clock(GTK_WIDGET(window)), "after-paint", closure,
                             FALSE);
    gtk_widget_queue_draw(GTK_WIDGET(play_window_worlds(window)));
}

static void on_screenshot(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                          gpointer window)
{
    char *name = name_with(window, ".png");
    add_filter(ask(window, _("Save a Picture"), name, save_picture), _("Pictures (PNG)"),
               (const char *const[]){"png", NULL});
    g_free(name);
}

/* Videos: first the log as a file in a folder of its own, then its last seconds are rendered. A
 * window that is closed meanwhile goes once that has been stopped, so that nothing is left behind.
 */

typedef struct video {
    PlayWindow *window;
    char *folder, *replay, *path;
    gint64 moment;
    gulong closing; /* for the window */
    GCancellable *stop;
} video;

static void end_video(video *v)
{
    play_window_set_progress(v->window, -1);
    g_object_set_data(G_OBJECT(v->window), "video", NULL);
    g_signal_handler_disconnect(v->window, v->closing);
    g_remove(v->replay);
    g_rmdir(v->folder);
    play_saving_release(v->window);
    g_free(v->folder);
    g_free(v->replay);
    g_free(v->path);
    g_object_unref(v->stop);
    g_object_unref(v->window);
    g_free(v);
}

static gboolean on_close(G_GNUC_UNUSED GtkWindow *window, video *v)
{
    g_cancellable_cancel(v->stop);
    return GDK_EVENT_PROPAGATE; /* it is held */
}

static void on_recorded(double share, bool ended, const char *error, gpointer data)
{
    video *v = data;
    if (!ended) {
        play_window_set_progress(v->window, share);
        return;
    }
    if (error && g_cancellable_is_cancelled(v->stop))
        play_window_toast(v->window, _("The video was stopped."));
    else
        play_saving_tell(v->window, v->path, error);
    end_video(v);
}

static void on_log_saved(PlayWindow *window, G_GNUC_UNUSED const char *path, const char *cause,
                         gpointer data)
{
    video *v = data;
    if (cause) {
        play_saving_tell(window, v->path, cause);
        end_video(v);
        return;
    }
    play_record(v->replay, v->path, v->moment, VIDEO_SECONDS,
                play_view_style(play_window_view(window)), v->stop, on_recorded, v);
}

static void record(PlayWindow *window, const char *path)
{
    if (g_object_get_data(G_OBJECT(window), "video")) {
        play_window_complain(window, _("A video is being made already."));
        return;
    }
    char *folder = g_dir_make_tmp("skvalp-XXXXXX", NULL);
    if (!folder) {
        play_window_complain(window, _("There is no room for temporary files."));
        return;
    }
    video *v = g_new0(video, 1);
    *v = (video){.window = g_object_ref(window),
                 .folder = folder,
                 .replay = g_build_filename(folder, "log.skvr", NULL),
                 .path = g_strdup(path),
                 .moment = play_view_picture(play_window_view(window))->moment,
                 .stop = g_cancellable_new()};
    g_object_set_data(G_OBJECT(window), "video", v);
    v->closing = g_signal_connect(window, "close-request", G_CALLBACK(on_close), v);
    play_saving_hold(window);
    play_window_set_progress(window, 0);
    play_saving_ask(window, v->replay, on_log_saved, v);
}

static void on_record(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                      gpointer window)
{
    char *program = g_find_program_in_path("ffmpeg");
    g_free(program);
    if (!program) {
        play_window_complain(window, _("Videos need ffmpeg: install it and try again."));
        return;
    }
    char *name = name_with(window, ".mp4");
    add_filter(ask(window, _("Save the Last 10 Seconds"), name, record), _("Videos (MP4)"),
               (const char *const[]){"mp4", NULL});
    g_free(name);
}

static void on_stop_recording(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                              gpointer window)
{
    video *v = g_object_get_data(G_OBJECT(window), "video");
    if (v)
        g_cancellable_cancel(v->stop);
}

/* What a part of the window that does not know it has made: name and content. */
static void on_write(G_GNUC_UNUSED GSimpleAction *action, GVariant *file, gpointer window)
{
    const char *path, *text;
    g_variant_get(file, "(^&ay&s)", &path, &text);
    play_saving_tell(window, path, play_saving_write(path, text, strlen(text)));
}

void play_files_add(PlayWindow *window)
{
    static const GActionEntry entries[] = {
        {.name = "open", .activate = on_open},
        {.name = "open-scene", .parameter_type = "s", .activate = on_open_scene},
        {.name = "open-uri", .parameter_type = "s", .activate = on_open_uri},
        {.name = "save", .activate = on_save},
        {.name = "write", .parameter_type = "(ays)", .activate = on_write},
        {.name = "screenshot", .activate = on_screenshot},
        {.name = "record", .activate = on_record},
        {.name = "stop-recording", .activate = on_stop_recording},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
}
