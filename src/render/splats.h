/* Splats: pass one of the thesis' rendering. */
#ifndef SKV_RENDER_SPLATS_H
#define SKV_RENDER_SPLATS_H

#include "render/gl.h"
#include "skvalp/world.h"

typedef struct skv_splats {
    GLuint program, attributes, buffer, texture, framebuffer;
    bool half_float;
    skv_gl_target target; /* the texture's size and its relation to the view */
    double reach;         /* radius of a splat, view pixels */
    double gain;          /* of the sums: below 1 where the texture holds bytes */
    double crowd;         /* the sums by those of splats of the usual width */

    /* What the last call showed, particle by particle. */
    int capacity, count;
    const skv_world *world;
    double time;
    uint32_t *ids;
    float *pressures; /* Pa m, smoothed over a few frames */
    float *vertices;  /* x, y, share of the pressure range, trust in it */
} skv_splats;

/* `half_float` false: sums in bytes, for devices that cannot draw into half floats. */
skv_result skv_splats_create(skv_splats *splats, bool half_float, skv_error *error);
void skv_splats_destroy(skv_splats *splats);

/* Draws the particles of `world` into the texture. Changes the framebuffer and the viewport. */
skv_result skv_splats_draw(skv_splats *splats, const skv_world *world, const skv_camera *camera,
                           double pressure_range, skv_error *error);

#endif
