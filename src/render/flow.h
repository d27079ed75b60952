/* Flow: the fluid's velocity as arrows and as streamlines. */
#ifndef SKV_RENDER_FLOW_H
#define SKV_RENDER_FLOW_H

#include "render/canvas.h"

skv_result skv_overlay_arrows(skv_strokes *strokes, const skv_overlay_scene *scene,
                              skv_error *error);
skv_result skv_overlay_streamlines(skv_strokes *strokes, const skv_overlay_scene *scene,
                                   skv_error *error);

#endif
