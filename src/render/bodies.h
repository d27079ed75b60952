/* Bodies as strokes, below all other overlays. */
#ifndef SKV_RENDER_BODIES_H
#define SKV_RENDER_BODIES_H

#include "render/canvas.h"

skv_result skv_bodies_draw(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error);

#endif
