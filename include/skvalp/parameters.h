/** @file
 * Parameters: the numbers and choices of a world and its fluid, by name.
 */
#ifndef SKVALP_PARAMETERS_H
#define SKVALP_PARAMETERS_H

#include "skvalp/base.h"
#include "skvalp/fields.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The parameters of a definition, its fluid's included, by path: "gravity.y", "fluid.viscosity".
 * The fields in documentation order; null past the last. Static. */
SKV_API const skv_field *skv_world_field(int i);

/** Sets a parameter of a definition from text: "0.001", "clavet", "true". Setting fluid.law gives
 * the new law's defaults to what has the old law's; fluid.material sets density and viscosity.
 * SKV_ERROR_VALUE, and nothing changed, for an unknown path or a value that its field does not
 * allow; the message says what it does. */
SKV_API skv_result skv_world_def_set(skv_world_def *def, const char *path, const char *text,
                                     skv_error *error);

/** Writes a parameter as text that would set it, cut to `size`; 32 bytes hold any. fluid.material
 * is empty if no material has this density and viscosity. SKV_ERROR_VALUE for an unknown path. */
SKV_API skv_result skv_world_def_get(const skv_world_def *def, const char *path, char *text,
                                     size_t size, skv_error *error);

/* The same without text: a parameter by its number, which is its place in the list of
 * skv_world_field, and a choice by its index, true and false as 1 and 0. */

/** A parameter's number; -1 for an unknown path. It is the same as long as the library is. */
SKV_API int skv_world_parameter(const char *path);

/** Sets a parameter of a definition. SKV_ERROR_VALUE, and nothing changed, for a number that its
 * field does not allow, or that is no parameter's. */
SKV_API skv_result skv_world_def_set_number(skv_world_def *def, int parameter, double value,
                                            skv_error *error);

/** A parameter of a definition; of fluid.material -1 if no material has this density and
 * viscosity. 0, and a caller's mistake, for what is no parameter's number. */
SKV_API double skv_world_def_number(const skv_world_def *def, int parameter);

/** The same for a world that runs, as skv_world_set and _get. */
SKV_API skv_result skv_world_set_number(skv_world *world, int parameter, double value,
                                        skv_error *error);
SKV_API double skv_world_number(const skv_world *world, int parameter);

/** The same as skv_world_def_set and _get for a world that runs. What skv_world_can_change denies
 * is refused with SKV_ERROR_VALUE. The substeps follow as they follow gravity. Fluid that sleeps
 * wakes up. Clavet's numbers and its contact distance are read as they were set, and act in full
 * after a second: until then fluid goes to them evenly (docs/model.md). */
SKV_API bool skv_world_can_change(const char *path);
SKV_API skv_result skv_world_set(skv_world *world, const char *path, const char *text,
                                 skv_error *error);
SKV_API skv_result skv_world_get(const skv_world *world, const char *path, char *text, size_t size,
                                 skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
