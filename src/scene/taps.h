/* From green and red areas of a painted world to emitters and drains. */
#ifndef SKV_SCENE_TAPS_H
#define SKV_SCENE_TAPS_H

#include "scene/scene_data.h"

/* Adds those of a scene's paint to its emitters and drains, from the bottom up. Fails with
 * SKV_ERROR_MEMORY, or SKV_ERROR_LIMIT for more areas than a world takes. */
skv_result skv_scene_build_taps(skv_scene *scene, const char *label, skv_error *error);

#endif
