/* Splats: particles added up in a texture of about a quarter of the view's resolution. Invariant:
 * the arrays hold `capacity` elements, the first `count` of which describe what was drawn last. */
#include "render/splats.h"

#include <math.h>

#include "base/memory.h"
#include "render/look.h"
#include "render/shaders.h"

/* Bounds of a splat's radius in texels: below, its shape is lost; above, a coarser texture shows
 * the same at a fraction of the cost (and every device draws points of that size). */
#define SMALLEST_RADIUS 3.0
#define LARGEST_RADIUS  16.0

/* Pressure flickers from frame to frame where the fluid does not; what is shown follows it with
 * this time constant, in simulated seconds. */
#define PRESSURE_SMOOTHING 0.06

/* The layer of particles that touches a wall, in spacings, carries the wall's push alone and shows
 * about twice the pressure of the fluid behind it. It counts half, and next to other fluid hardly
 * at all, so that the colour is the fluid's. */
#define FIRST_LAYER 0.85f
#define WALL_SHARE  0.5f
#define WALL_TRUST  0.05f

#define VERTEX_FLOATS 4

/* Bytes hold at most this many splats on top of each other. */
#define BYTE_SPLATS 12.0

skv_result skv_splats_create(skv_splats *splats, bool half_float, skv_error *error)
{
    *splats = (skv_splats){.half_float = half_float, .gain = half_float ? 1 : 1 / BYTE_SPLATS};
    skv_result result = skv_gl_program("splat", skv_shader_splat_vert, skv_shader_splat_frag,
                                       &splats->program, error);
    if (result != SKV_OK)
        return result;
    glGenVertexArrays(1, &splats->attributes);
    glGenBuffers(1, &splats->buffer);
    glGenFramebuffers(1, &splats->framebuffer);
    splats->texture = skv_gl_texture();

    GLsizei stride = VERTEX_FLOATS * sizeof(float);
    glBindVertexArray(splats->attributes);
    glBindBuffer(GL_ARRAY_BUFFER, splats->buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, (void *)0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, (void *)(2 * sizeof(float)));
    glBindVertexArray(0);
    return SKV_OK;
}

void skv_splats_destroy(skv_splats *splats)
{
    glDeleteProgram(splats->program);
    glDeleteVertexArrays(1, &splats->attributes);
    glDeleteBuffers(1, &splats->buffer);
    glDeleteFramebuffers(1, &splats->framebuffer);
    glDeleteTextures(1, &splats->texture);
    skv_free(splats->ids);
    skv_free(splats->pressures);
    skv_free(splats->vertices);
    *splats = (skv_splats){0};
}

static skv_result grow(skv_splats *splats, int count, skv_error *error)
{
    if (count <= splats->capacity)
        return SKV_OK;
    size_t capacity = (size_t)count + (size_t)count / 2;
    uint32_t *ids = skv_calloc(capacity, sizeof *ids);
    float *pressures = skv_calloc(capacity, sizeof *pressures);
    float *vertices = skv_calloc(capacity, VERTEX_FLOATS * sizeof *vertices);
    if (!ids || !pressures || !vertices) {
        skv_free(ids);
        skv_free(pressures);
        skv_free(vertices);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the picture of %d particles",
                        count);
    }
    skv_free(splats->ids);
    skv_free(splats->pressures);
    skv_free(splats->vertices);
    splats->ids = ids;
    splats->pressures = pressures;
    splats->vertices = vertices;
    splats->capacity = (int)capacity;
    splats->count = 0;
    glBindBuffer(GL_ARRAY_BUFFER, splats->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(capacity * VERTEX_FLOATS * sizeof *vertices), NULL,
                 GL_STREAM_DRAW);
    return SKV_OK;
}

/* Follows the particles' pressures and writes their vertices. The same world at the same time
 * gives the same vertices however often it is drawn. */
static void refresh(skv_splats *splats, const skv_world *world, double pressure_range)
{
    skv_particles particles = skv_world_particles(world);
    double passed = skv_world_time(world) - splats->time;
    bool known = world == splats->world && passed >= 0;
    float share = known ? (float)(1 - exp(-passed / PRESSURE_SMOOTHING)) : 1;
    const skv_terrain *terrain = skv_world_terrain(world);
    float first_layer = FIRST_LAYER * skv_world_spacing(world);
    float to_range = (float)(1 / pressure_range);
    for (int i = 0; i < particles.count; i++) {
        bool same = i < splats->count && splats->ids[i] == particles.id[i];
        float pressure = particles.pressure[i];
        if (same)
            pressure = splats->pressures[i] + share * (pressure - splats->pressures[i]);
        splats->ids[i] = particles.id[i];
        splats->pressures[i] = pressure;
        float *vertex = &splats->vertices[VERTEX_FLOATS * i];
        vertex[0] = particles.x[i];
        vertex[1] = particles.y[i];
        bool touches = skv_terrain_distance(terrain, vertex[0], vertex[1]) < first_layer;
        float shown = pressure * to_range * (touches ? WALL_SHARE : 1);
        vertex[2] = fminf(fmaxf(shown, 0), 1.5f);
        vertex[3] = touches ? WALL_TRUST : 1;
    }
    splats->count = particles.count;
    splats->world = world;
    splats->time = skv_world_time(world);
    glBindBuffer(GL_ARRAY_BUFFER, splats->buffer);
    glBufferSubData(GL_ARRAY_BUFFER, 0,
                    (GLsizeiptr)particles.count * VERTEX_FLOATS * (GLsizeiptr)sizeof(float),
                    splats->vertices);
}

/* Makes the texture fit the view and the splats; *radius is in texels. */
static skv_result fit(skv_splats *splats, const skv_world *world, const skv_camera *camera,
                      double *radius, skv_error *error)
{
    double spacing = skv_world_spacing(world) * camera->scale;
    double texels = 0.25;
    while (texels < 1 && SKV_SPLAT_RADIUS * spacing * texels < SMALLEST_RADIUS)
        texels *= 2;
    while (texels > 1.0 / 256 && SKV_SPLAT_RADIUS * spacing * texels > LARGEST_RADIUS)
        texels /= 2;
    *radius = fmax(SKV_SPLAT_RADIUS * spacing * texels, SMALLEST_RADIUS);

    /* Where splats are wider than usual because particles are smaller than pixels, the sums grow
     * with their area. */
    double widened = *radius / (SKV_SPLAT_RADIUS * spacing * texels);
    splats->crowd = widened * widened;
    splats->reach = *radius / texels;

    int margin = (int)ceil(*radius) + 2;
    skv_gl_target target = {.width = (int)ceil(camera->width * texels) + 2 * margin,
                            .height = (int)ceil(camera->height * texels) + 2 * margin,
                            .texels = texels,
                            .margin = margin};
    bool same = target.width == splats->target.width && target.height == splats->target.height;
    splats->target = target;
    glBindFramebuffer(GL_FRAMEBUFFER, splats->framebuffer);
    if (same)
        return SKV_OK;
    glBindTexture(GL_TEXTURE_2D, splats->texture);
    if (splats->half_float)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, target.width, target.height, 0, GL_RGBA,
                     GL_HALF_FLOAT, NULL);
    else
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, target.width, target.height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, NULL);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, splats->texture, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return SKV_OK;
    splats->target = (skv_gl_target){0};
    return skv_fail(error, SKV_ERROR_DEVICE,
                    "the graphics device cannot draw into a %d x %d texture: make the view smaller",
                    target.width, target.height);
}

skv_result skv_splats_draw(skv_splats *splats, const skv_world *world, const skv_camera *camera,
                           double pressure_range, skv_error *error)
{
    double radius;
    skv_result result = grow(splats, skv_world_particle_count(world), error);
    if (result == SKV_OK)
        result = fit(splats, world, camera, &radius, error);
    if (result != SKV_OK)
        return result;
    refresh(splats, world, pressure_range);

    glViewport(0, 0, splats->target.width, splats->target.height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(splats->program);
    skv_gl_set_transform(splats->program, camera, &splats->target);
    glUniform1f(glGetUniformLocation(splats->program, "u_diameter"), (float)(2 * radius));
    glUniform1f(glGetUniformLocation(splats->program, "u_gain"), (float)splats->gain);
    glBindVertexArray(splats->attributes);
    glDrawArrays(GL_POINTS, 0, splats->count);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    return SKV_OK;
}
