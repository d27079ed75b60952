/* The registry's inside: an identifier for every field, and what messages need from it. */
#ifndef SKV_SCENE_FIELDS_H
#define SKV_SCENE_FIELDS_H

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

/* Index of a field in the array of skv_scene_fields. */
typedef enum skv_field_id {
    SKV_F_NAME,
    SKV_F_TITLE,
    SKV_F_DESCRIPTION,
    SKV_F_SECONDS,
    SKV_F_PARTICLES,
    SKV_F_SUBSTEPS,
    SKV_F_SLEEP,
    SKV_F_DEPTH,
    SKV_F_WORLD_WIDTH,
    SKV_F_WORLD_HEIGHT,
    SKV_F_WORLD_PIXEL,
    SKV_F_WORLD_PICTURE,
    SKV_F_OPEN_LEFT,
    SKV_F_OPEN_RIGHT,
    SKV_F_OPEN_BOTTOM,
    SKV_F_OPEN_TOP,
    SKV_F_GRAVITY_X,
    SKV_F_GRAVITY_Y,
    SKV_F_FLUID_LAW,
    SKV_F_FLUID_MATERIAL,
    SKV_F_FLUID_SPACING,
    SKV_F_FLUID_RADIUS_RATIO,
    SKV_F_FLUID_DENSITY,
    SKV_F_FLUID_VISCOSITY,
    SKV_F_FLUID_VISCOSITY_LINEAR,
    SKV_F_FLUID_VISCOSITY_QUADRATIC,
    SKV_F_FLUID_NEAR_STIFFNESS,
    SKV_F_FLUID_COHESION,
    SKV_F_FLUID_RELAXATION,
    SKV_F_FLUID_ITERATIONS,
    SKV_F_FLUID_CLAVET_STIFFNESS,
    SKV_F_FLUID_CLAVET_NEAR_STIFFNESS,
    SKV_F_FLUID_CLAVET_REST_DENSITY,
    SKV_F_FLUID_WALL_FRICTION,
    SKV_F_FLUID_WALL_SOFTNESS,
    SKV_F_FLUID_CONTACT_DISTANCE,
    SKV_F_SINGLE, /* so many fields are no list's */
    SKV_F_SOLID = SKV_F_SINGLE,
    SKV_F_WATER = SKV_F_SOLID + SKV_SHAPE_CARVE + 1,
    SKV_F_COUNT = SKV_F_WATER + SKV_SHAPE_VY + 1
} skv_field_id;

/* Room for any path, indices included. */
#define SKV_PATH_SIZE 128

/* A path with its indices taken out: "water[2].points[0][1]" is the pattern "water[].points[][]"
 * with the indices 2, 0, 1. */
typedef struct skv_field_path {
    char pattern[SKV_PATH_SIZE];
    int index[3];
    int index_count;
} skv_field_path;

/* False if the text is not a path at all: too long, too many or too large indices. */
bool skv_field_parse_path(const char *text, skv_field_path *path);

/* The field of a pattern, or -1. */
int skv_field_find(const char *pattern);

/* Whether fields or list elements lie below a pattern, so that an object ("fluid", "water[]") or a
 * list ("water") is expected there. The pattern "" is the whole file. */
bool skv_field_is_object(const char *pattern);
bool skv_field_is_list(const char *pattern);

/* What belongs to an unknown path: "; did you mean fluid.spacing?", or the names allowed there. */
void skv_field_suggest(const char *pattern, char *text, size_t size);

/* What a field allows: "allowed is a number from 0.0005 to 0.1 m". */
void skv_field_allowed(const skv_field *field, char *text, size_t size);

/* The index of a choice in "a|b|c", or -1. */
int skv_field_choice(const char *choices, const char *text);

/* A number as a scene file writes it, whatever the locale; at most 32 bytes. */
void skv_format_number(double value, char text[32]);

/* Reads all of `text` as a finite decimal number, whatever the locale. */
bool skv_parse_number(const char *text, double *value);

#endif
