/* Vertices: from particles to what they show. Invariant: everything follows from the frame alone,
 * so that a moment looks the same however one came to it. */
#include "render/vertices.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/exact.h"
#include "base/memory.h"

/* Beside a wall particles lie in layers, and the pressure goes up and down from one to the next:
 * the first, this close in spacings, has a quarter more than the fluid behind it, the second less.
 * With this trust in the first they make up for each other. */
#define FIRST_LAYER 0.85f
#define FIRST_TRUST 0.4f

/* Light goes that share of the depth that the fluid may have. */
#define CLARITY 0.28

/* Foam begins, and covers everything, where particles differ so much from the fluid around them;
 * shares of the speed of a fall through that depth. */
#define FOAM_BEGINS 0.04f
#define FOAM_COVERS 0.20f

/* How much of a dyed particle's own colour shows; the rest is its surroundings'. */
#define OWN_COLOR 0.35f

void skv_vertices_destroy(skv_vertices *vertices)
{
    skv_free(vertices->list);
    skv_free(vertices->trusts);
    skv_mesh_destroy(&vertices->mesh);
    *vertices = (skv_vertices){0};
}

static skv_result grow(skv_vertices *vertices, int count, skv_error *error)
{
    if (count <= vertices->capacity)
        return SKV_OK;
    size_t capacity = (size_t)count + (size_t)count / 2;
    skv_vertex *list = skv_calloc(capacity, sizeof *list);
    float *trusts = skv_calloc(capacity, sizeof *trusts);
    if (!list || !trusts) {
        skv_free(list);
        skv_free(trusts);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the picture of %d particles",
                        count);
    }
    skv_free(vertices->list);
    skv_free(vertices->trusts);
    vertices->list = list;
    vertices->trusts = trusts;
    vertices->capacity = (int)capacity;
    return SKV_OK;
}

static bool touches_wall(const skv_frame *frame, int i)
{
    float first_layer = FIRST_LAYER * frame->spacing;
    return skv_terrain_distance(frame->terrain, frame->particles.x[i], frame->particles.y[i]) <
           first_layer;
}

/* Pressure, averaged with the neighbours'. What is averaged is its difference from the pressure of
 * fluid at rest, p - rho g x: beside a wall the neighbours are all on one side, and the average of
 * p itself would be that of a place further in. How layers make up for each other depends on where
 * a cell ends; the mean over two meshes, half a cell apart, hardly does. With one the pressure
 * beside the right wall of a tank was up to 6 % too high, at some numbers of particles. */
static void fill_pressure(skv_vertices *vertices, const skv_frame *frame, double range)
{
    static const float shifts[] = {0, 0.5f};
    const skv_particles particles = frame->particles;
    skv_mesh *mesh = &vertices->mesh;
    double slope_x = (double)frame->density * (double)frame->gravity_x / range;
    double slope_y = (double)frame->density * (double)frame->gravity_y / range;
    double sum = 0, trusted = 0;
    for (int i = 0; i < particles.count; i++) {
        bool touches = touches_wall(frame, i);
        double pressure = (double)particles.pressure[i] / range;
        double rest = slope_x * (double)particles.x[i] + slope_y * (double)particles.y[i];
        vertices->trusts[i] = touches ? FIRST_TRUST : 1;
        vertices->list[i].second = (float)(pressure - rest);
        sum += (double)vertices->trusts[i] * (pressure - rest);
        trusted += (double)vertices->trusts[i];
    }
    /* The mean is taken out too: small numbers are summed up more exactly. */
    double mean = trusted > 0 ? sum / trusted : 0;
    for (int s = 0; s < 2; s++) {
        skv_mesh_begin_values(mesh, shifts[s]);
        for (int i = 0; i < particles.count; i++)
            skv_mesh_add_value(mesh, particles.x[i], particles.y[i],
                               vertices->list[i].second - (float)mean, vertices->trusts[i]);
        for (int i = 0; i < particles.count; i++)
            vertices->list[i].value +=
                0.5f * skv_mesh_value(mesh, particles.x[i], particles.y[i], 0);
    }
    for (int i = 0; i < particles.count; i++) {
        vertices->list[i].value *= vertices->trusts[i];
        vertices->list[i].second = vertices->trusts[i];
    }
    vertices->slope[0] = slope_x;
    vertices->slope[1] = slope_y;
    vertices->slope[2] = mean;
}

static void fill_speed(skv_vertices *vertices, const skv_frame *frame, double range)
{
    const skv_particles particles = frame->particles;
    for (int i = 0; i < particles.count; i++) {
        float speed = hypotf(particles.vx[i], particles.vy[i]);
        vertices->list[i].value = fminf(speed / (float)range, 4);
        vertices->list[i].second = 1;
    }
}

/* Particles per area where there is room for them, as a share of the legend's scale. */
static void fill_density(skv_vertices *vertices, const skv_frame *frame, const skv_legend *legend)
{
    const skv_particles particles = frame->particles;
    float low = (float)legend->low, width = (float)(legend->high - legend->low);
    for (int i = 0; i < particles.count; i++) {
        float density = skv_mesh_density(&vertices->mesh, particles.x[i], particles.y[i]);
        vertices->list[i].value = fminf(fmaxf((density - low) / width, -1), 2);
        vertices->list[i].second = 1;
    }
}

static void fill_depth(skv_vertices *vertices, const skv_frame *frame)
{
    const skv_particles particles = frame->particles;
    skv_mesh_find_depth(&vertices->mesh);
    float per_metre = (float)(1 / (CLARITY * skv_look_depth(frame)));
    for (int i = 0; i < particles.count; i++) {
        float depth = skv_mesh_depth(&vertices->mesh, particles.x[i], particles.y[i]);
        vertices->list[i].value = depth < FLT_MAX ? fminf(per_metre * depth, 4) : 4;
        vertices->list[i].second = 1;
    }
}

/* Foam is where particles do not move as the fluid around them does, on average over them. */
static void fill_foam(skv_vertices *vertices, const skv_frame *frame)
{
    const skv_particles particles = frame->particles;
    skv_mesh *mesh = &vertices->mesh;
    float to_share = (float)(1 / skv_look_speed(frame));
    skv_mesh_begin_values(mesh, 0);
    for (int i = 0; i < particles.count; i++) {
        float vx, vy;
        skv_mesh_velocity(mesh, particles.x[i], particles.y[i], &vx, &vy);
        float apart = hypotf(particles.vx[i] - vx, particles.vy[i] - vy) * to_share;
        skv_mesh_add_value(mesh, particles.x[i], particles.y[i], fminf(apart, 1), 1);
    }
    for (int i = 0; i < particles.count; i++) {
        float apart = skv_mesh_value(mesh, particles.x[i], particles.y[i], 0);
        float foam = (apart - FOAM_BEGINS) / (FOAM_COVERS - FOAM_BEGINS);
        vertices->list[i].second = fminf(fmaxf(foam, 0), 1);
    }
}

/* Adds to what a vertex shows `share` of a colour; colours multiply, as inks do. */
static void add_tint(skv_vertex *vertex, const float taken[3], float share)
{
    for (int k = 0; k < 3; k++)
        vertex->tint[k] = (uint16_t)((float)vertex->tint[k] + 65535 * share * taken[k] + 0.5f);
    vertex->tint[3] = (uint16_t)((float)vertex->tint[3] + 65535 * share + 0.5f);
}

/* A dye shows on the fluid around its particles, too: where it mixes fluid becomes cloudy as with
 * ink, not speckled. */
static void fill_dye(skv_vertices *vertices, const skv_frame *frame, int dye, const float color[3])
{
    const skv_particles particles = frame->particles;
    skv_mesh *mesh = &vertices->mesh;
    float taken[3]; /* share of the most */
    for (int k = 0; k < 3; k++)
        taken[k] = fminf((float)-skv_log((double)color[k]) / SKV_TINT_LIGHT, 1);
    skv_mesh_begin_values(mesh, 0);
    for (int i = 0; i < particles.count; i++)
        skv_mesh_add_value(mesh, particles.x[i], particles.y[i], particles.dye[i] == dye, 1);
    for (int i = 0; i < particles.count; i++) {
        float own = particles.dye[i] == dye;
        float around = skv_mesh_value(mesh, particles.x[i], particles.y[i], 0);
        /* Less than the whole, so that rounding of all dyes stays within it. */
        add_tint(&vertices->list[i], taken, 0.9998f * (around + OWN_COLOR * (own - around)));
    }
}

static void fill_dyes(skv_vertices *vertices, const skv_frame *frame, const skv_colors *colors)
{
    const skv_particles particles = frame->particles;
    bool shown[SKV_DYES + 1] = {false};
    for (int i = 0; particles.dye && i < particles.count; i++)
        shown[particles.dye[i]] = true;
    for (int dye = 1; dye <= SKV_DYES; dye++)
        if (shown[dye]) {
            fill_dye(vertices, frame, dye, colors->dyes[dye - 1]);
            vertices->tinted = true;
        }
}

static void fill_fluids(skv_vertices *vertices, const skv_frame *frame)
{
    const skv_particles particles = frame->particles;
    for (int i = 0; particles.fluid && i < particles.count; i++) {
        vertices->list[i].fluid[0] = particles.fluid[i];
        if (particles.fluid[i] > vertices->last_fluid)
            vertices->last_fluid = particles.fluid[i];
    }
}

skv_result skv_vertices_fill(skv_vertices *vertices, const skv_frame *frame, skv_view view,
                             const skv_legend *legend, const skv_colors *colors, bool foam,
                             uint64_t walls_key, skv_error *error)
{
    const skv_particles particles = frame->particles;
    skv_result result = grow(vertices, particles.count, error);
    if (result == SKV_OK)
        result = skv_mesh_begin(&vertices->mesh, frame, walls_key, error);
    if (result != SKV_OK)
        return result;
    vertices->count = particles.count;
    vertices->foamy = foam;
    vertices->tinted = false;
    vertices->last_fluid = 0;
    for (int k = 0; k < 3; k++)
        vertices->slope[k] = 0;
    for (int i = 0; i < particles.count; i++)
        vertices->list[i] = (skv_vertex){.x = particles.x[i], .y = particles.y[i]};
    skv_mesh_add_motion(&vertices->mesh);
    if (view == SKV_VIEW_PRESSURE)
        fill_pressure(vertices, frame, legend->high);
    else if (view == SKV_VIEW_SPEED)
        fill_speed(vertices, frame, legend->high);
    else if (view == SKV_VIEW_DENSITY)
        fill_density(vertices, frame, legend);
    if (view == SKV_VIEW_WATER || view == SKV_VIEW_FLUID) {
        fill_depth(vertices, frame);
        fill_dyes(vertices, frame, colors);
        fill_fluids(vertices, frame);
    }
    if (foam)
        fill_foam(vertices, frame);
    return SKV_OK;
}
