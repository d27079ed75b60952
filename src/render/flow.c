/* Flow: arrows and streamlines of the velocity on the mesh. Invariant: they begin at points that
 * are fixed in the world, so that they move only as the fluid's velocity changes. */
#include "render/flow.h"

#include <math.h>

#include "base/exact.h"

/* Distances between arrows and between the beginnings of streamlines, in lines of the drawing. */
#define ARROW_STEP  30.0
#define SEED_STEP   26.0
#define ARROW_FULL  0.35 /* share of the scale's speed at which an arrow is as long as its step */
#define LINE_STEPS  16   /* of a streamline, in each direction */
#define LINE_LENGTH 3.0  /* of a fast one in each direction, in distances of beginnings */
#define LINE_SPEED  0.12 /* share of the scale's speed that counts as fast */

/* Points of a square grid that are in the view, in metres. */
typedef struct seeds {
    double step;
    int first_x, first_y, last_x, last_y;
} seeds;

static seeds seeds_in_view(const skv_overlay_scene *scene, double pixels)
{
    const skv_camera *camera = scene->camera;
    int exponent;
    double fraction = frexp(pixels * skv_look_line(camera) / camera->scale, &exponent);
    /* Halvings of a metre, the next one above: zooming keeps every other point. */
    double step = ldexp(fraction > 0.5 ? 1 : 0.5, exponent);
    double left, top, right, bottom;
    skv_camera_to_world(camera, 0, 0, &left, &top);
    skv_camera_to_world(camera, camera->width, camera->height, &right, &bottom);
    double width = (double)skv_terrain_width(scene->frame->terrain);
    double height = (double)skv_terrain_height(scene->frame->terrain);
    return (seeds){.step = step,
                   .first_x = (int)floor(fmax(left, 0) / step),
                   .first_y = (int)floor(fmax(bottom, 0) / step),
                   .last_x = (int)floor(fmin(right, width) / step),
                   .last_y = (int)floor(fmin(top, height) / step)};
}

static int seed_count(const seeds *grid)
{
    int across = grid->last_x - grid->first_x + 1, upwards = grid->last_y - grid->first_y + 1;
    return across > 0 && upwards > 0 ? across * upwards : 0;
}

static void add_segment(skv_strokes *strokes, const skv_camera *camera, const float from[2],
                        const float to[2], double radius, const float *color, double share)
{
    skv_stroke stroke = {.x0 = skv_overlay_x(camera, (double)from[0]),
                         .y0 = skv_overlay_y(camera, (double)from[1]),
                         .x1 = skv_overlay_x(camera, (double)to[0]),
                         .y1 = skv_overlay_y(camera, (double)to[1]),
                         .radius = (float)radius};
    skv_stroke_paint(&stroke, color, share);
    skv_strokes_add(strokes, stroke);
}

static void add_arrow(skv_strokes *strokes, const skv_overlay_scene *scene, float x, float y,
                      double step)
{
    float vx, vy;
    if (!skv_mesh_velocity(&scene->vertices->mesh, x, y, &vx, &vy))
        return;
    double line = skv_look_line(scene->camera), speed = hypot((double)vx, (double)vy);
    double length = step * fmin(speed / (ARROW_FULL * skv_look_speed(scene->frame)), 1.4);
    const float *ink = skv_overlay_ink(scene);
    if (length * scene->camera->scale < 2 * line) {
        const float at[2] = {x, y};
        add_segment(strokes, scene->camera, at, at, 1.1 * line, ink, 0.7);
        return;
    }
    /* Centred on its point; the head's sides are a third of it. */
    float along[2] = {(float)((double)vx / speed * length), (float)((double)vy / speed * length)};
    const float tail[2] = {x - 0.5f * along[0], y - 0.5f * along[1]};
    const float head[2] = {x + 0.5f * along[0], y + 0.5f * along[1]};
    add_segment(strokes, scene->camera, tail, head, 0.8 * line, ink, 1);
    for (int side = -1; side <= 1; side += 2) {
        const float barb[2] = {head[0] - 0.32f * along[0] + (float)side * 0.2f * along[1],
                               head[1] - 0.32f * along[1] - (float)side * 0.2f * along[0]};
        add_segment(strokes, scene->camera, head, barb, 0.8 * line, ink, 1);
    }
}

skv_result skv_overlay_arrows(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error)
{
    seeds grid = seeds_in_view(scene, ARROW_STEP);
    skv_result result = skv_strokes_reserve(strokes, 3 * seed_count(&grid), error);
    for (int j = grid.first_y; result == SKV_OK && j <= grid.last_y; j++)
        for (int i = grid.first_x; i <= grid.last_x; i++)
            add_arrow(strokes, scene, (float)((i + 0.5) * grid.step),
                      (float)((j + 0.5) * grid.step), grid.step);
    return result;
}

/* One step of the midpoint rule of this length; false where the fluid ends. */
static bool follow(const skv_mesh *mesh, float point[2], float step)
{
    float vx, vy;
    if (!skv_mesh_velocity(mesh, point[0], point[1], &vx, &vy))
        return false;
    float speed = hypotf(vx, vy);
    if (speed == 0)
        return false;
    float x = point[0] + 0.5f * step * vx / speed, y = point[1] + 0.5f * step * vy / speed;
    if (!skv_mesh_velocity(mesh, x, y, &vx, &vy))
        return false;
    speed = hypotf(vx, vy);
    if (speed == 0)
        return false;
    point[0] += step * vx / speed;
    point[1] += step * vy / speed;
    return skv_terrain_distance(mesh->frame->terrain, point[0], point[1]) > 0;
}

/* Both ways from a seed; as long as the fluid is fast there, fading towards the ends. */
static void add_streamline(skv_strokes *strokes, const skv_overlay_scene *scene, float x, float y,
                           double distance)
{
    float vx, vy;
    if (!skv_mesh_velocity(&scene->vertices->mesh, x, y, &vx, &vy))
        return;
    double fast = hypot((double)vx, (double)vy) / (LINE_SPEED * skv_look_speed(scene->frame));
    float step = (float)(LINE_LENGTH * distance * (1 - skv_exp(-fmin(fast, 100))) / LINE_STEPS);
    for (int way = -1; way <= 1; way += 2) {
        float at[2] = {x, y};
        for (int i = 0; i < LINE_STEPS; i++) {
            const float from[2] = {at[0], at[1]};
            if (!follow(&scene->vertices->mesh, at, (float)way * step))
                break;
            double share = 0.85 * (1 - (i + 0.5) / LINE_STEPS);
            add_segment(strokes, scene->camera, from, at, 0.6 * skv_look_line(scene->camera),
                        skv_overlay_ink(scene), share);
        }
    }
}

skv_result skv_overlay_streamlines(skv_strokes *strokes, const skv_overlay_scene *scene,
                                   skv_error *error)
{
    seeds grid = seeds_in_view(scene, SEED_STEP);
    skv_result result = skv_strokes_reserve(strokes, 2 * LINE_STEPS * seed_count(&grid), error);
    for (int j = grid.first_y; result == SKV_OK && j <= grid.last_y; j++)
        for (int i = grid.first_x; i <= grid.last_x; i++) {
            /* Every other row is shifted by half a step: fewer lines follow each other. */
            double shift = j & 1 ? 0.75 : 0.25;
            add_streamline(strokes, scene, (float)((i + shift) * grid.step),
                           (float)((j + 0.5) * grid.step), grid.step);
        }
    return result;
}
