/* Chips: readings in a row, and the card with the plot of one. Invariant: a chip belongs to one
 * instrument of the picture and goes with it; its history is kept only while its card is open. */
#include "chips.h"

#include <string.h>

#include "dialogs.h"
#include "plot.h"
#include "words.h"

typedef struct chip {
    PlayChips *all;
    guint32 probe;
    skv_instrument_kind kind;
    GtkWidget *button, *label, *card;
    PlayPlot *plot;
    bool seen; /* in this picture */
} chip;

struct PlayChips {
    PlayView *view;
    GtkBox *tray;
    GPtrArray *chips;
};

const char *play_chip_number(guint32 probe)
{
    static char text[12];
    g_snprintf(text, sizeof text, "%u", probe);
    return text;
}

/* An experiment may have others than those that people choose. */
static const char *title_of(skv_instrument_kind kind)
{
    const skv_gauge *gauge = skv_gauge_of(kind);
    return play_word(gauge ? gauge->title : skv_instrument_kind_name(kind));
}

/* The card. */

static void on_card_shown(G_GNUC_UNUSED GtkWidget *card, chip *c)
{
    skv_stage_watch_probe(play_view_stage(c->all->view), c->probe, true);
}

static void on_card_closed(G_GNUC_UNUSED GtkWidget *card, chip *c)
{
    skv_stage_watch_probe(play_view_stage(c->all->view), c->probe, false);
    gtk_widget_grab_focus(GTK_WIDGET(c->all->view));
}

static void on_remove(G_GNUC_UNUSED GtkButton *button, chip *c)
{
    gtk_popover_popdown(GTK_POPOVER(c->card));
    skv_stage_remove_probe(play_view_stage(c->all->view), c->probe);
}

static void on_name_chosen(GtkNativeDialog *dialog, int response, PlayPlot *plot)
{
    char *path = response == GTK_RESPONSE_ACCEPT ? play_chosen_path(dialog) : NULL;
    if (path) {
        GString *csv = play_plot_csv(plot);
        gtk_widget_activate_action(GTK_WIDGET(plot), "win.write", "(^ays)", path, csv->str);
        g_string_free(csv, TRUE);
    }
    g_free(path);
    g_object_unref(plot);
    g_object_unref(dialog);
}

static void on_export(GtkButton *button, chip *c)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(
        _("Save the Readings"), GTK_WINDOW(gtk_widget_get_root(GTK_WIDGET(button))),
        GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), "readings.csv");
    g_signal_connect(dialog, "response", G_CALLBACK(on_name_chosen), g_object_ref(c->plot));
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

static GtkWidget *make_card(chip *c)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    GtkWidget *export = gtk_button_new_with_mnemonic(_("_Save as CSV…"));
    GtkWidget *remove = gtk_button_new_with_mnemonic(_("_Remove"));
    c->plot = g_object_new(PLAY_TYPE_PLOT, NULL);
    gtk_widget_set_hexpand(export, TRUE);
    g_signal_connect(export, "clicked", G_CALLBACK(on_export), c);
    g_signal_connect(remove, "clicked", G_CALLBACK(on_remove), c);
    gtk_box_append(GTK_BOX(row), export);
    gtk_box_append(GTK_BOX(row), remove);
    gtk_box_append(GTK_BOX(box), GTK_WIDGET(c->plot));
    gtk_box_append(GTK_BOX(box), row);
    GtkWidget *card = gtk_popover_new();
    gtk_popover_set_child(GTK_POPOVER(card), box);
    g_signal_connect(card, "map", G_CALLBACK(on_card_shown), c);
    g_signal_connect(card, "closed", G_CALLBACK(on_card_closed), c);
    return card;
}

static PlayCurve curve_of(const skv_probe *probe, int channel, const char *label,
                          PlayCurveStyle style)
{
    return (PlayCurve){label, style, probe->samples, probe->times, probe->history[channel]};
}

/* Both worlds' curves, one of them dots: told apart without colours, too; and over them what theory
 * says. */
static void show_plot(const chip *c, const skv_probe *probe)
{
    int channel = play_main_channel(c->kind), count = 0;
    const skv_channel *info = skv_instrument_channel(c->kind, channel);
    const skv_channel *theory = skv_instrument_channel(c->kind, channel + 1);
    const skv_probe *beside = skv_stage_probe(play_view_stage(c->all->view), 1, c->probe);
    double unit;
    char *label = play_words_of_quantity(info->name, info->unit, &unit), *says = NULL;
    PlayCurve curves[4];
    curves[count++] =
        curve_of(probe, channel, beside ? _("World A") : play_word(info->name), PLAY_CURVE_LINE);
    if (beside)
        curves[count++] = curve_of(beside, channel, _("World B"), PLAY_CURVE_DOTS);
    if (theory && theory->theory) {
        /* Translators: what the textbook says, such as "theory: density g depth". */
        says = g_strdup_printf(_("theory: %s"), play_word(theory->name));
        curves[count++] = curve_of(probe, channel + 1, says, PLAY_CURVE_THEORY);
        if (beside)
            curves[count++] = curve_of(beside, channel + 1, _("theory, B"), PLAY_CURVE_THEORY);
    }
    play_plot_show(c->plot, _("time (s)"), label, unit, curves, probe->samples > 0 ? count : 0);
    g_free(says);
    g_free(label);
}

/* A chip of its own is moved by arrow keys: 1 cm, with Shift 1 mm. */
static gboolean on_key(G_GNUC_UNUSED GtkEventControllerKey *controller, guint key,
                       G_GNUC_UNUSED guint code, GdkModifierType state, chip *c)
{
    double step = state & GDK_SHIFT_MASK ? 0.001 : 0.01;
    double dx = (key == GDK_KEY_Right) - (key == GDK_KEY_Left);
    double dy = (key == GDK_KEY_Up) - (key == GDK_KEY_Down);
    if (key == GDK_KEY_Delete)
        skv_stage_remove_probe(play_view_stage(c->all->view), c->probe);
    else if (dx != 0 || dy != 0)
        skv_stage_shift_probe(play_view_stage(c->all->view), c->probe, dx * step, dy * step);
    else
        return GDK_EVENT_PROPAGATE;
    return GDK_EVENT_STOP;
}

/* A new chip is the last one of a row that may be wider than the window. Scrolls to it as soon as
 * it has a place. */
static gboolean scroll_to_new(GtkWidget *button, G_GNUC_UNUSED GdkFrameClock *clock,
                              G_GNUC_UNUSED gpointer data)
{
    if (gtk_widget_get_width(button) == 0)
        return G_SOURCE_CONTINUE;
    GtkWidget *frame = gtk_widget_get_ancestor(button, GTK_TYPE_SCROLLED_WINDOW);
    GtkAdjustment *way = gtk_scrolled_window_get_hadjustment(GTK_SCROLLED_WINDOW(frame));
    gtk_adjustment_set_value(way, gtk_adjustment_get_upper(way));
    return G_SOURCE_REMOVE;
}

static chip *add_chip(PlayChips *chips, const skv_probe *probe)
{
    chip *c = g_new0(chip, 1);
    *c = (chip){.all = chips, .probe = probe->id, .kind = probe->def.kind};
    c->button = gtk_menu_button_new();
    c->label = gtk_label_new("");
    c->card = make_card(c);
    gtk_menu_button_set_child(GTK_MENU_BUTTON(c->button), c->label);
    gtk_menu_button_set_popover(GTK_MENU_BUTTON(c->button), c->card);
    gtk_widget_set_tooltip_text(c->button, _("Plot; arrow keys move it, Delete takes it away"));
    gtk_widget_add_css_class(c->button, "chip");
    gtk_widget_add_css_class(c->label, "numeric");
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), c);
    gtk_widget_add_controller(c->button, keys);
    gtk_box_append(chips->tray, c->button);
    gtk_widget_add_tick_callback(c->button, scroll_to_new, NULL, NULL);
    g_ptr_array_add(chips->chips, c);
    return c;
}

static chip *find_chip(PlayChips *chips, guint32 probe)
{
    for (guint i = 0; i < chips->chips->len; i++) {
        chip *c = chips->chips->pdata[i];
        if (c->probe == probe)
            return c;
    }
    return NULL;
}

static void show_chip(chip *c, const skv_probe *probe)
{
    char *reading = play_words_of_probe(probe), *other = NULL;
    const skv_probe *beside = skv_stage_probe(play_view_stage(c->all->view), 1, c->probe);
    const char *number = play_chip_number(c->probe), *title = title_of(c->kind);
    if (beside)
        other = play_words_of_probe(beside);
    char *text = beside ? g_strdup_printf("%s  %s  A: %s  B: %s", number, title, reading, other)
                        : g_strdup_printf("%s  %s  %s", number, title, reading);
    gtk_label_set_text(GTK_LABEL(c->label), text);
    gtk_accessible_update_property(GTK_ACCESSIBLE(gtk_widget_get_first_child(c->button)),
                                   GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
    g_free(text);
    g_free(other);
    g_free(reading);
    if (gtk_widget_get_mapped(c->card))
        show_plot(c, probe);
    c->seen = true;
}

static void remove_chip(PlayChips *chips, chip *c)
{
    gtk_box_remove(chips->tray, c->button);
    g_ptr_array_remove(chips->chips, c);
    g_free(c);
}

void play_chips_show(PlayChips *chips)
{
    const skv_picture *picture = play_view_picture(chips->view);
    for (guint i = 0; i < chips->chips->len; i++)
        ((chip *)chips->chips->pdata[i])->seen = false;
    for (int i = 0; i < picture->probe_count; i++) {
        const skv_probe *probe = &picture->probes[i];
        chip *c = find_chip(chips, probe->id);
        show_chip(c ? c : add_chip(chips, probe), probe);
    }
    for (guint i = chips->chips->len; i-- > 0;) {
        chip *c = chips->chips->pdata[i];
        if (!c->seen)
            remove_chip(chips, c);
    }
    gtk_widget_set_visible(GTK_WIDGET(chips->tray), chips->chips->len > 0);
}

PlayChips *play_chips_new(PlayView *view, GtkBox *tray)
{
    PlayChips *chips = g_new0(PlayChips, 1);
    *chips = (PlayChips){view, tray, g_ptr_array_new()};
    gtk_widget_set_visible(GTK_WIDGET(tray), FALSE);
    return chips;
}

void play_chips_free(PlayChips *chips)
{
    /* The window takes the buttons with it. */
    g_ptr_array_set_free_func(chips->chips, g_free);
    g_ptr_array_free(chips->chips, TRUE);
    g_free(chips);
}
