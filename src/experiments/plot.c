/* Draws curves as SVG.
 *
 * The picture is text of a fixed size in one column of a page, with colours that read on white and
 * on dark paper, and that people who see red and green alike can tell apart: blue dots,
 * rings and lines are measured, the dashed orange line is theory. Invariant: every number written
 * is finite and every mark lies inside the frame.
 */
#include "experiments/plot.h"

#include "base/exact.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

void skv_plot_begin(skv_plot *p, const char *label, skv_curve_style style)
{
    if (p->count == MAX_CURVES) {
        p->failed = true;
        return;
    }
    curve *c = &p->curves[p->count++];
    skv_format(c->label, sizeof c->label, "%s", label);
    c->style = style;
    c->count = 0;
}

static bool grow(curve *c)
{
    int capacity = c->capacity ? 2 * c->capacity : 64;
    double *x = skv_calloc((size_t)capacity, sizeof *x);
    double *y = skv_calloc((size_t)capacity, sizeof *y);
    if (!x || !y) {
        skv_free(x);
        skv_free(y);
        return false;
    }
    if (c->count) {
        memcpy(x, c->x, (size_t)c->count * sizeof *x);
        memcpy(y, c->y, (size_t)c->count * sizeof *y);
    }
    skv_free(c->x);
    skv_free(c->y);
    c->x = x;
    c->y = y;
    c->capacity = capacity;
    return true;
}

void skv_plot_point(skv_plot *p, double x, double y)
{
    if (p->count == 0 || !isfinite(x) || !isfinite(y))
        return;
    curve *c = &p->curves[p->count - 1];
    if (c->count == c->capacity && !grow(c)) {
        p->failed = true;
        return;
    }
    c->x[c->count] = x;
    c->y[c->count++] = y;
}

void skv_plot_swing(skv_plot *p, const char *label, double start, double period, double time)
{
    const int points = 400;
    skv_plot_begin(p, label, SKV_CURVE_THEORY);
    for (int i = 0; i <= points; i++) {
        double at = time * i / points;
        skv_plot_point(p, at, start * skv_cos(2 * 3.14159265358979 * at / period));
    }
}

void skv_plot_cut(skv_plot *p, int count)
{
    if (p->count > count)
        p->count = count;
}

skv_curve skv_plot_curve(const skv_plot *p, int i)
{
    const curve *c = &p->curves[i];
    return (skv_curve){c->label, c->style, c->count, c->x, c->y};
}

void skv_plot_free(skv_plot *p)
{
    for (int i = 0; i < MAX_CURVES; i++) {
        skv_free(p->curves[i].x);
        skv_free(p->curves[i].y);
    }
    memset(p, 0, sizeof *p);
}

/* Text goes out line by line. */
typedef struct sink {
    skv_write *write;
    void *user;
    bool failed;
} sink;

static void __attribute__((format(printf, 2, 3))) say(sink *out, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    size_t length = skv_format_list(text, sizeof text, format, arguments);
    va_end(arguments);
    if (length >= sizeof text)
        out->failed = true;
    if (!out->failed)
        out->failed = !out->write(text, length, out->user);
}

static void say_cell(sink *out, const char *text)
{
    if (!out->failed)
        out->failed = !skv_write_cell(text, out->write, out->user);
}

/* Text inside an element. */
static void say_escaped(sink *out, const char *text)
{
    for (; *text; text++) {
        if (*text == '&')
            say(out, "&amp;");
        else if (*text == '<')
            say(out, "&lt;");
        else if (*text == '>')
            say(out, "&gt;");
        else
            say(out, "%c", *text);
    }
}

enum { WIDTH = PLOT_WIDTH, HEIGHT = PLOT_HEIGHT, LEFT = 74, RIGHT = 16, TOP = 40, BOTTOM = 54 };

/* One axis: values to pixels, and its ticks. */
typedef struct axis {
    double low, high, from, to; /* values and their pixels */
    double tick;
} axis;

static double round_tick(double span)
{
    double power = skv_decade(span / 5);
    double rest = span / 5 / power;
    return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

static axis make_axis(const skv_plot *p, bool vertical, double from, double to)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int c = 0; c < p->count; c++) {
        const double *values = vertical ? p->curves[c].y : p->curves[c].x;
        for (int i = 0; i < p->curves[c].count; i++) {
            low = fmin(low, values[i]);
            high = fmax(high, values[i]);
        }
    }
    if (!(low <= high)) {
        low = 0;
        high = 1;
    }
    /* A scale that begins near zero begins at zero. */
    if (low > 0 && low < 0.35 * high)
        low = 0;
    if (!(high - low > 1e-9 * fmax(fabs(high), fabs(low)))) {
        double pad = fmax(fabs(high) * 0.1, 1e-9);
        low -= pad;
        high += pad;
    }
    double tick = round_tick(high - low);
    if (vertical) {
        low = floor(low / tick) * tick;
        high = ceil(high / tick) * tick;
    }
    return (axis){low, high, from, to, tick};
}

static double pixel(const axis *a, double value)
{
    return a->from + (value - a->low) / (a->high - a->low) * (a->to - a->from);
}

static int first_tick(const axis *a)
{
    return (int)ceil(a->low / a->tick - 1e-6);
}

static int last_tick(const axis *a)
{
    return (int)floor(a->high / a->tick + 1e-6);
}

static void draw_ticks(sink *out, const axis *x, const axis *y)
{
    for (int k = first_tick(x); k <= last_tick(x); k++) {
        double v = k * x->tick;
        say(out, "<path class='grid' d='M%.1f %.1fV%.1f'/>\n", pixel(x, v), y->from, y->to);
        say(out, "<text x='%.1f' y='%.1f' text-anchor='middle'>%.6g</text>\n", pixel(x, v),
            y->from + 18, v);
    }
    for (int k = first_tick(y); k <= last_tick(y); k++) {
        double v = k * y->tick;
        say(out, "<path class='grid' d='M%.1f %.1fH%.1f'/>\n", x->from, pixel(y, v), x->to);
        say(out, "<text x='%.1f' y='%.1f' text-anchor='end'>%.6g</text>\n", x->from - 8,
            pixel(y, v) + 4, v);
    }
}

static bool is_marked(skv_curve_style style)
{
    return style == SKV_CURVE_DOTS || style == SKV_CURVE_RINGS;
}

static void say_mark(sink *out, skv_curve_style style, double x, double y)
{
    say(out, "<circle class='%s' cx='%.1f' cy='%.1f' r='3.5'/>\n",
        style == SKV_CURVE_RINGS ? "rings" : "dots", x, y);
}

static void draw_curve(sink *out, const curve *c, const axis *x, const axis *y)
{
    if (is_marked(c->style)) {
        for (int i = 0; i < c->count; i++)
            say_mark(out, c->style, pixel(x, c->x[i]), pixel(y, c->y[i]));
        return;
    }
    say(out, "<polyline class='%s' points='", c->style == SKV_CURVE_THEORY ? "theory" : "line");
    for (int i = 0; i < c->count; i++)
        say(out, "%.1f,%.1f ", pixel(x, c->x[i]), pixel(y, c->y[i]));
    say(out, "'/>\n");
}

static void draw_legend(sink *out, const skv_plot *p)
{
    /* From the right end of the title's line to the left. */
    double at = WIDTH - RIGHT;
    for (int i = p->count - 1; i >= 0; i--) {
        const curve *c = &p->curves[i];
        at -= 7.4 * (double)strlen(c->label);
        say(out, "<text x='%.1f' y='32'>", at);
        say_escaped(out, c->label);
        say(out, "</text>\n");
        if (is_marked(c->style))
            say_mark(out, c->style, at - 10, 28);
        else
            say(out, "<path class='%s' d='M%.1f 28h22'/>\n",
                c->style == SKV_CURVE_THEORY ? "theory" : "line", at - 27);
        at -= 46;
    }
}

static skv_result end(const sink *out, skv_error *error)
{
    if (out->failed)
        return skv_fail(error, SKV_ERROR_FILE, "plot: it could not be written");
    return SKV_OK;
}

skv_result skv_plot_write_svg(const skv_plot *p, skv_write *write, void *user, skv_error *error)
{
    sink stream = {write, user, false}, *out = &stream;
    axis x = make_axis(p, false, LEFT, WIDTH - RIGHT);
    axis y = make_axis(p, true, HEIGHT - BOTTOM, TOP + 8);
    say(out,
        "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' viewBox='0 0 %d %d'>\n",
        WIDTH, HEIGHT, WIDTH, HEIGHT);
    say(out, "<style>text{font:13px sans-serif;fill:#444}.title{font-weight:bold}"
             ".grid{stroke:#888;stroke-opacity:.25}.frame{stroke:#666;fill:none}"
             ".dots{fill:#1f6feb}.rings{fill:#fff;stroke:#1f6feb}.line{stroke:#1f6feb;stroke-width:"
             "1.8;fill:none}"
             ".theory{stroke:#d9730d;stroke-width:2;stroke-dasharray:7 4;fill:none}</style>\n"
             "<rect width='100%%' height='100%%' fill='#fff'/>\n");
    say(out, "<text class='title' x='%d' y='18'>", LEFT);
    say_escaped(out, p->title);
    say(out, "</text>\n");
    draw_ticks(out, &x, &y);
    say(out, "<path class='frame' d='M%d %.1fV%.1fH%d'/>\n", LEFT, y.to, y.from, WIDTH - RIGHT);
    for (int i = 0; i < p->count; i++)
        draw_curve(out, &p->curves[i], &x, &y);
    draw_legend(out, p);
    say(out, "<text x='%d' y='%d' text-anchor='middle'>", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12);
    say_escaped(out, p->x_label);
    say(out, "</text>\n<text transform='translate(18 %d) rotate(-90)' text-anchor='middle'>",
        (TOP + HEIGHT - BOTTOM) / 2);
    say_escaped(out, p->y_label);
    say(out, "</text>\n</svg>\n");
    return end(out, error);
}

skv_result skv_plot_write_csv(const skv_plot *p, skv_write *write, void *user, skv_error *error)
{
    sink stream = {write, user, false}, *out = &stream;
    say(out, "series,");
    say_cell(out, p->x_label);
    say(out, ",");
    say_cell(out, p->y_label);
    say(out, "\n");
    for (int c = 0; c < p->count; c++) {
        for (int i = 0; i < p->curves[c].count; i++) {
            say_cell(out, p->curves[c].label);
            say(out, ",%.9g,%.9g\n", p->curves[c].x[i], p->curves[c].y[i]);
        }
    }
    return end(out, error);
}
