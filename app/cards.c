/* Experiment cards. Invariant: what theory says is shown once something was measured, not before:
 * who predicts shall not read it off. */
#include "cards.h"

#include <skvalp/experiments.h>

#include "choices.h"
#include "lab_run.h"
#include "settings.h"
#include "words.h"

typedef struct card {
    const skv_experiment *experiment;
    int number, chosen; /* particles, of the last run */
    skv_render_style style;
    GtkWidget *run, *amount, *progress, *picture, *compare, *measured, *results;
    PlayPlot *plot;
    GCancellable *stop; /* null: it does not run */
} card;

static GtkWidget *add_text(GtkWidget *box, const char *text, const char *class)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    if (class)
        gtk_widget_add_css_class(label, class);
    gtk_box_append(GTK_BOX(box), label);
    return label;
}

static GtkWidget *add_part(GtkWidget *box, const char *heading, const char *text)
{
    GtkWidget *part = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    add_text(part, heading, "heading");
    add_text(part, gettext(text), NULL);
    gtk_box_append(GTK_BOX(box), part);
    return part;
}

/* The number of particles. */

static char *words_of_amount(const card *c)
{
    return g_strdup(play_number(skv_experiment_particles(c->number, c->chosen), 0).text);
}

/* As many as are chosen now. */
static void take_choice(card *c)
{
    c->chosen = play_settings_number("particles", 0);
    char *amount = words_of_amount(c);
    char *text = g_strdup_printf(_("It is measured with %s particles."), amount);
    gtk_label_set_text(GTK_LABEL(c->amount), text);
    g_free(text);
    g_free(amount);
}

static void tell_measured(const card *c, bool well)
{
    char *amount = words_of_amount(c);
    char *text = g_strdup_printf(_("Measured with %s particles"), amount);
    gtk_label_set_text(GTK_LABEL(c->measured), text);
    gtk_widget_set_visible(c->measured, well);
    g_free(text);
    g_free(amount);
}

/* The run. */

static void show_running(card *c, bool running)
{
    gtk_button_set_label(GTK_BUTTON(c->run), running ? _("Stop") : _("Measure"));
    gtk_widget_set_visible(c->progress, running);
}

static void show(const PlayLabNews *news, gpointer data)
{
    card *c = data;
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(c->progress), news->share);
    if (news->picture) {
        gtk_picture_set_paintable(GTK_PICTURE(c->picture), GDK_PAINTABLE(news->picture));
        gtk_widget_set_visible(c->picture, TRUE);
    }
    if (news->curve_count > 0) {
        play_plot_show(c->plot, gettext(c->experiment->x_label), gettext(c->experiment->y_label), 1,
                       news->curves, news->curve_count);
        gtk_widget_set_visible(GTK_WIDGET(c->plot), TRUE);
    }
    if (!news->ended)
        return;
    tell_measured(c, !news->error);
    gtk_label_set_text(GTK_LABEL(c->results), news->error ? news->error : news->results);
    gtk_widget_set_visible(c->compare, TRUE);
    g_clear_object(&c->stop);
    show_running(c, false);
}

static void on_run(G_GNUC_UNUSED GtkButton *button, card *c)
{
    if (c->stop) {
        g_cancellable_cancel(c->stop);
        g_clear_object(&c->stop);
        show_running(c, false);
        return;
    }
    c->stop = g_cancellable_new();
    show_running(c, true);
    take_choice(c);
    play_lab_run(c->number, c->chosen, &c->style, c->stop, show, c);
}

static void free_card(gpointer data)
{
    card *c = data;
    if (c->stop)
        g_cancellable_cancel(c->stop);
    g_clear_object(&c->stop);
    g_free(c);
}

static void add_measurement(card *c, GtkWidget *box)
{
    GtkWidget *part = add_part(box, _("3. Measure"), c->experiment->measure);
    c->run = gtk_button_new();
    gtk_widget_set_halign(c->run, GTK_ALIGN_START);
    gtk_widget_add_css_class(c->run, "suggested-action");
    gtk_widget_add_css_class(c->run, "pill");
    g_signal_connect(c->run, "clicked", G_CALLBACK(on_run), c);
    c->progress = gtk_progress_bar_new();
    c->picture = gtk_picture_new();
    gtk_picture_set_alternative_text(GTK_PICTURE(c->picture), _("The experiment as it runs"));
    gtk_widget_set_size_request(c->picture, -1, 220);
    gtk_widget_set_visible(c->picture, FALSE);
    c->plot = g_object_new(PLAY_TYPE_PLOT, NULL);
    gtk_widget_set_size_request(GTK_WIDGET(c->plot), -1, 260);
    gtk_widget_set_visible(GTK_WIDGET(c->plot), FALSE);
    gtk_box_append(GTK_BOX(part), c->run);
    c->amount = add_text(part, "", "caption");
    take_choice(c);
    gtk_box_append(GTK_BOX(part), c->progress);
    gtk_box_append(GTK_BOX(part), c->picture);
    gtk_box_append(GTK_BOX(part), GTK_WIDGET(c->plot));
    show_running(c, false);
}

/* What is measured, to play with: two liquids or resolutions side by side. */
static void add_scene(GtkWidget *box, const char *experiment)
{
    GtkWidget *button = gtk_menu_button_new();
    char *scene = play_choices_scene_of(experiment);
    GMenuModel *menu = play_choices_menu(scene);
    g_free(scene);
    gtk_menu_button_set_label(GTK_MENU_BUTTON(button), _("See Two Worlds Side by Side"));
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(button), menu);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("See Two Worlds Side by Side"), -1);
    gtk_widget_set_halign(button, GTK_ALIGN_START);
    gtk_box_append(GTK_BOX(box), button);
    g_object_unref(menu);
}

GtkWidget *play_card_new(int experiment, const skv_render_style *style)
{
    card *c = g_new0(card, 1);
    c->experiment = skv_experiment_info(experiment);
    c->number = experiment;
    c->style = *style;

    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 18);
    gtk_widget_add_css_class(box, "lab");
    add_text(box, gettext(c->experiment->title), "title-1");
    add_text(box, gettext(c->experiment->description), "dim-label");
    add_part(box, _("1. Question"), c->experiment->question);
    GtkWidget *predict = add_part(box, _("2. Predict"), c->experiment->predict);
    GtkWidget *entry = gtk_entry_new();
    gtk_entry_set_placeholder_text(GTK_ENTRY(entry), _("Your prediction"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(entry), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Your prediction"), -1);
    gtk_box_append(GTK_BOX(predict), entry);
    add_measurement(c, box);
    add_scene(box, c->experiment->name);
    c->compare = add_part(box, _("4. Compare"), c->experiment->compare);
    c->measured = add_text(c->compare, "", "caption");
    c->results = add_text(c->compare, "", "numeric");
    gtk_label_set_selectable(GTK_LABEL(c->results), TRUE);
    gtk_widget_set_visible(c->compare, FALSE);

    GtkWidget *clamp = adw_clamp_new();
    adw_clamp_set_maximum_size(ADW_CLAMP(clamp), 680);
    adw_clamp_set_child(ADW_CLAMP(clamp), box);
    GtkWidget *page = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(page), GTK_POLICY_NEVER,
                                   GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(page), clamp);
    g_object_set_data_full(G_OBJECT(page), "card", c, free_card);
    return page;
}

GtkWidget *play_cards_list(void)
{
    GtkWidget *list = gtk_list_box_new();
    const skv_experiment *experiment;
    gtk_list_box_set_selection_mode(GTK_LIST_BOX(list), GTK_SELECTION_NONE);
    gtk_widget_add_css_class(list, "boxed-list");
    for (int i = 0; (experiment = skv_experiment_info(i)); i++) {
        GtkWidget *row = adw_action_row_new();
        char *title = g_markup_escape_text(gettext(experiment->title), -1);
        char *text = g_markup_escape_text(gettext(experiment->description), -1);
        adw_preferences_row_set_title(ADW_PREFERENCES_ROW(row), title);
        adw_action_row_set_subtitle(ADW_ACTION_ROW(row), text);
        gtk_list_box_row_set_activatable(GTK_LIST_BOX_ROW(row), TRUE);
        gtk_actionable_set_action_name(GTK_ACTIONABLE(row), "win.experiment");
        gtk_actionable_set_action_target(GTK_ACTIONABLE(row), "i", i);
        adw_action_row_add_suffix(ADW_ACTION_ROW(row),
                                  gtk_image_new_from_icon_name("go-next-symbolic"));
        gtk_list_box_append(GTK_LIST_BOX(list), row);
        g_free(title);
        g_free(text);
    }
    return list;
}
