/* Putting particles into a world: single ones, and lattices that fill a region.
 *
 * Invariant: a lattice is a function of the box, the spacing and the terrain alone, and it is
 * walked from the bottom up, so that counting and filling agree.
 */
#include "base/assert.h"
#include "base/exact.h"
#include "world/world_internal.h"

#include <math.h>

/* Particles of a fresh lattice are this far from walls, in spacings. */
#define WALL_GAP 0.3f
/* Shift of each particle, in spacings: a perfect lattice would stand like a crystal. */
#define JITTER 0.02f

typedef struct lattice {
    const skv_terrain *terrain;
    float spacing, x0, y0, x1, y1;
    skv_inside *inside;
    void *user;
} lattice;

static float jitter(uint32_t number)
{
    number *= 0x9e3779b1u;
    number ^= number >> 16;
    number *= 0x85ebca6bu;
    number ^= number >> 13;
    return ((float)(number & 0xffff) / 65536.0f - 0.5f) * JITTER;
}

/* Walks the lattice; adds to `world` if there is one. Returns the number of points. */
static int walk(const lattice *l, int limit, skv_world *world)
{
    double a = (double)l->spacing * sqrt(2 / sqrt(3.0)), b = a * sqrt(3.0) / 2;
    int rows = (int)ceil(((double)(l->y1 - l->y0)) / b);
    int columns = (int)ceil(((double)(l->x1 - l->x0)) / a) + 1;
    int found = 0;
    for (int row = 0; row < rows; row++) {
        float y = (float)((double)l->y0 + (row + 0.5) * b);
        if (y > l->y1)
            break;
        for (int column = 0; column < columns; column++) {
            float x = (float)((double)l->x0 + (column + (row % 2 ? 0.75 : 0.25)) * a);
            if (x > l->x1 || (limit >= 0 && found >= limit))
                break;
            if (l->inside && !l->inside(x, y, l->user))
                continue;
            if (skv_terrain_distance(l->terrain, x, y) < WALL_GAP * l->spacing)
                continue;
            if (world)
                skv_world_append(world, x + l->spacing * jitter(2 * world->next_id),
                                 y + l->spacing * jitter(2 * world->next_id + 1), 0, 0);
            found++;
        }
    }
    return found;
}

static bool box_is_sane(float x0, float y0, float x1, float y1)
{
    return skv_within((double)x0, -100, 100) && skv_within((double)y0, -100, 100) &&
           skv_within((double)x1, -100, 100) && skv_within((double)y1, -100, 100);
}

/* The part of the box that the terrain covers. */
static lattice make_lattice(const skv_terrain *terrain, float spacing, float x0, float y0, float x1,
                            float y1, skv_inside *inside, void *user)
{
    return (lattice){terrain,
                     spacing,
                     skv_maxf(x0, 0),
                     skv_maxf(y0, 0),
                     skv_minf(x1, skv_terrain_width(terrain)),
                     skv_minf(y1, skv_terrain_height(terrain)),
                     inside,
                     user};
}

int skv_fill_count(const skv_terrain *terrain, float spacing, float x0, float y0, float x1,
                   float y1, skv_inside *inside, void *user)
{
    SKV_ASSERT_OR(terrain, 0);
    if (!box_is_sane(x0, y0, x1, y1) || !skv_within((double)spacing, 1e-4, 100))
        return 0;
    lattice l = make_lattice(terrain, spacing, x0, y0, x1, y1, inside, user);
    return walk(&l, -1, NULL);
}

skv_result skv_world_fill(skv_world *world, float x0, float y0, float x1, float y1,
                          skv_inside *inside, void *user, int limit, int *added, skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!box_is_sane(x0, y0, x1, y1))
        return skv_fail(error, SKV_ERROR_VALUE, "fill: the box is not finite");
    lattice l = make_lattice(world->terrain, world->fluid.spacing, x0, y0, x1, y1, inside, user);
    int count = walk(&l, limit, NULL);
    int64_t total = (int64_t)world->state.count + count;
    if (total > SKV_MAX_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "fill: %lld particles are too many; at most %d are allowed",
                        (long long)total, SKV_MAX_PARTICLES);
    skv_result result = skv_world_reserve(world, (int)total, error);
    if (result != SKV_OK)
        return result;
    walk(&l, limit, world);
    if (added)
        *added = count;
    return SKV_OK;
}

skv_result skv_world_add_particle(skv_world *world, float x, float y, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)x, -100, 100) || !skv_within((double)y, -100, 100) ||
        !skv_within((double)vx, -1000, 1000) || !skv_within((double)vy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: position or velocity is not finite or beyond 100 m, 1000 m/s");
    if (skv_terrain_distance(world->terrain, x, y) <= 0)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "particle: (%g, %g) is inside solid; choose a free place", (double)x,
                        (double)y);
    skv_result result = skv_world_reserve(world, world->state.count + 1, error);
    if (result == SKV_OK)
        skv_world_append(world, x, y, vx, vy);
    return result;
}

skv_result skv_world_add_velocity(skv_world *world, int first, int count, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)vx, -1000, 1000) || !skv_within((double)vy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE, "velocity: not finite or beyond 1000 m/s");
    if (first < 0 || count < 0 || first > world->state.count - count)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "velocity: particles %d.. do not exist; there are %d", first,
                        world->state.count);
    for (int i = first; i < first + count; i++) {
        world->state.vx[i] += vx;
        world->state.vy[i] += vy;
        skv_sleep_wake(world, i);
    }
    return SKV_OK;
}
