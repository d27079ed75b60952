/* Comparing. Invariant: there are two views exactly while there are two worlds. */
#include "compare.h"

#include "ball.h"
#include "choices.h"
#include "input.h"
#include "lab_run.h"
#include "legend.h"
#include "probes.h"
#include "properties.h"
#include "settings.h"
#include "words.h"

typedef struct compare {
    PlayWindow *window;
    PlayView *view, *other;          /* null: one world */
    const skv_choice *choice, *next; /* next: once a scene has been opened */
    GtkWidget *stage, *badges[2], *amount, *ball, *sides[2], *bar;
} compare;

static void set_label(GtkWidget *widget, const char *label)
{
    gtk_accessible_update_property(GTK_ACCESSIBLE(widget), GTK_ACCESSIBLE_PROPERTY_LABEL, label,
                                   -1);
}

static GSimpleAction *action_of(compare *c, const char *name)
{
    return G_SIMPLE_ACTION(g_action_map_lookup_action(G_ACTION_MAP(c->window), name));
}

/* The two worlds' names. */

static GtkWidget *make_badge(const char *letter, const char *style, const char *text)
{
    GtkWidget *badge = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    GtkWidget *name = gtk_label_new(letter), *what = gtk_label_new(text);
    gtk_widget_add_css_class(name, "letter");
    gtk_widget_add_css_class(name, style);
    gtk_label_set_ellipsize(GTK_LABEL(what), PANGO_ELLIPSIZE_END);
    gtk_box_append(GTK_BOX(badge), name);
    gtk_box_append(GTK_BOX(badge), what);
    gtk_widget_add_css_class(badge, "status");
    gtk_widget_add_css_class(badge, "badge");
    gtk_widget_set_halign(badge, GTK_ALIGN_CENTER);
    gtk_widget_set_valign(badge, GTK_ALIGN_END);
    gtk_widget_set_can_target(badge, FALSE);
    return badge;
}

static GtkWidget *make_button(GtkWidget *button, const char *icon, const char *name,
                              const char *action)
{
    gtk_button_set_icon_name(GTK_BUTTON(button), icon);
    gtk_widget_set_tooltip_text(button, name);
    set_label(button, name);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_widget_set_focus_on_click(button, FALSE);
    gtk_widget_add_css_class(button, "osd");
    gtk_widget_add_css_class(button, "circular");
    gtk_widget_add_css_class(button, "both");
    return button;
}

/* Lays something over a stage, at a corner. */
static void lay(GtkWidget *stage, GtkWidget *over, GtkAlign x, GtkAlign y)
{
    gtk_widget_set_halign(over, x);
    gtk_widget_set_valign(over, y);
    gtk_overlay_add_overlay(GTK_OVERLAY(stage), over);
}

/* The second world's own: names, amount, link and a way to close it; a legend and a gravity ball,
 * which show where they differ from the first's. */
static GtkWidget *make_stage(compare *c)
{
    GtkWidget *stage = gtk_overlay_new(), *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    GtkWidget *corner = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    PlayProbes *probes = g_object_new(PLAY_TYPE_PROBES, NULL);
    PlayLegend *legend = g_object_new(PLAY_TYPE_LEGEND, NULL);
    c->ball = g_object_new(PLAY_TYPE_BALL, NULL);
    c->amount = gtk_label_new("");
    gtk_widget_add_css_class(c->amount, "status");
    gtk_widget_add_css_class(c->amount, "numeric");
    gtk_widget_set_can_target(c->amount, FALSE);
    gtk_box_append(GTK_BOX(buttons),
                   make_button(gtk_toggle_button_new(), "skvalp-both-symbolic",
                               _("Hands and gravity in both worlds"), "win.compare-linked"));
    gtk_box_append(GTK_BOX(buttons), make_button(gtk_button_new(), "window-close-symbolic",
                                                 _("Close world B (C)"), "win.close-compare"));
    gtk_widget_add_css_class(buttons, "leave");
    gtk_widget_set_halign(buttons, GTK_ALIGN_END);
    gtk_widget_set_halign(GTK_WIDGET(legend), GTK_ALIGN_END);
    gtk_box_append(GTK_BOX(corner), buttons);
    gtk_box_append(GTK_BOX(corner), GTK_WIDGET(legend));
    c->badges[0] = make_badge("A", "world-a", _("As it is"));
    c->badges[1] = make_badge("B", "world-b", play_word(c->choice->title));
    gtk_overlay_set_child(GTK_OVERLAY(stage), GTK_WIDGET(c->other));
    gtk_overlay_add_overlay(GTK_OVERLAY(stage), GTK_WIDGET(probes));
    lay(stage, c->amount, GTK_ALIGN_START, GTK_ALIGN_START);
    gtk_overlay_add_overlay(GTK_OVERLAY(stage), c->badges[1]);
    lay(stage, corner, GTK_ALIGN_END, GTK_ALIGN_START);
    lay(stage, c->ball, GTK_ALIGN_END, GTK_ALIGN_END);
    gtk_overlay_add_overlay(GTK_OVERLAY(play_window_stage(c->window)), c->badges[0]);
    play_probes_attach(probes, c->other, NULL);
    play_legend_attach(legend, c->other);
    play_ball_attach(PLAY_BALL(c->ball), c->other);
    return stage;
}

/* Which world the properties are of. */
static void on_side(GtkToggleButton *side, compare *c)
{
    PlayView *view = side == GTK_TOGGLE_BUTTON(c->sides[1]) ? c->other : c->view;
    if (view && gtk_toggle_button_get_active(side))
        play_properties_show(play_window_properties(c->window), view);
}

static void show_sides(compare *c, bool shown)
{
    gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(c->sides[shown]), TRUE);
    gtk_widget_set_visible(c->bar, shown);
    g_simple_action_set_enabled(action_of(c, "close-compare"), shown);
    g_simple_action_set_enabled(action_of(c, "compare-linked"), shown);
}

/* Ending. */

/* The second view goes; its world has, or goes with it. */
static void end(compare *c)
{
    if (!c->other)
        return;
    show_sides(c, false);
    play_properties_show(play_window_properties(c->window), c->view);
    g_signal_handlers_disconnect_by_data(c->other, c);
    play_view_end_twin(c->view);
    gtk_overlay_remove_overlay(GTK_OVERLAY(play_window_stage(c->window)), c->badges[0]);
    gtk_box_remove(play_window_worlds(c->window), c->stage);
    set_label(GTK_WIDGET(c->view), _("Water"));
    gtk_widget_grab_focus(GTK_WIDGET(c->view));
    c->other = NULL;
}

static void end_both(compare *c)
{
    skv_stage_end_compare(play_view_stage(c->view));
    end(c);
}

/* Beginning. */

/* A ball of its own: for who asks each world alone, and where gravity is another one. */
static void show_ball(compare *c)
{
    const skv_picture *a = play_view_picture(c->view), *b = play_view_picture(c->other);
    bool own = !skv_stage_linked(play_view_stage(c->view)) || a->tilt_x != b->tilt_x ||
               a->tilt_y != b->tilt_y;
    gtk_widget_set_visible(c->ball, own && gtk_widget_get_visible(play_window_ball(c->window)));
}

static void on_other_changed(PlayView *other, compare *c)
{
    show_ball(c);
    char *amount = play_words_of_amount(play_view_picture(other));
    char *text = play_words_of_picture(play_view_stage(other), play_view_picture(other));
    if (g_strcmp0(gtk_label_get_text(GTK_LABEL(c->amount)), amount) != 0) {
        gtk_label_set_text(GTK_LABEL(c->amount), amount);
        gtk_accessible_update_property(GTK_ACCESSIBLE(other), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                       text, -1);
    }
    g_free(amount);
    g_free(text);
}

/* The second world is there, or cannot be. */
static void on_compared(PlayView *view, const char *error, compare *c)
{
    if (error) {
        play_window_complain(c->window, error);
        return;
    }
    const skv_choice *choice = skv_choice_named(skv_stage_choice(play_view_stage(view)));
    c->choice = choice ? choice : skv_choice_at(0); /* a link may say another one, or none */
    g_simple_action_set_state(action_of(c, "compare-linked"),
                              g_variant_new_boolean(skv_stage_linked(play_view_stage(view))));
    end(c);
    c->other = g_object_new(PLAY_TYPE_VIEW, NULL);
    play_view_begin(c->other, view);
    g_signal_connect(c->other, "changed", G_CALLBACK(on_other_changed), c);
    c->stage = make_stage(c);
    gtk_box_append(play_window_worlds(c->window), c->stage);
    play_input_attach(c->other);
    play_window_hide_description(c->window);
    set_label(GTK_WIDGET(view), _("World A"));
    set_label(GTK_WIDGET(c->other), _("World B"));
    show_sides(c, true);
    on_other_changed(c->other, c);
}

static void begin(compare *c, const skv_choice *choice)
{
    c->choice = choice;
    play_settings_set_text("compare", choice->name);
    play_window_show_page(c->window, "play");
    skv_control_compare(play_view_stage(c->view), choice);
}

/* Something else is open: nothing to compare with. */
static void on_opened(G_GNUC_UNUSED PlayView *view, compare *c)
{
    const skv_choice *next = c->next;
    end(c);
    c->next = NULL;
    if (next)
        begin(c, next);
}

/* What was to be compared did not open: what is opened next is not meant. */
static void on_failed(G_GNUC_UNUSED PlayView *view, G_GNUC_UNUSED const char *error, compare *c)
{
    c->next = NULL;
}

/* Actions. */

/* The name of a choice, and after a space what shows an experiment. */
static void on_compare(G_GNUC_UNUSED GSimpleAction *action, GVariant *value, gpointer data)
{
    compare *c = data;
    char **words = g_strsplit(g_variant_get_string(value, NULL), " ", 2);
    const skv_choice *choice = skv_choice_named(words[0]);
    if (choice && words[1] && *words[1]) {
        c->next = choice;
        if (g_str_has_prefix(words[1], PLAY_SET_UP))
            play_lab_open(words[1] + strlen(PLAY_SET_UP), c->view);
        else
            play_window_open(c->window, words[1]);
    } else if (choice) {
        begin(c, choice);
    }
    g_strfreev(words);
}

static void on_close(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                     gpointer data)
{
    end_both(data);
}

static void on_toggle(G_GNUC_UNUSED GSimpleAction *action, G_GNUC_UNUSED GVariant *none,
                      gpointer data)
{
    compare *c = data;
    if (c->other) {
        end_both(c);
        return;
    }
    char *name = play_settings_text("compare", "honey");
    const skv_choice *last = skv_choice_named(name);
    begin(c, last ? last : skv_choice_named("honey"));
    g_free(name);
}

static void on_linked(GSimpleAction *action, GVariant *state, gpointer data)
{
    compare *c = data;
    g_simple_action_set_state(action, state);
    skv_stage_set_linked(play_view_stage(c->view), g_variant_get_boolean(state));
    if (c->other)
        show_ball(c);
}

static gboolean on_window_closed(G_GNUC_UNUSED GtkWindow *window, compare *c)
{
    end_both(c);
    return FALSE;
}

/* In the panel of properties: what to compare with, and whose properties they are. */
static void add_to_panel(compare *c)
{
    GtkBox *panel = play_window_properties(c->window);
    GtkWidget *button = gtk_menu_button_new();
    GMenuModel *menu = play_choices_menu(NULL);
    gtk_menu_button_set_label(GTK_MENU_BUTTON(button), _("Compare with"));
    set_label(button, _("Compare with"));
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(button), menu);
    g_object_unref(menu);
    c->bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 0);
    gtk_widget_add_css_class(c->bar, "linked");
    for (int i = 0; i < 2; i++) {
        c->sides[i] = gtk_toggle_button_new_with_label(i == 0 ? _("World A") : _("World B"));
        gtk_widget_set_hexpand(c->sides[i], TRUE);
        gtk_box_append(GTK_BOX(c->bar), c->sides[i]);
        g_signal_connect(c->sides[i], "toggled", G_CALLBACK(on_side), c);
    }
    gtk_toggle_button_set_group(GTK_TOGGLE_BUTTON(c->sides[1]), GTK_TOGGLE_BUTTON(c->sides[0]));
    gtk_box_prepend(panel, c->bar);
    gtk_box_prepend(panel, button);
}

void play_compare_add(PlayWindow *window)
{
    static const GActionEntry entries[] = {
        {.name = "compare", .parameter_type = "s", .activate = on_compare},
        {.name = "toggle-compare", .activate = on_toggle},
        {.name = "close-compare", .activate = on_close},
        {.name = "compare-linked", .state = "true", .change_state = on_linked},
    };
    compare *c = g_new0(compare, 1);
    c->window = window;
    c->view = play_window_view(window);
    g_object_set_data_full(G_OBJECT(window), "compare", c, g_free);
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), c);
    add_to_panel(c);
    show_sides(c, false);
    g_signal_connect(c->view, "opened", G_CALLBACK(on_opened), c);
    g_signal_connect(c->view, "compared", G_CALLBACK(on_compared), c);
    g_signal_connect(c->view, "failed", G_CALLBACK(on_failed), c);
    g_signal_connect(window, "close-request", G_CALLBACK(on_window_closed), c);
}
