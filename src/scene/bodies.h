/* The bodies of a scene: from a draft's values to what a world is given. */
#ifndef SKV_SCENE_BODIES_H
#define SKV_SCENE_BODIES_H

#include "scene/scene_data.h"

/* Makes them, when the scene's size, water and spacing are known: those that are listed, and those
 * that are painted in the picture of that name. The water gets what they cover of it. */
skv_result skv_scene_build_bodies(const skv_draft *draft, const char *picture, skv_scene *scene,
                                  skv_error *error);

/* Puts them into a world. */
skv_result skv_scene_add_bodies(const skv_scene *scene, skv_world *world, skv_error *error);

#endif
