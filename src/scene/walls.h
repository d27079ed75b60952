/* From a scene's shapes of walls to the coverage of its pixels. */
#ifndef SKV_SCENE_WALLS_H
#define SKV_SCENE_WALLS_H

#include "scene/scene_data.h"

/* Draws the shapes, unless that would take very long, and notes which were made thicker. */
skv_result skv_scene_draw_walls(const skv_draft *draft, skv_scene *scene, skv_error *error);

#endif
