/* Another terrain under a fluid that goes on: walls that were drawn or erased.
 *
 * Invariant: afterwards the world is what it would be if it had been made with that terrain, bit
 * for bit: its walls follow from the picture alone, and what particles remember of distances is
 * forgotten wherever one may have changed. On failure nothing has changed.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "terrain/sample.h"
#include "world/area.h"
#include "world/bodies/bodies.h"
#include "world/remove.h"
#include "world/springs/springs.h"

#include <math.h>

/* Fluid wakes so far from what has changed, in smoothing radii. */
#define WAKES 2.0f

/* Ways along the normal until a surface is met; corners may need a few. */
#define MOST_PUSHES 4

/* Where the pictures of two terrains differ, and how far distances may. */
typedef struct edit {
    skv_squares changed, reached;
} edit;

static skv_result compare(const skv_terrain *a, const skv_terrain *b, edit *e, skv_error *error)
{
    skv_result result = skv_squares_create(a->columns, a->rows, &e->changed, error);
    if (result != SKV_OK)
        return result;
    skv_squares_add_differences(&e->changed, a->coverage, b->coverage, a->columns, a->rows);
    return skv_squares_spread(&e->changed, SKV_TERRAIN_REACH + 2, &e->reached, error);
}

/* Whether a place, or one within `reach` of it, lies in a set; all in metres. */
static bool is_near(const skv_squares *set, const skv_terrain *terrain, float x, float y,
                    float reach)
{
    double gx = (double)skv_to_grid(terrain, x), gy = (double)skv_to_grid(terrain, y);
    double pixels = (double)(reach * terrain->per_metre);
    return skv_squares_meet(set, gx - pixels, gy - pixels, gx + pixels, gy + pixels);
}

/* The box around a set in metres. What lies outside of the picture is near its edge's squares. */
static skv_region region_of(const skv_squares *set, const skv_terrain *terrain)
{
    skv_square_bounds b = skv_squares_bounds(set);
    const float far = INFINITY, pixel = terrain->pixel_size;
    const float rim = (float)SKV_TERRAIN_RIM + 1;
    return (skv_region){.x0 = b.x0 > 0 ? ((float)b.x0 - rim) * pixel : -far,
                        .y0 = b.y0 > 0 ? ((float)b.y0 - rim) * pixel : -far,
                        .x1 = b.x1 < terrain->columns ? (float)b.x1 * pixel : far,
                        .y1 = b.y1 < terrain->rows ? (float)b.y1 * pixel : far};
}

/* Puts a particle that a wall has come to cover onto its surface, where it no longer moves into it:
 * left to the contact, depth would become speed. Not through a wall that has been there before. */
static void push_out(skv_world *world, const skv_terrain *before, int i)
{
    const skv_state *s = &world->state;
    float x = s->x[i], y = s->y[i], nx = 0, ny = 0, distance = 0;
    for (int k = 0; k < MOST_PUSHES; k++) {
        distance = skv_normal_at(world->terrain, x, y, &nx, &ny);
        if (distance >= 0)
            break;
        x -= distance * nx;
        y -= distance * ny;
    }
    if (skv_terrain_sweep(before, s->x[i], s->y[i], x, y, 0) < 1)
        return;
    float into = s->vx[i] * nx + s->vy[i] * ny;
    if (into < 0) {
        s->vx[i] -= into * nx;
        s->vy[i] -= into * ny;
    }
    s->x[i] = x;
    s->y[i] = y;
}

/* Wakes who lies near what has changed, pushes out who lies in a new wall, and takes out who is too
 * deep for that; returns the number of these. */
static int tend_particles(skv_world *world, const skv_terrain *before, const edit *e)
{
    const skv_state *s = &world->state;
    const skv_terrain *terrain = world->terrain;
    float deepest = skv_minf(world->h, 0.99f * SKV_TERRAIN_REACH * terrain->pixel_size);
    int buried = 0;
    const skv_region near = region_of(&e->reached, terrain);
    for (int i = skv_next_in_box(s, &near, 0); i < s->count; i = skv_next_in_box(s, &near, i + 1)) {
        float x = s->x[i], y = s->y[i];
        if (!is_near(&e->reached, terrain, x, y, 0))
            continue;
        s->clearance[i] = 0;
        if (is_near(&e->changed, terrain, x, y, WAKES * world->h))
            skv_sleep_wake(world, i);
        float distance = skv_distance_at(terrain, x, y);
        if (distance < -deepest) {
            skv_world_remove_one(world, i);
            buried++;
        } else if (distance < 0) {
            push_out(world, before, i);
        }
    }
    return buried;
}

static skv_result update_walls(skv_world *world, const skv_terrain *terrain,
                               const skv_squares *changed, skv_error *error)
{
    world->busy = SKV_AT_WORK;
    skv_result result =
        skv_wall_map_update(world->walls, world->terrain, terrain, changed, world->pool, error);
    world->busy = SKV_IDLE;
    return result;
}

static bool is_same_size(const skv_terrain *a, const skv_terrain *b)
{
    return a->width == b->width && a->height == b->height && a->pixel_size == b->pixel_size;
}

skv_result skv_world_set_terrain(skv_world *world, skv_terrain *terrain, int *removed,
                                 skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world) && terrain, SKV_ERROR_VALUE);
    skv_terrain *before = world->terrain;
    if (!is_same_size(before, terrain))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "terrain: it has %d x %d pixels of %g m, the world's has %d x %d of %g m",
                        terrain->width, terrain->height, (double)terrain->pixel_size, before->width,
                        before->height, (double)before->pixel_size);
    edit e = {0};
    int buried = 0;
    skv_result result = compare(before, terrain, &e, error);
    if (result == SKV_OK)
        result = skv_world_begin_removal(world, world->state.count, error);
    if (result == SKV_OK)
        result = update_walls(world, terrain, &e.changed, error);
    if (result == SKV_OK) {
        world->terrain = terrain;
        world->boundary.terrain = terrain;
        skv_bodies_wake_all(world);
        buried = tend_particles(world, before, &e);
        skv_world_revise(world); /* pairs that a new thin wall parts are none */
        skv_terrain_destroy(before);
        skv_world_end_removal(world, buried);
        skv_springs_part(world);
        skv_world_adapt_substeps(world);
    }
    skv_squares_destroy(&e.changed);
    skv_squares_destroy(&e.reached);
    if (result == SKV_OK && removed)
        *removed = buried;
    return result;
}
