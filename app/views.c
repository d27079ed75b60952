/* Views: choices made from the renderer's tables. Invariant: no view is named here; what the tables
 * hold is in the menu, and the style says which of it is chosen. */
#include "views.h"

#include <string.h>

#include "settings.h"
#include "words.h"

static const char *name_of(skv_view view)
{
    const skv_style_choice *choice;
    for (int i = 0; (choice = skv_style_choice_at(SKV_STYLE_VIEW, i)); i++)
        if (choice->value == (int)view)
            return choice->name;
    return "";
}

static char *names_of(unsigned overlays)
{
    GString *names = g_string_new(NULL);
    const skv_style_choice *overlay;
    for (int i = 0; (overlay = skv_style_choice_at(SKV_STYLE_OVERLAY, i)); i++)
        if (overlays & (unsigned)overlay->value)
            g_string_append_printf(names, "%s%s", names->len ? "," : "", overlay->name);
    return g_string_free(names, FALSE);
}

/* What is shared says how it was seen. */
static void tell_look(PlayView *view)
{
    const skv_render_style *style = play_view_style(view);
    char *overlays = names_of(style->overlays);
    skv_stage_set_look(play_view_stage(view), name_of(style->view), overlays);
    g_free(overlays);
}

static void set_view(PlayView *view, const char *name)
{
    skv_render_style style = *play_view_style(view);
    if (skv_render_style_set(&style, SKV_STYLE_VIEW, name, NULL) != SKV_OK)
        return;
    style.range = 0;
    play_view_set_style(view, &style);
    tell_look(view);
    play_settings_set_text("view", name);
}

static void on_view(GSimpleAction *action, GVariant *state, gpointer view)
{
    set_view(view, g_variant_get_string(state, NULL));
    g_simple_action_set_state(action, state);
}

static void on_next_view(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                         gpointer data)
{
    PlayView *view = data;
    int i = 0;
    while (skv_style_choice_at(SKV_STYLE_VIEW, i)->value != (int)play_view_style(view)->view)
        i++;
    const skv_style_choice *next = skv_style_choice_at(SKV_STYLE_VIEW, i + 1);
    GActionMap *window = g_object_get_data(G_OBJECT(view), "views");
    g_action_change_state(
        g_action_map_lookup_action(window, "view"),
        g_variant_new_string((next ? next : skv_style_choice_at(SKV_STYLE_VIEW, 0))->name));
}

static void on_overlay(GSimpleAction *action, GVariant *state, gpointer data)
{
    PlayView *view = data;
    const skv_style_choice *overlay = g_object_get_data(G_OBJECT(action), "overlay");
    skv_render_style style = *play_view_style(view);
    if (g_variant_get_boolean(state))
        style.overlays |= (unsigned)overlay->value;
    else
        style.overlays &= ~(unsigned)overlay->value;
    play_view_set_style(view, &style);
    tell_look(view);
    char *names = names_of(style.overlays);
    play_settings_set_text("overlays", *names ? names : "none");
    g_free(names);
    g_simple_action_set_state(action, state);
}

/* The app draws its own legend. */
static bool is_ours(const skv_style_choice *overlay)
{
    return overlay->value == SKV_OVERLAY_LEGEND;
}

static char *action_of(const skv_style_choice *overlay)
{
    return g_strdup_printf("overlay-%s", overlay->name);
}

static void set_state(GActionMap *window, const char *name, GVariant *state)
{
    g_simple_action_set_state(G_SIMPLE_ACTION(g_action_map_lookup_action(window, name)), state);
}

/* The menu shows what the style says. */
static void show_states(GActionMap *window, PlayView *view)
{
    const skv_render_style *style = play_view_style(view);
    const skv_style_choice *overlay;
    set_state(window, "view", g_variant_new_string(name_of(style->view)));
    for (int i = 0; (overlay = skv_style_choice_at(SKV_STYLE_OVERLAY, i)); i++) {
        char *name = action_of(overlay);
        if (!is_ours(overlay))
            set_state(window, name,
                      g_variant_new_boolean(style->overlays & (unsigned)overlay->value));
        g_free(name);
    }
}

static void add_overlays(GActionMap *window, PlayView *view)
{
    const skv_style_choice *overlay;
    for (int i = 0; (overlay = skv_style_choice_at(SKV_STYLE_OVERLAY, i)); i++) {
        if (is_ours(overlay))
            continue;
        char *name = action_of(overlay);
        GSimpleAction *action =
            g_simple_action_new_stateful(name, NULL, g_variant_new_boolean(FALSE));
        g_object_set_data(G_OBJECT(action), "overlay", (gpointer)overlay);
        g_signal_connect(action, "change-state", G_CALLBACK(on_overlay), view);
        g_action_map_add_action(window, G_ACTION(action));
        g_object_unref(action);
        g_free(name);
    }
}

/* As whoever shared it saw it, for this time: what people prefer is still kept. */
static void on_opened(PlayView *view, GActionMap *window)
{
    const skv_picture *picture = play_view_picture(view);
    skv_render_style style = *play_view_style(view);
    if (!*picture->view ||
        skv_render_style_set(&style, SKV_STYLE_VIEW, picture->view, NULL) != SKV_OK)
        return;
    const char *overlays = *picture->overlays ? picture->overlays : "none";
    skv_render_style_set(&style, SKV_STYLE_OVERLAY, overlays, NULL);
    style.overlays &= ~(unsigned)SKV_OVERLAY_LEGEND;
    style.range = 0;
    play_view_set_style(view, &style);
    tell_look(view);
    show_states(window, view);
}

void play_views_add(GActionMap *window, PlayView *view)
{
    static const GActionEntry entries[] = {
        {.name = "view", .parameter_type = "s", .state = "'water'", .change_state = on_view},
        {.name = "next-view", .activate = on_next_view},
    };
    skv_render_style style = *play_view_style(view);
    char *name = play_settings_text("view", "water");
    char *overlays = play_settings_text("overlays", "none");
    skv_render_style_set(&style, SKV_STYLE_VIEW, name, NULL);
    skv_render_style_set(&style, SKV_STYLE_OVERLAY, overlays, NULL);
    style.overlays &= ~(unsigned)SKV_OVERLAY_LEGEND;
    style.comma = *play_numerals()->decimal == ',';
    play_view_set_style(view, &style);
    g_free(overlays);
    g_free(name);

    g_object_set_data(G_OBJECT(view), "views", window);
    g_action_map_add_action_entries(window, entries, G_N_ELEMENTS(entries), view);
    add_overlays(window, view);
    show_states(window, view);
    tell_look(view);
    g_signal_connect(view, "opened", G_CALLBACK(on_opened), window);
}

GMenuModel *play_views_menu(void)
{
    GMenu *menu = g_menu_new(), *views = g_menu_new(), *overlays = g_menu_new();
    GMenu *zoom = g_menu_new();
    const skv_style_choice *c;
    for (int i = 0; (c = skv_style_choice_at(SKV_STYLE_VIEW, i)); i++) {
        GMenuItem *item = g_menu_item_new(play_word(c->label), NULL);
        g_menu_item_set_action_and_target(item, "win.view", "s", c->name);
        g_menu_append_item(views, item);
        g_object_unref(item);
    }
    for (int i = 0; (c = skv_style_choice_at(SKV_STYLE_OVERLAY, i)); i++) {
        char *name = action_of(c), *action = g_strconcat("win.", name, NULL);
        if (!is_ours(c))
            g_menu_append(overlays, play_word(c->label), action);
        g_free(action);
        g_free(name);
    }
    g_menu_append(zoom, _("Zoom In"), "win.zoom(1.0)");
    g_menu_append(zoom, _("Zoom Out"), "win.zoom(-1.0)");
    g_menu_append(zoom, _("All of It"), "win.zoom(0.0)");
    g_menu_append_section(menu, NULL, G_MENU_MODEL(views));
    g_menu_append_section(menu, NULL, G_MENU_MODEL(overlays));
    g_menu_append_section(menu, NULL, G_MENU_MODEL(zoom));
    g_object_unref(views);
    g_object_unref(overlays);
    g_object_unref(zoom);
    return G_MENU_MODEL(menu);
}
