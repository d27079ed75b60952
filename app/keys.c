/* Keys: the library's table of them as shortcuts, and as a window that tells them. Invariant: keys
 * without Ctrl must not take letters from what is typed into: they come last. */
#include "keys.h"

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

/* The window. */

static void append(GString *xml, const char *property, const char *text)
{
    char *escaped = g_markup_escape_text(text, -1);
    g_string_append_printf(xml, "<property name='%s'>%s</property>", property, escaped);
    g_free(escaped);
}

static void begin(GString *xml, const char *class)
{
    g_string_append_printf(xml, "<child><object class='%s'>", class);
}

static void end(GString *xml)
{
    g_string_append(xml, "</object></child>");
}

/* A row: all keys of a title. Returns the index of the last. */
static int append_row(GString *xml, int i)
{
    GString *keys = g_string_new(NULL);
    const char *title = skv_key_at(i)->title, *gesture = NULL;
    const skv_key *key;
    begin(xml, "GtkShortcutsShortcut");
    append(xml, "title", play_word(title));
    for (; (key = skv_key_at(i)) && key->title && g_str_equal(key->title, title); i++) {
        char *accelerator = accelerator_of(key->key);
        if (accelerator)
            g_string_append_printf(keys, "%s%s", keys->len ? " " : "", accelerator);
        else
            gesture = play_word(key->key);
        g_free(accelerator);
    }
    if (gesture)
        append(xml, "subtitle", gesture);
    if (keys->len > 0)
        append(xml, "accelerator", keys->str);
    end(xml);
    g_string_free(keys, TRUE);
    return i - 1;
}

static void append_tools(GString *xml)
{
    const skv_tool *tool;
    for (int i = 0; (tool = skv_tool_info(i)); i++) {
        begin(xml, "GtkShortcutsShortcut");
        append(xml, "title", play_word(tool->title));
        append(xml, "accelerator", (char[]){tool->key, '\0'});
        end(xml);
    }
}

static void add_window(GtkApplicationWindow *window)
{
    GString *xml = g_string_new("<interface><object class='GtkShortcutsWindow' id='overlay'>");
    const skv_key *key;
    const char *section = "";
    append(xml, "modal", "True");
    begin(xml, "GtkShortcutsSection");
    append(xml, "section-name", "shortcuts");
    append(xml, "max-height", "14");
    for (int i = 0; (key = skv_key_at(i)); i++) {
        if (!g_str_equal(key->section, section)) {
            if (*section)
                end(xml);
            section = key->section;
            begin(xml, "GtkShortcutsGroup");
            append(xml, "title", play_word(section));
            if (g_str_equal(section, "Tools"))
                append_tools(xml);
        }
        if (key->title)
            i = append_row(xml, i);
    }
    end(xml);
    end(xml);
    g_string_append(xml, "</object></interface>");
    GtkBuilder *builder = gtk_builder_new_from_string(xml->str, (gssize)xml->len);
    GObject *overlay = gtk_builder_get_object(builder, "overlay");
    gtk_application_window_set_help_overlay(window, GTK_SHORTCUTS_WINDOW(overlay));
    g_object_unref(builder);
    g_string_free(xml, TRUE);
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
    add_window(window);
}
