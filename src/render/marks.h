/* Marks: what is drawn over the fluid, tracers' dots and hands' rings. */
#ifndef SKV_RENDER_MARKS_H
#define SKV_RENDER_MARKS_H

#include "render/gl.h"
#include "render/look.h"
#include "skvalp/world.h"

typedef struct skv_marks {
    GLuint program, attributes, buffer;
    int capacity;
    float *instances; /* x, y, radius in metres */
} skv_marks;

skv_result skv_marks_create(skv_marks *marks, skv_error *error);
void skv_marks_destroy(skv_marks *marks);

/* Both draw into the framebuffer that is bound, which shows the camera's view. */
skv_result skv_marks_draw_tracers(skv_marks *marks, const skv_world *world,
                                  const skv_camera *camera, const skv_palette *palette,
                                  skv_error *error);
skv_result skv_marks_draw_hands(skv_marks *marks, const skv_hand *hands, int count,
                                const skv_camera *camera, const skv_palette *palette,
                                skv_error *error);

#endif
