/* The look: every colour and proportion of the picture in one place. */
#ifndef SKV_RENDER_LOOK_H
#define SKV_RENDER_LOOK_H

#include "skvalp/camera.h"

/* Radius of a splat in spacings. Wide enough that the lattice of a pool at rest leaves no ripple
 * on its surface, narrow enough that thin streams stay thin. */
#define SKV_SPLAT_RADIUS 2.2

/* Thresholds, in units of one splat's centre. A lone particle is drawn as a disc of about the area
 * that it has in the fluid; a body of fluid, whose sum is 3.8 inside and half of that where its
 * area ends, a little beyond, so that thin sheets hold together. */
#define SKV_THRESHOLD_LONE 0.85
#define SKV_THRESHOLD_BODY 1.6

/* Radius of a tracer's dot in spacings. */
#define SKV_TRACER_RADIUS 0.36

typedef struct skv_palette {
    float sky[3], ground[3]; /* background, top and bottom */
    float shade[3];          /* background close to walls */
    float wall[3], wall_edge[3];
    float shallow[3], middle[3], deep[3]; /* fluid by pressure: blue, purple, white */
    float surface[3];                     /* the light line along the fluid's outline */
    float tracer[4], hand[4];             /* with alpha */
} skv_palette;

/* The palette for dark or light surroundings. Static. */
const skv_palette *skv_look_palette(int dark);

/* Width of the drawing's thin lines in view pixels: one on a small view, more on a large one, so
 * that the picture looks the same at any size. */
double skv_look_line(const skv_camera *camera);

#endif
