/* The registry's inside: an identifier for every field, and what messages need from it. */
#ifndef SKV_SCENE_FIELDS_H
#define SKV_SCENE_FIELDS_H

#include "base/fields.h"
#include "skvalp/bodies.h"
#include "skvalp/scene.h"

/* The fields of a list's element, relative to the list's first: those of every shape in the same
 * order, then what only one of the lists has. */
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
    SKV_SHAPE_SHARED,
    SKV_SHAPE_THICKNESS = SKV_SHAPE_SHARED, /* solid and water */
    SKV_SOLID_CARVE,
    SKV_SOLID_FIELDS,
    SKV_WATER_VX = SKV_SHAPE_THICKNESS + 1,
    SKV_WATER_VY,
    SKV_WATER_DYE,
    SKV_WATER_FLUID,
    SKV_WATER_FIELDS,
    SKV_FORCE_BEFORE = SKV_SHAPE_SHARED - 1,
#define FORCE_NUMBER(id, ...) SKV_FORCE_##id,
#include "world/force_rows.h"
    SKV_FORCE_FIELDS,
    SKV_EMITTER_X = 0,
    SKV_EMITTER_Y,
    SKV_EMITTER_VX,
    SKV_EMITTER_VY,
    SKV_EMITTER_WIDTH,
    SKV_EMITTER_DYE,
    SKV_EMITTER_FLUID,
    SKV_EMITTER_FIELDS,
    SKV_LIQUID_NAME = 0,
    SKV_LIQUID_MATERIAL,
    SKV_LIQUID_COLOR,
#define LIQUID_NUMBER(id, ...) SKV_LIQUID_##id,
#include "world/liquid_rows.h"
    SKV_LIQUID_FIELDS,
    SKV_DRAIN_RATE = SKV_SHAPE_SHARED,
    SKV_DRAIN_FIELDS,
    SKV_BODY_NAME = SKV_SHAPE_THICKNESS + 1,
    SKV_BODY_MATERIAL,
    SKV_BODY_DENSITY,
    SKV_BODY_ANGLE,
    SKV_BODY_VX,
    SKV_BODY_VY,
    SKV_BODY_SPIN,
    SKV_BODY_FRICTION,
    SKV_BODY_RESTITUTION,
    SKV_BODY_FIXED,
    SKV_BODY_PIN,
    SKV_BODY_MOTOR_SPEED,
    SKV_BODY_MOTOR_TORQUE,
    SKV_BODY_FIELDS,
    SKV_MOST_FIELDS = SKV_BODY_FIELDS /* of any list */
};

/* Bytes of a body's name, with the zero at its end. */
enum { SKV_BODY_NAME_SIZE = 32 };

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
    SKV_F_SETTLE,
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
    SKV_F_FLUIDS = SKV_F_SINGLE,
    SKV_F_SOLID = SKV_F_FLUIDS + SKV_LIQUID_FIELDS,
    SKV_F_WATER = SKV_F_SOLID + SKV_SOLID_FIELDS,
    SKV_F_FORCES = SKV_F_WATER + SKV_WATER_FIELDS,
    SKV_F_EMITTERS = SKV_F_FORCES + SKV_FORCE_FIELDS,
    SKV_F_DRAINS = SKV_F_EMITTERS + SKV_EMITTER_FIELDS,
    SKV_F_BODIES = SKV_F_DRAINS + SKV_DRAIN_FIELDS,
    SKV_F_AIR_PRESSURE = SKV_F_BODIES + SKV_BODY_FIELDS, /* by itself, yet not among the single */
    SKV_F_COUNT
} skv_field_id;

/* A list of a scene: "water" has elements "water[]" with fields "water[].shape" and so on. */
typedef enum skv_list {
    SKV_LIST_FLUIDS,
    SKV_LIST_SOLID,
    SKV_LIST_WATER,
    SKV_LIST_FORCES,
    SKV_LIST_EMITTERS,
    SKV_LIST_DRAINS,
    SKV_LIST_BODIES,
    SKV_LISTS
} skv_list;
typedef struct skv_list_fields {
    const char *name;
    int first, count; /* fields */
    int shape;        /* so many of them, the first, describe a shape */
    int most;         /* elements */
} skv_list_fields;
const skv_list_fields *skv_scene_list(skv_list list);

/* The world's parameters among the fields: from here to SKV_F_SINGLE, in the order of their own
 * registry. */
#define SKV_F_WORLDS (SKV_F_PARTICLES + 1)

/* The number of a path's field, or -1; and what may have been meant, or is allowed there. */
int skv_scene_find_field(const char *pattern);
void skv_scene_suggest(const char *pattern, char *text, size_t size);

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
