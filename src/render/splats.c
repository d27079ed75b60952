/* Splats: particles added up in textures of a quarter to the whole of the view's resolution.
 * Invariant: `target` is the size of the textures that are `used`. */
#include "render/splats.h"

#include <math.h>

#include "render/look.h"
#include "render/shaders.h"

/* Bounds of a splat's radius in texels: below, its shape is lost; above, a coarser texture shows
 * the same at a fraction of the cost (and every device draws points of that size). */
#define SMALLEST_RADIUS_PLAIN 3.0
#define SMALLEST_RADIUS_FULL  5.0
#define LARGEST_RADIUS        16.0

/* Bytes hold at most this many splats of the usual width on top of each other, half as many again
 * as there are in fluid at rest, and values from -2 to 2. */
#define BYTE_SPLATS 6.0
#define BYTE_FACTOR 0.25
#define BYTE_OFFSET 0.5

skv_result skv_splats_create(skv_splats *splats, bool half_float, skv_error *error)
{
    *splats = (skv_splats){.half_float = half_float,
                           .code = {half_float ? 1 : BYTE_FACTOR, half_float ? 0 : BYTE_OFFSET}};
    skv_result result = skv_gl_program("splat", "", skv_shader_splat_vert, skv_shader_splat_frag,
                                       &splats->program, error);
    if (result != SKV_OK)
        return result;
    glGenVertexArrays(1, &splats->attributes);
    glGenBuffers(1, &splats->buffer);
    glGenFramebuffers(1, &splats->framebuffer);
    for (int i = 0; i < SKV_SPLATS; i++)
        splats->textures[i] = skv_gl_texture();

    glBindVertexArray(splats->attributes);
    glBindBuffer(GL_ARRAY_BUFFER, splats->buffer);
    const struct {
        GLint size;
        GLenum type;
        GLboolean share;
        size_t offset;
    } parts[] = {{2, GL_FLOAT, GL_FALSE, offsetof(skv_vertex, x)},
                 {2, GL_FLOAT, GL_FALSE, offsetof(skv_vertex, value)},
                 {4, GL_UNSIGNED_SHORT, GL_TRUE, offsetof(skv_vertex, tint)},
                 {1, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(skv_vertex, fluid)}};
    for (GLuint i = 0; i < sizeof parts / sizeof *parts; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, parts[i].size, parts[i].type, parts[i].share, sizeof(skv_vertex),
                              (const void *)parts[i].offset);
    }
    glBindVertexArray(0);
    return SKV_OK;
}

void skv_splats_destroy(skv_splats *splats)
{
    glDeleteProgram(splats->program);
    glDeleteVertexArrays(1, &splats->attributes);
    glDeleteBuffers(1, &splats->buffer);
    glDeleteFramebuffers(1, &splats->framebuffer);
    glDeleteTextures(SKV_SPLATS, splats->textures);
    *splats = (skv_splats){0};
}

static void resize_texture(const skv_splats *splats, int number)
{
    glBindTexture(GL_TEXTURE_2D, splats->textures[number]);
    glTexImage2D(GL_TEXTURE_2D, 0, splats->half_float ? GL_RGBA16F : GL_RGBA8, splats->target.width,
                 splats->target.height, 0, GL_RGBA,
                 splats->half_float ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, NULL);
}

/* Makes the textures fit; leaves the framebuffer bound, with those that are wanted as targets. */
static skv_result fit_textures(skv_splats *splats, skv_gl_target target,
                               const bool wanted[SKV_SPLATS], skv_error *error)
{
    bool same = target.width == splats->target.width && target.height == splats->target.height;
    GLenum buffers[SKV_SPLATS];
    splats->target = target;
    glBindFramebuffer(GL_FRAMEBUFFER, splats->framebuffer);
    for (int i = 0; i < SKV_SPLATS; i++) {
        GLenum attachment = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        if (wanted[i] && !(same && splats->used[i]))
            resize_texture(splats, i);
        if (wanted[i] != splats->used[i])
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D,
                                   wanted[i] ? splats->textures[i] : 0, 0);
        splats->used[i] = wanted[i];
        buffers[i] = wanted[i] ? attachment : GL_NONE;
    }
    glDrawBuffers(SKV_SPLATS, buffers);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return SKV_OK;
    splats->target = (skv_gl_target){0};
    return skv_fail(error, SKV_ERROR_DEVICE,
                    "the graphics device cannot draw into a %d x %d texture: make the view smaller",
                    target.width, target.height);
}

/* Chooses the resolution for splats of this many view pixels; returns their radius in texels. */
static double choose_target(skv_splats *splats, double radius, bool full, const skv_camera *camera,
                            skv_gl_target *target)
{
    double smallest = full ? SMALLEST_RADIUS_FULL : SMALLEST_RADIUS_PLAIN;
    double texels = 0.25;
    while (texels < 1 && radius * texels < smallest)
        texels *= 2;
    while (texels > 1.0 / 256 && radius * texels > LARGEST_RADIUS)
        texels /= 2;
    double drawn = fmax(radius * texels, smallest);

    /* Where splats are wider than usual because particles are smaller than pixels, the sums grow
     * with their area. */
    double widened = drawn / (radius * texels);
    splats->crowd = widened * widened;
    splats->gain = splats->half_float ? 1 : 1 / (BYTE_SPLATS * splats->crowd);
    splats->reach = drawn / texels;
    int margin = (int)ceil(drawn) + 2;
    *target = (skv_gl_target){.width = (int)ceil(camera->width * texels) + 2 * margin,
                              .height = (int)ceil(camera->height * texels) + 2 * margin,
                              .texels = texels,
                              .margin = margin};
    return drawn;
}

skv_result skv_splats_draw(skv_splats *splats, const skv_vertices *vertices, double spacing,
                           const skv_camera *camera, bool full, skv_error *error)
{
    skv_gl_target target;
    double radius =
        choose_target(splats, SKV_SPLAT_RADIUS * spacing * camera->scale, full, camera, &target);
    const bool wanted[SKV_SPLATS] = {[SKV_SPLAT_SUMS] = true,
                                     [SKV_SPLAT_TINTS] = vertices->tinted,
                                     [SKV_SPLAT_FEW] = vertices->last_fluid > 0,
                                     [SKV_SPLAT_MORE] = vertices->last_fluid > 3};
    skv_result result = fit_textures(splats, target, wanted, error);
    if (result != SKV_OK)
        return result;
    splats->foamy = vertices->foamy;
    splats->last_fluid = vertices->last_fluid;

    glBindBuffer(GL_ARRAY_BUFFER, splats->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)vertices->count * (GLsizeiptr)sizeof(skv_vertex),
                 vertices->list, GL_STREAM_DRAW);
    glViewport(0, 0, target.width, target.height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(splats->program);
    skv_gl_set_transform(splats->program, camera, &target);
    glUniform1f(glGetUniformLocation(splats->program, "u_diameter"), (float)(2 * radius));
    glUniform1f(glGetUniformLocation(splats->program, "u_gain"), (float)splats->gain);
    glUniform2f(glGetUniformLocation(splats->program, "u_code"), (float)splats->code[0],
                (float)splats->code[1]);
    glBindVertexArray(splats->attributes);
    glDrawArrays(GL_POINTS, 0, vertices->count);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    return SKV_OK;
}
