/* The fluids of a scene: what a draft says of them, and which of them water and emitters name. */
#ifndef SKV_SCENE_FLUIDS_H
#define SKV_SCENE_FLUIDS_H

#include "scene/scene_data.h"

/* Makes the fluids beside the first, which is known. */
skv_result skv_scene_build_fluids(const skv_draft *draft, skv_scene *scene, skv_error *error);

/* Finds the fluid of yellow pixels, if there are any: the scene's that is named oil, or one more.
 * Messages begin with the picture's label. */
skv_result skv_scene_paint_oil(skv_scene *scene, const char *label, skv_error *error);

/* The number of the fluid that a value names, at `path` for messages; 0 if it names none. */
skv_result skv_scene_find_fluid(const skv_draft *draft, const skv_value *value, const char *path,
                                int *number, skv_error *error);

#endif
