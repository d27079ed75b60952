/* Actions: one small function each. Invariant: an action's state mirrors the session, whoever
 * changed it: they are brought in line whenever the view or the window says that it has changed. */
#include "actions.h"

#include "amount.h"
#include "compare.h"
#include "files.h"
#include "input.h"
#include "keys.h"
#include "preferences.h"
#include "resume.h"
#include "saving.h"
#include "sensor.h"
#include "share.h"
#include "stopwatch.h"
#include "tools.h"
#include "transport.h"
#include "views.h"
#include "words.h"

static skv_stage *stage_of(PlayWindow *window)
{
    return play_view_stage(play_window_view(window));
}

#define ACTIVATION(name)                                                                           \
    static void name(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *value,           \
                     gpointer window)

/* Playback. */

static void on_pause(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    skv_stage_set_paused(stage_of(window), g_variant_get_boolean(state));
}

ACTIVATION(on_step)
{
    skv_stage_set_paused(stage_of(window), true);
    skv_stage_step_once(stage_of(window));
}

ACTIVATION(on_reset)
{
    skv_stage_seek(stage_of(window), 0);
}

ACTIVATION(on_undo)
{
    skv_stage_undo(stage_of(window));
}

ACTIVATION(on_redo)
{
    skv_stage_redo(stage_of(window));
}

/* Frames back or forth in time. */
ACTIVATION(on_go)
{
    skv_control_go(stage_of(window), g_variant_get_int32(value));
}

static void on_speed(G_GNUC_UNUSED GSimpleAction *action, GVariant *state, gpointer window)
{
    skv_stage_set_speed(stage_of(window), g_variant_get_double(state));
}

/* The next speed of the menu in either direction. */
ACTIVATION(on_change_speed)
{
    skv_control_shift_speed(stage_of(window), g_variant_get_int32(value));
}

/* What acts on the fluid. */

ACTIVATION(on_weightless)
{
    skv_stage_set_gravity(stage_of(window), 0, 0, 0);
}

static void on_tool(G_GNUC_UNUSED GSimpleAction *action, GVariant *state, gpointer window)
{
    skv_control_tool(stage_of(window), g_variant_get_int32(state));
    play_window_show_page(window, "play");
}

static void on_fluid(G_GNUC_UNUSED GSimpleAction *action, GVariant *state, gpointer window)
{
    skv_control_fluid(stage_of(window), g_variant_get_int32(state));
}

ACTIVATION(on_next_fluid)
{
    skv_control_next_fluid(stage_of(window));
}

ACTIVATION(on_brush)
{
    skv_control_scale_brush(stage_of(window), g_variant_get_double(value));
}

ACTIVATION(on_stopwatch)
{
    play_stopwatch_press(play_window_view(window), g_variant_get_boolean(value));
}

ACTIVATION(on_measure)
{
    play_window_measure(window, g_variant_get_int32(value));
}

static void on_keyboard_hand(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_input_set_keyboard_hand(window, g_variant_get_boolean(state));
    if (g_variant_get_boolean(state))
        play_window_toast(window, _("Arrow keys move the hand, Return closes and opens it"));
}

static void on_tilt(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_sensor_set_on(play_sensor_of(play_window_view(window)), g_variant_get_boolean(state));
}

/* An action only where there is a sensor; else the menu does not show it. */
static void add_sensor(PlayWindow *window)
{
    static const GActionEntry entry = {.name = "tilt", .state = "false", .change_state = on_tilt};
    PlayView *view = play_window_view(window);
    play_sensor_attach(view);
    const PlaySensor *sensor = play_sensor_of(view);
    if (!sensor)
        return;
    g_action_map_add_action_entries(G_ACTION_MAP(window), &entry, 1, window);
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), "tilt");
    g_simple_action_set_state(G_SIMPLE_ACTION(action),
                              g_variant_new_boolean(play_sensor_is_on(sensor)));
}

/* The view. */

ACTIVATION(on_zoom)
{
    skv_stage *stage = stage_of(window);
    double steps = g_variant_get_double(value);
    skv_camera camera = skv_stage_camera(stage, 0);
    if (steps == 0)
        skv_stage_show_all(stage);
    else
        skv_stage_zoom(stage, 0, pow(skv_control_limits()->zoom_step, steps), camera.width / 2.0,
                       camera.height / 2.0);
}

/* The window. */

static void on_fullscreen(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    if (g_variant_get_boolean(state))
        gtk_window_fullscreen(window);
    else
        gtk_window_unfullscreen(window);
}

static void on_gallery(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_window_show_page(window, g_variant_get_boolean(state) ? "scenes" : "play");
}

ACTIVATION(on_experiment)
{
    play_window_show_experiment(window, g_variant_get_int32(value));
}

static void on_properties(GSimpleAction *action, GVariant *state, gpointer window)
{
    g_simple_action_set_state(action, state);
    play_window_show_properties(window, g_variant_get_boolean(state));
}

/* Escape leaves what was entered last: a message, the gallery, the panel, the keyboard's hand, full
 * screen. */
ACTIVATION(on_dismiss)
{
    static const char *const left[] = {"gallery", "properties", "keyboard-hand", "fullscreen"};
    if (play_window_dismiss(window))
        return;
    if (g_strcmp0(play_window_page(window), "experiment") == 0) {
        play_window_show_page(window, "scenes");
        return;
    }
    for (size_t i = 0; i < G_N_ELEMENTS(left); i++) {
        GVariant *state = g_action_group_get_action_state(G_ACTION_GROUP(window), left[i]);
        bool entered = g_variant_get_boolean(state);
        g_variant_unref(state);
        if (entered) {
            g_action_group_change_action_state(G_ACTION_GROUP(window), left[i],
                                               g_variant_new_boolean(FALSE));
            return;
        }
    }
}

ACTIVATION(on_preferences)
{
    play_preferences_show(window, play_window_view(window), play_window_ball(window));
}

ACTIVATION(on_about)
{
    adw_show_about_window(
        window, "application-name", "Skvalp", "application-icon", "org.skvalp.Play", "version",
        skv_version(), "developer-name", _("The Skvalp authors"), "license-type",
        GTK_LICENSE_MIT_X11, "comments",
        _("Water to play with, calibrated like the real thing.\n\nThe method follows Daniel "
          "Månsson, “Interactive 2D Particle-based Fluid Simulation for Mobile Devices” (2013), "
          "after Clavet, Beaudoin and Poulin (2005)."),
        NULL);
}

static const GActionEntry entries[] = {
    {.name = "pause", .state = "false", .change_state = on_pause},
    {.name = "step", .activate = on_step},
    {.name = "reset", .activate = on_reset},
    {.name = "undo", .activate = on_undo},
    {.name = "redo", .activate = on_redo},
    {.name = "go", .parameter_type = "i", .activate = on_go},
    {.name = "speed", .parameter_type = "d", .state = "1.0", .change_state = on_speed},
    {.name = "change-speed", .parameter_type = "i", .activate = on_change_speed},
    {.name = "weightless", .activate = on_weightless},
    {.name = "tool", .parameter_type = "i", .state = "0", .change_state = on_tool},
    {.name = "fluid", .parameter_type = "i", .state = "0", .change_state = on_fluid},
    {.name = "next-fluid", .activate = on_next_fluid},
    {.name = "brush", .parameter_type = "d", .activate = on_brush},
    {.name = "measure", .parameter_type = "i", .activate = on_measure},
    {.name = "stopwatch", .parameter_type = "b", .activate = on_stopwatch},
    {.name = "keyboard-hand", .state = "false", .change_state = on_keyboard_hand},
    {.name = "zoom", .parameter_type = "d", .activate = on_zoom},
    {.name = "fullscreen", .state = "false", .change_state = on_fullscreen},
    {.name = "gallery", .state = "false", .change_state = on_gallery},
    {.name = "experiment", .parameter_type = "i", .activate = on_experiment},
    {.name = "properties", .state = "false", .change_state = on_properties},
    {.name = "dismiss", .activate = on_dismiss},
    {.name = "preferences", .activate = on_preferences},
    {.name = "about", .activate = on_about},
};

/* States and what is possible follow the session. */

static void set_state(PlayWindow *window, const char *name, GVariant *state)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), name);
    g_simple_action_set_state(G_SIMPLE_ACTION(action), state);
}

static void set_enabled(PlayWindow *window, const char *name, bool enabled)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), name);
    g_simple_action_set_enabled(G_SIMPLE_ACTION(action), enabled);
}

static void update_states(PlayWindow *window)
{
    const skv_stage *stage = stage_of(window);
    skv_stage_state now = skv_stage_now(stage);
    set_state(window, "pause", g_variant_new_boolean(skv_stage_paused(stage)));
    set_state(window, "speed", g_variant_new_double(skv_stage_speed(stage)));
    set_state(window, "tool", g_variant_new_int32(skv_stage_tool(stage)));
    set_state(window, "fluid", g_variant_new_int32(skv_stage_fluid(stage)));
    set_state(window, "gallery",
              g_variant_new_boolean(g_strcmp0(play_window_page(window), "play") != 0));
    set_state(window, "fullscreen",
              g_variant_new_boolean(gtk_window_is_fullscreen(GTK_WINDOW(window))));
    set_enabled(window, "undo", now.can_undo);
    set_enabled(window, "redo", now.can_redo);
}

void play_actions_add(PlayWindow *window, gboolean offers)
{
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
    play_resume_add(window, offers);
    play_saving_add(window);
    play_files_add(window);
    play_share_add(window);
    play_amount_add(window);
    play_compare_add(window);
    play_files_show_recent(window, play_window_recent(window));
    add_sensor(window);
    play_views_add(G_ACTION_MAP(window), play_window_view(window));
    play_preferences_apply(play_window_view(window), play_window_ball(window));
    play_keys_add(GTK_APPLICATION_WINDOW(window));
    g_signal_connect_object(play_window_view(window), "changed", G_CALLBACK(update_states), window,
                            G_CONNECT_SWAPPED);
    g_signal_connect(window, "notify::fullscreened", G_CALLBACK(update_states), NULL);
    update_states(window);
}
