/** @file
 * Renderer: the thesis' two passes (section 3.6) over a current OpenGL ES 3.0 context, free of any
 * toolkit, and pictures without a display.
 *
 * Pass one adds a soft round splat per particle into a buffer of a quarter of the resolution; pass
 * two draws background, walls and, where the sum exceeds a threshold, the fluid, coloured by
 * pressure from blue over purple to white.
 */
#ifndef SKVALP_RENDER_H
#define SKVALP_RENDER_H

#include "skvalp/base.h"
#include "skvalp/camera.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What to draw besides the fluid. Initialise with skv_default_render_style. */
typedef struct skv_render_style {
    bool tracers;          /**< every tenth particle white (thesis: 10 %); default off */
    bool dark;             /**< colours for a dark surrounding; default true */
    double pressure_range; /**< Pa m shown as white; 0: from the scene (depth and gravity) */
    int cookie;
} skv_render_style;

SKV_API skv_render_style skv_default_render_style(void);

typedef struct skv_renderer skv_renderer;

/** Makes a renderer for the current context, which must stay current for every later call,
 * destruction included. SKV_ERROR_DEVICE if the context is not OpenGL ES 3.0. */
SKV_API skv_result skv_renderer_create(skv_renderer **renderer, skv_error *error);
SKV_API void skv_renderer_destroy(skv_renderer *renderer);

/** Draws a world into the framebuffer that is bound, filling the camera's view. The hands (null if
 * count is 0) are drawn as rings. */
SKV_API skv_result skv_renderer_draw(skv_renderer *renderer, const skv_world *world,
                                     const skv_camera *camera, const skv_render_style *style,
                                     const skv_hand *hands, int hand_count, skv_error *error);

/** A context without a display (EGL surfaceless) with a framebuffer of its own, for pictures and
 * videos. Becomes current on the calling thread. SKV_ERROR_DEVICE where EGL offers none. */
typedef struct skv_offscreen skv_offscreen;
SKV_API skv_result skv_offscreen_create(int width, int height, skv_offscreen **offscreen,
                                        skv_error *error);
SKV_API void skv_offscreen_destroy(skv_offscreen *offscreen);

/** Draws a world as large as fits and reads the picture back: width*height*3 bytes RGB, top row
 * first, into `rgb`. */
SKV_API skv_result skv_offscreen_render(skv_offscreen *offscreen, const skv_world *world,
                                        const skv_render_style *style, uint8_t *rgb,
                                        skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
