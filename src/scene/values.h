/* What a scene file says, as plain values: filled by a draft, read by build.c. */
#ifndef SKV_SCENE_VALUES_H
#define SKV_SCENE_VALUES_H

#include "scene/fields.h"

#define SKV_MAX_POINTS       1000  /* of a shape */
#define SKV_MAX_TOTAL_POINTS 10000 /* of all shapes of a list */

/* Where a value comes from; a later source overrides an earlier one. */
typedef enum skv_source {
    SKV_FROM_DEFAULT,
    SKV_FROM_FILE,
    SKV_FROM_SETTING, /* --set */
    SKV_FROM_OPTION   /* --particles */
} skv_source;

typedef struct skv_origin {
    skv_source source;
    int line; /* of the file, from 1; 0 if it has no lines */
} skv_origin;

/* One field's value. A choice's number is its index, a boolean's is 0 or 1. */
typedef struct skv_value {
    double number;
    char *text; /* null unless SKV_FIELD_TEXT and given */
    skv_origin origin;
} skv_value;

/* One element of a list. */
typedef struct skv_shape_values {
    skv_value value[SKV_MOST_FIELDS];
    double *points; /* x, y, x, y...; NaN where a coordinate is still missing */
    int point_count;
    skv_value pin[2]; /* of a body, x and y */
    skv_origin origin;
} skv_shape_values;

typedef struct skv_shape_list {
    skv_shape_values *shapes;
    int count;
    int total_points;
    bool given; /* also without an element */
} skv_shape_list;

typedef struct skv_values {
    skv_value value[SKV_F_SINGLE];
    skv_shape_list list[SKV_LISTS];
    skv_value air_pressure;
} skv_values;

#endif
