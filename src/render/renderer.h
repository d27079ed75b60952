/* What tests of the renderer see besides its public face. */
#ifndef SKV_RENDER_RENDERER_H
#define SKV_RENDER_RENDERER_H

#include "skvalp/render.h"

/* As skv_renderer_create, with the choice of how splats are summed up: false for devices that
 * cannot draw into half floats. */
skv_result skv_renderer_create_with(bool half_float, skv_renderer **renderer, skv_error *error);

#endif
