/** @file
 * Renderer: pictures of a frame over a current OpenGL ES 3.0 context, free of any toolkit, and
 * pictures without a display.
 *
 * As in the thesis (section 3.6) pass one adds a soft round splat per particle into a buffer of a
 * lower resolution, and pass two draws background, walls and, where the sum exceeds a threshold,
 * the fluid. What the fluid shows is the style's view; overlays go on top. A picture depends on the
 * frame, the camera and the style alone, not on what was drawn before.
 */
#ifndef SKVALP_RENDER_H
#define SKVALP_RENDER_H

#include "skvalp/base.h"
#include "skvalp/camera.h"
#include "skvalp/frame.h"
#include "skvalp/mark.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the fluid shows. */
typedef enum skv_view {
    SKV_VIEW_WATER,     /**< water: light on its rim, deeper blue below, foam where it is violent */
    SKV_VIEW_PRESSURE,  /**< pressure, with isobars */
    SKV_VIEW_SPEED,     /**< speed */
    SKV_VIEW_DENSITY,   /**< particles per area against the number at rest; less at the surface */
    SKV_VIEW_PARTICLES, /**< each particle as a disc of its own area, coloured by its speed */
    SKV_VIEW_FLUID      /**< water without light and foam */
} skv_view;

/** What is drawn over it: a set of bits. */
typedef enum skv_overlay {
    SKV_OVERLAY_TRACERS = 1,     /**< every tenth particle as a dot */
    SKV_OVERLAY_ARROWS = 2,      /**< the velocity on a grid */
    SKV_OVERLAY_STREAMLINES = 4, /**< lines along the velocity, longer where it is faster */
    SKV_OVERLAY_GRID = 8,        /**< lines every 10 cm, or the distance that suits the zoom */
    SKV_OVERLAY_RULER = 16,      /**< lengths along the left and lower side */
    SKV_OVERLAY_LEGEND = 32      /**< the view's scale with its figures */
} skv_overlay;

/** Colours: each keeps fluid and walls at a contrast of 3:1 or more. */
typedef enum skv_palette {
    SKV_PALETTE_DARK,
    SKV_PALETTE_LIGHT,
    SKV_PALETTE_CONTRAST /**< high contrast: black, white and one blue */
} skv_palette;

/** How much a picture may cost. */
typedef enum skv_detail {
    SKV_DETAIL_AUTO, /**< plain where OpenGL is drawn by the processor, else full */
    SKV_DETAIL_FULL,
    SKV_DETAIL_PLAIN /**< coarser outlines, no light, no foam; water as SKV_VIEW_FLUID */
} skv_detail;

/** How to draw. Initialise with skv_default_render_style. */
typedef struct skv_render_style {
    uint32_t cookie;
    skv_view view;       /**< default SKV_VIEW_WATER */
    unsigned overlays;   /**< skv_overlay bits; default 0 */
    skv_palette palette; /**< default SKV_PALETTE_DARK */
    skv_detail detail;   /**< default SKV_DETAIL_AUTO */
    double range;        /**< the upper end of the view's scale in its unit, see skv_legend;
                            0, the default: what suits the frame's walls, gravity and amount */
    bool comma;          /**< figures have a decimal comma, see skv_numerals; default a point */
} skv_render_style;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_render_style skv_default_render_style(void);
SKV_API void skv_render_style_init(skv_render_style *def, size_t size);

/** A part of a style that has names. */
typedef enum skv_style_part {
    SKV_STYLE_VIEW,
    SKV_STYLE_OVERLAY,
    SKV_STYLE_PALETTE,
    SKV_STYLE_DETAIL
} skv_style_part;

/** One of a part's choices, for menus, help and documentation. Static. */
typedef struct skv_style_choice {
    const char *name;  /**< "pressure", as skv_render_style_set takes it */
    const char *label; /**< "Pressure" */
    const char *help;  /**< one line */
    int value;         /**< of the enumeration */
} skv_style_choice;

/** Choice number `index` of a part, from 0 on; null beyond the last. Thread-safe. */
SKV_API const skv_style_choice *skv_style_choice_at(skv_style_part part, int index);

/** Sets a part of a style by name; of overlays, names separated by commas, or "none".
 * SKV_ERROR_VALUE, and the style stays as it was, if there is no such name. Thread-safe. */
SKV_API skv_result skv_render_style_set(skv_render_style *style, skv_style_part part,
                                        const char *names, skv_error *error);

#define SKV_LEGEND_COLORS 64

/** The scale of a view, for a face that draws its own legend. */
typedef struct skv_legend {
    bool shown;        /**< false: this view has no scale */
    const char *label; /**< "pressure" */
    const char *unit;  /**< "Pa m", "m/s", or "" for a share */
    double low, high;  /**< at the scale's ends; beyond, the last colour goes on */
    double step;       /**< between isobars; a good distance of figures */
    double depth;      /**< of pressure: m of the liquid at rest that one unit stands for; else 0 */
    uint8_t colors[SKV_LEGEND_COLORS][3]; /**< RGB, from low to high */
} skv_legend;

/** The scale with which a frame is drawn. Thread-safe. */
SKV_API skv_legend skv_render_legend(const skv_frame *frame, const skv_render_style *style);

/** What a frame's fluid looks like, by its number: 0xrrggbb, as halfway down. A fluid that names no
 * colour has one that suits its material (skvalp/fluid.h), or else one of its own, as far from
 * those of the others as can be; the first is blue. Thread-safe. */
SKV_API int skv_render_fluid_color(const skv_frame *frame, skv_palette palette, int fluid);

typedef struct skv_renderer skv_renderer;

/** Makes a renderer for the current context, which must stay current for every later call,
 * destruction included. SKV_ERROR_DEVICE if the context is not OpenGL ES 3.0. Where a context was
 * lost, a renderer made in the next one draws the same picture. */
SKV_API skv_result skv_renderer_create(skv_renderer **renderer, skv_error *error);
SKV_API void skv_renderer_destroy(skv_renderer *renderer);

/** Draws a frame into the framebuffer that is bound, filling the camera's view, and the marks over
 * it (null if their number is 0). */
SKV_API skv_result skv_renderer_draw(skv_renderer *renderer, const skv_frame *frame,
                                     const skv_camera *camera, const skv_render_style *style,
                                     const skv_mark *marks, int mark_count, skv_error *error);

/** A context without a display (EGL surfaceless) with a framebuffer of its own, for pictures and
 * videos. Becomes current on the calling thread, which has none, nor anything else of EGL's, once
 * it is destroyed there. SKV_ERROR_DEVICE where EGL offers none. */
typedef struct skv_offscreen skv_offscreen;
SKV_API skv_result skv_offscreen_create(int width, int height, skv_offscreen **offscreen,
                                        skv_error *error);
SKV_API void skv_offscreen_destroy(skv_offscreen *offscreen);

/** Draws a frame as large as fits and reads the picture back: width*height*3 bytes RGB, top row
 * first, into `rgb`. SKV_DETAIL_AUTO is full here: a picture is the same on every device. */
SKV_API skv_result skv_offscreen_render(skv_offscreen *offscreen, const skv_frame *frame,
                                        const skv_render_style *style, uint8_t *rgb,
                                        skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
