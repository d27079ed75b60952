/* Bodies as strokes, below all other overlays, and where they leave no room for fluid. */
#ifndef SKV_RENDER_BODIES_H
#define SKV_RENDER_BODIES_H

#include "render/canvas.h"

skv_result skv_bodies_draw(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error);

/* A body's outline where it lies, m, and the box around it. */
typedef struct skv_placed_body {
    int count;
    float x[SKV_MAX_CORNERS], y[SKV_MAX_CORNERS];
    float left, right, low, high;
} skv_placed_body;
skv_placed_body skv_body_place(const skv_body *body);

/* How far from its outline a place is: below 0 inside. */
float skv_placed_body_distance(const skv_placed_body *placed, float x, float y);

#endif
