/* The look: every colour and proportion of the picture in one place. */
#ifndef SKV_RENDER_LOOK_H
#define SKV_RENDER_LOOK_H

#include "skvalp/render.h"

/* Radius of a splat in spacings. Wide enough that the lattice of a pool at rest leaves no ripple
 * on its surface, narrow enough that thin streams stay thin. */
#define SKV_SPLAT_RADIUS 2.2

/* Thresholds, in units of one splat's centre. A lone particle is drawn as a disc of the area that
 * it has in the fluid, of radius s / sqrt(pi); a body of fluid, whose sum is 3.8 inside and half of
 * that where its area ends, a little beyond, so that thin sheets hold together. */
#define SKV_THRESHOLD_LONE 0.8154
#define SKV_THRESHOLD_BODY 1.6

typedef struct skv_colors {
    float sky[3], ground[3];     /* background, top and bottom */
    float shade[3];              /* background close to walls */
    float wall[3], wall_edge[3]; /* the edge parts walls from fluid of any colour */
    float shallow[3], deep[3];   /* water by depth */
    float surface[3], light[3];  /* water's outline; what rim and foam shine with */
    float outline[3];            /* of fluid that shows a scale */
    float relief, foam;          /* how much light models water and walls; how much foam covers */
    float murk[3];               /* how fast red, green and blue light fade with depth */
    float dyes[SKV_DYES][3];     /* water full of a dye, halfway down */
    float fluids[SKV_MAX_FLUIDS - 1][3]; /* fluids beside water, likewise */
    float bubble[4];                     /* in foam; with alpha, as what follows */
    float ink[4], faint[4];              /* overlays on water: tracers, arrows; grid; with alpha */
    float figures[4], plate[4];          /* ruler and legend, and what lies under them */
    float marks[7][4];                   /* by skv_mark_role */
    float halo[4];                       /* around what has to show on anything */
} skv_colors;

/* Static. */
const skv_colors *skv_look_colors(skv_palette palette);

/* What a frame's fluid looks like halfway down: its own colour, or what suits its material, or that
 * of its number. False if it looks like water. */
bool skv_look_fluid(const skv_colors *colors, const skv_frame *frame, int number, float color[3]);

/* The colour of a view's scale at a place from 0 to 1, RGB 0..1. */
void skv_look_scale(skv_view view, double place, float color[3]);

/* Width of the drawing's thin lines in view pixels: one on a small view, more on a large one, so
 * that the picture looks the same at any size. */
double skv_look_line(const skv_camera *camera);

/* The depth in metres over which a frame's fluid may extend: about that of the free region's height
 * when it is half full, less when there is less fluid. Constant in time, so that colours are. */
double skv_look_depth(const skv_frame *frame);

/* The speed of a fall through that depth, m/s. */
double skv_look_speed(const skv_frame *frame);

#endif
