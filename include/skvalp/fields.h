/** @file
 * Fields: the registry's rows. A field says what a parameter is called, what it may be and what it
 * is for. The world's parameters (skv_world_field), a scene's (skv_scene_field) and the
 * experiments' (skv_lab_parameter) are lists of fields; checks, messages, --set, panels and
 * documentation derive from them.
 */
#ifndef SKVALP_FIELDS_H
#define SKVALP_FIELDS_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a field holds. */
typedef enum skv_field_type {
    SKV_FIELD_NUMBER,  /**< finite, minimum..maximum to single precision */
    SKV_FIELD_INTEGER, /**< whole, minimum..maximum */
    SKV_FIELD_TEXT,    /**< at most `maximum` bytes of UTF-8 */
    SKV_FIELD_CHOICE,  /**< one of `choices`, separated by '|'; its number counts from 0 */
    SKV_FIELD_BOOLEAN
} skv_field_type;

typedef struct skv_field {
    const char *path; /**< "fluid.spacing"; a list's elements read "water[].x" */
    skv_field_type type;
    const char *unit; /**< "m", "m/s^2", ""; never null */
    double minimum, maximum;
    const char *choices;      /**< null unless SKV_FIELD_CHOICE */
    const char *default_text; /**< as it would be set; "" if there is none */
    const char *help;         /**< one line */
} skv_field;

/** One "path=value", as the command line's --set has it. */
typedef struct skv_setting {
    const char *path;
    const char *value;
} skv_setting;

#ifdef __cplusplus
}
#endif
#endif
