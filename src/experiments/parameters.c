/* The registry of the experiments' parameters, and reading settings by it.
 *
 * Invariant: the table alone knows paths, units, ranges and defaults; messages, help and
 * documentation all come from it.
 */
#include "experiments/parameters.h"

#include "base/assert.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OPTIONS_COOKIE = 0x6c616f31 };

#define G 9.81

static const skv_lab_parameter parameters[PARAM_COUNT] = {
    [PARAM_PARTICLES] = {"particles", "", 200, 200000, 4000, NULL, true,
                         "wanted number of particles; the spacing follows from it"},
    [PARAM_SPACING] = {"spacing", "m", 0, 0.1, 0, NULL, false,
                       "distance of the particles; 0: from their number"},
    [PARAM_SCALE] = {"scale", "", 0.2, 4, 1, NULL, false,
                     "multiplies every length of every set-up"},
    [PARAM_GRAVITY] = {"gravity", "m/s^2", 0.5, 100, G, NULL, false, "acceleration of gravity"},
    [PARAM_SUBSTEPS] = {"substeps", "", 0, 1000, 0, NULL, true,
                        "substeps a frame of 1/60 s; 0: by the rule of docs/model.md"},
    [PARAM_LAW] = {"fluid.law", "", 0, 1, SKV_LAW_CALIBRATED, "calibrated|clavet", true,
                   "pressure law"},
    [PARAM_DENSITY] = {"fluid.density", "kg/m^2", 1, 20000, 1000, NULL, false,
                       "density of the sheet"},
    [PARAM_RADIUS_RATIO] = {"fluid.radius_ratio", "", 0, 4, 0, NULL, false,
                            "smoothing radius in spacings, 2..4; 0: the law's own"},
    [PARAM_VISCOSITY] = {"fluid.viscosity", "m^2/s", 0, 0.05, 0, NULL, false,
                         "kinematic viscosity, on top of the method's own"},
    [PARAM_VISCOSITY_LINEAR] = {"fluid.viscosity_linear", "1/s", 0, 1000, 0, NULL, false,
                                "sigma: removes a pair's approach speed"},
    [PARAM_VISCOSITY_QUADRATIC] = {"fluid.viscosity_quadratic", "1/m", 0, 1000, 0, NULL, false,
                                   "beta: the same, growing with the speed"},
    [PARAM_NEAR_STIFFNESS] = {"fluid.near_stiffness", "m/s^2", 0, 200, 10 * G, NULL, false,
                              "k_near of the calibrated law"},
    [PARAM_COHESION] = {"fluid.cohesion", "m/s^2", 0, 500, 8 * G, NULL, false,
                        "k_coh of the calibrated law"},
    [PARAM_RELAXATION] = {"fluid.relaxation", "", 0.05, 0.4, 0.35, NULL, false,
                          "share of a correction that is applied"},
    [PARAM_ITERATIONS] = {"fluid.iterations", "", 0, 8, 0, NULL, true,
                          "relaxation rounds a substep, 1..8; 0: the law's own"},
    [PARAM_WALL_FRICTION] = {"fluid.wall_friction", "", 0, 1, 0.05, NULL, false,
                             "share of the speed along a wall lost in 1/60 s"},
    [PARAM_WALL_SOFTNESS] = {"fluid.wall_softness", "", 0.1, 1, 1, NULL, false,
                             "share of the penetration of a wall corrected in 1/60 s"},
    [PARAM_CONTACT_DISTANCE] = {"fluid.contact_distance", "", 0, 1, 0.2, NULL, false,
                                "closer than this to a wall is contact, in spacings"},
    [PARAM_POOL_WIDTH] = {"hydrostatics.width", "m", 0.2, 4, 1, NULL, false, "width of the pool"},
    [PARAM_POOL_DEPTH] = {"hydrostatics.depth", "m", 0.1, 2, 0.5, NULL, false, "depth of the pool"},
    [PARAM_REST_WIDTH] = {"rest.width", "m", 0.2, 4, 1, NULL, false, "width of the pool"},
    [PARAM_REST_DEPTH] = {"rest.depth", "m", 0.1, 2, 0.5, NULL, false, "depth of the pool"},
    [PARAM_U_ARM] = {"u-tube.arm", "m", 0.03, 0.4, 0.12, NULL, false,
                     "width of the arms and height of the bend"},
    [PARAM_U_GAP] = {"u-tube.gap", "m", 0.1, 3, 0.6, NULL, false,
                     "distance between the arms' centre lines"},
    [PARAM_U_LEVEL] = {"u-tube.level", "m", 0.1, 3, 0.6, NULL, false,
                       "level in both arms at rest, above the floor"},
    [PARAM_U_HEAD] = {"u-tube.head", "m", 0.02, 1, 0.3, NULL, false,
                      "difference of the levels at the start"},
    [PARAM_VESSELS_LEVEL] = {"vessels.level", "m", 0.2, 2, 0.45, NULL, false,
                             "mean level of the three vessels"},
    [PARAM_VESSELS_HEAD] = {"vessels.head", "m", 0.02, 1, 0.2, NULL, false,
                            "difference between the highest and the lowest level at the start"},
    [PARAM_SLOSH_WIDTH] = {"slosh.width", "m", 0.2, 4, 1.6, NULL, false, "width of the tank"},
    [PARAM_SLOSH_DEPTH] = {"slosh.depth", "m", 0.05, 2, 0.4, NULL, false, "depth at rest"},
    [PARAM_SLOSH_ANGLE] = {"slosh.angle", "rad", 0.02, 0.4, 0.15, NULL, false,
                           "slope of the surface at the start"},
    [PARAM_DAM_WIDTH] = {"dam-break.width", "m", 0.05, 1, 0.3, NULL, false,
                         "width of the column; it is twice as high"},
    [PARAM_ORIFICE_WIDTH] = {"orifice.width", "m", 0.2, 3, 1, NULL, false, "width of the tank"},
    [PARAM_ORIFICE_DEPTH] = {"orifice.depth", "m", 0.2, 2, 0.8, NULL, false,
                             "depth of the water at the start"},
    [PARAM_ORIFICE_SLOT] = {"orifice.slot", "m", 0.02, 0.4, 0.1, NULL, false, "height of the slot"},
    [PARAM_CHANNEL_LENGTH] = {"channel.length", "m", 0.4, 4, 1.2, NULL, false,
                              "length of the channel under the block"},
    [PARAM_CHANNEL_HEIGHT] = {"channel.height", "m", 0.04, 0.6, 0.2, NULL, false,
                              "height of the channel"},
    [PARAM_CHANNEL_SPEED] = {"channel.speed", "m/s", 0.02, 10, 3, NULL, false,
                             "speed to which the pump drags the water above the block"},
    [PARAM_CHANNEL_FRICTION] = {"channel.friction", "", 0, 1, 1, NULL, false,
                                "share of the speed along a wall lost in 1/60 s"},
    [PARAM_CHANNEL_VISCOSITY] = {"channel.viscosity", "1/s", 0, 1000, 150, NULL, false,
                                 "linear viscosity sigma of the fluid in the channel"},
    [PARAM_BODY_SIZE] = {"archimedes.size", "m", 0.05, 1, 0.2, NULL, false,
                         "side of the square body"},
    [PARAM_BODY_DEPTH] = {"archimedes.depth", "m", 0.05, 1, 0.2, NULL, false,
                          "depth of its upper side below the surface"},
    [PARAM_BLOB_SIZE] = {"momentum.size", "m", 0.05, 2, 0.5, NULL, false,
                         "side of the square blob"},
    [PARAM_BLOB_SPEED] = {"momentum.speed", "m/s", 0.001, 1, 0.3, NULL, false,
                          "speed with which it drifts"},
    [PARAM_BLOB_SPIN] = {"momentum.spin", "1/s", 0, 5, 0.5, NULL, false, "its angular velocity"},
    [PARAM_DROPLET_RADIUS] = {"droplet.radius", "m", 0.05, 1, 0.25, NULL, false,
                              "radius of the circle of the same area"},
    [PARAM_DROPLET_ASPECT] = {"droplet.aspect", "", 1, 3, 1.5, NULL, false,
                              "length over width at the start"},
    [PARAM_WHIRL_SIZE] = {"viscosity.size", "m", 0.1, 4, 0.8, NULL, false, "side of the box"},
    [PARAM_WHIRL_SPEED] = {"viscosity.speed", "m/s", 0.02, 2, 0.3, NULL, false,
                           "highest speed at the start"},
    [PARAM_WHIRL_VISCOSITY] = {"viscosity.nominal", "m^2/s", 0, 0.05, 0.02, NULL, false,
                               "kinematic viscosity that the fluid is given"},
};

const skv_lab_parameter *skv_lab_parameters(int *count)
{
    SKV_ASSERT_OR(count, NULL);
    *count = PARAM_COUNT;
    return parameters;
}

skv_lab_options skv_default_lab_options(void)
{
    return (skv_lab_options){.cookie = OPTIONS_COOKIE};
}

static int find(const char *path)
{
    for (int i = 0; i < PARAM_COUNT; i++) {
        if (strcmp(parameters[i].path, path) == 0)
            return i;
    }
    return -1;
}

/* The number of `text` among the words of `choices`, or -1. */
static int find_choice(const char *choices, const char *text)
{
    size_t length = strlen(text);
    for (int i = 0; *choices; i++) {
        size_t word = strcspn(choices, "|");
        if (word == length && strncmp(choices, text, word) == 0)
            return i;
        choices += word;
        choices += *choices == '|';
    }
    return -1;
}

static skv_result refuse(const skv_lab_parameter *p, const char *text, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE, "%s: '%.60s' is no %snumber in %.10g to %.10g%s%s",
                    p->path, text, p->whole ? "whole " : "", p->minimum, p->maximum,
                    *p->unit ? " " : "", p->unit);
}

static skv_result apply(settings *s, const skv_lab_setting *setting, skv_error *error)
{
    if (!setting->path || !setting->value)
        return skv_fail(error, SKV_ERROR_VALUE, "setting: a path and a value are needed");
    int found = find(setting->path);
    if (found < 0)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%.60s: the lab has no such parameter; see 'skvalp lab --help'",
                        setting->path);
    const skv_lab_parameter *p = &parameters[found];
    if (p->choices) {
        int choice = find_choice(p->choices, setting->value);
        if (choice < 0)
            return skv_fail(error, SKV_ERROR_VALUE, "%s: '%.60s' is none of %s", p->path,
                            setting->value, p->choices);
        s->value[found] = choice;
        return SKV_OK;
    }
    /* strtod alone would take "nan", "0x1p3" and leading spaces. */
    const char *text = setting->value;
    char *end = NULL;
    double value = (double)NAN;
    if (*text && text[strspn(text, "+-.0123456789eE")] == '\0')
        value = strtod(text, &end);
    if (!end || end == text || *end || !(value >= p->minimum && value <= p->maximum) ||
        (p->whole && value != floor(value)))
        return refuse(p, text, error);
    s->value[found] = value;
    return SKV_OK;
}

skv_result skv_settings_make(settings *s, const skv_lab_options *options, skv_error *error)
{
    for (int i = 0; i < PARAM_COUNT; i++)
        s->value[i] = parameters[i].value;
    if (!options)
        return SKV_OK;
    if (options->cookie != OPTIONS_COOKIE)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "lab: options not initialised; start from skv_default_lab_options()");
    for (int i = 0; i < options->setting_count; i++) {
        skv_result result = apply(s, &options->settings[i], error);
        if (result != SKV_OK)
            return result;
    }
    return SKV_OK;
}

skv_result skv_lab_check(const skv_lab_options *options, skv_error *error)
{
    settings s;
    return skv_settings_make(&s, options, error);
}

double skv_settings_length(const settings *s, parameter p)
{
    return s->value[p] * s->value[PARAM_SCALE];
}

skv_fluid_def skv_settings_fluid(const settings *s)
{
    const double *v = s->value;
    skv_fluid_def fluid = skv_default_fluid_def((skv_law)v[PARAM_LAW]);
    fluid.density = (float)v[PARAM_DENSITY];
    fluid.viscosity = (float)v[PARAM_VISCOSITY];
    fluid.viscosity_linear = (float)v[PARAM_VISCOSITY_LINEAR];
    fluid.viscosity_quadratic = (float)v[PARAM_VISCOSITY_QUADRATIC];
    fluid.near_stiffness = (float)v[PARAM_NEAR_STIFFNESS];
    fluid.cohesion = (float)v[PARAM_COHESION];
    fluid.relaxation = (float)v[PARAM_RELAXATION];
    fluid.wall_friction = (float)v[PARAM_WALL_FRICTION];
    fluid.wall_softness = (float)v[PARAM_WALL_SOFTNESS];
    fluid.contact_distance = (float)v[PARAM_CONTACT_DISTANCE];
    if (v[PARAM_RADIUS_RATIO] > 0)
        fluid.radius_ratio = (float)v[PARAM_RADIUS_RATIO];
    if (v[PARAM_ITERATIONS] > 0)
        fluid.iterations = (int)v[PARAM_ITERATIONS];
    return fluid;
}
