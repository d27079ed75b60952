/* The registry's inside: an identifier for every field, and what messages need from it. */
#ifndef SKV_SCENE_FIELDS_H
#define SKV_SCENE_FIELDS_H

#include "base/fields.h"
#include "skvalp/scene.h"

/* One shape of a list, relative to SKV_F_SOLID or SKV_F_WATER: the same fields in the same order,
 * then what only one of the lists has. */
enum {
    SKV_SHAPE_KIND,
    SKV_SHAPE_X0,
    SKV_SHAPE_Y0,
    SKV_SHAPE_X1,
    SKV_SHAPE_Y1,
    SKV_SHAPE_X,
    SKV_SHAPE_Y,
    SKV_SHAPE_RADIUS,
    SKV_SHAPE_POINTS,
    SKV_SHAPE_THICKNESS,
    SKV_SHAPE_SHARED,
    SKV_SHAPE_CARVE = SKV_SHAPE_SHARED, /* solid only */
    SKV_SHAPE_VX = SKV_SHAPE_SHARED,    /* water only, like the next */
    SKV_SHAPE_VY,
    SKV_SHAPE_FIELDS
};

/* Index of a field in skv_scene_field. Those of the world's parameters are SKV_F_ and
 * the row's name. */
typedef enum skv_field_id {
    SKV_F_NAME,
    SKV_F_TITLE,
    SKV_F_DESCRIPTION,
    SKV_F_SECONDS,
    SKV_F_WORLD_WIDTH,
    SKV_F_WORLD_HEIGHT,
    SKV_F_WORLD_PIXEL,
    SKV_F_WORLD_PICTURE,
    SKV_F_OPEN_LEFT,
    SKV_F_OPEN_RIGHT,
    SKV_F_OPEN_BOTTOM,
    SKV_F_OPEN_TOP,
    SKV_F_PARTICLES,
#define NUMBER(id, ...) SKV_F_##id,
#define WHOLE(id, ...)  SKV_F_##id,
#define FLAG(id, ...)   SKV_F_##id,
#define CHOICE(id, ...) SKV_F_##id,
#define PRESET(id, ...) SKV_F_##id,
#define HOST_WHOLE(...)
#define HOST_CHOICE(...)
#include "world/parameter_rows.h"
    SKV_F_SINGLE, /* so many fields are no list's */
    SKV_F_SOLID = SKV_F_SINGLE,
    SKV_F_WATER = SKV_F_SOLID + SKV_SHAPE_CARVE + 1,
    SKV_F_COUNT = SKV_F_WATER + SKV_SHAPE_VY + 1
} skv_field_id;

/* The world's parameters among the fields: from here to SKV_F_SINGLE, in the order of their own
 * registry. */
#define SKV_F_WORLDS (SKV_F_PARTICLES + 1)

/* All of skv_scene_field as an array of SKV_F_COUNT; writes their number if wanted. */
const skv_field *skv_scene_fields(int *count);

/* A path with its indices taken out: "water[2].points[0][1]" is the pattern "water[].points[][]"
 * with the indices 2, 0, 1. */
typedef struct skv_field_path {
    char pattern[SKV_PATH_SIZE];
    int index[3];
    int index_count;
} skv_field_path;

/* False if the text is not a path at all: too long, too many or too large indices. */
bool skv_field_parse_path(const char *text, skv_field_path *path);

/* Whether fields or list elements lie below a pattern, so that an object ("fluid", "water[]") or a
 * list ("water") is expected there. The pattern "" is the whole file. */
bool skv_field_is_object(const char *pattern);
bool skv_field_is_list(const char *pattern);

#endif
