/* What acts on a scene's fluid: force fields, emitters and drains. Invariant: what a scene holds of
 * it, a world takes.
 */
#include "base/memory.h"
#include "scene/fluids.h"
#include "scene/shapes.h"
#include "world/emitters.h"

#include <math.h>

static float number(const skv_shape_values *values, int field)
{
    return (float)values->value[field].number;
}

/* The same region for the world; a line has none. */
static skv_area area_of(const skv_shape *shape)
{
    if (shape->kind == SKV_SHAPE_CIRCLE)
        return skv_circle((float)shape->x, (float)shape->y, (float)shape->radius);
    if (shape->kind == SKV_SHAPE_BOX)
        return skv_box((float)shape->x0, (float)shape->y0, (float)shape->x1, (float)shape->y1);
    float corners[2 * SKV_MAX_CORNERS];
    for (int i = 0; i < 2 * shape->point_count; i++)
        corners[i] = (float)shape->points[i];
    return skv_polygon(corners, shape->point_count);
}

/* Writes the areas of a list, which have room. */
static skv_result build_areas(const skv_draft *draft, skv_list list, const skv_scene *scene,
                              skv_area *areas, skv_error *error)
{
    int count = draft->values.list[list].count;
    if (count == 0)
        return SKV_OK;
    skv_shape *shapes = skv_calloc((size_t)count, sizeof *shapes);
    if (shapes == NULL)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    skv_result result = skv_shapes_make(draft, list, scene->width * scene->pixel_size,
                                        scene->height * scene->pixel_size, shapes, error);
    for (int i = 0; result == SKV_OK && i < count; i++)
        areas[i] = area_of(&shapes[i]);
    skv_free(shapes);
    return result;
}

static skv_force make_force(const skv_shape_values *values, const skv_area *area)
{
    skv_force force = {.area = *area};
#define FORCE_NUMBER(id, member, ...) force.member = number(values, SKV_FORCE_##id);
#include "skvalp/acting.h"
#include "world/force_rows.h"
    return force;
}

static skv_result build_forces(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    skv_area areas[SKV_MAX_FORCES];
    const skv_shape_list *forces = &draft->values.list[SKV_LIST_FORCES];
    skv_result result = build_areas(draft, SKV_LIST_FORCES, scene, areas, error);
    if (result != SKV_OK)
        return result;
    scene->force_count = forces->count;
    for (int i = 0; i < forces->count; i++)
        scene->forces[i] = make_force(&forces->shapes[i], &areas[i]);
    return SKV_OK;
}

/* Fails for an element of a list, or a field of it. */
static skv_result fail_element(const skv_draft *draft, skv_list list, int index, const char *field,
                               skv_result code, const char *message, skv_error *error)
{
    char path[SKV_PATH_SIZE];
    skv_format(path, sizeof path, "%s[%d]%s", skv_scene_list(list)->name, index, field);
    return skv_draft_fail(draft, draft->values.list[list].shapes[index].origin, path, error, code,
                          "%s", message);
}

/* Whether all of the line that an emitter is lies outside: on a side it emits. */
static bool is_outside(const skv_emitter *e, double width, double height)
{
    float speed = skv_emitter_speed(e), half = speed > 0 ? e->width / 2 / speed : 0;
    float across = half * fabsf(e->vy), up = half * fabsf(e->vx);
    return e->x + across < 0 || e->x - across > (float)width || e->y + up < 0 ||
           e->y - up > (float)height;
}

/* What is wrong with where an emitter is; null: nothing. */
static const char *complain_of_emitter(const skv_scene *scene, const skv_emitter *e, char *text,
                                       size_t size)
{
    double width = scene->width * scene->pixel_size, height = scene->height * scene->pixel_size;
    if (skv_emitter_is_wide(e, scene->def.fluid.spacing, text, size))
        return text;
    if (!is_outside(e, width, height))
        return NULL;
    skv_say_outside(width, height, text, size);
    return text;
}

static skv_result build_emitters(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    const skv_shape_list *list = &draft->values.list[SKV_LIST_EMITTERS];
    for (int i = 0; i < list->count; i++) {
        const skv_shape_values *values = &list->shapes[i];
        for (int k = SKV_EMITTER_X; k <= SKV_EMITTER_Y; k++)
            if (values->value[k].origin.source == SKV_FROM_DEFAULT)
                return fail_element(draft, SKV_LIST_EMITTERS, i, k ? ".y" : ".x", SKV_ERROR_VALUE,
                                    "is missing; an emitter needs a place", error);
        skv_emitter emitter = {
            .x = number(values, SKV_EMITTER_X),
            .y = number(values, SKV_EMITTER_Y),
            .vx = number(values, SKV_EMITTER_VX),
            .vy = number(values, SKV_EMITTER_VY),
            .width = number(values, SKV_EMITTER_WIDTH),
            .dye = (int)number(values, SKV_EMITTER_DYE),
        };
        char text[160], path[SKV_PATH_SIZE];
        skv_format(path, sizeof path, "emitters[%d].fluid", i);
        skv_result result = skv_scene_find_fluid(draft, &values->value[SKV_EMITTER_FLUID], path,
                                                 &emitter.fluid, error);
        if (result != SKV_OK)
            return result;
        const char *wrong = complain_of_emitter(scene, &emitter, text, sizeof text);
        if (wrong)
            return fail_element(draft, SKV_LIST_EMITTERS, i, "", SKV_ERROR_VALUE, wrong, error);
        if (scene->emitter_count == SKV_MAX_EMITTERS)
            return fail_element(draft, SKV_LIST_EMITTERS, i, "", SKV_ERROR_LIMIT,
                                "is one too many, with those painted; allowed are 16", error);
        scene->emitters[scene->emitter_count++] = emitter;
    }
    return SKV_OK;
}

static skv_result build_drains(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    skv_area areas[SKV_MAX_DRAINS];
    const skv_shape_list *list = &draft->values.list[SKV_LIST_DRAINS];
    skv_result result = build_areas(draft, SKV_LIST_DRAINS, scene, areas, error);
    for (int i = 0; i < list->count && result == SKV_OK; i++) {
        if (scene->drain_count == SKV_MAX_DRAINS)
            return fail_element(draft, SKV_LIST_DRAINS, i, "", SKV_ERROR_LIMIT,
                                "is one too many, with those painted; allowed are 16", error);
        scene->drains[scene->drain_count++] =
            (skv_drain){areas[i], number(&list->shapes[i], SKV_DRAIN_RATE)};
    }
    return result;
}

skv_result skv_scene_build_acting(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    skv_result result = build_forces(draft, scene, error);
    if (result == SKV_OK)
        result = build_emitters(draft, scene, error);
    return result == SKV_OK ? build_drains(draft, scene, error) : result;
}

skv_result skv_scene_set_acting(const skv_scene *scene, skv_world *world, skv_error *error)
{
    skv_result result = skv_world_set_forces(world, scene->forces, scene->force_count, error);
    if (result == SKV_OK)
        result = skv_world_set_emitters(world, scene->emitters, scene->emitter_count, error);
    return result == SKV_OK ? skv_world_set_drains(world, scene->drains, scene->drain_count, error)
                            : result;
}
