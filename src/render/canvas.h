/* Canvas: what everything that is drawn over the fluid is drawn on. */
#ifndef SKV_RENDER_CANVAS_H
#define SKV_RENDER_CANVAS_H

#include "render/look.h"
#include "render/strokes.h"
#include "render/vertices.h"

/* What overlays are about. */
typedef struct skv_overlay_scene {
    const skv_frame *frame;
    const skv_camera *camera;
    const skv_vertices *vertices; /* of the frame */
    const skv_colors *colors;
    skv_palette palette; /* that they are of */
    skv_view view;
    const skv_legend *legend;
    bool comma; /* in figures */
} skv_overlay_scene;

/* View pixels, y up, of a point in metres. */
float skv_overlay_x(const skv_camera *camera, double x);
float skv_overlay_y(const skv_camera *camera, double y);

/* The colour of strokes on the fluid: bright on water, dark on scales, which are bright. */
const float *skv_overlay_ink(const skv_overlay_scene *scene);

/* Sets a stroke's colour, with a share of its alpha. */
void skv_stroke_paint(skv_stroke *stroke, const float color[4], double share);

/* A distance in metres of one figure, 1, 2 or 5, that is at least `pixels` long in the view; 0.1
 * where that is at most ten times as long. */
double skv_overlay_step(const skv_camera *camera, double pixels);

#endif
