/* Mesh: sums over particles on a coarse grid. Invariant: between begin and the next begin all
 * arrays have columns * rows cells, and every point of the world lies between four of them. */
#include "render/mesh.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "render/bodies.h"

#define CELL_SPACINGS 2.0
/* A wide world with few particles gets larger cells: nobody looks that closely. */
#define MOST_CELLS 200000.0
#define ARRAYS     7
#define FILLED     0.05f /* a cell with less fluid than that is air */
#define IN_WALL    0.5f  /* the room of a cell whose centre lies on a wall */

void skv_mesh_destroy(skv_mesh *mesh)
{
    skv_free(mesh->room);
    *mesh = (skv_mesh){0};
}

static skv_result grow(skv_mesh *mesh, int cells, skv_error *error)
{
    if (cells <= mesh->capacity)
        return SKV_OK;
    float *memory = skv_calloc((size_t)cells * ARRAYS, sizeof *memory);
    if (!memory)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a mesh of %d cells", cells);
    skv_free(mesh->room);
    mesh->capacity = cells;
    mesh->walls_key = 0;
    float **arrays[ARRAYS] = {&mesh->room,  &mesh->weight, &mesh->vx,   &mesh->vy,
                              &mesh->value, &mesh->trust,  &mesh->depth};
    for (int i = 0; i < ARRAYS; i++)
        *arrays[i] = memory + (size_t)i * (size_t)cells;
    return SKV_OK;
}

static float centre(const skv_mesh *mesh, int index)
{
    return ((float)index - 0.5f) * mesh->cell;
}

/* How much of the fluid in reach of a cell's centre fits beside a straight wall at that distance;
 * particles spread over a cell on each side, less with the distance. */
static float room_beside(float distance, float cell)
{
    float t = fminf(fmaxf(distance / cell, -1), 1);
    return t > 0 ? 1 - 0.5f * (1 - t) * (1 - t) : 0.5f * (1 + t) * (1 + t);
}

static void find_room(skv_mesh *mesh)
{
    float known = SKV_TERRAIN_REACH * skv_terrain_pixel_size(mesh->frame->terrain);
    for (int j = 0; j < mesh->rows; j++)
        for (int i = 0; i < mesh->columns; i++) {
            float distance =
                skv_terrain_distance(mesh->frame->terrain, centre(mesh, i), centre(mesh, j));
            mesh->room[j * mesh->columns + i] =
                distance < 0.98f * known ? room_beside(distance, mesh->cell) : 1;
        }
}

/* The first cell whose centre is at a coordinate or beyond; at most `count`. */
static int cell_at(const skv_mesh *mesh, float at, int count)
{
    return (int)fminf(fmaxf(ceilf(at / mesh->cell + 0.5f), 0), (float)count);
}

/* Leaves no room in bodies. */
static void cut_bodies(skv_mesh *mesh)
{
    for (int k = 0; k < mesh->frame->body_count; k++) {
        skv_placed_body body = skv_body_place(&mesh->frame->bodies[k]);
        int first = cell_at(mesh, body.left - mesh->cell, mesh->columns);
        int end = cell_at(mesh, body.right + mesh->cell, mesh->columns);
        int top = cell_at(mesh, body.high + mesh->cell, mesh->rows);
        for (int j = cell_at(mesh, body.low - mesh->cell, mesh->rows); j < top; j++)
            for (int i = first; i < end; i++) {
                float *room = &mesh->room[j * mesh->columns + i];
                float distance = skv_placed_body_distance(&body, centre(mesh, i), centre(mesh, j));
                *room = fminf(*room, room_beside(distance, mesh->cell));
            }
    }
}

skv_result skv_mesh_begin(skv_mesh *mesh, const skv_frame *frame, uint64_t walls_key,
                          skv_error *error)
{
    double width = (double)skv_terrain_width(frame->terrain);
    double height = (double)skv_terrain_height(frame->terrain);
    double cell = fmax(CELL_SPACINGS * (double)frame->spacing, sqrt(width * height / MOST_CELLS));
    /* One on each side, and one for values that are shifted. */
    int columns = (int)ceil(width / cell) + 3, rows = (int)ceil(height / cell) + 3;
    skv_result result = grow(mesh, columns * rows, error);
    if (result != SKV_OK)
        return result;
    bool same = walls_key == mesh->walls_key && !mesh->bodies && columns == mesh->columns &&
                rows == mesh->rows && (float)cell == mesh->cell;
    mesh->frame = frame;
    mesh->columns = columns;
    mesh->rows = rows;
    mesh->cell = (float)cell;
    mesh->per_cell = (float)(cell * cell / ((double)frame->spacing * (double)frame->spacing));
    mesh->walls_key = walls_key;
    if (!same)
        find_room(mesh);
    mesh->bodies = frame->body_count > 0;
    if (mesh->bodies)
        cut_bodies(mesh);
    size_t bytes = (size_t)(columns * rows) * sizeof(float);
    float *const sums[] = {mesh->weight, mesh->vx, mesh->vy};
    for (int i = 0; i < 3; i++)
        memset(sums[i], 0, bytes);
    return SKV_OK;
}

void skv_mesh_begin_values(skv_mesh *mesh, float shift)
{
    mesh->shift = shift;
    size_t bytes = (size_t)(mesh->columns * mesh->rows) * sizeof(float);
    memset(mesh->value, 0, bytes);
    memset(mesh->trust, 0, bytes);
}

static skv_mesh_place locate(const skv_mesh *mesh, float x, float y, float shift)
{
    float from = 0.5f + shift;
    float across = fminf(fmaxf(x / mesh->cell + from, 0), (float)(mesh->columns - 2));
    float upwards = fminf(fmaxf(y / mesh->cell + from, 0), (float)(mesh->rows - 2));
    int i = (int)across, j = (int)upwards;
    return (skv_mesh_place){j * mesh->columns + i, across - (float)i, upwards - (float)j};
}

skv_mesh_place skv_mesh_locate(const skv_mesh *mesh, float x, float y)
{
    return locate(mesh, x, y, 0);
}

/* The shares of the four cells. */
static void shares(skv_mesh_place place, float share[4])
{
    share[0] = (1 - place.right) * (1 - place.up);
    share[1] = place.right * (1 - place.up);
    share[2] = (1 - place.right) * place.up;
    share[3] = place.right * place.up;
}

static void add(const skv_mesh *mesh, float *sums, skv_mesh_place place, const float share[4],
                float amount)
{
    float *row = sums + place.cell;
    row[0] += share[0] * amount;
    row[1] += share[1] * amount;
    row[mesh->columns] += share[2] * amount;
    row[mesh->columns + 1] += share[3] * amount;
}

static float mean(const skv_mesh *mesh, const float *sums, skv_mesh_place place,
                  const float share[4])
{
    const float *row = sums + place.cell;
    return share[0] * row[0] + share[1] * row[1] + share[2] * row[mesh->columns] +
           share[3] * row[mesh->columns + 1];
}

void skv_mesh_add_motion(skv_mesh *mesh)
{
    const skv_particles particles = mesh->frame->particles;
    for (int i = 0; i < particles.count; i++) {
        float share[4];
        skv_mesh_place place = skv_mesh_locate(mesh, particles.x[i], particles.y[i]);
        shares(place, share);
        add(mesh, mesh->weight, place, share, 1);
        add(mesh, mesh->vx, place, share, particles.vx[i]);
        add(mesh, mesh->vy, place, share, particles.vy[i]);
    }
}

void skv_mesh_add_value(skv_mesh *mesh, float x, float y, float value, float trust)
{
    float share[4];
    skv_mesh_place place = locate(mesh, x, y, mesh->shift);
    shares(place, share);
    add(mesh, mesh->value, place, share, value * trust);
    add(mesh, mesh->trust, place, share, trust);
}

float skv_mesh_value(const skv_mesh *mesh, float x, float y, float fallback)
{
    float share[4];
    skv_mesh_place place = locate(mesh, x, y, mesh->shift);
    shares(place, share);
    float trust = mean(mesh, mesh->trust, place, share);
    return trust > 0 ? mean(mesh, mesh->value, place, share) / trust : fallback;
}

float skv_mesh_density(const skv_mesh *mesh, float x, float y)
{
    float share[4];
    skv_mesh_place place = skv_mesh_locate(mesh, x, y);
    shares(place, share);
    float room = mean(mesh, mesh->room, place, share) * mesh->per_cell;
    return room > 0 ? mean(mesh, mesh->weight, place, share) / room : 1;
}

bool skv_mesh_velocity(const skv_mesh *mesh, float x, float y, float *vx, float *vy)
{
    float share[4];
    skv_mesh_place place = skv_mesh_locate(mesh, x, y);
    shares(place, share);
    float weight = mean(mesh, mesh->weight, place, share);
    bool there = weight > 0.25f * mesh->per_cell;
    *vx = weight > 0 ? mean(mesh, mesh->vx, place, share) / weight : 0;
    *vy = weight > 0 ? mean(mesh, mesh->vy, place, share) / weight : 0;
    return there;
}

/* Depth: the eikonal equation |grad depth| = fill, solved by sweeping over the grid in the four
 * diagonal directions (Godunov's upwind scheme). Since a cell's fill grows smoothly as particles
 * enter it, so does the depth: nothing flickers. */

static float one_step(float across, float upwards, float step)
{
    float low = fminf(across, upwards);
    if (low == FLT_MAX)
        return FLT_MAX;
    if (fabsf(across - upwards) >= step)
        return low + step;
    float difference = across - upwards;
    return 0.5f * (across + upwards + sqrtf(2 * step * step - difference * difference));
}

static void sweep(skv_mesh *mesh, int di, int dj)
{
    int columns = mesh->columns, rows = mesh->rows;
    float *depth = mesh->depth;
    for (int n = 0; n < rows; n++) {
        int j = dj > 0 ? n : rows - 1 - n;
        for (int m = 0; m < columns; m++) {
            int i = di > 0 ? m : columns - 1 - m, at = j * columns + i;
            if (mesh->room[at] <= IN_WALL || depth[at] == 0)
                continue;
            float left = i > 0 ? depth[at - 1] : FLT_MAX;
            float right = i + 1 < columns ? depth[at + 1] : FLT_MAX;
            float below = j > 0 ? depth[at - columns] : FLT_MAX;
            float above = j + 1 < rows ? depth[at + columns] : FLT_MAX;
            float fill = fminf(mesh->weight[at] / (mesh->per_cell * mesh->room[at]), 1);
            float found = one_step(fminf(left, right), fminf(below, above), fill * mesh->cell);
            depth[at] = fminf(depth[at], found);
        }
    }
}

void skv_mesh_find_depth(skv_mesh *mesh)
{
    for (int at = 0; at < mesh->columns * mesh->rows; at++) {
        bool air = mesh->room[at] > IN_WALL && mesh->weight[at] < FILLED * mesh->per_cell;
        mesh->depth[at] = air ? 0 : FLT_MAX;
    }
    for (int round = 0; round < 2; round++) {
        sweep(mesh, 1, 1);
        sweep(mesh, -1, 1);
        sweep(mesh, -1, -1);
        sweep(mesh, 1, -1);
    }
}

float skv_mesh_depth(const skv_mesh *mesh, float x, float y)
{
    float share[4], sum = 0, weight = 0;
    skv_mesh_place place = skv_mesh_locate(mesh, x, y);
    shares(place, share);
    for (int k = 0; k < 4; k++) {
        int at = place.cell + (k & 1) + (k >> 1) * mesh->columns;
        if (mesh->depth[at] < FLT_MAX) {
            sum += share[k] * mesh->depth[at];
            weight += share[k];
        }
    }
    return weight > 0 ? sum / weight : FLT_MAX;
}
