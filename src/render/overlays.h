/* Overlays: what is shown over walls and fluid, as strokes. */
#ifndef SKV_RENDER_OVERLAYS_H
#define SKV_RENDER_OVERLAYS_H

#include "render/canvas.h"

/* The view's own particles, if it shows particles, and everything in a set of skv_overlay bits. */
skv_result skv_overlays_add(skv_strokes *strokes, const skv_overlay_scene *scene, unsigned overlays,
                            skv_error *error);

/* What tools show. */
skv_result skv_overlays_add_marks(skv_strokes *strokes, const skv_overlay_scene *scene,
                                  const skv_mark *marks, int count, skv_error *error);

#endif
