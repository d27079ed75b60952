/* What is worth saying about a scene that can be built. */
#ifndef SKV_SCENE_NOTES_H
#define SKV_SCENE_NOTES_H

#include "scene/scene_data.h"

/* Adds notes, skv_scene_note, to a scene that is complete. */
void skv_scene_add_notes(skv_scene *scene);

#endif
