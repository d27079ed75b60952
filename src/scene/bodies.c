/* The bodies of a scene. Invariant: a body that comes out may be a world's of the scene's spacing.
 */
#include "scene/bodies.h"

#include "base/exact.h"
#include "base/memory.h"
#include "scene/painted_bodies.h"
#include "scene/shapes.h"
#include "world/bodies/bodies.h"
#include "world/bodies/shape.h"

#include <string.h>

/* kg/m^2 of the sheet, in the order of the registry's choices: cork, pine and ice at 0 C, brick and
 * steel as tables have them. */
static const float densities[] = {240, 500, 917, 1900, SKV_STEEL};

typedef struct builder {
    const skv_draft *draft;
    const skv_shape_values *values;
    int index;
    skv_error *error;
} builder;

static const skv_value *value_of(const builder *b, int field)
{
    return &b->values->value[field];
}

static bool is_given(const builder *b, int field)
{
    return value_of(b, field)->origin.source != SKV_FROM_DEFAULT;
}

static float number_of(const builder *b, int field)
{
    return (float)value_of(b, field)->number;
}

/* Fails for one of a body's fields, or for the whole of it. */
static skv_result fail(const builder *b, const char *field, const char *message)
{
    char path[SKV_PATH_SIZE];
    skv_format(path, sizeof path, "bodies[%d]%s", b->index, field);
    return skv_draft_fail(b->draft, b->values->origin, path, b->error, SKV_ERROR_VALUE, "%s",
                          message);
}

static skv_result make_area(const builder *b, const skv_shape *shape, skv_area *area)
{
    float corners[2 * SKV_MAX_CORNERS];
    const double *p = shape->points;
    switch (shape->kind) {
    case SKV_SHAPE_BOX:
        *area = skv_box((float)shape->x0, (float)shape->y0, (float)shape->x1, (float)shape->y1);
        break;
    case SKV_SHAPE_CIRCLE:
        *area = skv_circle((float)shape->x, (float)shape->y, (float)shape->radius);
        break;
    case SKV_SHAPE_LINE:
        if (shape->point_count != 2)
            return fail(b, ".points", "a body's line has 2 points; draw others as a polygon");
        *area = skv_swept_circle((float)p[0], (float)p[1], (float)p[2], (float)p[3],
                                 (float)shape->radius);
        break;
    case SKV_SHAPE_POLYGON:
        if (shape->point_count > SKV_MAX_CORNERS)
            return fail(b, ".points", "too many points; a body has at most 64");
        for (int i = 0; i < 2 * shape->point_count; i++)
            corners[i] = (float)p[i];
        *area = skv_polygon(corners, shape->point_count);
        break;
    }
    return SKV_OK;
}

static skv_result set_pin(const builder *b, skv_scene_body *body)
{
    skv_body_def *def = &body->def;
    const skv_value *pin = b->values->pin;
    bool x = pin[0].origin.source != SKV_FROM_DEFAULT, y = pin[1].origin.source != SKV_FROM_DEFAULT;
    if (x != y)
        return fail(b, ".pin", "lacks a value; a pin is a pair [x, y]");
    def->pinned = x;
    def->pin_x = (float)pin[0].number;
    def->pin_y = (float)pin[1].number;
    def->motor_speed = number_of(b, SKV_BODY_MOTOR_SPEED);
    def->motor_torque = number_of(b, SKV_BODY_MOTOR_TORQUE);
    if (is_given(b, SKV_BODY_MOTOR_SPEED) && !is_given(b, SKV_BODY_MOTOR_TORQUE))
        return fail(b, ".motor", "lacks its torque; a motor has speed and torque");
    if (def->motor_torque > 0 && (!def->pinned || def->fixed))
        return fail(b, ".motor", "turns nothing; it takes a pin, and a body that is not fixed");
    return SKV_OK;
}

static skv_result make_body(const builder *b, const skv_scene *scene, const skv_shape *shape,
                            skv_scene_body *body)
{
    skv_body_def *def = &body->def;
    *def = skv_default_body_def();
    skv_result result = make_area(b, shape, &def->shape);
    if (result != SKV_OK)
        return result;
    def->density = densities[(int)value_of(b, SKV_BODY_MATERIAL)->number];
    if (is_given(b, SKV_BODY_DENSITY))
        def->density = number_of(b, SKV_BODY_DENSITY);
    body->angle = number_of(b, SKV_BODY_ANGLE);
    def->vx = number_of(b, SKV_BODY_VX);
    def->vy = number_of(b, SKV_BODY_VY);
    def->spin = number_of(b, SKV_BODY_SPIN);
    def->friction = number_of(b, SKV_BODY_FRICTION);
    def->restitution = number_of(b, SKV_BODY_RESTITUTION);
    def->fixed = value_of(b, SKV_BODY_FIXED)->number != 0;
    const char *name = value_of(b, SKV_BODY_NAME)->text;
    if (name)
        memcpy(body->name, name, strlen(name));
    else
        skv_format(body->name, sizeof body->name, "body %d", b->index + 1);
    result = set_pin(b, body);
    if (result != SKV_OK)
        return result;
    skv_outline outline;
    skv_error cause;
    if (skv_outline_make(&def->shape, scene->def.fluid.spacing, &outline, &cause) != SKV_OK)
        return fail(b, "", cause.text + strlen("body: "));
    return SKV_OK;
}

/* Where a scene file names the picture, the scene and the line come first. */
static skv_result find_painted(const skv_draft *draft, skv_scene *scene, const char *picture,
                               skv_error *error)
{
    skv_error cause;
    skv_origin origin = draft->values.value[SKV_F_WORLD_PICTURE].origin;
    skv_result result = skv_scene_find_bodies(scene, picture, &cause);
    if (result == SKV_OK)
        return SKV_OK;
    if (origin.source == SKV_FROM_DEFAULT)
        return skv_fail(error, result, "%s", cause.text);
    return skv_draft_fail(draft, origin, "world.picture", error, result, "%s", cause.text);
}

/* ---- In the fluid ---------------------------------------------------------------------------- */

bool skv_water_is_covered(const skv_water *water, float x, float y)
{
    for (int i = 0; i < water->cover_count; i++)
        if (skv_shape_contains(&water->covers[i], (double)x, (double)y))
            return true;
    return false;
}

/* What a body covers in the scene, in room for the points of its polygon. */
static skv_shape cover_of(const skv_scene_body *body, float spacing, double *points)
{
    skv_outline outline;
    skv_outline_make(&body->def.shape, spacing, &outline, NULL); /* it has gone well before */
    double c = skv_cos((double)body->angle), s = skv_sin((double)body->angle);
    double x = body->def.pinned ? (double)body->def.pin_x : outline.middle_x;
    double y = body->def.pinned ? (double)body->def.pin_y : outline.middle_y;
    for (int i = 0; i < outline.corners; i++) {
        double dx = outline.corner[i][0] + outline.middle_x - x;
        double dy = outline.corner[i][1] + outline.middle_y - y;
        points[2 * i] = x + c * dx - s * dy;
        points[2 * i + 1] = y + s * dx + c * dy;
    }
    skv_shape shape = {.kind = SKV_SHAPE_POLYGON, .points = points, .point_count = outline.corners};
    skv_shape_set_bounds(&shape);
    return shape;
}

/* Notes which bodies lie where fluid may be. */
static skv_result cover_water(skv_scene *scene, skv_error *error)
{
    enum { NUMBERS = 2 * SKV_MAX_CORNERS };
    skv_water *w = &scene->water;
    if (scene->body_count == 0)
        return SKV_OK;
    w->covers = skv_calloc((size_t)scene->body_count, sizeof *w->covers + NUMBERS * sizeof(double));
    if (!w->covers)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the bodies");
    double *points = (double *)(w->covers + scene->body_count);
    for (int i = 0; i < scene->body_count; i++, points += NUMBERS) {
        skv_shape cover = cover_of(&scene->bodies[i], scene->def.fluid.spacing, points);
        if (cover.x0 < (double)w->x1 && cover.x1 > (double)w->x0 && cover.y0 < (double)w->y1 &&
            cover.y1 > (double)w->y0)
            w->covers[w->cover_count++] = cover;
    }
    return SKV_OK;
}

/* ---- All of them ----------------------------------------------------------------------------- */

skv_result skv_scene_build_bodies(const skv_draft *draft, const char *picture, skv_scene *scene,
                                  skv_error *error)
{
    const skv_shape_list *list = &draft->values.list[SKV_LIST_BODIES];
    bool painted = scene->marked[SKV_PAINT_BODY] > 0;
    if (list->count == 0 && !painted)
        return SKV_OK;
    /* An element more, for none is no failure. */
    skv_shape *shapes = skv_calloc((size_t)list->count + 1, sizeof *shapes);
    scene->bodies =
        skv_calloc((size_t)(painted ? SKV_MAX_BODIES : list->count), sizeof *scene->bodies);
    if (!shapes || !scene->bodies) {
        skv_free(shapes);
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", draft->label);
    }
    skv_result result = skv_shapes_make(draft, SKV_LIST_BODIES, scene->width * scene->pixel_size,
                                        scene->height * scene->pixel_size, shapes, error);
    for (int i = 0; i < list->count && result == SKV_OK; i++) {
        const builder b = {draft, &list->shapes[i], i, error};
        result = make_body(&b, scene, &shapes[i], &scene->bodies[i]);
        scene->body_count = i + 1;
    }
    skv_free(shapes);
    if (result == SKV_OK && painted)
        result = find_painted(draft, scene, picture, error);
    return result == SKV_OK ? cover_water(scene, error) : result;
}

/* ---- In a world ------------------------------------------------------------------------------ */

static void turn_about_pin(skv_body_def *def, float angle)
{
    double c = skv_cos((double)angle), s = skv_sin((double)angle);
    double x = (double)def->pin_x, y = (double)def->pin_y;
    def->angle = angle;
    def->x = (float)(x - (c * x - s * y));
    def->y = (float)(y - (s * x + c * y));
}

skv_result skv_scene_add_bodies(const skv_scene *scene, skv_world *world, skv_error *error)
{
    skv_result result = SKV_OK;
    for (int i = 0; i < scene->body_count && result == SKV_OK; i++) {
        const skv_scene_body *wanted = &scene->bodies[i];
        skv_body_def def = wanted->def;
        skv_body_id id;
        skv_body body;
        if (def.pinned)
            turn_about_pin(&def, wanted->angle);
        result = skv_world_add_body(world, &def, &id, NULL, error);
        /* Turned about its own middle. */
        if (result == SKV_OK && !def.pinned && wanted->angle != 0 &&
            skv_world_body(world, id, &body))
            result = skv_world_set_body_pose(world, id, body.x, body.y, wanted->angle, error);
    }
    return result;
}
