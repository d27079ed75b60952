/* Splats: pass one of the thesis' rendering. */
#ifndef SKV_RENDER_SPLATS_H
#define SKV_RENDER_SPLATS_H

#include "render/gl.h"
#include "render/vertices.h"

/* What is added up: values; what dyes take; the shares of fluids 1 to 3 and of all, and of 4 to 7.
 */
typedef enum skv_splat {
    SKV_SPLAT_SUMS,
    SKV_SPLAT_TINTS,
    SKV_SPLAT_FEW,
    SKV_SPLAT_MORE,
    SKV_SPLATS
} skv_splat;

typedef struct skv_splats {
    GLuint program, attributes, buffer, framebuffer;
    GLuint textures[SKV_SPLATS];
    bool used[SKV_SPLATS]; /* in the picture that was drawn last */
    bool half_float, foamy;
    int last_fluid;       /* as in skv_vertices */
    skv_gl_target target; /* the textures' size and its relation to the view */
    double reach;         /* radius of a splat, view pixels */
    double crowd;         /* the sums by those of splats of the usual width */
    double gain;          /* of the sums: below 1 where the textures hold bytes */
    double code[2];       /* factor and offset that bring values into what they hold */
} skv_splats;

/* `half_float` false: sums in bytes, for devices that cannot draw into half floats. */
skv_result skv_splats_create(skv_splats *splats, bool half_float, skv_error *error);
void skv_splats_destroy(skv_splats *splats);

/* Draws particles, `spacing` metres apart, into the textures. `full`: at a resolution at which
 * round drops are round. Changes the framebuffer and the viewport. */
skv_result skv_splats_draw(skv_splats *splats, const skv_vertices *vertices, double spacing,
                           const skv_camera *camera, bool full, skv_error *error);

#endif
