/* Transport: time as a person handles it. Invariant: while a finger is on the bar, the picture
 * follows it; once it lets go, the scene plays on from there if it played before. */
#include "transport.h"

#include "stopwatch.h"
#include "words.h"

#define FRAMES_A_SECOND (double)skv_control_limits()->frames_a_second

struct _PlayTransport {
    GtkBox parent;
    PlayView *view;
    GtkWidget *buttons, *stopwatch, *play, *bar, *clock, *pace, *pace_label, *costs;
    bool held;    /* a finger is on the bar */
    bool resumes; /* it played before */
    bool narrow;
};

G_DEFINE_FINAL_TYPE(PlayTransport, play_transport, GTK_TYPE_BOX)

/* The bar. */

static gboolean on_change_value(G_GNUC_UNUSED GtkRange *range, G_GNUC_UNUSED GtkScrollType scroll,
                                double value, PlayTransport *transport)
{
    gint64 end = play_view_picture(transport->view)->end;
    skv_control_seek(play_view_stage(transport->view), end + (gint64)(value * FRAMES_A_SECOND));
    return FALSE;
}

static void hold(PlayTransport *transport)
{
    transport->held = true;
    transport->resumes = !skv_stage_paused(play_view_stage(transport->view));
}

static void let_go(PlayTransport *transport)
{
    if (transport->held && transport->resumes)
        skv_stage_set_paused(play_view_stage(transport->view), false);
    transport->held = false;
}

/* The range's own gestures take what they handle, so the events themselves tell when. */
static gboolean on_bar_event(G_GNUC_UNUSED GtkEventControllerLegacy *controller, GdkEvent *event,
                             PlayTransport *transport)
{
    switch (gdk_event_get_event_type(event)) {
    case GDK_BUTTON_PRESS:
    case GDK_TOUCH_BEGIN:
        hold(transport);
        break;
    case GDK_BUTTON_RELEASE:
    case GDK_TOUCH_END:
    case GDK_TOUCH_CANCEL:
    case GDK_GRAB_BROKEN:
        let_go(transport);
        break;
    default:
        break;
    }
    return GDK_EVENT_PROPAGATE;
}

static void show_bar(PlayTransport *transport, const skv_picture *picture)
{
    gint64 behind = picture->end - picture->moment;
    gtk_widget_set_sensitive(transport->bar, picture->end > 0);
    if (!transport->held)
        gtk_range_set_value(GTK_RANGE(transport->bar), -(double)behind / FRAMES_A_SECOND);
    char *time = play_quantity(picture->frame.time, 1, "s");
    char *text = g_strdup_printf(behind > 0 ? "%s (%s)" : "%s", time,
                                 play_number(-(double)behind / FRAMES_A_SECOND, 1).text);
    gtk_label_set_text(GTK_LABEL(transport->clock), text);
    g_free(text);
    g_free(time);
}

/* The rest. */

static void show_play(PlayTransport *transport, const skv_picture *picture)
{
    const char *name = picture->paused ? _("Play") : _("Pause");
    char *tip = g_strdup_printf(_("%s (Space)"), name);
    gtk_button_set_icon_name(GTK_BUTTON(transport->play), picture->paused
                                                              ? "media-playback-start-symbolic"
                                                              : "media-playback-pause-symbolic");
    gtk_widget_set_tooltip_text(transport->play, tip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(transport->play), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   name, -1);
    g_free(tip);
}

static void show_pace(PlayTransport *transport, const skv_picture *picture)
{
    skv_stage *stage = play_view_stage(transport->view);
    skv_going going = skv_control_going(stage);
    char *text = going.slow && transport->narrow
                     ? g_strdup_printf("%s×", play_number_short(going.times, 2).text)
                     : play_words_of_pace(stage);
    gtk_label_set_text(GTK_LABEL(transport->pace_label), text);
    g_free(text);
    if (going.slow)
        gtk_widget_add_css_class(transport->pace_label, "slow");
    else
        gtk_widget_remove_css_class(transport->pace_label, "slow");
    if (!gtk_widget_get_mapped(transport->costs))
        return;
    char *step = play_quantity(picture->step_ms, 1, "ms");
    char *drawing = play_quantity(picture->draw_ms, 1, "ms");
    text =
        g_strdup_printf(_("Step: %s\nPicture: %s\n%s pictures a second\n"
                          "%d substeps a frame\nSpeed asked for: %s×"),
                        step, drawing, play_number(play_view_frame_rate(transport->view), 0).text,
                        picture->substeps, play_number_short(picture->speed, 3).text);
    gtk_label_set_text(GTK_LABEL(transport->costs), text);
    g_free(text);
    g_free(drawing);
    g_free(step);
}

static void on_changed(PlayTransport *transport)
{
    const skv_picture *picture = play_view_picture(transport->view);
    show_play(transport, picture);
    show_bar(transport, picture);
    show_pace(transport, picture);
}

void play_transport_attach(PlayTransport *transport, PlayView *view)
{
    transport->view = view;
    play_stopwatch_fill(transport->buttons, transport->stopwatch, view);
    g_signal_connect_object(view, "changed", G_CALLBACK(on_changed), transport, G_CONNECT_SWAPPED);
}

void play_transport_set_narrow(PlayTransport *transport, gboolean narrow)
{
    transport->narrow = narrow;
    gtk_orientable_set_orientation(GTK_ORIENTABLE(transport),
                                   narrow ? GTK_ORIENTATION_VERTICAL : GTK_ORIENTATION_HORIZONTAL);
}

static GtkWidget *add_button(GtkWidget *row, const char *icon, const char *name, const char *key,
                             const char *action)
{
    GtkWidget *button = gtk_button_new_from_icon_name(icon);
    char *tip = g_strdup_printf("%s (%s)", name, key);
    gtk_widget_set_tooltip_text(button, tip);
    g_free(tip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_widget_set_focus_on_click(button, FALSE);
    gtk_widget_add_css_class(button, "flat");
    gtk_box_append(GTK_BOX(row), button);
    return button;
}

static GtkWidget *make_bar(PlayTransport *transport)
{
    GtkWidget *bar = gtk_scale_new_with_range(GTK_ORIENTATION_HORIZONTAL,
                                              -skv_control_limits()->reach / FRAMES_A_SECOND, 0,
                                              1.0 / FRAMES_A_SECOND);
    gtk_scale_set_draw_value(GTK_SCALE(bar), FALSE);
    gtk_range_set_increments(GTK_RANGE(bar), 1.0 / FRAMES_A_SECOND, 1);
    gtk_range_set_value(GTK_RANGE(bar), 0);
    gtk_widget_set_hexpand(bar, TRUE);
    gtk_widget_set_size_request(bar, 90, -1);
    gtk_widget_set_tooltip_text(bar, _("The last 30 seconds: drag to go back (Shift+Left)"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(bar), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Rewind"),
                                   -1);
    g_signal_connect(bar, "change-value", G_CALLBACK(on_change_value), transport);
    GtkEventController *events = gtk_event_controller_legacy_new();
    gtk_event_controller_set_propagation_phase(events, GTK_PHASE_CAPTURE);
    g_signal_connect(events, "event", G_CALLBACK(on_bar_event), transport);
    gtk_widget_add_controller(bar, events);
    return bar;
}

static GtkWidget *make_pace(PlayTransport *transport)
{
    transport->pace_label = gtk_label_new("");
    gtk_label_set_width_chars(GTK_LABEL(transport->pace_label), 9);
    gtk_label_set_xalign(GTK_LABEL(transport->pace_label), 1);
    transport->costs = gtk_label_new("");
    GtkWidget *popover = gtk_popover_new();
    gtk_popover_set_child(GTK_POPOVER(popover), transport->costs);
    GtkWidget *pace = gtk_menu_button_new();
    gtk_menu_button_set_child(GTK_MENU_BUTTON(pace), transport->pace_label);
    gtk_menu_button_set_popover(GTK_MENU_BUTTON(pace), popover);
    gtk_widget_set_tooltip_text(pace, _("How fast it goes, and what it costs"));
    /* The button proper is inside. */
    gtk_accessible_update_property(GTK_ACCESSIBLE(gtk_widget_get_first_child(pace)),
                                   GTK_ACCESSIBLE_PROPERTY_LABEL, _("How fast it goes"), -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(pace), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("How fast it goes"), -1);
    gtk_widget_add_css_class(pace, "flat");
    gtk_widget_add_css_class(pace, "pace");
    return pace;
}

static void play_transport_class_init(PlayTransportClass *class)
{
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "transport");
}

static void play_transport_init(PlayTransport *transport)
{
    GtkWidget *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    gtk_widget_set_halign(buttons, GTK_ALIGN_CENTER);
    transport->buttons = buttons;
    transport->stopwatch = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    gtk_widget_set_halign(transport->stopwatch, GTK_ALIGN_CENTER);
    transport->play =
        add_button(buttons, "media-playback-pause-symbolic", _("Pause"), _("Space"), "win.pause");
    add_button(buttons, "skvalp-step-symbolic", _("One step of 1/60 s"), ".", "win.step");
    add_button(buttons, "media-skip-backward-symbolic", _("Back to the start"), "R", "win.reset");
    add_button(buttons, "edit-undo-symbolic", _("Undo"), _("Ctrl+Z"), "win.undo");
    add_button(buttons, "edit-redo-symbolic", _("Redo"), _("Shift+Ctrl+Z"), "win.redo");

    GtkWidget *time = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    gtk_widget_set_hexpand(time, TRUE);
    transport->bar = make_bar(transport);
    transport->clock = gtk_label_new("");
    gtk_label_set_width_chars(GTK_LABEL(transport->clock), 6);
    gtk_widget_add_css_class(transport->clock, "numeric");
    transport->pace = make_pace(transport);
    gtk_box_append(GTK_BOX(time), transport->bar);
    gtk_box_append(GTK_BOX(time), transport->clock);
    gtk_box_append(GTK_BOX(time), transport->pace);

    gtk_box_append(GTK_BOX(transport), buttons);
    gtk_box_append(GTK_BOX(transport), transport->stopwatch);
    gtk_box_append(GTK_BOX(transport), time);
    gtk_box_set_spacing(GTK_BOX(transport), 2);
}
