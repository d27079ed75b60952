/* The few helpers around OpenGL ES that every pass shares. */
#ifndef SKV_RENDER_GL_H
#define SKV_RENDER_GL_H

#include <GLES3/gl3.h>

#include "skvalp/base.h"
#include "skvalp/camera.h"

/* Compiles and links a program; `name` is for the message, `defines` is text that goes before the
 * shaders. */
skv_result skv_gl_program(const char *name, const char *defines, const char *vertex,
                          const char *fragment, GLuint *program, skv_error *error);

/* True if the processor does what a graphics device would. */
bool skv_gl_is_software(void);

/* True if the current context can draw into, and blend in, half-float textures. */
bool skv_gl_half_float(void);

/* Sets the uniforms u_scale and u_offset that take metres to clip space, for a target that shows
 * the camera's view at `texels` a pixel with a margin of `margin` texels around it. */
typedef struct skv_gl_target {
    int width, height; /* texels, margins included */
    double texels;     /* a view pixel */
    int margin;        /* texels on each side */
} skv_gl_target;
void skv_gl_set_transform(GLuint program, const skv_camera *camera, const skv_gl_target *target);

/* Makes a 2D texture that is sampled linearly and clamped to its edge. */
GLuint skv_gl_texture(void);

#endif
