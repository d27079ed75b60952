/* How a fluid is packed: neighbours and the room that a particle takes, from lists of the present
 * positions. Invariant: the sums run in the particles' order, so the same world gives the same
 * bits.
 */
#include "base/assert.h"
#include "model/lattice.h"
#include "solver/direction.h"
#include "solver/reference/neighbours.h"
#include "world/world_internal.h"

#include <math.h>

/* A particle is in the bulk if its surroundings are even: |g| below this share of its value at a
 * flat surface. */
#define BULK_GRADIENT 0.3

/* Lists of the present positions; they are to be destroyed, even on failure. */
static skv_result list_neighbours(const skv_world *world, skv_neighbours *lists, skv_error *error)
{
    const skv_state *s = &world->state;
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    skv_result result =
        skv_neighbours_create(lists, 0, 0, width, height, world->h, &world->boundary, error);
    if (result == SKV_OK)
        result = skv_neighbours_reserve(lists, s->count, error);
    if (result != SKV_OK)
        return result;
    skv_neighbours_build(lists, s->x, s->y, s->count, world->h);
    if (lists->wanted <= lists->list_capacity)
        return SKV_OK;
    result = skv_neighbours_reserve(lists, s->count, error);
    if (result == SKV_OK)
        skv_neighbours_build(lists, s->x, s->y, s->count, world->h);
    return result;
}

/* Sums over one particle's surroundings, as pass A of the solver sees them. */
typedef struct surroundings {
    double neighbours, density, gradient;
} surroundings;

static surroundings look_around(const skv_world *world, const skv_neighbours *lists, int i)
{
    const skv_fluid_def *fluid = &world->fluid;
    const skv_kernel kernel = skv_law_kernel(fluid->law);
    const float inv_h = (float)(1 / ((double)fluid->spacing * (double)fluid->radius_ratio));
    surroundings around = {0};
    double gx = 0, gy = 0;
    const skv_state *s = &world->state;
    for (int k = lists->start[i]; k < lists->start[i + 1]; k++) {
        int j = lists->list[k];
        float dx = s->x[j] - s->x[i], dy = s->y[j] - s->y[i];
        float r = sqrtf(dx * dx + dy * dy), ux, uy;
        if (r > SKV_COINCIDENT * world->h) {
            ux = dx * (1 / r);
            uy = dy * (1 / r);
        } else {
            skv_fallback_direction(s->id[i], s->id[j], &ux, &uy);
        }
        around.neighbours += 1;
        double q = (double)(1 - r * inv_h), force = skv_kernel_force(kernel, q);
        around.density += skv_kernel_density(kernel, q);
        gx += force * (double)ux;
        gy += force * (double)uy;
    }
    skv_wall_sample wall;
    skv_boundary_sample(&world->boundary, s->x[i], s->y[i], &wall);
    gx -= (double)wall.f1x;
    gy -= (double)wall.f1y;
    around.density += (double)wall.r;
    around.gradient = sqrt(gx * gx + gy * gy);
    return around;
}

static skv_packing average(const skv_world *world, const skv_neighbours *lists)
{
    skv_kernel kernel = skv_law_kernel(world->fluid.law);
    double rest = skv_lattice_sums(kernel, (double)world->fluid.radius_ratio).density;
    double bulk_below = BULK_GRADIENT * skv_surface_gradient(&world->fluid);
    double pairs = 0, volume = 0, bulk = 0;
    const skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++) {
        if (!isfinite(s->x[i]) || !isfinite(s->y[i]))
            continue;
        surroundings around = look_around(world, lists, i);
        pairs += around.neighbours;
        if (around.gradient < bulk_below && around.density > 0.5 * rest) {
            volume += (1 + rest) / (1 + around.density);
            bulk += 1;
        }
    }
    return (skv_packing){pairs / s->count, bulk > 0 ? volume / bulk : 1};
}

skv_result skv_world_packing(const skv_world *world, skv_packing *packing, skv_error *error)
{
    SKV_ASSERT_OR(world && packing, SKV_ERROR_VALUE);
    *packing = (skv_packing){.volume_ratio = 1};
    if (world->state.count == 0)
        return SKV_OK;
    skv_neighbours lists = {0};
    skv_result result = list_neighbours(world, &lists, error);
    if (result == SKV_OK)
        *packing = average(world, &lists);
    skv_neighbours_destroy(&lists);
    return result;
}
