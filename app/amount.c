/* Number of particles: a choice that is kept, and with which every scene is opened from then on.
 * Invariant: the scene that is open begins anew with it, once what was done in it is kept, which
 * can be brought back; a state or a replay stays as it is. */
#include "amount.h"

#include <glib/gstdio.h>

#include "saving.h"
#include "settings.h"
#include "words.h"

/* The name or path by which what is open can be opened again; null if it is no scene. */
static const char *scene_of(PlayWindow *window)
{
    const skv_picture *picture = play_view_picture(play_window_view(window));
    const char *path = picture->scene ? skv_scene_file(picture->scene, 0) : NULL;
    return path ? path : picture->scene ? picture->name : NULL;
}

/* Bringing back. */

#define OFFER_TIME 20 /* s */

typedef struct replaced {
    char *path, *scene, *title;
    int amount; /* that was chosen before */
    bool asked; /* for the file */
} replaced;

static void free_replaced(gpointer data)
{
    replaced *r = data;
    g_remove(r->path);
    g_free(r->path);
    g_free(r->scene);
    g_free(r->title);
    g_free(r);
}

static replaced *replaced_of(PlayWindow *window)
{
    return g_object_get_data(G_OBJECT(window), "replaced");
}

static void choose(PlayWindow *window, int amount)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), "particles");
    g_simple_action_set_state(G_SIMPLE_ACTION(action), g_variant_new_int32(amount));
    play_settings_set_number("particles", amount);
}

static void on_bring_back(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                          gpointer window)
{
    const replaced *r = replaced_of(window);
    if (play_saving_open(window, r->path, r->title))
        choose(window, r->amount);
}

/* What was done is on the disk, or stays on the screen. */
static void on_kept(PlayWindow *window, const char *path, const char *cause,
                    G_GNUC_UNUSED gpointer data)
{
    replaced *r = replaced_of(window);
    r->asked = false;
    if (cause) {
        play_saving_tell(window, path, cause);
    } else {
        AdwToast *toast = adw_toast_new(_("The scene begins anew"));
        g_object_set(toast, "button-label", _("Bring Back"), "action-name", "win.bring-back",
                     "timeout", OFFER_TIME, NULL);
        play_window_open(window, r->scene);
        play_window_add_toast(window, toast);
    }
    play_saving_release(window);
}

/* In a file of its own, for other windows may be open. */
static void keep(PlayWindow *window, const char *scene, int before)
{
    const skv_picture *picture = play_view_picture(play_window_view(window));
    char *path;
    GError *error = NULL;
    int file = g_file_open_tmp("skvalp-XXXXXX.skv", &path, &error);
    if (file < 0) {
        play_window_complain(window, error->message);
        g_error_free(error);
        return;
    }
    g_close(file, NULL);
    replaced *r = g_new0(replaced, 1);
    *r = (replaced){.path = path,
                    .scene = g_strdup(scene),
                    .title = g_strdup(*picture->title ? picture->title : picture->name),
                    .amount = before,
                    .asked = true};
    g_object_set_data_full(G_OBJECT(window), "replaced", r, free_replaced);
    play_saving_hold(window);
    play_saving_ask(window, r->path, on_kept, NULL);
}

/* Choosing. */

static void on_amount(G_GNUC_UNUSED GSimpleAction *action, GVariant *state, gpointer window)
{
    const char *scene = scene_of(window);
    replaced *earlier = replaced_of(window);
    int before = play_settings_number("particles", 0);
    choose(window, g_variant_get_int32(state));
    if (!scene || skv_amount_of(scene, 1) == 0 || (earlier && earlier->asked))
        return;
    if (play_view_picture(play_window_view(window))->can_undo)
        keep(window, scene, before);
    else
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
    static const GActionEntry entries[] = {
        {.name = "particles", .state = "0", .change_state = on_amount, .parameter_type = "i"},
        {.name = "bring-back", .activate = on_bring_back},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(window), "particles");
    g_simple_action_set_state(G_SIMPLE_ACTION(action),
                              g_variant_new_int32(play_settings_number("particles", 0)));
    fill(play_window_amounts(window));
}
