/* Properties: rows made from the registry, with units, help and a way back. Invariants: a row shows
 * what the picture's world has, whoever changed it or went back in time, or what was typed and
 * refused, with the reason below its title; no parameter is named here, but for the quick choices
 * of planets: a new row of the registry that can be changed while a world runs is a new row of the
 * panel. */
#include "properties.h"

#include <string.h>

#include "skvalp/parameters.h"
#include "words.h"

typedef struct property {
    PlayView *view;
    const skv_field *field;
    GtkWidget *row, *control, *reset;
    char *help;        /* with the unit, escaped */
    char standard[64]; /* as the scene began */
    char shown[64];    /* the picture's */
    bool showing;      /* the control is moved by us */
    bool refused;      /* what the control shows was typed, and is not taken */
} property;

typedef struct panel {
    PlayView *view;
    GPtrArray *rows;
    gulong handler;
    guint32 opened; /* what the rows show */
} panel;

/* What has become of it the next picture says. */
static void set(property *row, const char *text)
{
    skv_stage_set(play_view_stage(row->view), play_view_side(row->view), row->field->path, text);
}

/* Controls. */

/* `words` are why it is refused, with two numbers in them; null: it is taken. */
static void tell_refusal(property *row, const char *words)
{
    row->refused = words != NULL;
    char *why = words ? play_words_with(words, row->field->minimum, row->field->maximum) : NULL;
    adw_action_row_set_subtitle(ADW_ACTION_ROW(row->row), why ? why : row->help);
    gtk_accessible_update_state(GTK_ACCESSIBLE(row->control), GTK_ACCESSIBLE_STATE_INVALID,
                                why ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE,
                                -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row->control),
                                   GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, why ? why : row->help, -1);
    if (why)
        gtk_widget_add_css_class(row->row, "error");
    else
        gtk_widget_remove_css_class(row->row, "error");
    g_free(why);
}

static void on_entry(GtkEntry *entry, property *row)
{
    char text[64];
    skv_number_read(gtk_editable_get_text(GTK_EDITABLE(entry)), play_numerals(), text, sizeof text);
    tell_refusal(row, skv_field_refusal(row->field, text));
    if (!row->refused)
        set(row, text);
}

static void on_switch(GtkSwitch *control, G_GNUC_UNUSED GParamSpec *spec, property *row)
{
    if (!row->showing)
        set(row, gtk_switch_get_active(control) ? "true" : "false");
}

static void on_choice(GtkDropDown *control, G_GNUC_UNUSED GParamSpec *spec, property *row)
{
    char **choices = g_strsplit(row->field->choices, "|", -1);
    guint chosen = gtk_drop_down_get_selected(control);
    if (!row->showing && chosen < g_strv_length(choices))
        set(row, choices[chosen]);
    g_strfreev(choices);
}

static void show_value(property *row, const char *text)
{
    row->showing = true;
    if (GTK_IS_SWITCH(row->control)) {
        gtk_switch_set_active(GTK_SWITCH(row->control), strcmp(text, "true") == 0);
    } else if (GTK_IS_DROP_DOWN(row->control)) {
        char **choices = g_strsplit(row->field->choices, "|", -1);
        for (guint i = 0; choices[i]; i++)
            if (strcmp(choices[i], text) == 0)
                gtk_drop_down_set_selected(GTK_DROP_DOWN(row->control), i);
        g_strfreev(choices);
    } else {
        gtk_editable_set_text(GTK_EDITABLE(row->control),
                              skv_number_shown(text, play_numerals()).text);
        if (row->refused)
            tell_refusal(row, NULL);
    }
    row->showing = false;
}

static void on_reset(G_GNUC_UNUSED GtkButton *button, property *row)
{
    set(row, row->standard);
}

/* What was typed and not entered is forgotten. */
static void on_entry_left(G_GNUC_UNUSED GtkEventControllerFocus *controller, property *row)
{
    if (!row->refused)
        show_value(row, row->shown);
}

static GtkWidget *make_choices(const char *list)
{
    char **choices = g_strsplit(list, "|", -1);
    GtkStringList *names = gtk_string_list_new(NULL);
    for (int i = 0; choices[i]; i++)
        gtk_string_list_append(names, play_word(choices[i]));
    g_strfreev(choices);
    return gtk_drop_down_new(G_LIST_MODEL(names), NULL);
}

static GtkWidget *make_control(property *row)
{
    GtkWidget *control;
    if (row->field->type == SKV_FIELD_BOOLEAN) {
        control = gtk_switch_new();
        g_signal_connect(control, "notify::active", G_CALLBACK(on_switch), row);
    } else if (row->field->type == SKV_FIELD_CHOICE) {
        control = make_choices(row->field->choices);
        g_signal_connect(control, "notify::selected", G_CALLBACK(on_choice), row);
    } else {
        control = gtk_entry_new();
        gtk_editable_set_width_chars(GTK_EDITABLE(control), 9);
        gtk_editable_set_max_width_chars(GTK_EDITABLE(control), 9);
        gtk_entry_set_alignment(GTK_ENTRY(control), 1);
        gtk_entry_set_input_purpose(GTK_ENTRY(control), GTK_INPUT_PURPOSE_NUMBER);
        g_signal_connect(control, "activate", G_CALLBACK(on_entry), row);
        GtkEventController *focus = gtk_event_controller_focus_new();
        g_signal_connect(focus, "leave", G_CALLBACK(on_entry_left), row);
        gtk_widget_add_controller(control, focus);
    }
    gtk_widget_set_valign(control, GTK_ALIGN_CENTER);
    return control;
}

static GtkWidget *make_row(property *row)
{
    const skv_field *field = row->field;
    char *title = play_title_of_path(field->path);
    char *unit = *field->unit ? g_strdup_printf("%s · ", skv_unit_of(field->unit, false).name)
                              : g_strdup("");
    char *text = g_strdup_printf("%s%s", unit, play_word(field->help));
    GtkWidget *widget = adw_action_row_new();
    row->row = widget;
    row->help = g_markup_escape_text(text, -1);
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(widget), title);
    adw_action_row_set_subtitle(ADW_ACTION_ROW(widget), row->help);
    row->control = make_control(row);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row->control), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   title, GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
    if (GTK_IS_DROP_DOWN(row->control)) /* the button proper is inside */
        gtk_accessible_update_property(GTK_ACCESSIBLE(gtk_widget_get_first_child(row->control)),
                                       GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    row->reset = gtk_button_new_from_icon_name("edit-undo-symbolic");
    gtk_widget_set_tooltip_text(row->reset, _("As the scene began"));
    gtk_widget_set_valign(row->reset, GTK_ALIGN_CENTER);
    gtk_widget_set_visible(row->reset, FALSE);
    gtk_widget_add_css_class(row->reset, "flat");
    g_signal_connect(row->reset, "clicked", G_CALLBACK(on_reset), row);
    adw_action_row_add_suffix(ADW_ACTION_ROW(widget), row->reset);
    adw_action_row_add_suffix(ADW_ACTION_ROW(widget), row->control);
    g_free(text);
    g_free(unit);
    g_free(title);
    return widget;
}

/* The rows follow the picture. */

static void read_row(const property *row, const skv_world_def *def, char text[64])
{
    skv_world_def_get(def, row->field->path, text, sizeof row->shown, NULL);
}

/* What the scene began with. */
static void read_standards(const panel *p, const skv_scene *scene)
{
    skv_world_def def = scene ? skv_scene_world_def(scene) : skv_default_world_def();
    for (guint i = 0; i < p->rows->len; i++) {
        property *row = p->rows->pdata[i];
        read_row(row, &def, row->standard);
    }
    skv_terrain_destroy(def.terrain);
}

static void show_row(property *row, const skv_world_def *def)
{
    char text[64];
    read_row(row, def, text);
    gtk_widget_set_visible(row->reset, strcmp(text, row->standard) != 0);
    if (strcmp(text, row->shown) == 0)
        return;
    g_strlcpy(row->shown, text, sizeof row->shown);
    show_value(row, text);
}

static void on_changed(PlayView *view, panel *p)
{
    const skv_picture *picture = play_view_picture(view);
    if (picture->opened != p->opened)
        read_standards(p, picture->scene);
    p->opened = picture->opened;
    for (guint i = 0; i < p->rows->len; i++)
        show_row(p->rows->pdata[i], &picture->parameters);
}

/* Quick choices. */

static void on_planet(GtkButton *button, panel *p)
{
    skv_control_planet(play_view_stage(p->view), play_view_side(p->view),
                       g_object_get_data(G_OBJECT(button), "planet"));
}

static GtkWidget *make_planets(panel *p)
{
    GtkWidget *group = adw_preferences_group_new();
    GtkWidget *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 0);
    adw_preferences_group_set_title(ADW_PREFERENCES_GROUP(group), _("Gravity as on"));
    gtk_widget_add_css_class(buttons, "linked");
    const skv_named_number *planet;
    for (int i = 0; (planet = skv_planet_at(i)); i++) {
        GtkWidget *button = gtk_button_new_with_label(play_word(planet->title));
        gtk_widget_set_hexpand(button, TRUE);
        gtk_widget_add_css_class(button, "planet");
        g_object_set_data(G_OBJECT(button), "planet", (gpointer)planet);
        g_signal_connect(button, "clicked", G_CALLBACK(on_planet), p);
        gtk_box_append(GTK_BOX(buttons), button);
    }
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), buttons);
    return group;
}

/* "fluid" of "fluid.viscosity"; "world" of what has no group. */
static char *group_of(const char *path)
{
    const char *dot = strchr(path, '.');
    return dot ? g_strndup(path, (gsize)(dot - path)) : g_strdup("world");
}

static void free_row(gpointer data)
{
    property *row = data;
    g_free(row->help);
    g_free(row);
}

static void free_panel(gpointer data)
{
    panel *p = data;
    g_ptr_array_free(p->rows, TRUE);
    g_free(p);
}

void play_properties_fill(GtkBox *box, PlayView *view)
{
    panel *p = g_new0(panel, 1);
    p->view = view;
    p->rows = g_ptr_array_new_with_free_func(free_row);
    g_object_set_data_full(G_OBJECT(box), "panel", p, free_panel);
    gtk_box_append(box, make_planets(p));

    GHashTable *groups = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    const skv_field *field;
    for (int i = 0; (field = skv_world_field(i)); i++) {
        if (!skv_world_can_change(field->path))
            continue;
        char *name = group_of(field->path);
        GtkWidget *group = g_hash_table_lookup(groups, name);
        if (!group) {
            char *title = play_title_of_path(name);
            group = adw_preferences_group_new();
            adw_preferences_group_set_title(ADW_PREFERENCES_GROUP(group), title);
            gtk_box_append(box, group);
            g_hash_table_insert(groups, g_strdup(name), group);
            g_free(title);
        }
        g_free(name);
        property *row = g_new0(property, 1);
        row->view = view;
        row->field = field;
        g_ptr_array_add(p->rows, row);
        adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), make_row(row));
    }
    g_hash_table_unref(groups);
    read_standards(p, NULL);
    on_changed(view, p);
    p->handler = g_signal_connect(view, "changed", G_CALLBACK(on_changed), p);
}

void play_properties_show(GtkBox *box, PlayView *view)
{
    panel *p = g_object_get_data(G_OBJECT(box), "panel");
    g_clear_signal_handler(&p->handler, p->view);
    p->view = view;
    p->opened = 0;
    for (guint i = 0; i < p->rows->len; i++)
        ((property *)p->rows->pdata[i])->view = view;
    on_changed(view, p);
    p->handler = g_signal_connect(view, "changed", G_CALLBACK(on_changed), p);
}
