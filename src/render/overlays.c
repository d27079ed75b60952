/* Overlays: from particles and marks in metres to strokes in view pixels. Invariant: what is drawn
 * depends on the frame, the marks and the view alone. */
#include "render/overlays.h"

#include <math.h>

#include "base/assert.h"
#include "render/bodies.h"
#include "render/flow.h"
#include "render/rulers.h"

/* Radius of a tracer's dot in spacings. */
#define TRACER_RADIUS 0.36

/* Radius of a disc of a particle's area in spacings: 1 / sqrt(pi). */
#define PARTICLE_RADIUS 0.5642

#define ROLES 7

static skv_stroke dot_at(const skv_camera *camera, float x, float y, double radius)
{
    skv_stroke stroke = {.x0 = skv_overlay_x(camera, (double)x),
                         .y0 = skv_overlay_y(camera, (double)y),
                         .radius = (float)radius};
    stroke.x1 = stroke.x0;
    stroke.y1 = stroke.y0;
    return stroke;
}

static skv_result add_particles(skv_strokes *strokes, const skv_overlay_scene *scene,
                                skv_error *error)
{
    const skv_particles particles = scene->frame->particles;
    const skv_legend *legend = scene->legend;
    double radius = PARTICLE_RADIUS * (double)scene->frame->spacing * scene->camera->scale;
    skv_result result = skv_strokes_reserve(strokes, particles.count, error);
    for (int i = 0; result == SKV_OK && i < particles.count; i++) {
        skv_stroke disc = dot_at(scene->camera, particles.x[i], particles.y[i], fmax(radius, 0.6));
        double speed = hypot((double)particles.vx[i], (double)particles.vy[i]);
        int at =
            (int)fmin(speed / legend->high * (SKV_LEGEND_COLORS - 1) + 0.5, SKV_LEGEND_COLORS - 1);
        for (int k = 0; k < 3; k++)
            disc.color[k] = legend->colors[at][k];
        disc.color[3] = 255;
        skv_strokes_add(strokes, disc);
    }
    return result;
}

/* A particle's own random number. */
static uint32_t random_of(uint32_t id)
{
    uint32_t hash = id * 0x9e3779b1u;
    hash = (hash ^ (hash >> 15)) * 0x85ebca77u;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae3du;
    return hash ^ (hash >> 16);
}

/* Bubbles where there is foam: each particle has its size, and the amount of foam at which its
 * bubble shows; it comes and goes by fading. */
static skv_result add_bubbles(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error)
{
    const skv_vertices *vertices = scene->vertices;
    double spacing = (double)scene->frame->spacing * scene->camera->scale;
    skv_result result = skv_strokes_reserve(strokes, vertices->count, error);
    for (int i = 0; result == SKV_OK && i < vertices->count; i++) {
        uint32_t random = random_of(scene->frame->particles.id[i]);
        double needed = 0.05 + 0.9 * (random & 255) / 255;
        double share = fmin(5 * ((double)vertices->list[i].second - needed), 1);
        if (share <= 0)
            continue;
        double size = 0.10 + 0.16 * (random >> 8 & 255) / 255;
        skv_stroke bubble = dot_at(scene->camera, vertices->list[i].x, vertices->list[i].y,
                                   fmax(size * spacing, 0.7));
        skv_stroke_paint(&bubble, scene->colors->bubble, share);
        skv_strokes_add(strokes, bubble);
    }
    return result;
}

/* One particle in ten; at random, because every tenth of a lattice would stand in rows. */
static bool is_tracer(uint32_t id)
{
    return random_of(id) % 10 == 0;
}

static skv_result add_tracers(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error)
{
    const skv_particles particles = scene->frame->particles;
    const float *ink = skv_overlay_ink(scene);
    int count = 0;
    for (int i = 0; i < particles.count; i++)
        count += is_tracer(particles.id[i]);
    skv_result result = skv_strokes_reserve(strokes, count, error);
    if (result != SKV_OK)
        return result;
    /* Never smaller than what can be seen. */
    double radius = fmax(TRACER_RADIUS * (double)scene->frame->spacing * scene->camera->scale, 1.2);
    for (int i = 0; i < particles.count; i++) {
        if (!is_tracer(particles.id[i]))
            continue;
        skv_stroke dot = dot_at(scene->camera, particles.x[i], particles.y[i], radius);
        skv_stroke_paint(&dot, ink, 1);
        skv_strokes_add(strokes, dot);
    }
    return SKV_OK;
}

skv_result skv_overlays_add(skv_strokes *strokes, const skv_overlay_scene *scene, unsigned overlays,
                            skv_error *error)
{
    /* In the order in which they cover each other. */
    const struct {
        unsigned overlay;
        skv_result (*add)(skv_strokes *, const skv_overlay_scene *, skv_error *);
    } all[] = {{SKV_OVERLAY_GRID, skv_overlay_grid},
               {SKV_OVERLAY_STREAMLINES, skv_overlay_streamlines},
               {SKV_OVERLAY_ARROWS, skv_overlay_arrows},
               {SKV_OVERLAY_TRACERS, add_tracers},
               {SKV_OVERLAY_RULER, skv_overlay_ruler},
               {SKV_OVERLAY_LEGEND, skv_overlay_legend}};
    skv_result result = skv_bodies_draw(strokes, scene, error);
    if (result == SKV_OK && scene->view == SKV_VIEW_PARTICLES)
        result = add_particles(strokes, scene, error);
    if (result == SKV_OK && scene->view == SKV_VIEW_WATER && scene->vertices->foamy &&
        scene->colors->foam > 0)
        result = add_bubbles(strokes, scene, error);
    for (size_t i = 0; i < sizeof all / sizeof *all && result == SKV_OK; i++)
        if (overlays & all[i].overlay)
            result = all[i].add(strokes, scene, error);
    return result;
}

/* A mark's line over a wider one of the opposite brightness, so that it shows on anything. */
static void add_line(skv_strokes *strokes, skv_stroke line, double halo, const float color[4],
                     const float halo_color[4])
{
    skv_stroke under = line;
    under.radius += (float)halo;
    if (under.ring > 0)
        under.ring += 2 * (float)halo;
    skv_stroke_paint(&under, halo_color, 1);
    skv_stroke_paint(&line, color, 1);
    skv_strokes_add(strokes, under);
    skv_strokes_add(strokes, line);
}

static void add_mark(skv_strokes *strokes, const skv_overlay_scene *scene, const skv_mark *mark)
{
    const skv_camera *camera = scene->camera;
    double line = skv_look_line(camera);
    SKV_ASSERT((int)mark->role >= 0 && mark->role < ROLES);
    SKV_ASSERT(mark->dye >= 0 && mark->dye <= SKV_DYES);
    const float *color = scene->colors->marks[mark->role];
    skv_stroke stroke = dot_at(camera, mark->x0, mark->y0, 3 * line);
    if (mark->shape == SKV_MARK_CIRCLE) {
        stroke.radius = (float)fmax((double)mark->radius * camera->scale, 2 * line);
        skv_stroke fill = stroke;
        if (mark->dye > 0)
            skv_stroke_paint(&fill, scene->colors->dyes[mark->dye - 1], 0.6);
        else
            skv_stroke_paint(&fill, color, 0.08);
        skv_strokes_add(strokes, fill);
        stroke.ring = (float)(1.5 * line);
    } else if (mark->shape == SKV_MARK_SEGMENT) {
        stroke.x1 = skv_overlay_x(camera, (double)mark->x1);
        stroke.y1 = skv_overlay_y(camera, (double)mark->y1);
        stroke.radius = (float)line;
    }
    if (mark->dashed && mark->shape != SKV_MARK_POINT)
        stroke.dash = (float)(6 * line);
    add_line(strokes, stroke, line, color, scene->colors->halo);
}

skv_result skv_overlays_add_marks(skv_strokes *strokes, const skv_overlay_scene *scene,
                                  const skv_mark *marks, int count, skv_error *error)
{
    skv_result result = skv_strokes_reserve(strokes, 3 * count, error);
    for (int i = 0; result == SKV_OK && i < count; i++)
        add_mark(strokes, scene, &marks[i]);
    return result;
}
