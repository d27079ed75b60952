/* Keys: the library's table of them as shortcuts, and as a window that tells them. Invariant: keys
 * without Ctrl must not take letters from what is typed into: they come last. */
#include "keys.h"

#include <adwaita.h>
#include <string.h>

#include "words.h"

/* "<Control><Shift>z" of "Ctrl+Shift+z", to be freed; null for a gesture. */
static char *accelerator_of(const char *key)
{
    GString *text = g_string_new(NULL);
    const char *name = key;
    for (; g_str_has_prefix(name, "Ctrl+") || g_str_has_prefix(name, "Shift+");
         name = strchr(name, '+') + 1)
        g_string_append(text, *name == 'C' ? "<Control>" : "<Shift>");
    guint value = !name[1]                     ? gdk_unicode_to_keyval((guchar)*name)
                  : g_str_equal(name, "Space") ? GDK_KEY_space
                                               : gdk_keyval_from_name(name);
    if (value != GDK_KEY_VoidSymbol)
        g_string_append(text, gdk_keyval_name(value));
    return g_string_free(text, value == GDK_KEY_VoidSymbol);
}

static char *detailed_name(const skv_key *key)
{
    const char *group = strchr(key->action, '.') ? "" : "win.";
    return key->argument ? g_strdup_printf("%s%s(%s)", group, key->action, key->argument)
                         : g_strconcat(group, key->action, NULL);
}

/* Menus show these, and they act whatever has the focus. */
static void add_accelerator(GtkApplication *application, const char *detailed, const char *trigger)
{
    char **before = gtk_application_get_accels_for_action(application, detailed);
    if (g_strv_contains((const char *const *)before, trigger)) { /* of another window */
        g_strfreev(before);
        return;
    }
    GStrvBuilder *all = g_strv_builder_new();
    g_strv_builder_addv(all, (const char **)before);
    g_strv_builder_add(all, trigger);
    char **now = g_strv_builder_end(all);
    gtk_application_set_accels_for_action(application, detailed, (const char *const *)now);
    g_strfreev(now);
    g_strv_builder_unref(all);
    g_strfreev(before);
}

static void add_plain(GtkEventController *plain, const char *detailed, const char *trigger)
{
    char *name = NULL;
    GVariant *target = NULL;
    g_action_parse_detailed_name(detailed, &name, &target, NULL);
    GtkShortcut *shortcut =
        gtk_shortcut_new(gtk_shortcut_trigger_parse_string(trigger), gtk_named_action_new(name));
    gtk_shortcut_set_arguments(shortcut, target);
    gtk_shortcut_controller_add_shortcut(GTK_SHORTCUT_CONTROLLER(plain), shortcut);
    g_clear_pointer(&target, g_variant_unref);
    g_free(name);
}

/* Where the same sign is on the keypad. */
static const char *on_keypad(const char *trigger)
{
    return g_str_has_suffix(trigger, "plus")    ? "KP_Add"
           : g_str_has_suffix(trigger, "minus") ? "KP_Subtract"
           : g_str_has_suffix(trigger, "0")     ? "KP_0"
                                                : NULL;
}

static void add_key(const skv_key *key, GtkApplication *application, GtkEventController *plain)
{
    char *detailed = detailed_name(key), *trigger = accelerator_of(key->key);
    const char *keypad = on_keypad(trigger);
    bool ctrl = *trigger == '<', function = *trigger == 'F';
    char *also = keypad ? g_strconcat(ctrl ? "<Control>" : "", keypad, NULL) : NULL;
    for (int i = 0; i < (keypad ? 2 : 1); i++) {
        if (ctrl || function)
            add_accelerator(application, detailed, i == 0 ? trigger : also);
        else
            add_plain(plain, detailed, i == 0 ? trigger : also);
    }
    g_free(also);
    g_free(trigger);
    g_free(detailed);
}

/* The table: a window of its own, for the toolkit's has pages of fixed width. */

/* Adds a row: what happens, and the keys or the gesture for it. */
static void add_row(GtkWidget *group, const char *title, const char *keys)
{
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12);
    GtkWidget *labels[] = {gtk_label_new(title), gtk_label_new(keys)};
    for (int i = 0; i < 2; i++) {
        gtk_label_set_wrap(GTK_LABEL(labels[i]), TRUE);
        gtk_label_set_xalign(GTK_LABEL(labels[i]), (float)i);
        gtk_label_set_justify(GTK_LABEL(labels[i]), i ? GTK_JUSTIFY_RIGHT : GTK_JUSTIFY_LEFT);
        gtk_box_append(GTK_BOX(row), labels[i]);
    }
    gtk_widget_set_hexpand(labels[0], TRUE);
    gtk_widget_add_css_class(labels[1], "dim-label");
    gtk_widget_add_css_class(row, "key");
    gtk_list_box_append(GTK_LIST_BOX(group), row);
}

static GtkWidget *add_group(GtkWidget *box, const char *title)
{
    GtkWidget *heading = gtk_label_new(title), *group = gtk_list_box_new();
    gtk_label_set_xalign(GTK_LABEL(heading), 0);
    gtk_widget_add_css_class(heading, "heading");
    gtk_list_box_set_selection_mode(GTK_LIST_BOX(group), GTK_SELECTION_NONE);
    gtk_widget_add_css_class(group, "boxed-list");
    gtk_box_append(GTK_BOX(box), heading);
    gtk_box_append(GTK_BOX(box), group);
    return group;
}

/* "Ctrl+Z" as people here read it, or a gesture in words. To be freed. */
static char *words_of(const skv_key *key)
{
    char *text = accelerator_of(key->key), *words = NULL;
    GtkShortcutTrigger *trigger = text ? gtk_shortcut_trigger_parse_string(text) : NULL;
    if (trigger) {
        words = gtk_shortcut_trigger_to_label(trigger, gdk_display_get_default());
        g_object_unref(trigger);
    }
    g_free(text);
    return words ? words : g_strdup(play_word(key->key));
}

/* A row: all keys of a title. Returns the index of the last. */
static int add_keys(GtkWidget *group, int i)
{
    const char *title = skv_key_at(i)->title;
    GString *keys = g_string_new(NULL);
    const skv_key *key;
    for (; (key = skv_key_at(i)) && key->title && g_str_equal(key->title, title); i++) {
        char *words = words_of(key);
        g_string_append_printf(keys, "%s%s", keys->len ? " · " : "", words);
        g_free(words);
    }
    add_row(group, play_word(title), keys->str);
    g_string_free(keys, TRUE);
    return i - 1;
}

static void fill(GtkWidget *box)
{
    const char *section = "";
    const skv_key *key;
    const skv_tool *tool;
    GtkWidget *group = NULL;
    for (int i = 0; (key = skv_key_at(i)); i++) {
        if (!g_str_equal(key->section, section)) {
            section = key->section;
            group = add_group(box, play_word(section));
            for (int k = 0; g_str_equal(section, "Tools") && (tool = skv_tool_info(k)); k++)
                add_row(group, play_word(tool->title), (char[]){tool->key, '\0'});
        }
        if (key->title)
            i = add_keys(group, i);
    }
}

/* The toolkit fits a window to the one below it at times only, so its size is asked here. */
static void on_help(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                    gpointer parent)
{
    int width = MIN(480, gtk_widget_get_width(parent)),
        height = MIN(560, gtk_widget_get_height(parent));
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 9), *clamp = adw_clamp_new();
    GtkWidget *page = gtk_scrolled_window_new();
    GtkWidget *window = g_object_new(GTK_TYPE_WINDOW, "transient-for", parent, "modal", TRUE,
                                     "title", _("Keyboard Shortcuts"), "child", page,
                                     "default-width", width, "default-height", height, NULL);
    fill(box);
    gtk_widget_add_css_class(box, "lab");
    adw_clamp_set_child(ADW_CLAMP(clamp), box);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(page), GTK_POLICY_NEVER,
                                   GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(page), clamp);
    GtkEventController *leave = gtk_shortcut_controller_new();
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(leave),
        gtk_shortcut_new(gtk_shortcut_trigger_parse_string("Escape"),
                         gtk_named_action_new("window.close")));
    gtk_widget_add_controller(window, leave);
    gtk_window_present(GTK_WINDOW(window));
}

void play_keys_add(GtkApplicationWindow *window)
{
    GtkApplication *application = gtk_window_get_application(GTK_WINDOW(window));
    GtkEventController *plain = gtk_shortcut_controller_new();
    const skv_key *key;
    const skv_tool *tool;
    for (int i = 0; (key = skv_key_at(i)); i++)
        if (key->action)
            add_key(key, application, plain);
    for (int i = 0; (tool = skv_tool_info(i)); i++) {
        char *detailed = g_strdup_printf("win.tool(%d)", i);
        add_plain(plain, detailed, (char[]){tool->key, '\0'});
        g_free(detailed);
    }
    gtk_widget_add_controller(GTK_WIDGET(window), plain);
    static const GActionEntry help = {.name = "show-help-overlay", .activate = on_help};
    g_action_map_add_action_entries(G_ACTION_MAP(window), &help, 1, window);
}
