/* Painted bodies: from brown areas of a picture to bodies of a scene. */
#ifndef SKV_SCENE_PAINTED_BODIES_H
#define SKV_SCENE_PAINTED_BODIES_H

#include "scene/scene_data.h"

/* Appends them to the scene's bodies, which have room for all that a world may have, and takes them
 * out of its painting. `label` names the picture. Fails with SKV_ERROR_LIMIT for too many, with
 * SKV_ERROR_VALUE for what is no body's shape, and the pixel, or with SKV_ERROR_MEMORY. */
skv_result skv_scene_find_bodies(skv_scene *scene, const char *label, skv_error *error);

#endif
