/* The stopwatch's buttons. Invariant: what they show is what the library reads at the moment of the
 * picture; nothing here counts time. */
#include "stopwatch.h"

#include "words.h"

#include <skvalp/stopwatch.h>

#define FRAMES_A_SECOND (double)skv_control_limits()->frames_a_second

typedef struct stopwatch {
    skv_stopwatch watch;
    guint32 opened; /* what its presses are of */
    GtkWidget *button, *readings, *time, *lap;
} stopwatch;

static char *words_of(const skv_stopwatch_reading *reading)
{
    char *time = play_quantity((double)reading->frames / FRAMES_A_SECOND, 2, "s");
    if (reading->laps == 0)
        return time;
    char *lap = play_quantity((double)reading->lap / FRAMES_A_SECOND, 2, "s");
    char *text = g_strdup_printf("%s (%d: %s)", time, reading->laps, lap);
    g_free(lap);
    g_free(time);
    return text;
}

/* What went another way than when it was pressed has not been pressed. */
static void follow(stopwatch *s, const skv_picture *picture)
{
    if (picture->opened != s->opened)
        s->watch = (skv_stopwatch){0};
    s->opened = picture->opened;
    skv_stopwatch_cut(&s->watch, picture->end);
}

static void show(PlayView *view, GtkWidget *button)
{
    stopwatch *s = g_object_get_data(G_OBJECT(button), "stopwatch");
    const skv_picture *picture = play_view_picture(view);
    follow(s, picture);
    skv_stopwatch_reading reading = skv_stopwatch_read(&s->watch, picture->moment);
    skv_stage_set_timed(play_view_stage(view), reading.running);
    char *text = words_of(&reading);
    gtk_widget_set_visible(s->readings, s->watch.count > 0);
    gtk_widget_set_visible(s->lap, reading.running);
    if (g_strcmp0(gtk_label_get_text(GTK_LABEL(s->time)), text) != 0) {
        gtk_label_set_text(GTK_LABEL(s->time), text);
        gtk_accessible_update_property(GTK_ACCESSIBLE(s->button),
                                       GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
    }
    g_free(text);
}

void play_stopwatch_press(PlayView *view, gboolean lap)
{
    GtkWidget *button = g_object_get_data(G_OBJECT(view), "stopwatch");
    stopwatch *s = g_object_get_data(G_OBJECT(button), "stopwatch");
    const skv_picture *picture = play_view_picture(view);
    follow(s, picture);
    skv_stopwatch_press(&s->watch, picture->moment, lap);
    show(view, button);
}

static GtkWidget *add_button(GtkWidget *box, GtkWidget *child, const char *name, const char *tip,
                             gboolean lap)
{
    GtkWidget *button = gtk_button_new();
    gtk_button_set_child(GTK_BUTTON(button), child);
    gtk_widget_set_tooltip_text(button, tip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), "win.stopwatch");
    gtk_actionable_set_action_target(GTK_ACTIONABLE(button), "b", lap);
    gtk_widget_set_focus_on_click(button, FALSE);
    gtk_widget_add_css_class(button, "flat");
    gtk_box_append(GTK_BOX(box), button);
    return button;
}

void play_stopwatch_fill(GtkWidget *buttons, GtkWidget *readings, PlayView *view)
{
    stopwatch *s = g_new0(stopwatch, 1);
    s->button = add_button(buttons, gtk_image_new_from_icon_name("skvalp-stopwatch-symbolic"),
                           _("Stopwatch"), _("Stopwatch: start and stop (W)"), FALSE);
    s->readings = readings;
    gtk_widget_set_visible(readings, FALSE);
    s->time = gtk_label_new("");
    gtk_widget_add_css_class(s->time, "numeric");
    gtk_box_append(GTK_BOX(readings), s->time);
    s->lap = add_button(readings, gtk_label_new(_("Lap")), _("Lap"), _("Lap (L)"), TRUE);
    gtk_widget_set_visible(s->lap, FALSE);
    g_object_set_data_full(G_OBJECT(s->button), "stopwatch", s, g_free);
    g_object_set_data(G_OBJECT(view), "stopwatch", s->button);
    g_signal_connect_object(view, "changed", G_CALLBACK(show), s->button, 0);
}
