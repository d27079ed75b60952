/* Strokes: one instanced quad each. Invariant: `list` holds `capacity` strokes, the first `count`
 * of which wait to be drawn. */
#include "render/strokes.h"

#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "render/shaders.h"

skv_result skv_strokes_create(skv_strokes *strokes, skv_error *error)
{
    *strokes = (skv_strokes){0};
    skv_result result = skv_gl_program("stroke", "", skv_shader_stroke_vert, skv_shader_stroke_frag,
                                       &strokes->program, error);
    if (result != SKV_OK)
        return result;
    glGenVertexArrays(1, &strokes->attributes);
    glGenBuffers(1, &strokes->buffer);
    glBindVertexArray(strokes->attributes);
    glBindBuffer(GL_ARRAY_BUFFER, strokes->buffer);
    const struct {
        GLint size;
        GLenum type;
        size_t offset;
    } parts[] = {{4, GL_FLOAT, offsetof(skv_stroke, x0)},
                 {3, GL_FLOAT, offsetof(skv_stroke, radius)},
                 {4, GL_UNSIGNED_BYTE, offsetof(skv_stroke, color)}};
    for (GLuint i = 0; i < 3; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, parts[i].size, parts[i].type, GL_TRUE, sizeof(skv_stroke),
                              (const void *)parts[i].offset);
        glVertexAttribDivisor(i, 1);
    }
    glBindVertexArray(0);
    return SKV_OK;
}

void skv_strokes_destroy(skv_strokes *strokes)
{
    glDeleteProgram(strokes->program);
    glDeleteVertexArrays(1, &strokes->attributes);
    glDeleteBuffers(1, &strokes->buffer);
    skv_free(strokes->list);
    *strokes = (skv_strokes){0};
}

skv_result skv_strokes_reserve(skv_strokes *strokes, int count, skv_error *error)
{
    int wanted = strokes->count + count;
    if (wanted <= strokes->capacity)
        return SKV_OK;
    size_t capacity = (size_t)wanted + (size_t)wanted / 2;
    skv_stroke *list = skv_calloc(capacity, sizeof *list);
    if (!list)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d strokes in the picture",
                        wanted);
    if (strokes->count)
        memcpy(list, strokes->list, (size_t)strokes->count * sizeof *list);
    skv_free(strokes->list);
    strokes->list = list;
    strokes->capacity = (int)capacity;
    return SKV_OK;
}

void skv_strokes_add(skv_strokes *strokes, skv_stroke stroke)
{
    SKV_ASSERT(strokes->count < strokes->capacity);
    strokes->list[strokes->count++] = stroke;
}

void skv_strokes_draw(skv_strokes *strokes, int width, int height)
{
    int count = strokes->count;
    strokes->count = 0;
    if (!count)
        return;
    glBindBuffer(GL_ARRAY_BUFFER, strokes->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)count * (GLsizeiptr)sizeof(skv_stroke), strokes->list,
                 GL_STREAM_DRAW);
    glUseProgram(strokes->program);
    glUniform2f(glGetUniformLocation(strokes->program, "u_view"), (float)width, (float)height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(strokes->attributes);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
}
