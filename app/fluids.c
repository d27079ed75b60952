/* Fluids: a chip for each that can be poured, in its colour and with its name. Invariant: chips are
 * made anew only where what was opened or the palette is another. */
#include "fluids.h"

#include "words.h"

typedef struct fluids {
    GtkBox *box;
    guint32 opened;
    skv_palette palette;
} fluids;

static GtkWidget *make_chip(const skv_frame *frame, skv_palette palette, int number)
{
    const char *name = play_word(frame->fluids[number].name);
    GtkWidget *chip = gtk_toggle_button_new(), *label = gtk_label_new(NULL);
    char *text = g_markup_printf_escaped("<span foreground=\"#%06x\">⬤</span>  %s",
                                         skv_render_fluid_color(frame, palette, number), name);
    gtk_label_set_markup(GTK_LABEL(label), text);
    g_free(text);
    gtk_button_set_child(GTK_BUTTON(chip), label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(chip), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(chip), "win.fluid");
    gtk_actionable_set_action_target(GTK_ACTIONABLE(chip), "i", number);
    gtk_widget_set_focus_on_click(chip, FALSE);
    gtk_widget_add_css_class(chip, "chip");
    return chip;
}

static void on_changed(PlayView *view, fluids *chips)
{
    const skv_picture *picture = play_view_picture(view);
    const skv_frame *frame = &picture->frame;
    skv_palette palette = play_view_style(view)->palette;
    GtkWidget *child;
    if (picture->opened == chips->opened && palette == chips->palette)
        return;
    chips->opened = picture->opened;
    chips->palette = palette;
    while ((child = gtk_widget_get_first_child(GTK_WIDGET(chips->box))))
        gtk_box_remove(chips->box, child);
    for (int i = 0; frame->fluid_count > 1 && i < frame->fluid_count; i++)
        gtk_box_append(chips->box, make_chip(frame, palette, i));
    gtk_widget_set_visible(GTK_WIDGET(chips->box), frame->fluid_count > 1);
}

void play_fluids_attach(GtkBox *box, PlayView *view)
{
    fluids *chips = g_new0(fluids, 1);
    chips->box = box;
    gtk_widget_set_visible(GTK_WIDGET(box), FALSE);
    g_object_set_data_full(G_OBJECT(box), "skvalp-fluids", chips, g_free);
    g_signal_connect(view, "changed", G_CALLBACK(on_changed), chips);
}
