/* Bodies: filled polygons with an outline, as strokes. A polygon is filled by lines across it, a
 * line of the picture each, so it needs no shader of its own. Invariant: what is drawn depends on
 * the frame and the view alone. */
#include "render/bodies.h"

#include <math.h>

#include "render/body_look.h"

/* View pixels from line to line, in thin lines, and half the width of each: they overlap. */
#define APART 1.0
#define HALF  0.75

/* Radius of a pin, in thin lines: larger than what is at the middle of a paddle's outline. */
#define PIN 3.0

skv_placed_body skv_body_place(const skv_body *body)
{
    skv_placed_body p = {.count = body->corners,
                         .left = INFINITY,
                         .right = -INFINITY,
                         .low = INFINITY,
                         .high = -INFINITY};
    double c = cos((double)body->angle), s = sin((double)body->angle);
    for (int i = 0; i < p.count; i++) {
        double x = (double)body->outline[2 * i], y = (double)body->outline[2 * i + 1];
        p.x[i] = (float)((double)body->x + c * x - s * y);
        p.y[i] = (float)((double)body->y + s * x + c * y);
        p.left = fminf(p.left, p.x[i]);
        p.right = fmaxf(p.right, p.x[i]);
        p.low = fminf(p.low, p.y[i]);
        p.high = fmaxf(p.high, p.y[i]);
    }
    return p;
}

float skv_placed_body_distance(const skv_placed_body *p, float x, float y)
{
    float least = INFINITY;
    bool inside = false;
    for (int i = 0; i < p->count; i++) {
        int k = (i + 1) % p->count;
        float along_x = p->x[k] - p->x[i], along_y = p->y[k] - p->y[i];
        float rx = x - p->x[i], ry = y - p->y[i];
        float squared = along_x * along_x + along_y * along_y;
        float share = squared > 0 ? (rx * along_x + ry * along_y) / squared : 0;
        share = fminf(fmaxf(share, 0), 1);
        least = fminf(least, hypotf(rx - share * along_x, ry - share * along_y));
        if ((p->y[i] > y) != (p->y[k] > y) && rx < ry / along_y * along_x)
            inside = !inside;
    }
    return inside ? -least : least;
}

/* The same in view pixels. */
static skv_placed_body show(const skv_camera *camera, const skv_body *body)
{
    skv_placed_body p = skv_body_place(body);
    for (int i = 0; i < p.count; i++) {
        p.x[i] = skv_overlay_x(camera, (double)p.x[i]);
        p.y[i] = skv_overlay_y(camera, (double)p.y[i]);
    }
    p.low = skv_overlay_y(camera, (double)p.low);
    p.high = skv_overlay_y(camera, (double)p.high);
    return p;
}

/* Where the polygon crosses a height, from left to right. */
static int find_crossings(const skv_placed_body *p, float y, float crossing[SKV_MAX_CORNERS])
{
    int count = 0;
    for (int i = 0; i < p->count; i++) {
        int k = (i + 1) % p->count;
        if ((p->y[i] > y) == (p->y[k] > y))
            continue;
        float x = p->x[i] + (y - p->y[i]) / (p->y[k] - p->y[i]) * (p->x[k] - p->x[i]);
        int at = count++;
        for (; at > 0 && crossing[at - 1] > x; at--)
            crossing[at] = crossing[at - 1];
        crossing[at] = x;
    }
    return count;
}

static skv_result fill(skv_strokes *strokes, const skv_placed_body *p, double line,
                       const float color[4], skv_error *error)
{
    float apart = (float)(APART * line), half = (float)(HALF * line);
    int lines = (int)((p->high - p->low) / apart) + 1;
    skv_result result = skv_strokes_reserve(strokes, lines * p->count / 2, error);
    for (int k = 0; result == SKV_OK && k < lines; k++) {
        float crossing[SKV_MAX_CORNERS], y = p->low + ((float)k + 0.5f) * apart;
        int count = find_crossings(p, y, crossing);
        for (int i = 0; i + 1 < count; i += 2) {
            skv_stroke across = {.x0 = fminf(crossing[i] + half, crossing[i + 1]),
                                 .x1 = fmaxf(crossing[i + 1] - half, crossing[i]),
                                 .y0 = y,
                                 .y1 = y,
                                 .radius = half};
            skv_stroke_paint(&across, color, 1);
            skv_strokes_add(strokes, across);
        }
    }
    return result;
}

static skv_result outline(skv_strokes *strokes, const skv_placed_body *p, double line,
                          const float color[4], skv_error *error)
{
    skv_result result = skv_strokes_reserve(strokes, p->count, error);
    for (int i = 0; result == SKV_OK && i < p->count; i++) {
        int k = (i + 1) % p->count;
        skv_stroke side = {.x0 = p->x[i], .y0 = p->y[i], .x1 = p->x[k], .y1 = p->y[k]};
        side.radius = (float)line;
        skv_stroke_paint(&side, color, 1);
        skv_strokes_add(strokes, side);
    }
    return result;
}

/* A dot over all bodies, for a pin may lie beside its own. */
static skv_result draw_pins(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error)
{
    skv_result result = skv_strokes_reserve(strokes, scene->frame->body_count, error);
    for (int i = 0; i < scene->frame->body_count && result == SKV_OK; i++) {
        const skv_body *body = &scene->frame->bodies[i];
        if (!body->pinned)
            continue;
        skv_stroke dot = {.radius = (float)(PIN * skv_look_line(scene->camera))};
        dot.x0 = dot.x1 = skv_overlay_x(scene->camera, (double)body->pin_x);
        dot.y0 = dot.y1 = skv_overlay_y(scene->camera, (double)body->pin_y);
        skv_stroke_paint(&dot, skv_look_body(scene->palette, body->density)->edge, 1);
        skv_strokes_add(strokes, dot);
    }
    return result;
}

skv_result skv_bodies_draw(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error)
{
    double line = skv_look_line(scene->camera);
    skv_result result = SKV_OK;
    for (int i = 0; i < scene->frame->body_count && result == SKV_OK; i++) {
        const skv_body *body = &scene->frame->bodies[i];
        const skv_body_look *look = skv_look_body(scene->palette, body->density);
        skv_placed_body p = show(scene->camera, body);
        result = fill(strokes, &p, line, look->inside, error);
        if (result == SKV_OK)
            result = outline(strokes, &p, line, look->edge, error);
    }
    return result == SKV_OK ? draw_pins(strokes, scene, error) : result;
}
