/* Number of particles: a choice that is kept, and with which every scene is opened from then on.
 * Invariant: the scene that is open begins anew with it; a state or a replay stays as it is. */
#include "amount.h"

#include "settings.h"
#include "words.h"

/* The name or path by which what is open can be opened again; null if it is no scene. */
static const char *scene_of(PlayWindow *window)
{
    const skv_picture *picture = play_view_picture(play_window_view(window));
    const char *path = picture->scene ? skv_scene_file(picture->scene, 0) : NULL;
    return path ? path : picture->scene ? picture->name : NULL;
}

static void on_amount(GSimpleAction *action, GVariant *state, gpointer window)
{
    const char *scene = scene_of(window);
    g_simple_action_set_state(action, state);
    play_settings_set_number("particles", g_variant_get_int32(state));
    if (scene && skv_amount_of(scene, 1) > 0)
        play_window_open(window, scene);
}

static void fill(GMenu *menu)
{
    int amount;
    g_menu_append(menu, _("As the Scene Says"), "win.particles(0)");
    for (int i = 0; (amount = skv_amount_at(i)) > 0; i++) {
        char *action = g_strdup_printf("win.particles(%d)", amount);
        g_menu_append(menu, play_number(amount, 0).text, action);
        g_free(action);
    }
}

void play_amount_add(PlayWindow *window)
{
    static const GActionEntry entry = {
        .name = "particles", .state = "0", .change_state = on_amount, .parameter_type = "i"};
    g_action_map_add_action_entries(G_ACTION_MAP(window), &entry, 1, window);
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), "particles");
    g_simple_action_set_state(G_SIMPLE_ACTION(action),
                              g_variant_new_int32(play_settings_number("particles", 0)));
    fill(play_window_amounts(window));
}
