/* The legend: colours from the renderer's scale, figures in units people know. Invariant: it shows
 * the scale with which the picture is drawn, at every moment; where two worlds have the same, the
 * first's alone shows. */
#include "legend.h"

#include <string.h>

#include "words.h"

#define WIDTH  180
#define HEIGHT 52
#define MARGIN 10
#define BAR    12 /* pixels high */

struct _PlayLegend {
    GtkWidget parent;
    PlayView *view;
    skv_legend scale;
    bool si; /* its units */
};

G_DEFINE_FINAL_TYPE(PlayLegend, play_legend, GTK_TYPE_WIDGET)

static char *title_of(const PlayLegend *legend)
{
    skv_unit shown = play_unit_of(legend->scale.unit);
    const char *unit = play_word(shown.name);
    const char *fixed = play_view_style(legend->view)->range > 0 ? _(" (fixed)") : "";
    if (*unit)
        return g_strdup_printf("%s, %s%s", play_word(legend->scale.label), unit, fixed);
    return g_strdup_printf("%s%s", play_word(legend->scale.label), fixed);
}

static void write_text(GtkWidget *widget, GtkSnapshot *snapshot, double x, double y, double align,
                       const char *text)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, text);
    int width, height;
    GdkRGBA color;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &color);
    pango_layout_get_pixel_size(layout, &width, &height);
    gtk_snapshot_save(snapshot);
    gtk_snapshot_translate(snapshot, &GRAPHENE_POINT_INIT((float)(x - align * width), (float)y));
    gtk_snapshot_append_layout(snapshot, layout, &color);
    gtk_snapshot_restore(snapshot);
    g_object_unref(layout);
}

static void append_bar(GtkSnapshot *snapshot, const skv_legend *scale, const graphene_rect_t *bar)
{
    GskColorStop stops[SKV_LEGEND_COLORS];
    for (int i = 0; i < SKV_LEGEND_COLORS; i++)
        stops[i] =
            (GskColorStop){(float)i / (SKV_LEGEND_COLORS - 1),
                           {(float)scale->colors[i][0] / 255, (float)scale->colors[i][1] / 255,
                            (float)scale->colors[i][2] / 255, 1}};
    graphene_point_t from = bar->origin, to = from;
    to.x += bar->size.width;
    gtk_snapshot_append_linear_gradient(snapshot, bar, &from, &to, stops, SKV_LEGEND_COLORS);
}

static void snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    PlayLegend *legend = PLAY_LEGEND(widget);
    const skv_legend *scale = &legend->scale;
    double width = gtk_widget_get_width(widget), right = width - MARGIN;
    char *title = title_of(legend);
    double unit = play_unit_of(scale->unit).size;
    write_text(widget, snapshot, MARGIN, 2, 0, title);
    append_bar(snapshot, scale, &GRAPHENE_RECT_INIT(MARGIN, 20, (float)(right - MARGIN), BAR));
    for (int i = 0; i <= 2; i++) {
        double value = (scale->low + (scale->high - scale->low) * i / 2) / unit;
        write_text(widget, snapshot, MARGIN + (right - MARGIN) * i / 2, 34, i / 2.0,
                   play_number_short(value, 4).text);
    }
    g_free(title);
}

static bool is_same(const skv_legend *a, const skv_legend *b)
{
    return a->shown == b->shown && a->label == b->label && a->unit == b->unit && a->low == b->low &&
           a->high == b->high && a->step == b->step && a->depth == b->depth &&
           memcmp(a->colors, b->colors, sizeof a->colors) == 0;
}

/* That of a second world that is as the first's: one is enough. */
static bool is_known(const PlayLegend *legend, const skv_legend *scale)
{
    if (play_view_side(legend->view) == 0)
        return false;
    const skv_picture *first = skv_stage_picture(play_view_stage(legend->view), 0);
    skv_legend other = skv_render_legend(&first->frame, play_view_style(legend->view));
    return is_same(scale, &other);
}

static void on_changed(PlayLegend *legend)
{
    const skv_picture *picture = play_view_picture(legend->view);
    if (picture->opened == 0)
        return;
    skv_legend scale = skv_render_legend(&picture->frame, play_view_style(legend->view));
    gtk_widget_set_visible(GTK_WIDGET(legend), scale.shown && !is_known(legend, &scale));
    if (scale.shown && (!is_same(&scale, &legend->scale) || legend->si != play_words_si()))
        gtk_widget_queue_draw(GTK_WIDGET(legend));
    legend->scale = scale;
    legend->si = play_words_si();
}

static void on_tap(G_GNUC_UNUSED GtkGestureClick *click, G_GNUC_UNUSED int count,
                   G_GNUC_UNUSED double x, G_GNUC_UNUSED double y, PlayLegend *legend)
{
    skv_render_style style = *play_view_style(legend->view);
    style.range = style.range > 0 ? 0 : legend->scale.high;
    play_view_set_style(legend->view, &style);
    gtk_widget_queue_draw(GTK_WIDGET(legend));
}

void play_legend_attach(PlayLegend *legend, PlayView *view)
{
    legend->view = view;
    g_signal_connect_object(view, "changed", G_CALLBACK(on_changed), legend, G_CONNECT_SWAPPED);
}

static void measure(G_GNUC_UNUSED GtkWidget *widget, GtkOrientation orientation,
                    G_GNUC_UNUSED int size, int *minimum, int *natural, int *minimum_baseline,
                    int *natural_baseline)
{
    *minimum = *natural = orientation == GTK_ORIENTATION_HORIZONTAL ? WIDTH : HEIGHT;
    *minimum_baseline = *natural_baseline = -1;
}

static void play_legend_class_init(PlayLegendClass *class)
{
    GTK_WIDGET_CLASS(class)->snapshot = snapshot;
    GTK_WIDGET_CLASS(class)->measure = measure;
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_IMG);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "legend");
}

static void play_legend_init(PlayLegend *legend)
{
    GtkGesture *click = gtk_gesture_click_new();
    g_signal_connect(click, "pressed", G_CALLBACK(on_tap), legend);
    gtk_widget_add_controller(GTK_WIDGET(legend), GTK_EVENT_CONTROLLER(click));
    gtk_widget_set_visible(GTK_WIDGET(legend), FALSE);
    gtk_widget_set_tooltip_text(GTK_WIDGET(legend),
                                _("Keep this range, or let it follow the water"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(legend), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Legend"), -1);
}
