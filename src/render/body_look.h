/* The look of bodies, beside all others (look.h): the page's first module has none. */
#ifndef SKV_RENDER_BODY_LOOK_H
#define SKV_RENDER_BODY_LOOK_H

#include "skvalp/render.h"

/* RGBA 0..1. */
typedef struct skv_body_look {
    float inside[4], edge[4];
} skv_body_look;

/* What a body of this density, kg/m^2, looks like: that of which things so heavy are made. Static.
 */
const skv_body_look *skv_look_body(skv_palette palette, float density);

#endif
