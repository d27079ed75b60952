/* The parameters of the experiments, by number. */
#ifndef SKV_EXPERIMENTS_PARAMETERS_H
#define SKV_EXPERIMENTS_PARAMETERS_H

#include "skvalp/experiments.h"
#include "skvalp/world.h"

typedef enum parameter {
    PARAM_PARTICLES,
    PARAM_SPACING,
    PARAM_SCALE,
    PARAM_GRAVITY,
    PARAM_SUBSTEPS,
    PARAM_LAW,
    PARAM_DENSITY,
    PARAM_RADIUS_RATIO,
    PARAM_VISCOSITY,
    PARAM_VISCOSITY_LINEAR,
    PARAM_VISCOSITY_QUADRATIC,
    PARAM_NEAR_STIFFNESS,
    PARAM_COHESION,
    PARAM_RELAXATION,
    PARAM_ITERATIONS,
    PARAM_WALL_FRICTION,
    PARAM_WALL_SOFTNESS,
    PARAM_CONTACT_DISTANCE,
    PARAM_POOL_WIDTH,
    PARAM_POOL_DEPTH,
    PARAM_REST_WIDTH,
    PARAM_REST_DEPTH,
    PARAM_U_ARM,
    PARAM_U_GAP,
    PARAM_U_LEVEL,
    PARAM_U_HEAD,
    PARAM_VESSELS_LEVEL,
    PARAM_VESSELS_HEAD,
    PARAM_SLOSH_WIDTH,
    PARAM_SLOSH_DEPTH,
    PARAM_SLOSH_ANGLE,
    PARAM_DAM_WIDTH,
    PARAM_ORIFICE_WIDTH,
    PARAM_ORIFICE_DEPTH,
    PARAM_ORIFICE_SLOT,
    PARAM_CHANNEL_LENGTH,
    PARAM_CHANNEL_HEIGHT,
    PARAM_CHANNEL_SPEED,
    PARAM_CHANNEL_FRICTION,
    PARAM_CHANNEL_VISCOSITY,
    PARAM_BODY_SIZE,
    PARAM_BODY_DEPTH,
    PARAM_BLOB_SIZE,
    PARAM_BLOB_SPEED,
    PARAM_BLOB_SPIN,
    PARAM_DROPLET_RADIUS,
    PARAM_DROPLET_ASPECT,
    PARAM_WHIRL_SIZE,
    PARAM_WHIRL_SPEED,
    PARAM_WHIRL_VISCOSITY,
    PARAM_COUNT
} parameter;

/* A value for every parameter. */
typedef struct settings {
    double value[PARAM_COUNT];
} settings;

/* The defaults with the options' settings applied. */
skv_result skv_settings_make(settings *s, const skv_lab_options *options, skv_error *error);

/* A length: the parameter times the scale. */
double skv_settings_length(const settings *s, parameter p);

/* The fluid that the settings describe, but for its spacing. */
skv_fluid_def skv_settings_fluid(const settings *s);

#endif
