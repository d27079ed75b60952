/* A plot: ticks at round numbers, one colour a curve, theory dashed. Invariant: every finite point
 * of every curve lies within the axes. */
#include "plot.h"

#include <math.h>
#include <string.h>

#include "words.h"

#define MOST_CURVES  8
#define MARGIN_LEFT  52.0
#define MARGIN_BELOW 36.0
#define MARGIN       10.0
#define ROW          16.0
#define TICK_PIXELS  64.0 /* about so far apart */
#define LEAST_SPAN   0.05 /* of the greatest value, upwards: what hardly changes looks like that */

typedef struct kept_curve {
    char *label;
    PlayCurveStyle style;
    int count;
    double *x, *y;
} kept_curve;

struct _PlayPlot {
    GtkWidget parent;
    char *x_label, *y_label;
    kept_curve curves[MOST_CURVES];
    int count;
};

G_DEFINE_FINAL_TYPE(PlayPlot, play_plot, GTK_TYPE_WIDGET)

/* Blue, orange, green, purple: told apart by colour-blind eyes, and on light and dark grounds. */
static const GdkRGBA colors[] = {{0.25F, 0.55F, 0.95F, 1},
                                 {0.90F, 0.45F, 0.05F, 1},
                                 {0.10F, 0.62F, 0.45F, 1},
                                 {0.70F, 0.40F, 0.85F, 1}};

typedef struct axis {
    double low, high, step;
    double from, to; /* pixels */
} axis;

static double place(const axis *a, double value)
{
    return a->from + (value - a->low) / (a->high - a->low) * (a->to - a->from);
}

/* 1, 2 or 5 times a power of ten, at least so large. */
static double round_step(double least)
{
    double power = pow(10, floor(log10(least)));
    for (int i = 0; i < 3; i++) {
        static const double nice[] = {1, 2, 5};
        if (nice[i] * power >= least)
            return nice[i] * power;
    }
    return 10 * power;
}

static axis make_axis(double low, double high, double from, double to)
{
    if (!(low <= high))
        low = 0, high = 1;
    double slack = high - low > 1e-9 * (fabs(high) + fabs(low)) ? 0 : MAX(fabs(high) * 0.05, 1e-3);
    axis a = {low - slack, high + slack, 1, from, to};
    a.step = round_step((a.high - a.low) * TICK_PIXELS / MAX(fabs(to - from), TICK_PIXELS));
    a.low = floor(a.low / a.step + 1e-9) * a.step;
    a.high = ceil(a.high / a.step - 1e-9) * a.step;
    return a;
}

static void extend(const double *values, int count, double *low, double *high)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(values[i]))
            continue;
        *low = fmin(*low, values[i]);
        *high = fmax(*high, values[i]);
    }
}

/* Text of the widget's font, somewhat smaller. */
static PangoLayout *lay_out(PlayPlot *plot, const char *text)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(GTK_WIDGET(plot), text);
    PangoAttrList *list = pango_attr_list_new();
    pango_attr_list_insert(list, pango_attr_scale_new(0.85));
    pango_layout_set_attributes(layout, list);
    pango_attr_list_unref(list);
    return layout;
}

static double text_width(PlayPlot *plot, const char *text)
{
    PangoLayout *layout = lay_out(plot, text);
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    g_object_unref(layout);
    return width;
}

/* `align` 0: the place is its left end, 1 its right end. */
static void write_text(PlayPlot *plot, cairo_t *cairo, double x, double y, double align,
                       const char *text)
{
    PangoLayout *layout = lay_out(plot, text);
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    cairo_move_to(cairo, x - align * width, y - height / 2.0);
    pango_cairo_show_layout(cairo, layout);
    g_object_unref(layout);
}

/* Of an axis; so many that no text fits are never asked for. */
static int steps_of(const axis *a)
{
    return (int)CLAMP((a->high - a->low) / a->step + 0.5, 0, 100);
}

static skv_digits tick_text(const axis *a, double value)
{
    return play_number_short(fabs(value) < a->step / 2 ? 0 : value, 4);
}

static void draw_axes(PlayPlot *plot, cairo_t *cairo, const axis *x, const axis *y,
                      const GdkRGBA *color)
{
    GdkRGBA faint = *color;
    faint.alpha = 0.18F;
    cairo_set_line_width(cairo, 1);
    for (int i = 0; i <= steps_of(x); i++) {
        double value = x->low + i * x->step;
        double at = floor(place(x, value)) + 0.5;
        gdk_cairo_set_source_rgba(cairo, &faint);
        cairo_move_to(cairo, at, y->from);
        cairo_line_to(cairo, at, y->to);
        cairo_stroke(cairo);
        gdk_cairo_set_source_rgba(cairo, color);
        write_text(plot, cairo, at, y->from + 10, 0.5, tick_text(x, value).text);
    }
    for (int i = 0; i <= steps_of(y); i++) {
        double value = y->low + i * y->step;
        double at = floor(place(y, value)) + 0.5;
        gdk_cairo_set_source_rgba(cairo, &faint);
        cairo_move_to(cairo, x->from, at);
        cairo_line_to(cairo, x->to, at);
        cairo_stroke(cairo);
        gdk_cairo_set_source_rgba(cairo, color);
        write_text(plot, cairo, x->from - 6, at, 1, tick_text(y, value).text);
    }
    write_text(plot, cairo, (x->from + x->to) / 2, y->from + 26, 0.5, plot->x_label);
    write_text(plot, cairo, 4, 9, 0, plot->y_label);
}

static void draw_curve(cairo_t *cairo, const kept_curve *curve, const axis *x, const axis *y)
{
    bool down = false;
    cairo_set_line_width(cairo, 2);
    if (curve->style == PLAY_CURVE_THEORY)
        cairo_set_dash(cairo, (const double[]){6, 4}, 2, 0);
    for (int i = 0; i < curve->count; i++) {
        if (!isfinite(curve->x[i]) || !isfinite(curve->y[i])) {
            down = false;
            continue;
        }
        double px = place(x, curve->x[i]), py = place(y, curve->y[i]);
        if (curve->style == PLAY_CURVE_DOTS) {
            cairo_new_sub_path(cairo);
            cairo_arc(cairo, px, py, 2.5, 0, 2 * G_PI);
        } else if (down) {
            cairo_line_to(cairo, px, py);
        } else {
            cairo_move_to(cairo, px, py);
        }
        down = true;
    }
    if (curve->style == PLAY_CURVE_DOTS)
        cairo_fill(cairo);
    else
        cairo_stroke(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
}

/* Labels stand above the axes, over a curve they would hide it: two in a row where all pairs fit.
 */
static int labels_in_a_row(PlayPlot *plot, double room)
{
    int in_a_row = 2;
    for (int i = 0; i + 1 < plot->count; i += 2)
        if (text_width(plot, plot->curves[i].label) + text_width(plot, plot->curves[i + 1].label) >
            room - MARGIN)
            in_a_row = 1;
    return in_a_row;
}

static void draw_labels(PlayPlot *plot, cairo_t *cairo, const axis *x, int in_a_row)
{
    for (int i = 0; i < plot->count && plot->count > 1; i++) {
        int row = 1 + i / in_a_row;
        bool right = i % in_a_row == 1;
        gdk_cairo_set_source_rgba(cairo, &colors[i % (int)G_N_ELEMENTS(colors)]);
        write_text(plot, cairo, right ? x->to : x->from, 9 + ROW * row, right,
                   plot->curves[i].label);
    }
}

static void snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    PlayPlot *plot = PLAY_PLOT(widget);
    double width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
    for (int i = 0; i < plot->count; i++) {
        extend(plot->curves[i].x, plot->curves[i].count, &low_x, &high_x);
        extend(plot->curves[i].y, plot->curves[i].count, &low_y, &high_y);
    }
    double lacking = LEAST_SPAN * fmax(fabs(low_y), fabs(high_y)) - (high_y - low_y);
    if (lacking > 0) {
        low_y -= lacking / 2;
        high_y += lacking / 2;
    }
    axis x = make_axis(low_x, high_x, MARGIN_LEFT, width - 2 * MARGIN);
    int in_a_row = labels_in_a_row(plot, x.to - x.from);
    int rows = plot->count > 1 ? (plot->count + in_a_row - 1) / in_a_row : 0;
    axis y = make_axis(low_y, high_y, height - MARGIN_BELOW, 2 * MARGIN + ROW * rows);
    GdkRGBA color;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &color);
    cairo_t *cairo =
        gtk_snapshot_append_cairo(snapshot, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    draw_axes(plot, cairo, &x, &y, &color);
    for (int i = 0; i < plot->count; i++) {
        gdk_cairo_set_source_rgba(cairo, &colors[i % (int)G_N_ELEMENTS(colors)]);
        draw_curve(cairo, &plot->curves[i], &x, &y);
    }
    draw_labels(plot, cairo, &x, in_a_row);
    cairo_destroy(cairo);
}

static void clear(PlayPlot *plot)
{
    for (int i = 0; i < plot->count; i++) {
        g_free(plot->curves[i].label);
        g_free(plot->curves[i].x);
        g_free(plot->curves[i].y);
    }
    plot->count = 0;
    g_free(plot->x_label);
    g_free(plot->y_label);
    plot->x_label = plot->y_label = NULL;
}

void play_plot_show(PlayPlot *plot, const char *x_label, const char *y_label, double unit,
                    const PlayCurve *curves, int count)
{
    clear(plot);
    plot->x_label = g_strdup(x_label);
    plot->y_label = g_strdup(y_label);
    plot->count = MIN(count, MOST_CURVES);
    for (int i = 0; i < plot->count; i++) {
        size_t size = (size_t)curves[i].count * sizeof(double);
        plot->curves[i] = (kept_curve){g_strdup(curves[i].label), curves[i].style, curves[i].count,
                                       g_memdup2(curves[i].x, size), g_memdup2(curves[i].y, size)};
        for (int k = 0; k < curves[i].count; k++)
            plot->curves[i].y[k] /= unit;
    }
    gtk_widget_queue_draw(GTK_WIDGET(plot));
}

static bool append(const char *text, size_t length, void *to)
{
    g_string_append_len(to, text, (gssize)length);
    return true;
}

GString *play_plot_csv(PlayPlot *plot)
{
    GString *text = g_string_new("series,");
    skv_write_cell(plot->x_label, append, text);
    g_string_append_c(text, ',');
    skv_write_cell(plot->y_label, append, text);
    g_string_append_c(text, '\n');
    char x[G_ASCII_DTOSTR_BUF_SIZE], y[G_ASCII_DTOSTR_BUF_SIZE];
    for (int i = 0; i < plot->count; i++) {
        const kept_curve *curve = &plot->curves[i];
        for (int k = 0; k < curve->count; k++) {
            if (!isfinite(curve->x[k]) || !isfinite(curve->y[k]))
                continue;
            skv_write_cell(curve->label, append, text);
            g_string_append_printf(text, ",%s,%s\n",
                                   g_ascii_formatd(x, sizeof x, "%.7g", curve->x[k]),
                                   g_ascii_formatd(y, sizeof y, "%.7g", curve->y[k]));
        }
    }
    return text;
}

static void measure(G_GNUC_UNUSED GtkWidget *widget, GtkOrientation orientation,
                    G_GNUC_UNUSED int size, int *minimum, int *natural, int *minimum_baseline,
                    int *natural_baseline)
{
    *minimum = orientation == GTK_ORIENTATION_HORIZONTAL ? 200 : 140;
    *natural = orientation == GTK_ORIENTATION_HORIZONTAL ? 320 : 220;
    *minimum_baseline = *natural_baseline = -1;
}

static void finalize(GObject *object)
{
    clear(PLAY_PLOT(object));
    G_OBJECT_CLASS(play_plot_parent_class)->finalize(object);
}

static void play_plot_class_init(PlayPlotClass *class)
{
    G_OBJECT_CLASS(class)->finalize = finalize;
    GTK_WIDGET_CLASS(class)->snapshot = snapshot;
    GTK_WIDGET_CLASS(class)->measure = measure;
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_IMG);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "plot");
}

static void play_plot_init(PlayPlot *plot)
{
    play_plot_show(plot, "", "", 1, NULL, 0);
}
