/* Builds and runs the worlds of the experiments.
 *
 * Solids are drawn as exact shares of pixels: the coverage of a pixel follows from its centre's
 * distance to the solid, so a wall lies where it was put to a tenth of a pixel. Invariant: what
 * decides the particles' paths (positions, gravity) is computed with +, -, *, / and sqrt alone.
 */
#include "experiments/stage.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

#define FRAME 1.0f / 60

solid skv_solid_box(double x0, double y0, double x1, double y1)
{
    return (solid){4, {x0, x1, x1, x0}, {y0, y0, y1, y1}};
}

/* Distance of a point from a convex solid, < 0 inside; beyond a corner a little short. */
static double distance(const solid *s, double x, double y)
{
    double farthest = -HUGE_VAL;
    for (int i = 0; i < s->corners; i++) {
        int next = (i + 1) % s->corners;
        double ex = s->x[next] - s->x[i], ey = s->y[next] - s->y[i];
        double length = sqrt(ex * ex + ey * ey);
        double out = ((x - s->x[i]) * ey - (y - s->y[i]) * ex) / length;
        farthest = fmax(farthest, out);
    }
    return farthest;
}

static uint8_t coverage(const stage_plan *plan, double pixel, double x, double y)
{
    double most = 0;
    for (int i = 0; i < plan->solid_count; i++)
        most = fmax(most, 0.5 - distance(&plan->solids[i], x, y) / pixel);
    return (uint8_t)(fmin(most, 1) * 255 + 0.5);
}

/* Four pixels a spacing, as far as a picture may be that large. */
static skv_result make_terrain(const stage *s, const stage_plan *plan, skv_terrain **terrain,
                               skv_error *error)
{
    double longest = fmax(plan->width, plan->height);
    double pixel = fmax(s->spacing / 4, longest / (SKV_TERRAIN_MAX_PIXELS - 1));
    /* The width is met exactly; the height to less than a pixel. */
    int columns = (int)ceil(plan->width / pixel);
    columns = columns < SKV_TERRAIN_MIN_PIXELS ? SKV_TERRAIN_MIN_PIXELS : columns;
    pixel = plan->width / columns;
    int rows = (int)ceil(plan->height / pixel);
    rows = rows < SKV_TERRAIN_MIN_PIXELS ? SKV_TERRAIN_MIN_PIXELS : rows;
    uint8_t *picture = skv_calloc((size_t)columns * (size_t)rows, 1);
    if (!picture)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a terrain");
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++)
            picture[(size_t)row * (size_t)columns + (size_t)column] =
                coverage(plan, pixel, (column + 0.5) * pixel, (row + 0.5) * pixel);
    }
    skv_terrain_def def = skv_default_terrain_def();
    def.width = columns;
    def.height = rows;
    def.coverage = picture;
    def.pixel_size = (float)pixel;
    def.open_sides = plan->open_sides;
    skv_result result = skv_terrain_create(&def, terrain, error);
    skv_free(picture);
    return result;
}

static skv_result make_world(const stage *s, const stage_plan *plan, skv_world **world,
                             skv_error *error)
{
    skv_world_def def = skv_default_world_def();
    def.fluid = s->fluid;
    def.fluid.spacing = (float)s->spacing;
    def.gravity_x = (float)plan->gravity_x;
    def.gravity_y = (float)plan->gravity_y;
    def.depth = (float)plan->depth;
    def.substeps = (int)s->settings->value[PARAM_SUBSTEPS];
    def.sleep = false; /* it would cut small motions off, docs/model.md */
    def.threads = s->options ? s->options->threads : 0;
    skv_result result = make_terrain(s, plan, &def.terrain, error);
    if (result != SKV_OK)
        return result;
    result = skv_world_create(&def, world, error);
    if (result != SKV_OK)
        skv_terrain_destroy(def.terrain);
    return result;
}

void skv_stage_choose_spacing(stage *s, double area, double share)
{
    double given = skv_settings_length(s->settings, PARAM_SPACING);
    double wanted = s->settings->value[PARAM_PARTICLES] * share;
    /* As the world will have it, in single precision. */
    float spacing = (float)(given > 0 ? given : sqrt(area / wanted));
    s->spacing = (double)spacing;
    s->h = (double)(spacing * s->fluid.radius_ratio);
}

skv_result skv_stage_build(stage *s, const stage_plan *plan, skv_error *error)
{
    skv_world_destroy(s->world);
    s->world = NULL;
    skv_result result = make_world(s, plan, &s->world, error);
    if (result == SKV_OK && !s->lab)
        result = skv_lab_create(&s->lab, error);
    return result;
}

skv_result skv_stage_rebuild(stage *s, const stage_plan *plan, skv_error *error)
{
    skv_world *next = NULL;
    skv_result result = make_world(s, plan, &next, error);
    if (result != SKV_OK)
        return result;
    skv_particles p = skv_world_particles(s->world);
    for (int i = 0; i < p.count && result == SKV_OK; i++)
        result = skv_world_add_particle(next, p.x[i], p.y[i], p.vx[i], p.vy[i], error);
    if (result != SKV_OK) {
        skv_world_destroy(next);
        return result;
    }
    skv_world_destroy(s->world);
    s->world = next;
    return SKV_OK;
}

void skv_stage_close(stage *s)
{
    skv_lab_destroy(s->lab);
    skv_world_destroy(s->world);
    s->lab = NULL;
    s->world = NULL;
}

skv_result skv_stage_fill(stage *s, double x0, double y0, double x1, double y1, skv_inside *inside,
                          void *user, skv_error *error)
{
    skv_fill_def def = skv_default_fill_def();
    def.x0 = (float)x0;
    def.y0 = (float)y0;
    def.x1 = (float)x1;
    def.y1 = (float)y1;
    def.inside = inside;
    def.user = user;
    return skv_world_fill(s->world, &def, NULL, error);
}

skv_result skv_stage_add(stage *s, skv_instrument_kind kind, double x0, double y0, double x1,
                         double y1, double window, skv_instrument *id, skv_error *error)
{
    skv_instrument_def def = skv_default_instrument_def(kind);
    def.x0 = x0;
    def.y0 = y0;
    def.x1 = x1;
    def.y1 = y1;
    def.window = window;
    def.capacity = 4000;
    return skv_lab_add(s->lab, &def, id, error);
}

static skv_result step(stage *s, skv_error *error)
{
    skv_result result = skv_world_step(s->world, FRAME, error);
    if (result != SKV_OK)
        return result;
    s->done += (double)(FRAME);
    double share = fmin(1, s->done / s->total);
    if (s->options && s->options->progress && !s->options->progress(share, s->options->user))
        return skv_fail(error, SKV_ERROR_LIMIT, "the experiment was stopped");
    return SKV_OK;
}

double skv_stage_mean_level(const stage *s, const skv_instrument *gauges, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += skv_lab_reading(s->lab, gauges[i], 2) / count;
    return sum;
}

skv_result skv_stage_frame(stage *s, skv_error *error)
{
    skv_result result = step(s, error);
    return result == SKV_OK ? skv_lab_sample(s->lab, s->world, error) : result;
}

skv_result skv_stage_wait(stage *s, double seconds, skv_error *error)
{
    skv_result result = SKV_OK;
    int frames = (int)(seconds * 60 + 0.5);
    for (int i = 0; i < frames && result == SKV_OK; i++)
        result = step(s, error);
    return result;
}

skv_result skv_stage_check_passage(const stage *s, const char *what, double width, skv_error *error)
{
    const double needed = 6;
    if (width >= needed * s->spacing)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "%s: %.3g m are %.2g spacings of %.3g m; at least %g are needed, take more "
                    "particles or make it wider",
                    what, width, width / s->spacing, s->spacing, needed);
}
