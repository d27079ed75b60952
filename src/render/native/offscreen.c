/* Offscreen: an EGL context without a display, and a framebuffer of its own. Invariant: a live
 * offscreen has a context, a renderer made in it, and a complete framebuffer of its size. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "render/gl.h"
#include "skvalp/render.h"

#define LARGEST_SIDE 16384
#define MOST_DEVICES 16

struct skv_offscreen {
    int width, height;
    EGLDisplay display;
    EGLContext context;
    EGLSurface surface; /* a token where the display knows no contexts without one */
    GLuint framebuffer, color;
    uint8_t *rows; /* RGBA as read, bottom row first */
    skv_renderer *renderer;
};

static bool listed(const char *extensions, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = extensions; at && (at = strstr(at, name)); at += length)
        if ((at == extensions || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static bool start(EGLDisplay display)
{
    return display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL);
}

/* The first device that starts, hardware before software as EGL lists them. */
static EGLDisplay device_display(PFNEGLGETPLATFORMDISPLAYEXTPROC get_display)
{
    PFNEGLQUERYDEVICESEXTPROC query =
        (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    EGLDeviceEXT devices[MOST_DEVICES];
    EGLint count = 0;
    if (!query || !query(MOST_DEVICES, devices, &count))
        return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; i++) {
        EGLDisplay display = get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL);
        if (start(display))
            return display;
    }
    return EGL_NO_DISPLAY;
}

/* A display that needs no window system, or as a last resort the default one. Displays are shared
 * by the whole process, so they are never terminated here: another offscreen, or the program's
 * own window, may live on the same one. */
static EGLDisplay find_display(void)
{
    const char *extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    EGLDisplay display = EGL_NO_DISPLAY;
    if (get_display && listed(extensions, "EGL_MESA_platform_surfaceless")) {
        display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
        if (start(display))
            return display;
    }
    if (get_display && listed(extensions, "EGL_EXT_platform_device")) {
        display = device_display(get_display);
        if (display != EGL_NO_DISPLAY)
            return display;
    }
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return start(display) ? display : EGL_NO_DISPLAY;
}

static bool find_config(EGLDisplay display, bool surfaceless, EGLConfig *config)
{
    const EGLint wanted[] = {EGL_SURFACE_TYPE, surfaceless ? EGL_DONT_CARE : EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
    EGLint count = 0;
    return eglChooseConfig(display, wanted, config, 1, &count) && count > 0;
}

static skv_result make_context(skv_offscreen *offscreen, skv_error *error)
{
    EGLDisplay display = offscreen->display = find_display();
    if (display == EGL_NO_DISPLAY)
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "no EGL display for pictures: install a graphics driver "
                        "(Debian: libegl1 libgl1-mesa-dri)");
    bool surfaceless =
        listed(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
    EGLConfig config;
    if (!eglBindAPI(EGL_OPENGL_ES_API) || !find_config(display, surfaceless, &config))
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "EGL offers no OpenGL ES 3.0 on this machine: install a newer driver "
                        "(Debian: libgl1-mesa-dri)");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    const EGLint tiny[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    if (!surfaceless)
        offscreen->surface = eglCreatePbufferSurface(display, config, tiny);
    offscreen->context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (offscreen->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(display, offscreen->surface, offscreen->surface, offscreen->context))
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "EGL could not make an OpenGL ES 3.0 context (error 0x%x)",
                        (unsigned)eglGetError());
    return SKV_OK;
}

static skv_result make_framebuffer(skv_offscreen *offscreen, skv_error *error)
{
    GLint largest = 0, view[2] = {0, 0};
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, view);
    for (int i = 0; i < 2; i++)
        largest = view[i] < largest ? view[i] : largest;
    if (offscreen->width > largest || offscreen->height > largest)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "a picture of %d x %d is larger than this device draws: use at most %d",
                        offscreen->width, offscreen->height, (int)largest);
    glGenFramebuffers(1, &offscreen->framebuffer);
    glGenRenderbuffers(1, &offscreen->color);
    glBindRenderbuffer(GL_RENDERBUFFER, offscreen->color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, offscreen->width, offscreen->height);
    glBindFramebuffer(GL_FRAMEBUFFER, offscreen->framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              offscreen->color);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return skv_fail(error, SKV_ERROR_MEMORY,
                        "the graphics device has no room for a picture of %d x %d",
                        offscreen->width, offscreen->height);
    return SKV_OK;
}

skv_result skv_offscreen_create(int width, int height, skv_offscreen **offscreen, skv_error *error)
{
    SKV_ASSERT_OR(offscreen, SKV_ERROR_VALUE);
    *offscreen = NULL;
    if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "a picture of %d x %d cannot be drawn: use 1 to %d pixels a side", width,
                        height, LARGEST_SIDE);
    skv_offscreen *made = skv_calloc(1, sizeof *made);
    if (made)
        made->rows = skv_calloc((size_t)width * (size_t)height, 4);
    if (!made || !made->rows) {
        skv_free(made);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a picture of %d x %d", width,
                        height);
    }
    made->width = width;
    made->height = height;
    made->display = EGL_NO_DISPLAY;
    made->context = EGL_NO_CONTEXT;
    made->surface = EGL_NO_SURFACE;
    skv_result result = make_context(made, error);
    if (result == SKV_OK)
        result = make_framebuffer(made, error);
    if (result == SKV_OK)
        result = skv_renderer_create(&made->renderer, error);
    if (result != SKV_OK) {
        skv_offscreen_destroy(made);
        return result;
    }
    *offscreen = made;
    return SKV_OK;
}

static bool make_current(const skv_offscreen *offscreen)
{
    return offscreen->context != EGL_NO_CONTEXT && eglBindAPI(EGL_OPENGL_ES_API) &&
           eglMakeCurrent(offscreen->display, offscreen->surface, offscreen->surface,
                          offscreen->context);
}

void skv_offscreen_destroy(skv_offscreen *offscreen)
{
    if (!offscreen)
        return;
    if (make_current(offscreen)) {
        skv_renderer_destroy(offscreen->renderer);
        glDeleteFramebuffers(1, &offscreen->framebuffer);
        glDeleteRenderbuffers(1, &offscreen->color);
    }
    if (offscreen->context != EGL_NO_CONTEXT)
        eglDestroyContext(offscreen->display, offscreen->context);
    if (offscreen->surface != EGL_NO_SURFACE)
        eglDestroySurface(offscreen->display, offscreen->surface);
    /* The context goes now, and what EGL keeps of the thread: of one that outlives main, libglvnd
     * would free it twice. */
    eglReleaseThread();
    skv_free(offscreen->rows);
    skv_free(offscreen);
}

/* GL's bottom row first with alpha to top row first without. */
static void copy_flipped(const skv_offscreen *offscreen, uint8_t *rgb)
{
    size_t width = (size_t)offscreen->width, height = (size_t)offscreen->height;
    for (size_t j = 0; j < height; j++) {
        const uint8_t *from = offscreen->rows + (height - 1 - j) * width * 4;
        uint8_t *to = rgb + j * width * 3;
        for (size_t i = 0; i < width; i++)
            memcpy(to + 3 * i, from + 4 * i, 3);
    }
}

skv_result skv_offscreen_render(skv_offscreen *offscreen, const skv_frame *frame,
                                const skv_render_style *style, uint8_t *rgb, skv_error *error)
{
    SKV_ASSERT_OR(offscreen && frame && style && rgb, SKV_ERROR_VALUE);
    if (!make_current(offscreen))
        return skv_fail(error, SKV_ERROR_DEVICE, "the graphics device was lost (EGL error 0x%x)",
                        (unsigned)eglGetError());
    const skv_terrain *terrain = frame->terrain;
    skv_camera camera = skv_camera_fit(offscreen->width, offscreen->height,
                                       skv_terrain_width(terrain), skv_terrain_height(terrain));
    glBindFramebuffer(GL_FRAMEBUFFER, offscreen->framebuffer);
    skv_render_style chosen = *style;
    if (chosen.detail == SKV_DETAIL_AUTO)
        chosen.detail = SKV_DETAIL_FULL;
    skv_result result =
        skv_renderer_draw(offscreen->renderer, frame, &camera, &chosen, NULL, 0, error);
    if (result != SKV_OK)
        return result;
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, offscreen->width, offscreen->height, GL_RGBA, GL_UNSIGNED_BYTE,
                 offscreen->rows);
    GLenum state = glGetError();
    if (state != GL_NO_ERROR)
        return skv_fail(error, SKV_ERROR_DEVICE,
                        "the graphics device failed to draw a picture of %d x %d (GL error 0x%x)",
                        offscreen->width, offscreen->height, (unsigned)state);
    copy_flipped(offscreen, rgb);
    return SKV_OK;
}
