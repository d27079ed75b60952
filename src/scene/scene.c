/* A loaded scene: its facts, and the worlds it builds.
 *
 * Invariant: nothing here changes a scene, so every world of it starts the same.
 */
#include "base/assert.h"
#include "base/memory.h"
#include "scene/bodies.h"
#include "scene/lay.h"
#include "scene/scene_data.h"
#include "skvalp/air.h"
#include "skvalp/particles.h"

void skv_scene_destroy(skv_scene *scene)
{
    if (scene == NULL)
        return;
    skv_free(scene->name);
    skv_free(scene->title);
    skv_free(scene->description);
    skv_terrain_destroy(scene->terrain);
    skv_free(scene->coverage);
    skv_free(scene->paint);
    skv_free(scene->solids);
    skv_free(scene->water.shapes);
    skv_free(scene->points);
    skv_free(scene->bodies);
    skv_free(scene->water.covers);
    for (int i = 0; i < SKV_MAX_FILES; i++)
        skv_free(scene->files[i]);
    for (int i = 0; i < SKV_MAX_NOTICES; i++)
        skv_free(scene->notices[i]);
    skv_free(scene->recipe);
    skv_free(scene);
}

/* ---- Worlds ---------------------------------------------------------------------------------- */

/* The shape whose speed a particle takes. A fresh lattice is slightly shaken, so a particle may
 * have left its shape by a hundredth of a spacing. */
static const skv_shape *shape_near(const skv_water *water, float x, float y, float slack)
{
    const skv_shape *shape = skv_water_shape_at(water, x, y);
    for (int i = 0; shape == NULL && i < 4; i++)
        shape =
            skv_water_shape_at(water, i & 1 ? x + slack : x - slack, i & 2 ? y + slack : y - slack);
    return shape;
}

static bool is_moving(const skv_shape *shape)
{
    return shape->vx != 0.0 || shape->vy != 0.0;
}

static bool is_plain(const skv_shape *shape)
{
    return !is_moving(shape) && shape->dye == 0 && shape->fluid == 0;
}

/* Gives the fluid of shapes their speed and colour, and makes it theirs; and what is painted as oil
 * is oil. */
static skv_result tend_fluid(const skv_scene *scene, skv_world *world, skv_error *error)
{
    bool special = scene->marked[SKV_PAINT_OIL] > 0;
    for (int i = 0; i < scene->water.shape_count; i++)
        special |= !is_plain(&scene->water.shapes[i]);
    if (!special)
        return SKV_OK;
    skv_particles particles = skv_world_particles(world);
    float slack = 0.02f * scene->def.fluid.spacing;
    skv_result result = SKV_OK;
    for (int i = 0; i < particles.count && result == SKV_OK; i++) {
        const skv_shape *shape = shape_near(&scene->water, particles.x[i], particles.y[i], slack);
        bool oil = shape == NULL && skv_water_is_oil(&scene->water, particles.x[i], particles.y[i]);
        if (shape == NULL && !oil)
            continue;
        uint8_t dye = (uint8_t)(oil ? 0 : shape->dye);
        uint8_t fluid = (uint8_t)(oil ? scene->oil : shape->fluid);
        result = skv_world_set_dyes(world, i, 1, &dye, error);
        if (result == SKV_OK)
            result = skv_world_set_fluids(world, i, 1, &fluid, error);
        if (result == SKV_OK && shape != NULL && is_moving(shape))
            result = skv_world_add_velocity(world, i, 1, (float)shape->vx, (float)shape->vy, error);
    }
    return result;
}

/* Adds the particles that a scene begins with. */
static skv_result add_fluid(const skv_scene *scene, skv_world *world, skv_error *error)
{
    size_t count = (size_t)scene->particles;
    float *x = skv_malloc(2 * count, sizeof *x);
    if (x == NULL)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the fluid");
    float *y = x + count;
    skv_result result = skv_lay(&scene->water, scene->terrain, scene->def.fluid.spacing,
                                scene->particles, x, y, error);
    for (int i = 0; i < scene->particles && result == SKV_OK; i++)
        result = skv_world_add_particle(world, x[i], y[i], 0, 0, error);
    skv_free(x);
    return result;
}

skv_result skv_scene_fill(const skv_scene *scene, skv_world *world, skv_error *error)
{
    SKV_ASSERT_OR(scene != NULL && world != NULL, SKV_ERROR_VALUE);
    skv_water water = scene->water; /* the callback's user pointer is not constant */
    /* Bodies come first: one that comes into fluid takes out what lies in it. */
    skv_result result = skv_scene_add_bodies(scene, world, error);
    if (result == SKV_OK && scene->particles > 0)
        result = add_fluid(scene, world, error);
    if (result == SKV_OK)
        result = tend_fluid(scene, world, error);
    if (result == SKV_OK)
        result = skv_scene_set_acting(scene, world, error);
    if (result == SKV_OK)
        result = skv_world_set_air(world, scene->air, error);
    if (result == SKV_OK && scene->settle)
        result = skv_world_settle_drawn(world, skv_water_inside, &water, error);
    return result;
}

skv_world_def skv_scene_world_def(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, skv_default_world_def());
    skv_world_def def = scene->def;
    def.terrain = skv_terrain_share(scene->terrain);
    def.capacity = scene->particles;
    return def;
}

skv_result skv_scene_create_world(const skv_scene *scene, int threads, skv_world **world,
                                  skv_error *error)
{
    SKV_ASSERT_OR(world != NULL, SKV_ERROR_VALUE);
    *world = NULL;
    SKV_ASSERT_OR(scene != NULL, SKV_ERROR_VALUE);
    skv_world_def def = skv_scene_world_def(scene);
    def.threads = threads;
    skv_error cause;
    skv_result result = skv_world_create(&def, world, &cause);
    if (result != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        const char *file = scene->files[0] ? scene->files[0] : scene->name;
        return skv_fail(error, result, "%s: %s", file, cause.text);
    }
    result = skv_scene_fill(scene, *world, error);
    if (result != SKV_OK) {
        skv_world_destroy(*world);
        *world = NULL;
    }
    return result;
}

/* ---- Facts ----------------------------------------------------------------------------------- */

const char *skv_scene_name(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, "");
    return scene->name;
}

const char *skv_scene_title(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, "");
    return scene->title;
}

const char *skv_scene_description(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, "");
    return scene->description;
}

int skv_scene_particles(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, 0);
    return scene->particles;
}

int skv_scene_amount(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, 0);
    return scene->amount;
}

double skv_scene_seconds(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, 0.0);
    return scene->seconds;
}

int skv_scene_body_count(const skv_scene *scene)
{
    SKV_ASSERT_OR(scene != NULL, 0);
    return scene->body_count;
}

const char *skv_scene_body_name(const skv_scene *scene, int i)
{
    SKV_ASSERT_OR(scene != NULL, NULL);
    return i >= 0 && i < scene->body_count ? scene->bodies[i].name : NULL;
}

const char *skv_scene_file(const skv_scene *scene, int i)
{
    SKV_ASSERT_OR(scene != NULL, NULL);
    return i >= 0 && i < SKV_MAX_FILES ? scene->files[i] : NULL;
}

const char *skv_scene_notice(const skv_scene *scene, int i)
{
    SKV_ASSERT_OR(scene != NULL, NULL);
    return i >= 0 && i < SKV_MAX_NOTICES ? scene->notices[i] : NULL;
}
