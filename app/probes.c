/* Probes: what lies over the picture. Invariant: where an instrument is, is the session's; while it
 * is dragged the session is told, and what is drawn is what the picture says. Only the points of
 * instruments take the pointer; all else is the view's below. */
#include "probes.h"

#include <string.h>

#include "chips.h"
#include "words.h"

/* Pixels from the middle of a grip to its reading. */
#define BESIDE 18

struct _PlayProbes {
    GtkWidget parent;
    PlayView *view;
    PlayChips *chips;
    guint32 dragged; /* id */
    int end;         /* of it: 0 or 1 */
    double grab_x, grab_y;
};

G_DEFINE_FINAL_TYPE(PlayProbes, play_probes, GTK_TYPE_WIDGET)

GMenuModel *play_probes_menu(void)
{
    GMenu *menu = g_menu_new();
    const skv_gauge *gauge;
    for (int i = 0; (gauge = skv_gauge_at(i)); i++) {
        GMenuItem *item = g_menu_item_new(play_word(gauge->title), NULL);
        g_menu_item_set_action_and_target(item, "win.measure", "i", gauge->kind);
        g_menu_append_item(menu, item);
        g_object_unref(item);
    }
    return G_MENU_MODEL(menu);
}

/* Places. */

static void to_widget(PlayProbes *probes, double x, double y, double *px, double *py)
{
    skv_camera camera = play_view_camera(probes->view);
    int scale = gtk_widget_get_scale_factor(GTK_WIDGET(probes));
    skv_camera_to_view(&camera, x, y, px, py);
    *px /= scale;
    *py /= scale;
}

static void to_world(PlayProbes *probes, double px, double py, double *x, double *y)
{
    skv_camera camera = play_view_camera(probes->view);
    int scale = gtk_widget_get_scale_factor(GTK_WIDGET(probes));
    skv_camera_to_world(&camera, px * scale, py * scale, x, y);
}

static bool is_near(PlayProbes *probes, double x, double y, double px, double py)
{
    double at_x, at_y;
    to_widget(probes, x, y, &at_x, &at_y);
    return hypot(at_x - px, at_y - py) < skv_control_limits()->grip;
}

/* The instrument under a place, the last first, and which of its ends; null if there is none. */
static const skv_probe *find(PlayProbes *probes, double px, double py, int *end)
{
    const skv_picture *picture = play_view_picture(probes->view);
    for (int i = picture->probe_count - 1; i >= 0; i--) {
        const skv_probe *probe = &picture->probes[i];
        const skv_gauge *gauge = skv_gauge_of(probe->def.kind);
        *end = gauge && gauge->line && is_near(probes, probe->def.x1, probe->def.y1, px, py);
        if (*end || is_near(probes, probe->def.x0, probe->def.y0, px, py))
            return probe;
    }
    return NULL;
}

static gboolean contains(GtkWidget *widget, double x, double y)
{
    int end;
    return PLAY_PROBES(widget)->view && find(PLAY_PROBES(widget), x, y, &end) != NULL;
}

void play_probes_add(PlayProbes *probes, int kind)
{
    const skv_gauge *gauge = skv_gauge_of((skv_instrument_kind)kind);
    if (gauge)
        skv_control_add_gauge(play_view_stage(probes->view), gauge);
}

/* Dragging. */

static void on_drag_begin(GtkGestureDrag *drag, double px, double py, PlayProbes *probes)
{
    const skv_probe *probe = find(probes, px, py, &probes->end);
    if (!probe) {
        gtk_gesture_set_state(GTK_GESTURE(drag), GTK_EVENT_SEQUENCE_DENIED);
        return;
    }
    gtk_gesture_set_state(GTK_GESTURE(drag), GTK_EVENT_SEQUENCE_CLAIMED);
    probes->dragged = probe->id;
    to_widget(probes, probes->end ? probe->def.x1 : probe->def.x0,
              probes->end ? probe->def.y1 : probe->def.y0, &probes->grab_x, &probes->grab_y);
}

static void on_drag_update(G_GNUC_UNUSED GtkGestureDrag *drag, double dx, double dy,
                           PlayProbes *probes)
{
    double x, y;
    to_world(probes, probes->grab_x + dx, probes->grab_y + dy, &x, &y);
    skv_control_drag(play_view_stage(probes->view), play_view_side(probes->view), probes->dragged,
                     probes->end, x, y);
}

/* Drawing. */

static void draw_grip(cairo_t *cairo, double x, double y, const char *letter)
{
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.75);
    cairo_arc(cairo, x, y, 11, 0, 2 * G_PI);
    cairo_fill(cairo);
    cairo_set_source_rgb(cairo, 1, 0.85, 0.25);
    cairo_set_line_width(cairo, 2);
    cairo_arc(cairo, x, y, 10, 0, 2 * G_PI);
    cairo_stroke(cairo);
    cairo_text_extents_t size;
    cairo_set_font_size(cairo, 13);
    cairo_text_extents(cairo, letter, &size);
    cairo_move_to(cairo, x - size.width / 2 - size.x_bearing, y - size.height / 2 - size.y_bearing);
    cairo_show_text(cairo, letter);
}

/* What it reads, beside a grip: to the left of it where there is no room to the right. Dark below,
 * over water and walls of any colour. */
static void draw_reading(GtkWidget *widget, cairo_t *cairo, double x, double y, const char *text)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, text);
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    bool left = x + BESIDE + width > gtk_widget_get_width(widget);
    double from = left ? x - BESIDE - width : x + BESIDE;
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.6);
    cairo_rectangle(cairo, from - 4, y - height / 2.0 - 1, width + 8, height + 2);
    cairo_fill(cairo);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_move_to(cairo, from, y - height / 2.0);
    pango_cairo_show_layout(cairo, layout);
    g_object_unref(layout);
}

static void draw_line(cairo_t *cairo, double x0, double y0, double x1, double y1, bool box)
{
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 0)
            cairo_set_source_rgba(cairo, 0, 0, 0, 0.6);
        else
            cairo_set_source_rgb(cairo, 1, 0.85, 0.25);
        cairo_set_line_width(cairo, pass == 0 ? 4 : 2);
        if (box)
            cairo_rectangle(cairo, MIN(x0, x1), MIN(y0, y1), fabs(x1 - x0), fabs(y1 - y0));
        cairo_move_to(cairo, x0, y0);
        if (!box)
            cairo_line_to(cairo, x1, y1);
        cairo_stroke(cairo);
    }
}

static void snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    PlayProbes *probes = PLAY_PROBES(widget);
    const skv_picture *picture = probes->view ? play_view_picture(probes->view) : NULL;
    if (!picture || picture->probe_count == 0)
        return;
    cairo_t *cairo = gtk_snapshot_append_cairo(
        snapshot, &GRAPHENE_RECT_INIT(0, 0, (float)gtk_widget_get_width(widget),
                                      (float)gtk_widget_get_height(widget)));
    for (int i = 0; i < picture->probe_count; i++) {
        const skv_probe *probe = &picture->probes[i];
        const skv_gauge *gauge = skv_gauge_of(probe->def.kind);
        double x0, y0, x1, y1;
        to_widget(probes, probe->def.x0, probe->def.y0, &x0, &y0);
        to_widget(probes, probe->def.x1, probe->def.y1, &x1, &y1);
        if (gauge && gauge->line) {
            draw_line(cairo, x0, y0, x1, y1, gauge->box);
            draw_grip(cairo, x1, y1, "");
        }
        draw_grip(cairo, x0, y0, play_chip_number(probe->id));
        char *reading = play_words_of_probe(probe);
        draw_reading(widget, cairo, x0, y0, reading);
        g_free(reading);
    }
    cairo_destroy(cairo);
}

/* What stands beside the grips, for who does not see it. */
static void tell_readings(PlayProbes *probes, const skv_picture *picture)
{
    GString *said = g_string_new(NULL);
    for (int i = 0; i < picture->probe_count; i++) {
        char *reading = play_words_of_probe(&picture->probes[i]);
        g_string_append_printf(said, "%s%s  %s", i ? ", " : "",
                               play_chip_number(picture->probes[i].id), reading);
        g_free(reading);
    }
    gtk_accessible_update_property(GTK_ACCESSIBLE(probes), GTK_ACCESSIBLE_PROPERTY_LABEL, said->str,
                                   -1);
    g_string_free(said, TRUE);
}

static void on_changed(PlayProbes *probes)
{
    const skv_picture *picture = play_view_picture(probes->view);
    if (picture->probe_count > 0) {
        gtk_widget_queue_draw(GTK_WIDGET(probes));
        tell_readings(probes, picture);
    }
    if (probes->chips)
        play_chips_show(probes->chips);
}

void play_probes_attach(PlayProbes *probes, PlayView *view, GtkBox *tray)
{
    probes->view = view;
    probes->chips = tray ? play_chips_new(view, tray) : NULL;
    g_signal_connect_object(view, "changed", G_CALLBACK(on_changed), probes, G_CONNECT_SWAPPED);
}

static void finalize(GObject *object)
{
    g_clear_pointer(&PLAY_PROBES(object)->chips, play_chips_free);
    G_OBJECT_CLASS(play_probes_parent_class)->finalize(object);
}

static void play_probes_class_init(PlayProbesClass *class)
{
    G_OBJECT_CLASS(class)->finalize = finalize;
    GTK_WIDGET_CLASS(class)->snapshot = snapshot;
    GTK_WIDGET_CLASS(class)->contains = contains;
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "probes");
}

static void play_probes_init(PlayProbes *probes)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), probes);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), probes);
    gtk_widget_add_controller(GTK_WIDGET(probes), GTK_EVENT_CONTROLLER(drag));
}
