/* OpenGL ES helpers. Invariant: on failure nothing of what was made is left in the context. */
#include "render/gl.h"

#include <string.h>

#include "render/shaders.h"

static GLuint compile(const char *name, const char *defines, GLenum stage, const char *text,
                      skv_error *error)
{
    const char *parts[] = {"#version 300 es\n", defines, skv_shader_common, text};
    GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 4, parts, NULL);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done)
        return shader;
    char log[256] = "";
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    skv_fail(error, SKV_ERROR_DEVICE, "the graphics driver refused the %s %s shader: %s", name,
             stage == GL_VERTEX_SHADER ? "vertex" : "fragment", log);
    glDeleteShader(shader);
    return 0;
}

static skv_result link_program(const char *name, GLuint program, skv_error *error)
{
    glLinkProgram(program);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (done)
        return SKV_OK;
    char log[256] = "";
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    return skv_fail(error, SKV_ERROR_DEVICE, "the graphics driver refused the %s program: %s", name,
                    log);
}

skv_result skv_gl_program(const char *name, const char *defines, const char *vertex,
                          const char *fragment, GLuint *program, skv_error *error)
{
    *program = 0;
    GLuint first = compile(name, defines, GL_VERTEX_SHADER, vertex, error);
    GLuint second = first ? compile(name, defines, GL_FRAGMENT_SHADER, fragment, error) : 0;
    skv_result result = SKV_ERROR_DEVICE;
    if (second) {
        *program = glCreateProgram();
        glAttachShader(*program, first);
        glAttachShader(*program, second);
        result = link_program(name, *program, error);
    }
    /* Attached shaders live on as long as their program. */
    glDeleteShader(first);
    glDeleteShader(second);
    if (result != SKV_OK) {
        glDeleteProgram(*program);
        *program = 0;
    }
    return result;
}

bool skv_gl_is_software(void)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "SwiftShader", "Software"};
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    for (const char *at = renderer; at && *at; at++)
        for (size_t i = 0; i < sizeof names / sizeof *names; i++)
            if (strncmp(at, names[i], strlen(names[i])) == 0)
                return true;
    return false;
}

bool skv_gl_half_float(void)
{
    GLint major = 0, minor = 0, count = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major > 3 || (major == 3 && minor >= 2))
        return true;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; i++) {
        const char *name = (const char *)glGetStringi(GL_EXTENSIONS, (GLuint)i);
        if (name && (strcmp(name, "GL_EXT_color_buffer_half_float") == 0 ||
                     strcmp(name, "GL_EXT_color_buffer_float") == 0))
            return true;
    }
    return false;
}

void skv_gl_set_transform(GLuint program, const skv_camera *camera, const skv_gl_target *target)
{
    double zoom = camera->scale * target->texels;
    double origin_x = camera->origin_x * target->texels + target->margin;
    double origin_y = (camera->height - camera->origin_y) * target->texels + target->margin;
    glUniform2f(glGetUniformLocation(program, "u_scale"), (float)(2 * zoom / target->width),
                (float)(2 * zoom / target->height));
    glUniform2f(glGetUniformLocation(program, "u_offset"),
                (float)(2 * origin_x / target->width - 1),
                (float)(2 * origin_y / target->height - 1));
}

GLuint skv_gl_texture(void)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}
