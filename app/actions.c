/* Actions: one small function each. Invariant: an action's state mirrors the session, whoever
 * changed it: they are brought in line whenever the view or the window says that it has changed. */
#include "actions.h"

#include <skvalp/render.h>

static skv_session *session_of(PlayWindow *window)
{
    return play_view_session(play_window_view(window));
}

/* Playback. */

static void on_pause(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_view_set_paused(play_window_view(window), g_variant_get_boolean(state));
}

static void on_step(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer window)
{
    play_view_step(play_window_view(window));
}

static void on_reset(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer window)
{
    skv_error error;
    if (!play_view_reset(play_window_view(window), &error))
        play_window_complain(window, error.text);
}

static void on_speed(G_GNUC_UNUSED GSimpleAction *action, GVariant *state, gpointer window)
{
    play_view_set_speed(play_window_view(window), g_variant_get_double(state));
}

static const double speeds[] = {0.1, 0.25, 0.5, 1, 2};

/* The next speed of the menu in either direction. */
static void on_change_speed(G_GNUC_UNUSED GSimpleAction *action, GVariant *steps, gpointer window)
{
    int at = 0, last = G_N_ELEMENTS(speeds) - 1;
    while (at < last && speeds[at] < skv_session_speed(session_of(window)))
        at++;
    at = CLAMP(at + g_variant_get_int32(steps), 0, last);
    play_view_set_speed(play_window_view(window), speeds[at]);
}

static void on_weightless(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                          gpointer window)
{
    play_view_set_gravity(play_window_view(window), 0, 0);
}

/* Opening. */

static void on_open_scene(G_GNUC_UNUSED GSimpleAction *action, GVariant *name, gpointer window)
{
    play_window_open(window, g_variant_get_string(name, NULL));
}

static GtkFileFilter *filter(const char *name, const char *const suffixes[])
{
    GtkFileFilter *made = gtk_file_filter_new();
    gtk_file_filter_set_name(made, name);
    for (int i = 0; suffixes[i]; i++)
        gtk_file_filter_add_suffix(made, suffixes[i]);
    return made;
}

static void add_filters(GtkFileChooser *chooser)
{
    GtkFileFilter *filters[] = {
        filter("Scenes and pictures", (const char *const[]){"json", "png", NULL}),
        filter("Scenes (JSON)", (const char *const[]){"json", NULL}),
        filter("Pictures (PNG)", (const char *const[]){"png", NULL}),
    };
    for (size_t i = 0; i < G_N_ELEMENTS(filters); i++) {
        gtk_file_chooser_add_filter(chooser, filters[i]);
        g_object_unref(filters[i]);
    }
}

static void on_file_chosen(GtkNativeDialog *dialog, int response, PlayWindow *window)
{
    if (response == GTK_RESPONSE_ACCEPT) {
        GFile *file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
        play_window_open_file(window, file);
        g_object_unref(file);
    }
    g_object_unref(dialog);
}

static void on_open(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer window)
{
    GtkFileChooserNative *dialog =
        gtk_file_chooser_native_new("Open a Scene or a Picture", GTK_WINDOW(window),
                                    GTK_FILE_CHOOSER_ACTION_OPEN, "_Open", "_Cancel");
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    add_filters(GTK_FILE_CHOOSER(dialog));
    g_signal_connect(dialog, "response", G_CALLBACK(on_file_chosen), window);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

/* View and window. */

static void on_tracers(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_view_set_tracers(play_window_view(window), g_variant_get_boolean(state));
}

static void on_fullscreen(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    if (g_variant_get_boolean(state)) {
        gtk_window_fullscreen(window);
        play_window_toast(window, "F11 leaves full screen");
    } else {
        gtk_window_unfullscreen(window);
    }
}

static void on_dismiss(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                       gpointer window)
{
    play_window_dismiss(window);
}

static void on_about(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer window)
{
    adw_show_about_window(
        window, "application-name", "Skvalp", "application-icon", "org.skvalp.Play", "version",
        skv_version(), "developer-name", "The Skvalp authors", "license-type", GTK_LICENSE_MIT_X11,
        "comments",
        "Water to play with, calibrated like the real thing.\n\nThe method follows Daniel Månsson, "
        "“Interactive 2D Particle-based Fluid Simulation for Mobile Devices” (2013), after Clavet, "
        "Beaudoin and Poulin (2005).",
        NULL);
}

static const GActionEntry entries[] = {
    {.name = "pause", .state = "false", .change_state = on_pause},
    {.name = "step", .activate = on_step},
    {.name = "reset", .activate = on_reset},
    {.name = "speed", .parameter_type = "d", .state = "1.0", .change_state = on_speed},
    {.name = "change-speed", .parameter_type = "i", .activate = on_change_speed},
    {.name = "weightless", .activate = on_weightless},
    {.name = "open", .activate = on_open},
    {.name = "open-scene", .parameter_type = "s", .activate = on_open_scene},
    {.name = "tracers", .state = "false", .change_state = on_tracers},
    {.name = "fullscreen", .state = "false", .change_state = on_fullscreen},
    {.name = "dismiss", .activate = on_dismiss},
    {.name = "about", .activate = on_about},
};

static void set_state(PlayWindow *window, const char *name, GVariant *state)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), name);
    g_simple_action_set_state(G_SIMPLE_ACTION(action), state);
}

static void update_states(PlayWindow *window)
{
    const skv_session *session = session_of(window);
    set_state(window, "pause", g_variant_new_boolean(skv_session_paused(session)));
    set_state(window, "speed", g_variant_new_double(skv_session_speed(session)));
    set_state(window, "fullscreen",
              g_variant_new_boolean(gtk_window_is_fullscreen(GTK_WINDOW(window))));
}

void play_actions_add(PlayWindow *window)
{
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
    g_signal_connect_object(play_window_view(window), "changed", G_CALLBACK(update_states), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect(window, "notify::fullscreened", G_CALLBACK(update_states), NULL);
    update_states(window);
}

void play_actions_set_keys(GtkApplication *application)
{
    static const struct {
        const char *action;
        const char *keys[4];
    } shortcuts[] = {
        {"win.pause", {"space"}},
        {"win.step", {"s", "period"}},
        {"win.reset", {"r"}},
        {"win.change-speed(-1)", {"minus", "KP_Subtract"}},
        {"win.change-speed(1)", {"plus", "equal", "KP_Add"}},
        {"win.weightless", {"0", "KP_0"}},
        {"win.tracers", {"t"}},
        {"win.fullscreen", {"F11"}},
        {"win.dismiss", {"Escape"}},
        {"win.open", {"<Control>o"}},
        {"window.close", {"<Control>q", "<Control>w"}},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(shortcuts); i++)
        gtk_application_set_accels_for_action(application, shortcuts[i].action, shortcuts[i].keys);
}
