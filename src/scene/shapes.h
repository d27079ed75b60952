/* From a list of shape values to shapes, with the checks that concern several fields at once. */
#ifndef SKV_SCENE_SHAPES_H
#define SKV_SCENE_SHAPES_H

#include "scene/draft.h"
#include "scene/shape.h"

/* Writes the shapes of a list to `shapes`, which has room for them. Their points stay the values'.
 * Boxes without a far corner end at the world's (`width`, `height`). Solid may lie outside it. */
skv_result skv_shapes_make(const skv_draft *draft, skv_list list, double width, double height,
                           skv_shape *shapes, skv_error *error);

/* Says in `text` of what lies outside a world how far that reaches. */
void skv_say_outside(double width, double height, char *text, size_t size);

#endif
