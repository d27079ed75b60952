/* The registry of a world's parameters, by number; shared with the scene layer, whose files set the
 * same parameters. */
#ifndef SKV_WORLD_PARAMETERS_H
#define SKV_WORLD_PARAMETERS_H

#include "skvalp/parameters.h"

/* Index of a row, as in skv_world_field. */
typedef enum skv_parameter {
#define NUMBER(id, ...) SKV_P_##id,
#define WHOLE(id, ...)  SKV_P_##id,
#define FLAG(id, ...)   SKV_P_##id,
#define CHOICE(id, ...) SKV_P_##id,
#define PRESET(id, ...) SKV_P_##id,
#include "world/parameter_rows.h"
    SKV_P_COUNT
} skv_parameter;

/* Stores a value that the field of a skv_parameter allows. A law gives its own default to what has
 * the other law's; a material sets density and viscosity. */
void skv_parameter_store(skv_world_def *def, int parameter, double number);

/* The value of a parameter; of the material: that of this density and viscosity, or -1. */
double skv_parameter_load(const skv_world_def *def, int parameter);

/* What a running world is like, as its definition would have it, its terrain apart. */
skv_world_def skv_world_describe(const skv_world *world);

/* The whole of a definition that a host hands in, which may know less of it: itself, or `own`. Null
 * if it, or its fluid, was not initialised. */
const skv_world_def *skv_open_world_def(const skv_world_def *def, skv_world_def *own);

/* Every parameter lies in its range; SKV_ERROR_VALUE names the first that does not. */
skv_result skv_check_world_def(const skv_world_def *def, skv_error *error);

#endif
