/* Rulers: grid, ruler and legend. Invariant: their lines are at whole numbers of steps of the
 * world's metres, wherever the camera is. */
#include "render/rulers.h"

#include <math.h>
#include <string.h>

#include "render/figures.h"

/* In lines of the drawing. */
#define GRID_LEAST   24.0 /* between lines */
#define RULER_LEAST  40.0 /* between figures */
#define FIGURE       9.0  /* height */
#define FIGURE_GAP   4.0  /* between figures of the scale: more than between two digits of one */
#define LEGEND_WIDTH 200.0

/* The part of the world that is in the view, m. */
typedef struct window {
    double x0, y0, x1, y1;
} window;

static window visible(const skv_overlay_scene *scene)
{
    const skv_camera *camera = scene->camera;
    window w;
    skv_camera_to_world(camera, 0, camera->height, &w.x0, &w.y0);
    skv_camera_to_world(camera, camera->width, 0, &w.x1, &w.y1);
    w.x0 = fmax(w.x0, 0);
    w.y0 = fmax(w.y0, 0);
    w.x1 = fmin(w.x1, (double)skv_terrain_width(scene->frame->terrain));
    w.y1 = fmin(w.y1, (double)skv_terrain_height(scene->frame->terrain));
    return w;
}

static void add(skv_strokes *strokes, float x0, float y0, float x1, float y1, double radius,
                const float *color, double share)
{
    skv_stroke stroke = {.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1, .radius = (float)radius};
    skv_stroke_paint(&stroke, color, share);
    skv_strokes_add(strokes, stroke);
}

skv_result skv_overlay_grid(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error)
{
    const skv_camera *camera = scene->camera;
    double line = skv_look_line(camera), step = skv_overlay_step(camera, GRID_LEAST * line);
    window w = visible(scene);
    int first_x = (int)ceil(w.x0 / step - 1e-6), last_x = (int)floor(w.x1 / step + 1e-6);
    int first_y = (int)ceil(w.y0 / step - 1e-6), last_y = (int)floor(w.y1 / step + 1e-6);
    int count = (last_x - first_x + 1) + (last_y - first_y + 1);
    skv_result result = skv_strokes_reserve(strokes, count > 0 ? count : 0, error);
    if (result != SKV_OK)
        return result;
    float left = skv_overlay_x(camera, w.x0), right = skv_overlay_x(camera, w.x1);
    float bottom = skv_overlay_y(camera, w.y0), top = skv_overlay_y(camera, w.y1);
    for (int i = first_x; i <= last_x; i++) {
        float x = skv_overlay_x(camera, i * step);
        add(strokes, x, bottom, x, top, 0.5 * line, scene->colors->faint, i % 10 ? 1 : 2);
    }
    for (int j = first_y; j <= last_y; j++) {
        float y = skv_overlay_y(camera, j * step);
        add(strokes, left, y, right, y, 0.5 * line, scene->colors->faint, j % 10 ? 1 : 2);
    }
    return SKV_OK;
}

/* A text with a plate under it, centred at a point. */
static skv_result add_figures(skv_strokes *strokes, const skv_overlay_scene *scene,
                              const char *text, double x, double y, skv_error *error)
{
    double line = skv_look_line(scene->camera), height = FIGURE * line;
    skv_result result = skv_strokes_reserve(strokes, skv_figures_count(text), error);
    if (result != SKV_OK)
        return result;
    double width = (double)skv_figures_width(text, (float)height);
    skv_stroke paint = {0};
    skv_stroke_paint(&paint, scene->colors->figures, 1);
    skv_figures_add(strokes, text, (float)(x - 0.5 * width), (float)(y - 0.5 * height),
                    (float)height, paint.color);
    return SKV_OK;
}

/* In a language whose decimals come after a comma. */
static void write_comma(char *text)
{
    for (; *text; text++)
        *text = *text == '.' ? ',' : *text;
}

/* A length in the unit that suits steps of this size. */
static void format_length(char text[16], double metres, double step, bool with_unit, bool comma)
{
    bool whole = step >= 1;
    skv_format(text, 16, "%.6g%s", metres * (whole ? 1 : 100),
               !with_unit ? ""
               : whole    ? " m"
                          : " cm");
    if (comma)
        write_comma(text);
}

/* One side of the ruler, ticks and figures along x or y. */
static skv_result add_side(skv_strokes *strokes, const skv_overlay_scene *scene, bool upright,
                           skv_error *error)
{
    const skv_camera *camera = scene->camera;
    double line = skv_look_line(camera), step = skv_overlay_step(camera, RULER_LEAST * line);
    window w = visible(scene);
    double from = upright ? w.y0 : w.x0, to = upright ? w.y1 : w.x1;
    double left = (double)skv_overlay_x(camera, w.x0), bottom = (double)skv_overlay_y(camera, w.y0);
    int first = (int)ceil(10 * from / step - 1e-6), last = (int)floor(10 * to / step + 1e-6);
    int unit_at = 10 * ((first + 9) / 10 + (first <= 0));     /* the first figure has the unit */
    int every = step * camera->scale / 10 < 3 * line ? 5 : 1; /* or ticks would touch */
    skv_result result = skv_strokes_reserve(strokes, last > first ? last - first + 1 : 0, error);
    for (int i = first; i <= last && result == SKV_OK; i++) {
        if (i % every)
            continue;
        double length = (i % 10 == 0 ? 10 : i % 5 == 0 ? 7 : 4) * line;
        double at = i * step / 10;
        double x = upright ? left : (double)skv_overlay_x(camera, at);
        double y = upright ? (double)skv_overlay_y(camera, at) : bottom;
        add(strokes, (float)x, (float)y, (float)(upright ? x + length : x),
            (float)(upright ? y : y + length), 0.6 * line, scene->colors->figures, 0.9);
        if (i % 10 || i == 0)
            continue;
        char text[16];
        format_length(text, at, step, !upright && i == unit_at, scene->comma);
        double width = (double)skv_figures_width(text, (float)(FIGURE * line));
        bool inside = upright ? at < to - 0.2 * step : at < to - 0.3 * step;
        result = skv_strokes_reserve(strokes, last - i + 1 + skv_figures_count(text), error);
        if (result == SKV_OK && inside)
            result =
                add_figures(strokes, scene, text, upright ? x + length + 3 * line + width / 2 : x,
                            upright ? y : y + length + 9 * line, error);
    }
    return result;
}

skv_result skv_overlay_ruler(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error)
{
    const skv_camera *camera = scene->camera;
    double line = skv_look_line(camera);
    window w = visible(scene);
    skv_result result = skv_strokes_reserve(strokes, 2, error);
    if (result != SKV_OK)
        return result;
    float left = skv_overlay_x(camera, w.x0), bottom = skv_overlay_y(camera, w.y0);
    float half = (float)(13 * line);
    add(strokes, left, bottom + half, skv_overlay_x(camera, w.x1), bottom + half, (double)half,
        scene->colors->plate, 1);
    add(strokes, left + half, bottom + half, left + half, skv_overlay_y(camera, w.y1), (double)half,
        scene->colors->plate, 1);
    result = add_side(strokes, scene, false, error);
    if (result == SKV_OK)
        result = add_side(strokes, scene, true, error);
    return result;
}

/* Four digits, or all before the point; no exponent, for which figures have no signs. */
static void format_digits(char text[24], double value)
{
    int decimals = 0;
    for (double least = 1000; decimals < 9 && value < least; least /= 10)
        decimals++;
    skv_format(text, 24, "%.*f", decimals, value);
    size_t length = strlen(text);
    while (decimals-- > 0 && text[length - 1] == '0')
        text[--length] = '\0';
    if (text[length - 1] == '.')
        text[length - 1] = '\0';
}

/* A figure of the scale in the unit that is shown: pressure as depth of the liquid at rest, if
 * anything presses it down. */
static void format_figure(char text[32], const skv_legend *legend, double value, bool with_unit)
{
    char digits[24];
    bool as_depth = legend->depth > 0;
    format_digits(digits, as_depth ? 100 * value * legend->depth : value);
    skv_format(text, 32, "%s%s%s", digits, with_unit && (as_depth || *legend->unit) ? " " : "",
               !with_unit ? ""
               : as_depth ? "cm"
                          : legend->unit);
}

skv_result skv_overlay_legend(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error)
{
    const skv_legend *legend = scene->legend;
    const skv_camera *camera = scene->camera;
    double line = skv_look_line(camera);
    double width = fmin(LEGEND_WIDTH * line, 0.6 * camera->width);
    double right = camera->width - 26 * line, left = right - width;
    double top = camera->height - 20 * line, radius = 6 * line;
    if (!legend->shown)
        return SKV_OK;
    skv_result result = skv_strokes_reserve(strokes, SKV_LEGEND_COLORS + 1, error);
    if (result != SKV_OK)
        return result;
    float middle = (float)(top - 8 * line);
    add(strokes, (float)left, middle, (float)right, middle, 22 * line, scene->colors->plate, 1);
    for (int i = 0; i < SKV_LEGEND_COLORS; i++) {
        double at = left + width * i / SKV_LEGEND_COLORS;
        skv_stroke part = {.x0 = (float)at,
                           .y0 = (float)top,
                           .x1 = (float)(at + width / SKV_LEGEND_COLORS),
                           .y1 = (float)top,
                           .radius = (float)radius};
        memcpy(part.color, legend->colors[i], 3);
        part.color[3] = 255;
        skv_strokes_add(strokes, part);
    }
    /* From the last one, which has the unit: what would reach into the next is left out. */
    double next = camera->width;
    for (int k = 2; k >= 0 && result == SKV_OK; k--) {
        char text[32];
        double value = legend->low + 0.5 * k * (legend->high - legend->low);
        format_figure(text, legend, value, k == 2);
        if (scene->comma)
            write_comma(text);
        double half = 0.5 * (double)skv_figures_width(text, (float)(FIGURE * line));
        double at = left + 0.5 * k * width - (k == 2 ? fmax(half - 8 * line, 0) : 0);
        if (at + half > next - FIGURE_GAP * line)
            continue;
        result = add_figures(strokes, scene, text, at, top - radius - 10 * line, error);
        next = at - half;
    }
    return result;
}
