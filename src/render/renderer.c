/* Renderer: pass one into the splat texture, pass two into the caller's framebuffer, marks on top.
 * Invariant: between calls no state of the context matters, every call sets what it needs; the
 * framebuffer that was bound is bound again afterwards, with the viewport on the camera's view. */
#include "render/renderer.h"

#include <math.h>

#include "base/assert.h"
#include "base/memory.h"
#include "render/look.h"
#include "render/marks.h"
#include "render/shaders.h"
#include "render/splats.h"
#include "render/walls.h"

#define STYLE_COOKIE  0x736b7673
#define EARTH_GRAVITY 9.81

struct skv_renderer {
    GLuint compose, attributes;
    skv_splats splats;
    skv_walls walls;
    skv_marks marks;
};

skv_render_style skv_default_render_style(void)
{
    return (skv_render_style){.dark = true, .cookie = STYLE_COOKIE};
}

static skv_result check_context(skv_error *error)
{
    const char *version = (const char *)glGetString(GL_VERSION);
    if (!version)
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "no OpenGL ES context is current: make one current first");
    GLint major = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    bool embedded = version[0] == 'O' && version[7] == 'E'; /* "OpenGL ES 3.0 ..." */
    if (major < 3 || !embedded)
        return skv_fail(error, SKV_ERROR_DEVICE, "OpenGL ES 3.0 is needed, but this is %s",
                        version);
    return SKV_OK;
}

static skv_result create_parts(skv_renderer *renderer, bool half_float, skv_error *error)
{
    skv_result result = skv_gl_program("compose", skv_shader_compose_vert, skv_shader_compose_frag,
                                       &renderer->compose, error);
    if (result == SKV_OK)
        result = skv_splats_create(&renderer->splats, half_float, error);
    if (result == SKV_OK)
        result = skv_marks_create(&renderer->marks, error);
    glGenVertexArrays(1, &renderer->attributes);
    skv_walls_create(&renderer->walls);
    return result;
}

skv_result skv_renderer_create_with(bool half_float, skv_renderer **renderer, skv_error *error)
{
    SKV_ASSERT_OR(renderer, SKV_ERROR_VALUE);
    *renderer = NULL;
    skv_result result = check_context(error);
    if (result != SKV_OK)
        return result;
    skv_renderer *made = skv_calloc(1, sizeof *made);
    if (!made)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a renderer");
    result = create_parts(made, half_float && skv_gl_half_float(), error);
    if (result != SKV_OK) {
        skv_renderer_destroy(made);
        return result;
    }
    *renderer = made;
    return SKV_OK;
}

skv_result skv_renderer_create(skv_renderer **renderer, skv_error *error)
{
    return skv_renderer_create_with(true, renderer, error);
}

void skv_renderer_destroy(skv_renderer *renderer)
{
    if (!renderer)
        return;
    glDeleteProgram(renderer->compose);
    glDeleteVertexArrays(1, &renderer->attributes);
    skv_splats_destroy(&renderer->splats);
    skv_walls_destroy(&renderer->walls);
    skv_marks_destroy(&renderer->marks);
    skv_free(renderer);
}

/* The pressure shown as white when the style leaves it open: about that of the free region's height
 * when it is half full, less when there is less fluid, so that water at rest goes from blue to
 * purple and impacts flash white. Constant in time, so that colours are. */
static double pressure_range(const skv_world *world, const skv_walls *walls)
{
    float x, y;
    skv_world_gravity(world, &x, &y);
    double gravity = hypot(x, y);
    double spacing = skv_world_spacing(world);
    double fluid_area = skv_world_particle_count(world) * spacing * spacing;
    double filled = walls->free_area > 0 ? fluid_area / walls->free_area : 1;
    double height = walls->highest - walls->lowest;
    double depth = fmax(1.6 * sqrt(fmin(filled, 1)), 0.3) * height;
    double range = skv_world_fluid(world)->density * fmax(gravity, 0.1 * EARTH_GRAVITY) * depth;
    return range > 0 ? range : 1;
}

static void set_color(GLuint program, const char *name, const float color[3])
{
    glUniform3fv(glGetUniformLocation(program, name), 1, color);
}

static void set_palette(GLuint program, const skv_palette *palette)
{
    set_color(program, "u_sky", palette->sky);
    set_color(program, "u_ground", palette->ground);
    set_color(program, "u_shade", palette->shade);
    set_color(program, "u_wall", palette->wall);
    set_color(program, "u_wall_edge", palette->wall_edge);
    set_color(program, "u_shallow", palette->shallow);
    set_color(program, "u_middle", palette->middle);
    set_color(program, "u_deep", palette->deep);
    set_color(program, "u_surface", palette->surface);
}

static void set_geometry(GLuint program, const skv_terrain *terrain, const skv_camera *camera)
{
    unsigned open = skv_terrain_open_sides(terrain);
    glUniform1f(glGetUniformLocation(program, "u_scale"), (float)camera->scale);
    glUniform2f(glGetUniformLocation(program, "u_origin"), (float)camera->origin_x,
                (float)(camera->height - camera->origin_y));
    glUniform2f(glGetUniformLocation(program, "u_world"), skv_terrain_width(terrain),
                skv_terrain_height(terrain));
    glUniform4f(glGetUniformLocation(program, "u_closed"), open & SKV_SIDE_LEFT ? 0 : 1,
                open & SKV_SIDE_RIGHT ? 0 : 1, open & SKV_SIDE_BOTTOM ? 0 : 1,
                open & SKV_SIDE_TOP ? 0 : 1);
    glUniform2f(glGetUniformLocation(program, "u_view"), (float)camera->width,
                (float)camera->height);
    glUniform1f(glGetUniformLocation(program, "u_pixel"), (float)skv_look_line(camera));
}

static void compose(const skv_renderer *renderer, const skv_terrain *terrain,
                    const skv_camera *camera, const skv_palette *palette)
{
    const skv_splats *splats = &renderer->splats;
    GLuint program = renderer->compose;
    glUseProgram(program);
    set_palette(program, palette);
    set_geometry(program, terrain, camera);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, renderer->walls.texture);
    glUniform1i(glGetUniformLocation(program, "u_walls"), 1);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, splats->texture);
    glUniform1i(glGetUniformLocation(program, "u_splats"), 0);
    glUniform2f(glGetUniformLocation(program, "u_splat_size"), (float)splats->target.width,
                (float)splats->target.height);
    glUniform1f(glGetUniformLocation(program, "u_texels"), (float)splats->target.texels);
    glUniform1f(glGetUniformLocation(program, "u_margin"), (float)splats->target.margin);
    glUniform1f(glGetUniformLocation(program, "u_gain"), (float)splats->gain);
    glUniform1f(glGetUniformLocation(program, "u_crowd"), (float)splats->crowd);
    glUniform2f(glGetUniformLocation(program, "u_threshold"), (float)SKV_THRESHOLD_LONE,
                (float)SKV_THRESHOLD_BODY);
    glUniform1f(glGetUniformLocation(program, "u_reach"), (float)splats->reach);
    glBindVertexArray(renderer->attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

static void set_plain_state(void)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glActiveTexture(GL_TEXTURE0);
}

skv_result skv_renderer_draw(skv_renderer *renderer, const skv_world *world,
                             const skv_camera *camera, const skv_render_style *style,
                             const skv_hand *hands, int hand_count, skv_error *error)
{
    SKV_ASSERT_OR(renderer && world && camera && style, SKV_ERROR_VALUE);
    SKV_ASSERT_INITIALISED(style, STYLE_COOKIE);
    SKV_ASSERT_OR(hand_count == 0 || (hands && hand_count > 0), SKV_ERROR_VALUE);
    SKV_ASSERT_OR(camera->scale > 0 && camera->width > 0 && camera->height > 0, SKV_ERROR_VALUE);
    if (!isfinite(style->pressure_range) || style->pressure_range < 0)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "pressure_range is %g: use 0 (automatic) or a pressure in Pa m",
                        style->pressure_range);

    const skv_terrain *terrain = skv_world_terrain(world);
    const skv_palette *palette = skv_look_palette(style->dark);
    GLint framebuffer = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    set_plain_state();
    skv_result result = skv_walls_update(&renderer->walls, terrain, error);
    if (result == SKV_OK) {
        double range = style->pressure_range > 0 ? style->pressure_range
                                                 : pressure_range(world, &renderer->walls);
        result = skv_splats_draw(&renderer->splats, world, camera, range, error);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)framebuffer);
    glViewport(0, 0, camera->width, camera->height);
    if (result != SKV_OK)
        return result;

    compose(renderer, terrain, camera, palette);
    if (style->tracers)
        result = skv_marks_draw_tracers(&renderer->marks, world, camera, palette, error);
    if (result == SKV_OK && hand_count > 0)
        result = skv_marks_draw_hands(&renderer->marks, hands, hand_count, camera, palette, error);
    return result;
}
