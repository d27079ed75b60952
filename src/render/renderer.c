/* Renderer: pass one into the splat textures, pass two into the caller's framebuffer, strokes on
 * top. Invariant: between calls no state of the context matters, every call sets what it needs; the
 * framebuffer that was bound is bound again afterwards, with the viewport on the camera's view. */
#include "render/renderer.h"

#include <math.h>

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "render/compose.h"
#include "render/overlays.h"
#include "render/style.h"

struct skv_renderer {
    bool software;
    skv_vertices vertices;
    skv_splats splats;
    skv_walls walls;
    skv_compose compose;
    skv_strokes strokes;
};

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
    renderer->software = skv_gl_is_software();
    skv_result result = skv_compose_create(&renderer->compose, error);
    if (result == SKV_OK)
        result = skv_splats_create(&renderer->splats, half_float, error);
    if (result == SKV_OK)
        result = skv_strokes_create(&renderer->strokes, error);
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
    skv_compose_destroy(&renderer->compose);
    skv_vertices_destroy(&renderer->vertices);
    skv_splats_destroy(&renderer->splats);
    skv_walls_destroy(&renderer->walls);
    skv_strokes_destroy(&renderer->strokes);
    skv_free(renderer);
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
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

static skv_result check_style(const skv_render_style *style, skv_error *error)
{
    if (!isfinite(style->range) || style->range < 0)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "range is %g: use 0 (automatic) or the upper end of the view's scale",
                        style->range);
    return SKV_OK;
}

/* Whatever the style does not leave open. */
static bool is_full(const skv_renderer *renderer, const skv_render_style *style)
{
    if (style->view == SKV_VIEW_FLUID || style->detail == SKV_DETAIL_PLAIN)
        return false;
    return style->detail == SKV_DETAIL_FULL || !renderer->software;
}

/* Everything that stands over walls and fluid. */
static skv_result draw_overlays(skv_renderer *renderer, const skv_overlay_scene *scene,
                                unsigned overlays, const skv_mark *marks, int mark_count,
                                skv_error *error)
{
    skv_strokes *strokes = &renderer->strokes;
    skv_result result = skv_overlays_add(strokes, scene, overlays, error);
    if (result == SKV_OK)
        result = skv_overlays_add_marks(strokes, scene, marks, mark_count, error);
    if (result == SKV_OK)
        skv_strokes_draw(strokes, scene->camera->width, scene->camera->height);
    return result;
}

skv_result skv_renderer_draw(skv_renderer *renderer, const skv_frame *frame,
                             const skv_camera *camera, const skv_render_style *style,
                             const skv_mark *marks, int mark_count, skv_error *error)
{
    SKV_ASSERT_OR(renderer && frame && camera && style, SKV_ERROR_VALUE);
    skv_render_style own = skv_default_render_style();
    SKV_ASSERT_INITIALISED(style, skv_def_open(style, &own, sizeof own), SKV_ERROR_VALUE);
    SKV_ASSERT_OR(mark_count == 0 || (marks && mark_count > 0), SKV_ERROR_VALUE);
    SKV_ASSERT_OR(camera->scale > 0 && camera->width > 0 && camera->height > 0, SKV_ERROR_VALUE);
    skv_result result = check_style(style, error);
    if (result != SKV_OK)
        return result;

    bool full = is_full(renderer, style);
    /* Foam is a small part of a sum, less than bytes can tell. */
    bool foam = full && style->view == SKV_VIEW_WATER && renderer->splats.half_float;
    skv_legend legend = skv_render_legend(frame, style);
    skv_vertices *vertices = &renderer->vertices;
    GLint framebuffer = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    set_plain_state();
    result = skv_walls_update(&renderer->walls, frame->terrain, error);
    if (result == SKV_OK)
        result = skv_vertices_fill(vertices, frame, style->view, &legend,
                                   skv_look_colors(style->palette), foam, renderer->walls.version,
                                   error);
    if (result == SKV_OK)
        result = skv_splats_draw(&renderer->splats, vertices, (double)frame->spacing, camera, full,
                                 error);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)framebuffer);
    glViewport(0, 0, camera->width, camera->height);
    if (result != SKV_OK)
        return result;

    skv_composition picture = {.frame = frame,
                               .camera = camera,
                               .view = style->view,
                               .colors = skv_look_colors(style->palette),
                               .legend = &legend,
                               .slope = vertices->slope,
                               .full = full};
    result =
        skv_compose_draw(&renderer->compose, &renderer->splats, &renderer->walls, &picture, error);
    if (result != SKV_OK)
        return result;
    skv_overlay_scene scene = {.frame = frame,
                               .camera = camera,
                               .vertices = vertices,
                               .colors = picture.colors,
                               .palette = style->palette,
                               .view = style->view,
                               .legend = &legend,
                               .comma = style->comma};
    return draw_overlays(renderer, &scene, style->overlays, marks, mark_count, error);
}
