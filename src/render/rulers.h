/* Rulers: lengths and the view's scale, with figures. */
#ifndef SKV_RENDER_RULERS_H
#define SKV_RENDER_RULERS_H

#include "render/canvas.h"

skv_result skv_overlay_grid(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error);
skv_result skv_overlay_ruler(skv_strokes *strokes, const skv_overlay_scene *scene,
                             skv_error *error);
skv_result skv_overlay_legend(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error);

#endif
