/* Preferences: light and dark, detail, units, the gravity ball, where links lead, and the sensor.
 * Invariant: a choice acts at once and is remembered at once. */
#include "preferences.h"

#include "sensor.h"
#include "settings.h"
#include "words.h"

static const AdwColorScheme schemes[] = {ADW_COLOR_SCHEME_DEFAULT, ADW_COLOR_SCHEME_FORCE_LIGHT,
                                         ADW_COLOR_SCHEME_FORCE_DARK};

static void set_scheme(int number)
{
    adw_style_manager_set_color_scheme(adw_style_manager_get_default(),
                                       schemes[CLAMP(number, 0, (int)G_N_ELEMENTS(schemes) - 1)]);
}

static void set_detail(PlayView *view, const char *name)
{
    skv_render_style style = *play_view_style(view);
    if (skv_render_style_set(&style, SKV_STYLE_DETAIL, name, NULL) == SKV_OK)
        play_view_set_style(view, &style);
}

void play_preferences_apply(PlayView *view, GtkWidget *ball)
{
    char *detail = play_settings_text("detail", "auto");
    set_scheme(play_settings_number("scheme", 0));
    set_detail(view, detail);
    play_words_set_si(play_settings_number("si", 0) != 0);
    gtk_widget_set_visible(ball, play_settings_number("ball", 1) != 0);
    g_free(detail);
}

static void on_scheme(AdwComboRow *row)
{
    int number = (int)adw_combo_row_get_selected(row);
    set_scheme(number);
    play_settings_set_number("scheme", number);
}

static void on_detail(AdwComboRow *row, G_GNUC_UNUSED GParamSpec *spec, PlayView *view)
{
    const skv_style_choice *choice =
        skv_style_choice_at(SKV_STYLE_DETAIL, (int)adw_combo_row_get_selected(row));
    set_detail(view, choice->name);
    play_settings_set_text("detail", choice->name);
}

/* What shows readings takes them from the view, as if it had news. */
static void on_units(AdwComboRow *row, G_GNUC_UNUSED GParamSpec *spec, PlayView *view)
{
    int si = adw_combo_row_get_selected(row) == 1;
    play_words_set_si(si);
    play_settings_set_number("si", si);
    g_signal_emit_by_name(view, "changed");
}

static void on_ball(GtkSwitch *control, G_GNUC_UNUSED GParamSpec *spec, GtkWidget *ball)
{
    gtk_widget_set_visible(ball, gtk_switch_get_active(control));
    play_settings_set_number("ball", gtk_switch_get_active(control));
}

static void on_page(GtkEditable *entry)
{
    char *page = g_strstrip(g_strdup(gtk_editable_get_text(entry)));
    play_settings_set_text("page", page);
    g_free(page);
}

static GtkWidget *make_combo(const char *title, const char *const *names, int selected)
{
    GtkWidget *row = adw_combo_row_new();
    GtkStringList *list = gtk_string_list_new(names);
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(row), title);
    adw_combo_row_set_model(ADW_COMBO_ROW(row), G_LIST_MODEL(list));
    adw_combo_row_set_selected(ADW_COMBO_ROW(row), (guint)selected);
    g_object_unref(list);
    return row;
}

static GtkWidget *make_detail(PlayView *view)
{
    const char *names[8] = {NULL};
    int selected = 0;
    const skv_style_choice *choice;
    for (int i = 0; i < 7 && (choice = skv_style_choice_at(SKV_STYLE_DETAIL, i)); i++) {
        names[i] = play_word(choice->label);
        if (choice->value == (int)play_view_style(view)->detail)
            selected = i;
    }
    GtkWidget *row = make_combo(_("Detail"), names, selected);
    g_signal_connect(row, "notify::selected", G_CALLBACK(on_detail), view);
    return row;
}

static void on_up(AdwComboRow *row, G_GNUC_UNUSED GParamSpec *spec, PlaySensor *sensor)
{
    play_sensor_set_up(sensor, (int)adw_combo_row_get_selected(row));
}

static void on_strength(GtkRange *range, PlaySensor *sensor)
{
    play_sensor_set_strength(sensor, gtk_range_get_value(range));
}

static char *strength_text(G_GNUC_UNUSED GtkScale *scale, double value, G_GNUC_UNUSED gpointer data)
{
    return g_strdup(play_number(value, 1).text);
}

static AdwPreferencesGroup *make_sensor(PlaySensor *sensor)
{
    AdwPreferencesGroup *group = ADW_PREFERENCES_GROUP(adw_preferences_group_new());
    adw_preferences_group_set_title(group, _("Tilt Sensor"));
    const char *const edges[] = {_("As it is built"), _("Left edge"), _("Lower edge"),
                                 _("Right edge"), NULL};
    GtkWidget *up = make_combo(_("Up on the screen is"), edges, play_sensor_up(sensor));
    g_signal_connect(up, "notify::selected", G_CALLBACK(on_up), sensor);
    adw_preferences_group_add(group, up);

    GtkWidget *row = adw_action_row_new();
    GtkWidget *scale = gtk_scale_new_with_range(GTK_ORIENTATION_HORIZONTAL, 0, 2, 0.1);
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(row), _("Strength"));
    adw_action_row_set_subtitle(ADW_ACTION_ROW(row), _("Against the scene's own gravity"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(scale), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Strength"), -1);
    gtk_scale_add_mark(GTK_SCALE(scale), 1, GTK_POS_BOTTOM, NULL);
    gtk_scale_set_draw_value(GTK_SCALE(scale), TRUE);
    gtk_scale_set_value_pos(GTK_SCALE(scale), GTK_POS_LEFT);
    gtk_scale_set_format_value_func(GTK_SCALE(scale), strength_text, NULL, NULL);
    gtk_range_set_value(GTK_RANGE(scale), play_sensor_strength(sensor));
    gtk_widget_set_size_request(scale, 180, -1);
    g_signal_connect(scale, "value-changed", G_CALLBACK(on_strength), sensor);
    adw_action_row_add_suffix(ADW_ACTION_ROW(row), scale);
    adw_preferences_group_add(group, row);
    return group;
}

void play_preferences_show(GtkWindow *parent, PlayView *view, GtkWidget *ball)
{
    const char *const names[] = {_("As the system"), _("Light"), _("Dark"), NULL};
    GtkWidget *scheme = make_combo(_("Colours"), names, play_settings_number("scheme", 0));
    g_signal_connect(scheme, "notify::selected", G_CALLBACK(on_scheme), NULL);

    const char *const systems[] = {_("Everyday (cm of water)"), _("SI (Pa m)"), NULL};
    GtkWidget *units = make_combo(_("Units"), systems, play_words_si());
    g_signal_connect(units, "notify::selected", G_CALLBACK(on_units), view);

    GtkWidget *gravity = adw_action_row_new(), *control = gtk_switch_new();
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(gravity), _("Gravity ball"));
    gtk_switch_set_active(GTK_SWITCH(control), gtk_widget_get_visible(ball));
    gtk_widget_set_valign(control, GTK_ALIGN_CENTER);
    g_signal_connect(control, "notify::active", G_CALLBACK(on_ball), ball);
    adw_action_row_add_suffix(ADW_ACTION_ROW(gravity), control);
    adw_action_row_set_activatable_widget(ADW_ACTION_ROW(gravity), control);

    GtkWidget *address = adw_entry_row_new();
    char *kept = play_settings_text("page", "");
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(address), _("Web page that links lead to"));
    gtk_editable_set_text(GTK_EDITABLE(address), kept);
    g_signal_connect(address, "changed", G_CALLBACK(on_page), NULL);
    g_free(kept);

    GtkWidget *group = adw_preferences_group_new(), *page = adw_preferences_page_new();
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), scheme);
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), make_detail(view));
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), units);
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), gravity);
    adw_preferences_group_add(ADW_PREFERENCES_GROUP(group), address);
    adw_preferences_page_add(ADW_PREFERENCES_PAGE(page), ADW_PREFERENCES_GROUP(group));
    if (play_sensor_of(view))
        adw_preferences_page_add(ADW_PREFERENCES_PAGE(page), make_sensor(play_sensor_of(view)));
    GtkWidget *window = adw_preferences_window_new();
    adw_preferences_window_add(ADW_PREFERENCES_WINDOW(window), ADW_PREFERENCES_PAGE(page));
    adw_preferences_window_set_search_enabled(ADW_PREFERENCES_WINDOW(window), FALSE);
    gtk_window_set_transient_for(GTK_WINDOW(window), parent);
    gtk_window_set_modal(GTK_WINDOW(window), TRUE);
    gtk_window_present(GTK_WINDOW(window));
}
