/* Shape values to shapes.
 *
 * Invariant: a shape that comes out has everything its kind needs, nothing of another kind, and a
 * box that is not empty.
 */
#include "scene/shapes.h"

#include <math.h>
#include <string.h>

#include "scene/fluids.h"
#include "skvalp/area.h"

/* Which fields beside the shape itself a kind has, and which of them it needs. */
typedef struct kind_fields {
    const char *name;
    const char *list; /* `has` in words */
    unsigned has, needs;
} kind_fields;

#define BIT(field) (1u << (field))

static const kind_fields kinds[] = {
    [SKV_SHAPE_BOX] = {"box", "x0, y0, x1 and y1",
                       BIT(SKV_SHAPE_X0) | BIT(SKV_SHAPE_Y0) | BIT(SKV_SHAPE_X1) |
                           BIT(SKV_SHAPE_Y1),
                       0},
    [SKV_SHAPE_CIRCLE] = {"circle", "x, y and radius",
                          BIT(SKV_SHAPE_X) | BIT(SKV_SHAPE_Y) | BIT(SKV_SHAPE_RADIUS),
                          BIT(SKV_SHAPE_X) | BIT(SKV_SHAPE_Y) | BIT(SKV_SHAPE_RADIUS)},
    [SKV_SHAPE_POLYGON] = {"polygon", "points", BIT(SKV_SHAPE_POINTS), BIT(SKV_SHAPE_POINTS)},
    [SKV_SHAPE_LINE] = {"line", "points and thickness",
                        BIT(SKV_SHAPE_POINTS) | BIT(SKV_SHAPE_THICKNESS), BIT(SKV_SHAPE_POINTS)},
};

/* What a message needs to name a field of a shape. */
typedef struct context {
    const skv_draft *draft;
    const skv_shape_values *values;
    const skv_list_fields *list;
    int index;
    skv_error *error;
} context;

/* The last key of a shape's field: "radius". */
static const char *key_of(const context *c, int field)
{
    const char *path = skv_scene_fields(NULL)[c->list->first + field].path;
    return path + strlen(c->list->name) + 3; /* behind "water[]." */
}

/* Fails for one field, or for the whole shape if `field` is negative. */
static skv_result fail(const context *c, int field, const char *message)
{
    char path[SKV_PATH_SIZE];
    skv_format(path, sizeof path, "%s[%d]", c->list->name, c->index);
    if (field >= 0) {
        const char *key = key_of(c, field);
        int length = field == SKV_SHAPE_POINTS ? 6 : 20; /* "points[][]" without its indices */
        skv_format(path, sizeof path, "%s[%d].%.*s", c->list->name, c->index, length, key);
    }
    skv_origin origin = c->values->origin;
    if (field >= 0 && c->values->value[field].origin.source != SKV_FROM_DEFAULT)
        origin = c->values->value[field].origin;
    return skv_draft_fail(c->draft, origin, path, c->error, SKV_ERROR_VALUE, "%s", message);
}

/* Every field that is given belongs to the kind, and every one the kind needs is given. */
static skv_result check_fields(const context *c, const kind_fields *kind)
{
    char message[120];
    for (int i = 0; i < c->list->shape; i++) {
        bool given = c->values->value[i].origin.source != SKV_FROM_DEFAULT ||
                     (i == SKV_SHAPE_POINTS && c->values->point_count > 0);
        if (given && !((kind->has | BIT(SKV_SHAPE_KIND)) & BIT(i))) {
            skv_format(message, sizeof message, "does not belong to a %s; it has %s", kind->name,
                       kind->list);
            return fail(c, i, message);
        }
        if (!given && (kind->needs & BIT(i))) {
            skv_format(message, sizeof message, "is missing; a %s needs it", kind->name);
            return fail(c, i, message);
        }
    }
    return SKV_OK;
}

static skv_result check_points(const context *c, skv_shape_kind kind)
{
    const skv_shape_values *values = c->values;
    for (int i = 0; i < 2 * values->point_count; i++) {
        if (isnan(values->points[i]))
            return fail(c, SKV_SHAPE_POINTS, "a point lacks a value; a point is a pair [x, y]");
    }
    if (kind == SKV_SHAPE_POLYGON && values->point_count < 3)
        return fail(c, SKV_SHAPE_POINTS, "a polygon needs at least 3 points");
    if (kind == SKV_SHAPE_LINE && values->point_count < 2)
        return fail(c, SKV_SHAPE_POINTS, "a line needs at least 2 points");
    if (c->list->shape == SKV_SHAPE_SHARED && values->point_count > SKV_MAX_CORNERS)
        return fail(c, SKV_SHAPE_POINTS, "too many points; an area has at most 64");
    return SKV_OK;
}

/* Fills in the box. */
static skv_result make_box(const context *c, double width, double height, skv_shape *shape)
{
    const skv_value *value = c->values->value;
    bool has_x1 = value[SKV_SHAPE_X1].origin.source != SKV_FROM_DEFAULT;
    bool has_y1 = value[SKV_SHAPE_Y1].origin.source != SKV_FROM_DEFAULT;
    shape->x0 = value[SKV_SHAPE_X0].number;
    shape->y0 = value[SKV_SHAPE_Y0].number;
    shape->x1 = has_x1 ? value[SKV_SHAPE_X1].number : width;
    shape->y1 = has_y1 ? value[SKV_SHAPE_Y1].number : height;
    if (shape->x0 >= shape->x1)
        return fail(c, has_x1 ? SKV_SHAPE_X1 : SKV_SHAPE_X0,
                    "the box is empty; x0 must be smaller than x1");
    if (shape->y0 >= shape->y1)
        return fail(c, has_y1 ? SKV_SHAPE_Y1 : SKV_SHAPE_Y0,
                    "the box is empty; y0 must be smaller than y1");
    return SKV_OK;
}

static skv_result find_fluid(const context *c, int *number)
{
    char path[SKV_PATH_SIZE];
    skv_format(path, sizeof path, "%s[%d].fluid", c->list->name, c->index);
    return skv_scene_find_fluid(c->draft, &c->values->value[SKV_WATER_FLUID], path, number,
                                c->error);
}

void skv_say_outside(double width, double height, char *text, size_t size)
{
    char x[32], y[32];
    skv_format_number(width, x);
    skv_format_number(height, y);
    skv_format(text, size, "lies outside the world; it reaches from 0, 0 to %s, %s m", x, y);
}

static skv_result make_shape(const context *c, skv_list list, double width, double height,
                             skv_shape *shape)
{
    const skv_value *value = c->values->value;
    if (value[SKV_SHAPE_KIND].origin.source == SKV_FROM_DEFAULT && list != SKV_LIST_FORCES)
        return fail(c, SKV_SHAPE_KIND,
                    list == SKV_LIST_DRAINS
                        ? "is missing; allowed is box, circle or polygon"
                        : "is missing; allowed is box, circle, polygon or line");
    skv_shape_kind kind = (skv_shape_kind)value[SKV_SHAPE_KIND].number;
    bool solid = list == SKV_LIST_SOLID, water = list == SKV_LIST_WATER;
    skv_result result = check_fields(c, &kinds[kind]);
    if (result == SKV_OK)
        result = check_points(c, kind);
    if (result != SKV_OK)
        return result;
    *shape = (skv_shape){
        .kind = kind,
        .x = value[SKV_SHAPE_X].number,
        .y = value[SKV_SHAPE_Y].number,
        .radius = kind == SKV_SHAPE_LINE ? 0.5 * value[SKV_SHAPE_THICKNESS].number
                                         : value[SKV_SHAPE_RADIUS].number,
        .points = c->values->points,
        .point_count = c->values->point_count,
        .carve = solid && value[SKV_SOLID_CARVE].number != 0.0,
        .vx = water ? value[SKV_WATER_VX].number : 0.0,
        .vy = water ? value[SKV_WATER_VY].number : 0.0,
        .dye = water ? (int)value[SKV_WATER_DYE].number : 0,
    };
    if (water)
        result = find_fluid(c, &shape->fluid);
    if (result != SKV_OK)
        return result;
    if (kind == SKV_SHAPE_BOX)
        result = make_box(c, width, height, shape);
    else
        skv_shape_set_bounds(shape);
    if (result != SKV_OK)
        return result;
    if (!solid &&
        (shape->x1 <= 0.0 || shape->y1 <= 0.0 || shape->x0 >= width || shape->y0 >= height)) {
        char message[160];
        skv_say_outside(width, height, message, sizeof message);
        return fail(c, -1, message);
    }
    return SKV_OK;
}

skv_result skv_shapes_make(const skv_draft *draft, skv_list list, double width, double height,
                           skv_shape *shapes, skv_error *error)
{
    const skv_shape_list *values = &draft->values.list[list];
    for (int i = 0; i < values->count; i++) {
        context c = {.draft = draft,
                     .values = &values->shapes[i],
                     .list = skv_scene_list(list),
                     .index = i,
                     .error = error};
        skv_result result = make_shape(&c, list, width, height, &shapes[i]);
        if (result != SKV_OK)
            return result;
    }
    return SKV_OK;
}
