/* Window: puts the parts together and says what the view cannot. Invariant: a message of something
 * that failed stays until it is closed or something else was opened. */
#include "window.h"

#include "input.h"

#define DEFAULT_SCENE "dam-break"

struct _PlayWindow {
    AdwApplicationWindow parent;
    GtkWidget *header, *scenes, *stage, *message_text, *play;
    AdwWindowTitle *title;
    AdwToastOverlay *toasts;
    GtkRevealer *message;
    GtkLabel *status;
    PlayView *view;
};

G_DEFINE_FINAL_TYPE(PlayWindow, play_window, ADW_TYPE_APPLICATION_WINDOW)

PlayView *play_window_view(PlayWindow *window)
{
    return window->view;
}

/* Messages. */

void play_window_complain(PlayWindow *window, const char *text)
{
    gtk_label_set_text(GTK_LABEL(window->message_text), text);
    gtk_revealer_set_reveal_child(window->message, TRUE);
}

void play_window_dismiss(PlayWindow *window)
{
    gtk_revealer_set_reveal_child(window->message, FALSE);
}

void play_window_toast(PlayWindow *window, const char *text)
{
    char *escaped = g_markup_escape_text(text, -1); /* toasts read markup */
    AdwToast *toast = adw_toast_new(escaped);
    adw_toast_set_timeout(toast, 6);
    adw_toast_overlay_add_toast(window->toasts, toast);
    g_free(escaped);
}

/* Opening. */

static void show_notices(PlayWindow *window, const skv_scene *scene)
{
    const char *notice;
    for (int i = 0; (notice = skv_scene_notice(scene, i)); i++)
        play_window_toast(window, notice);
}

void play_window_open(PlayWindow *window, const char *name_or_path)
{
    skv_error error;
    if (!play_view_open(window->view, name_or_path, &error)) {
        play_window_complain(window, error.text);
        return;
    }
    const skv_scene *scene = skv_session_scene(play_view_session(window->view));
    const char *title = skv_scene_title(scene);
    adw_window_title_set_subtitle(window->title, title);
    char *name = g_strdup_printf("%s – Skvalp", title);
    gtk_window_set_title(GTK_WINDOW(window), name);
    g_free(name);
    play_window_dismiss(window);
    show_notices(window, scene);
}

void play_window_open_file(PlayWindow *window, GFile *file)
{
    char *path = g_file_get_path(file);
    if (path)
        play_window_open(window, path);
    else
        play_window_complain(window, "This file is not on this computer: copy it here first.");
    g_free(path);
}

static gboolean on_drop(G_GNUC_UNUSED GtkDropTarget *target, const GValue *value,
                        G_GNUC_UNUSED double x, G_GNUC_UNUSED double y, PlayWindow *window)
{
    GSList *files = g_value_get_boxed(value); /* of a GdkFileList */
    if (!files)
        return FALSE;
    play_window_open_file(window, files->data);
    return TRUE;
}

/* What the view tells. */

/* "3 000 particles": groups of three digits with thin spaces. */
static void format_count(int count, char *text, size_t size)
{
    if (count >= 1000000)
        g_snprintf(text, size, "%d\u202f%03d\u202f%03d", count / 1000000, count / 1000 % 1000,
                   count % 1000);
    else if (count >= 10000)
        g_snprintf(text, size, "%d\u202f%03d", count / 1000, count % 1000);
    else
        g_snprintf(text, size, "%d", count);
}

static void show_status(PlayWindow *window)
{
    const skv_session *session = play_view_session(window->view);
    const skv_world *world = skv_session_world(play_view_session(window->view));
    gtk_widget_set_visible(GTK_WIDGET(window->status), world != NULL);
    if (!world)
        return;
    char count[32], pace[32] = "";
    format_count(skv_world_particle_count(world), count, sizeof count);
    if (skv_session_paused(session))
        g_strlcpy(pace, "paused", sizeof pace);
    else if (skv_world_awake_count(world) == 0)
        g_strlcpy(pace, "at rest", sizeof pace);
    else if (play_view_frame_rate(window->view) > 0)
        g_snprintf(pace, sizeof pace, "%.0f fps", play_view_frame_rate(window->view));
    char speed[32] = "";
    if (skv_session_speed(session) != 1)
        g_snprintf(speed, sizeof speed, "  ·  × %g", skv_session_speed(session));
    char *text = g_strdup_printf("%s particles  ·  %.1f s%s%s%s", count, skv_world_time(world),
                                 speed, *pace ? "  ·  " : "", pace);
    gtk_label_set_text(window->status, text);
    g_free(text);
}

static void on_view_changed(PlayWindow *window)
{
    bool paused = skv_session_paused(play_view_session(window->view));
    gtk_button_set_icon_name(GTK_BUTTON(window->play), paused ? "media-playback-start-symbolic"
                                                              : "media-playback-pause-symbolic");
    gtk_widget_set_tooltip_text(window->play, paused ? "Play (Space)" : "Pause (Space)");
    show_status(window);
}

static void on_dark_changed(PlayWindow *window)
{
    AdwStyleManager *styles = adw_style_manager_get_default();
    play_view_set_dark(window->view, adw_style_manager_get_dark(styles));
}

static void on_fullscreen_changed(PlayWindow *window)
{
    gtk_widget_set_visible(window->header, !gtk_window_is_fullscreen(GTK_WINDOW(window)));
}

static GMenuModel *scenes_menu(void)
{
    GMenu *menu = g_menu_new();
    const skv_scene_info *scene;
    for (int i = 0; (scene = skv_builtin_scene(i)); i++) {
        GMenuItem *item = g_menu_item_new(scene->title, NULL);
        g_menu_item_set_action_and_target(item, "win.open-scene", "s", scene->name);
        g_menu_append_item(menu, item);
        g_object_unref(item);
    }
    return G_MENU_MODEL(menu);
}

static void play_window_class_init(PlayWindowClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    g_type_ensure(PLAY_TYPE_VIEW);
    gtk_widget_class_set_template_from_resource(widget_class, "/org/skvalp/Play/window.ui");
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, header);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, scenes);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, stage);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, play);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, title);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, toasts);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, message);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, message_text);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, status);
    gtk_widget_class_bind_template_child(widget_class, PlayWindow, view);
}

static void play_window_init(PlayWindow *window)
{
    gtk_widget_init_template(GTK_WIDGET(window));
    play_input_attach(window->view);

    GMenuModel *menu = scenes_menu();
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(window->scenes), menu);
    g_object_unref(menu);

    GtkDropTarget *target = gtk_drop_target_new(GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
    g_signal_connect(target, "drop", G_CALLBACK(on_drop), window);
    gtk_widget_add_controller(window->stage, GTK_EVENT_CONTROLLER(target));

    g_signal_connect_object(window->view, "changed", G_CALLBACK(on_view_changed), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(window->view, "failed", G_CALLBACK(play_window_complain), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(adw_style_manager_get_default(), "notify::dark",
                            G_CALLBACK(on_dark_changed), window, G_CONNECT_SWAPPED);
    g_signal_connect(window, "notify::fullscreened", G_CALLBACK(on_fullscreen_changed), NULL);
    on_dark_changed(window);
    gtk_widget_grab_focus(GTK_WIDGET(window->view));
}

PlayWindow *play_window_new(GtkApplication *application, const char *scene)
{
    PlayWindow *window = g_object_new(PLAY_TYPE_WINDOW, "application", application, NULL);
    play_window_open(window, scene ? scene : DEFAULT_SCENE);
    if (!skv_session_scene(play_view_session(window->view))) {
        /* Opening the default scene would close the message that says why it is shown. */
        char *reason = g_strdup(gtk_label_get_text(GTK_LABEL(window->message_text)));
        play_window_open(window, DEFAULT_SCENE);
        play_window_complain(window, reason);
        g_free(reason);
    }
    return window;
}
