/* Marks: discs and rings, one instanced quad each. Invariant: `instances` and the buffer hold
 * `capacity` marks. */
#include "render/marks.h"

#include <math.h>

#include "base/memory.h"
#include "render/shaders.h"

skv_result skv_marks_create(skv_marks *marks, skv_error *error)
{
    *marks = (skv_marks){0};
    skv_result result =
        skv_gl_program("mark", skv_shader_mark_vert, skv_shader_mark_frag, &marks->program, error);
    if (result != SKV_OK)
        return result;
    glGenVertexArrays(1, &marks->attributes);
    glGenBuffers(1, &marks->buffer);
    glBindVertexArray(marks->attributes);
    glBindBuffer(GL_ARRAY_BUFFER, marks->buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), (void *)0);
    glVertexAttribDivisor(0, 1);
    glBindVertexArray(0);
    return SKV_OK;
}

void skv_marks_destroy(skv_marks *marks)
{
    glDeleteProgram(marks->program);
    glDeleteVertexArrays(1, &marks->attributes);
    glDeleteBuffers(1, &marks->buffer);
    skv_free(marks->instances);
    *marks = (skv_marks){0};
}

static skv_result grow(skv_marks *marks, int count, skv_error *error)
{
    if (count <= marks->capacity)
        return SKV_OK;
    size_t capacity = (size_t)count + (size_t)count / 2;
    float *instances = skv_calloc(capacity, 3 * sizeof *instances);
    if (!instances)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d marks in the picture",
                        count);
    skv_free(marks->instances);
    marks->instances = instances;
    marks->capacity = (int)capacity;
    glBindBuffer(GL_ARRAY_BUFFER, marks->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(capacity * 3 * sizeof *instances), NULL,
                 GL_STREAM_DRAW);
    return SKV_OK;
}

static void put(skv_marks *marks, int i, float x, float y, float radius)
{
    marks->instances[3 * i] = x;
    marks->instances[3 * i + 1] = y;
    marks->instances[3 * i + 2] = radius;
}

/* `line` in view pixels, `inner` the share of the colour inside of it. */
static void draw(const skv_marks *marks, int count, const skv_camera *camera, const float color[4],
                 double line, double inner)
{
    skv_gl_target view = {.width = camera->width, .height = camera->height, .texels = 1};
    GLuint program = marks->program;
    glBindBuffer(GL_ARRAY_BUFFER, marks->buffer);
    glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)count * 3 * (GLsizeiptr)sizeof(float),
                    marks->instances);
    glUseProgram(program);
    skv_gl_set_transform(program, camera, &view);
    glUniform1f(glGetUniformLocation(program, "u_pixels"), (float)camera->scale);
    glUniform4fv(glGetUniformLocation(program, "u_color"), 1, color);
    glUniform1f(glGetUniformLocation(program, "u_line"), (float)line);
    glUniform1f(glGetUniformLocation(program, "u_inner"), (float)inner);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(marks->attributes);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
}

/* One particle in ten; hashed, because every tenth of a lattice would stand in rows. */
static bool is_tracer(uint32_t id)
{
    uint32_t hash = id * 0x9e3779b1u;
    hash = (hash ^ (hash >> 15)) * 0x85ebca77u;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae3du;
    return (hash ^ (hash >> 16)) % 10 == 0;
}

skv_result skv_marks_draw_tracers(skv_marks *marks, const skv_world *world,
                                  const skv_camera *camera, const skv_palette *palette,
                                  skv_error *error)
{
    skv_particles particles = skv_world_particles(world);
    int count = 0;
    for (int i = 0; i < particles.count; i++)
        count += is_tracer(particles.id[i]);
    skv_result result = grow(marks, count, error);
    if (result != SKV_OK)
        return result;
    /* Never smaller than what can be seen. */
    double radius = fmax(SKV_TRACER_RADIUS * skv_world_spacing(world), 1.2 / camera->scale);
    int next = 0;
    for (int i = 0; i < particles.count; i++)
        if (is_tracer(particles.id[i]))
            put(marks, next++, particles.x[i], particles.y[i], (float)radius);
    draw(marks, count, camera, palette->tracer, 1e6, 1);
    return SKV_OK;
}

skv_result skv_marks_draw_hands(skv_marks *marks, const skv_hand *hands, int count,
                                const skv_camera *camera, const skv_palette *palette,
                                skv_error *error)
{
    skv_result result = grow(marks, count, error);
    if (result != SKV_OK)
        return result;
    for (int i = 0; i < count; i++)
        put(marks, i, hands[i].x, hands[i].y, hands[i].radius);
    draw(marks, count, camera, palette->hand, skv_look_line(camera) * 1.5, 0.12);
    return SKV_OK;
}
