/* The parameters of the experiments, and the settings that change them. */
#ifndef SKV_EXPERIMENTS_PARAMETERS_H
#define SKV_EXPERIMENTS_PARAMETERS_H

#include "skvalp/experiments.h"

enum { MAX_OWN = 8, MAX_FLUID_SETTINGS = 64 };

/* What concerns every experiment. */
typedef enum common_parameter {
    PARAM_PARTICLES,
    PARAM_SCALE,
    PARAM_GRAVITY,
    COMMON_PARAMETERS
} common_parameter;

typedef struct experiment experiment;
typedef struct findings findings;

/* The settings for one experiment. */
typedef struct settings {
    double common[COMMON_PARAMETERS];
    double own[MAX_OWN]; /* of the experiment, in the order of its table */
    /* What a scene knows better: the fluid and the substeps, as they were given. */
    skv_setting fluid[MAX_FLUID_SETTINGS];
    int fluid_count;
    double spacing; /* of them, fluid.spacing; 0: it follows from the number of particles */
} settings;

/* The whole of options that a host hands in, which may know less of them: themselves, or `own`; the
 * defaults for null. Null for some that were not initialised. */
const skv_lab_options *skv_open_lab_options(const skv_lab_options *options, skv_lab_options *own);

/* The defaults with the options' settings applied; `e` null: just checks them. The texts stay the
 * options'. */
skv_result skv_settings_make(settings *s, const experiment *e, const skv_lab_options *options,
                             skv_error *error);

#endif
