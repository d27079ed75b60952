/* Bodies that people drop, and take away again. Invariant: none comes where a wall or another body
 * leaves no room for the circle around it. */
#include "session/command.h"

#include "base/exact.h"
#include "world/bodies/bodies.h"

#include <math.h>

/* Corners in a circle of radius 1, counter-clockwise. */
static const float duck[] = {-0.56f, -0.62f, 0.44f,  -0.62f, 0.78f,  -0.32f, 0.98f,
                             0.12f,  0.36f,  -0.06f, 0,      -0.06f, -0.02f, 0.46f,
                             -0.24f, 0.74f,  -0.5f,  0.74f,  -0.7f,  0.52f,  -0.94f,
                             0.34f,  -0.6f,  0.28f,  -0.58f, 0.02f,  -0.9f,  -0.2f};
enum { DUCK_NUMBERS = sizeof duck / sizeof *duck };

enum { DUCK, BALL, CRATE, SHAPES };
static const char *const names[SHAPES] = {[DUCK] = "duck", [BALL] = "ball", [CRATE] = "crate"};

const char *skv_drop_shape(int i)
{
    return i >= 0 && i < SHAPES ? names[i] : NULL;
}

static skv_area area_of(int shape, float radius)
{
    const float half = 0.70710678f * radius; /* its corners lie on the circle */
    float corners[DUCK_NUMBERS];
    if (shape == BALL)
        return skv_circle(0, 0, radius);
    if (shape == CRATE)
        return skv_box(-half, -half, half, half);
    for (int i = 0; i < DUCK_NUMBERS; i++)
        corners[i] = radius * duck[i];
    return skv_polygon(corners, DUCK_NUMBERS / 2);
}

/* Whether it is a place that can be asked about, whoever wrote it. */
static bool is_place(float x, float y)
{
    return skv_within((double)x, -1000, 1000) && skv_within((double)y, -1000, 1000);
}

/* Farther away than distances reach is far enough for whatever is larger. */
static bool has_room(const skv_drop *drop, const skv_world *world)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    float reach = 0.95f * SKV_TERRAIN_REACH * skv_terrain_pixel_size(terrain);
    float least = skv_minf(drop->radius, reach);
    return is_place(drop->x, drop->y) && skv_terrain_distance(terrain, drop->x, drop->y) >= least &&
           skv_bodies_distance(world, drop->x, drop->y) >= least;
}

skv_result skv_drop_apply(const skv_drop *drop, skv_world *world, skv_error *error)
{
    if (!skv_drop_shape(drop->shape))
        return skv_fail(error, SKV_ERROR_VALUE, "body: there is no shape %d", drop->shape);
    if (!has_room(drop, world))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "a wall or another body leaves no room for one here; drop it elsewhere, or "
                        "make the tool smaller");
    skv_body_def def = skv_default_body_def();
    def.shape = area_of(drop->shape, drop->radius);
    def.x = drop->x;
    def.y = drop->y;
    def.vx = drop->vx;
    def.vy = drop->vy;
    def.density = drop->density;
    return skv_world_add_body(world, &def, NULL, NULL, error);
}

/* Whether the way of a brush's middle leads over a body, looked at as often as the brush is wide.
 */
static bool leads_over(const skv_dab *dab, const skv_world *world, int body)
{
    float dx = dab->x1 - dab->x0, dy = dab->y1 - dab->y0;
    float width = skv_maxf(dab->radius, 1e-3f);
    int looks = (int)skv_minf(ceilf(sqrtf(dx * dx + dy * dy) / width), 1000);
    for (int i = 0; i <= looks; i++) {
        float share = looks > 0 ? (float)i / (float)looks : 1;
        if (skv_body_distance(world, body, dab->x0 + share * dx, dab->y0 + share * dy) <= 0)
            return true;
    }
    return false;
}

void skv_drop_take(const skv_dab *dab, skv_world *world)
{
    bool known = is_place(dab->x0, dab->y0) && is_place(dab->x1, dab->y1);
    for (int k = skv_world_body_count(world) - 1; known && k >= 0; k--) {
        skv_body body;
        if (leads_over(dab, world, k) && skv_world_body_at(world, k, &body))
            skv_world_remove_body(world, body.id);
    }
}

bool skv_drop_code(skv_command *command, const skv_command last[2], skv_coder *coder)
{
    skv_drop *drop = &command->drop;
    uint64_t shape = (uint64_t)drop->shape;
    skv_exchange(&coder->port, &shape, 1);
    drop->shape = (int)shape;
    skv_code_float(coder, &drop->x, last[0].drop.x, SKV_UNIT_LENGTH);
    skv_code_float(coder, &drop->y, last[0].drop.y, SKV_UNIT_LENGTH);
    skv_code_float(coder, &drop->vx, last[0].drop.vx, SKV_UNIT_SPEED);
    skv_code_float(coder, &drop->vy, last[0].drop.vy, SKV_UNIT_SPEED);
    skv_code_float(coder, &drop->radius, last[0].drop.radius, SKV_UNIT_LENGTH);
    skv_code_float(coder, &drop->density, last[0].drop.density, SKV_UNIT_SPEED);
    return true;
}
