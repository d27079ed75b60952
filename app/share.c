/* Sharing: games as links (docs/share.md). Invariant: the clipboard is written only with a link
 * that is whole; and of a recorded game that was played to its end is said whether it went as it
 * went. */
#include "share.h"

#include <skvalp/link.h>

#include "settings.h"
#include "words.h"

static skv_stage *stage_of(PlayWindow *window)
{
    return play_view_stage(play_window_view(window));
}

/* Copying. */

static bool take_link(const char *text, size_t length, void *window)
{
    char *link = g_strndup(text, length);
    gdk_clipboard_set_text(gtk_widget_get_clipboard(window), link);
    g_free(link);
    return true;
}

typedef struct sharing {
    PlayWindow *window;
    skv_error error;
} sharing;

static bool make_link(const char *bytes, size_t size, void *user)
{
    sharing *share = user;
    char *page = play_settings_text("page", "");
    skv_link_write(bytes, size, *page ? page : NULL, take_link, share->window, &share->error);
    g_free(page);
    return true;
}

/* What is too long for a link can be saved. */
static void explain(PlayWindow *window, const skv_error *error)
{
    if (error->code == SKV_ERROR_LIMIT)
        play_window_complain(window, _("This is too long for a link. Save it as a file (Ctrl+S) "
                                       "and send that."));
    else
        play_window_complain(window, error->text);
}

static void on_shared(PlayView *view, const char *error, PlayWindow *window)
{
    sharing share = {.window = window};
    gulong *waiting = g_object_get_data(G_OBJECT(window), "sharing");
    g_clear_signal_handler(waiting, view);
    if (error) {
        play_window_complain(window, error);
        return;
    }
    skv_stage_read_shared(stage_of(window), make_link, &share);
    if (share.error.code != SKV_OK)
        explain(window, &share.error);
    else
        play_window_toast(window, _("The link was copied: paste it into a message"));
}

static void on_share(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer window)
{
    gulong *waiting = g_object_get_data(window, "sharing");
    PlayView *view = play_window_view(window);
    g_clear_signal_handler(waiting, view);
    *waiting = g_signal_connect(view, "shared", G_CALLBACK(on_shared), window);
    skv_stage_share(stage_of(window));
}

/* Pasting. */

static void on_text(GObject *clipboard, GAsyncResult *result, gpointer data)
{
    PlayWindow *window = data;
    char *text = gdk_clipboard_read_text_finish(GDK_CLIPBOARD(clipboard), result, NULL);
    if (text && skv_link_is(text))
        play_window_open(window, text);
    else
        play_window_complain(window, _("There is no link to open on the clipboard: copy one whole, "
                                       "from skvalp: or https: on."));
    g_free(text);
    g_object_unref(window);
}

static void on_paste(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer window)
{
    gdk_clipboard_read_text_async(gtk_widget_get_clipboard(window), NULL, on_text,
                                  g_object_ref(window));
}

/* Watching what was recorded, and taking it over. */

typedef struct watch {
    PlayWindow *window;
    bool said;
    unsigned withheld; /* that was told of */
} watch;

static void on_take_over(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                         gpointer window)
{
    skv_stage_take_over(stage_of(window));
    skv_stage_set_paused(stage_of(window), false);
}

static void on_skip(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer window)
{
    skv_stage_skip(stage_of(window));
}

static void show_watching(watch *w, const skv_picture *picture)
{
    play_window_set_watching(w->window, picture->watching);
    if (picture->withheld > w->withheld)
        play_window_toast(w->window, _("This is a replay: take it over to play with the water"));
    w->withheld = picture->withheld;
}

static void on_opened(G_GNUC_UNUSED PlayView *view, watch *w)
{
    w->said = false;
}

/* The window says it if not. */
static void on_changed(PlayView *view, watch *w)
{
    show_watching(w, play_view_picture(view));
    if (w->said || !play_view_picture(view)->as_recorded)
        return;
    w->said = true;
    play_window_toast(w->window, _("The end: it went exactly as it was recorded"));
}

void play_share_add(PlayWindow *window)
{
    static const GActionEntry entries[] = {
        {.name = "share", .activate = on_share},
        {.name = "paste", .activate = on_paste},
        {.name = "take-over", .activate = on_take_over},
        {.name = "skip", .activate = on_skip},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
    PlayView *view = play_window_view(window);
    watch *w = g_new0(watch, 1);
    w->window = window;
    g_object_set_data_full(G_OBJECT(view), "recorded", w, g_free);
    g_object_set_data_full(G_OBJECT(window), "sharing", g_new0(gulong, 1), g_free);
    g_signal_connect(view, "opened", G_CALLBACK(on_opened), w);
    g_signal_connect(view, "changed", G_CALLBACK(on_changed), w);
}
