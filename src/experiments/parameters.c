/* The experiments' parameters: their own tables, and the fluid's fields as scenes have them.
 *
 * Invariant: paths, units, ranges and defaults stand in an experiment's file, in the table of
 * common ones below, or in the registry of scenes; messages, help and documentation come from
 * there.
 */
#include "experiments/parameters.h"

#include "base/assert.h"
#include "base/defs.h"
#include "base/fields.h"
#include "experiments/experiment.h"

#include <string.h>

enum { OPTIONS_COOKIE = 0x4c41 };

static const skv_field common[COMMON_PARAMETERS] = {
    [PARAM_PARTICLES] = {"particles", SKV_FIELD_INTEGER, "", 200, 200000, NULL, "4000",
                         "wanted number of particles; the spacing follows from it"},
    [PARAM_SCALE] = {"scale", SKV_FIELD_NUMBER, "", 0.2, 4, NULL, "1",
                     "multiplies every length of every set-up"},
    [PARAM_GRAVITY] = {"gravity", SKV_FIELD_NUMBER, "m/s^2", 0.5, 100, NULL, "9.81",
                       "acceleration of gravity"},
};

/* Whether a scene's field concerns the fluid of any set-up. */
static bool is_general(const skv_field *field)
{
    return strncmp(field->path, "fluid.", 6) == 0 || strcmp(field->path, "substeps") == 0;
}

const skv_field *skv_lab_parameter(int i)
{
    if (i < 0)
        return NULL;
    if (i < COMMON_PARAMETERS)
        return &common[i];
    i -= COMMON_PARAMETERS;
    for (int k = 0; skv_scene_field(k); k++) {
        if (is_general(skv_scene_field(k)) && i-- == 0)
            return skv_scene_field(k);
    }
    for (int k = 0; skv_experiment_at(k); k++) {
        for (const skv_field *own = skv_experiment_at(k)->parameters; own->path; own++) {
            if (i-- == 0)
                return own;
        }
    }
    return NULL;
}

skv_lab_options skv_default_lab_options(void)
{
    return (skv_lab_options){.cookie = SKV_COOKIE(OPTIONS_COOKIE, skv_lab_options)};
}

void skv_lab_options_init(skv_lab_options *def, size_t size)
{
    const skv_lab_options standard = skv_default_lab_options();
    skv_def_init(def, size, &standard, sizeof standard);
}

const skv_lab_options *skv_open_lab_options(const skv_lab_options *options, skv_lab_options *own)
{
    *own = skv_default_lab_options();
    return options ? skv_def_open(options, own, sizeof *own) : own;
}

static double default_of(const skv_field *field)
{
    double value = 0;
    skv_field_read(field, field->default_text, &value);
    return value;
}

static skv_result read_value(const skv_field *field, const char *text, double *value,
                             skv_error *error)
{
    double read;
    const char *wrong = skv_field_read(field, text, &read);
    if (wrong)
        return skv_field_refuse(field, text, wrong, error);
    *value = read;
    return SKV_OK;
}

/* Keeps a setting of the fluid for the scene. */
static skv_result keep(settings *s, const skv_field *field, const skv_setting *setting,
                       skv_error *error)
{
    double value = 0;
    skv_result result = read_value(field, setting->value, &value, error);
    if (result != SKV_OK)
        return result;
    if (s->fluid_count == MAX_FLUID_SETTINGS)
        return skv_fail(error, SKV_ERROR_LIMIT, "%.60s: more than %d settings of the fluid",
                        setting->path, MAX_FLUID_SETTINGS);
    s->fluid[s->fluid_count++] = *setting;
    if (strcmp(setting->path, "fluid.spacing") == 0)
        s->spacing = value;
    return SKV_OK;
}

static skv_result apply(settings *s, const experiment *e, const skv_setting *setting,
                        skv_error *error)
{
    if (!setting->path || !setting->value)
        return skv_fail(error, SKV_ERROR_VALUE, "setting: a path and a value are needed");
    const skv_field *field = NULL;
    for (int i = 0; (field = skv_lab_parameter(i)) && strcmp(field->path, setting->path) != 0;)
        i++;
    if (!field)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%.60s: the lab has no such parameter; see 'skvalp lab --help'",
                        setting->path);
    if (field >= common && field < common + COMMON_PARAMETERS)
        return read_value(field, setting->value, &s->common[field - common], error);
    if (is_general(field))
        return keep(s, field, setting, error);
    double unused;
    bool is_own = e && field >= e->parameters && field < e->parameters + MAX_OWN;
    return read_value(field, setting->value, is_own ? &s->own[field - e->parameters] : &unused,
                      error);
}

skv_result skv_settings_make(settings *s, const experiment *e, const skv_lab_options *options,
                             skv_error *error)
{
    *s = (settings){0};
    for (int i = 0; i < COMMON_PARAMETERS; i++)
        s->common[i] = default_of(&common[i]);
    for (int i = 0; e && e->parameters[i].path; i++)
        s->own[i] = default_of(&e->parameters[i]);
    skv_lab_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_lab_options(options, &own), SKV_ERROR_VALUE);
    for (int i = 0; i < options->setting_count; i++) {
        skv_result result = apply(s, e, &options->settings[i], error);
        if (result != SKV_OK)
            return result;
    }
    return SKV_OK;
}

skv_result skv_lab_check(const skv_lab_options *options, skv_error *error)
{
    settings s;
    return skv_settings_make(&s, NULL, options, error);
}
