/* Reading a world: statistics, hash. Invariant: nothing here changes the world, and
 * every sum runs in creation order, so the same world gives the same bits. */
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "solver/lattice.h"
#include "solver/reference/neighbours.h"
#include "solver/reference/pair.h"
#include "solver/rows/rows.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

/* A particle is in the bulk if its surroundings are even: |g| below this share of its value at a
 * flat surface. */
#define BULK_GRADIENT 0.3

static bool finite_particle(const skv_state *s, int i)
{
    return isfinite(s->x[i]) && isfinite(s->y[i]) && isfinite(s->vx[i]) && isfinite(s->vy[i]);
}

static bool has_escaped(const skv_world *world, float x, float y)
{
    const skv_terrain *terrain = world->terrain;
    unsigned open = skv_terrain_open_sides(terrain);
    bool leaving = ((open & SKV_SIDE_LEFT) && x < 0) ||
                   ((open & SKV_SIDE_RIGHT) && x > skv_terrain_width(terrain)) ||
                   ((open & SKV_SIDE_BOTTOM) && y < 0) ||
                   ((open & SKV_SIDE_TOP) && y > skv_terrain_height(terrain));
    return !leaving && skv_terrain_distance(terrain, x, y) < -world->h;
}

/* Sums over one particle's surroundings, as pass A of the solver sees them. */
typedef struct surroundings {
    double neighbours, density, gradient;
} surroundings;

static surroundings look_around(const skv_world *world, const skv_neighbours *lists,
                                const skv_constants *constants, int i)
{
    skv_kernel kernel = skv_law_kernel(world->fluid.law);
    surroundings around = {0};
    double gx = 0, gy = 0;
    const skv_state *s = &world->state;
    const skv_pass_data data = {.count = s->count, .x = s->x, .y = s->y, .id = s->id};
    for (int k = lists->start[i]; k < lists->start[i + 1]; k++) {
        skv_pair pair;
        if (!skv_pair_of(&data, constants, i, lists->list[k], &pair))
            continue;
        around.neighbours += 1;
        double q = (double)pair.q, force = skv_kernel_force(kernel, q);
        around.density += skv_kernel_density(kernel, q);
        gx += force * (double)pair.ux;
        gy += force * (double)pair.uy;
    }
    skv_wall_sample wall;
    skv_boundary_sample(&world->boundary, s->x[i], s->y[i], &wall);
    gx -= (double)wall.f1x;
    gy -= (double)wall.f1y;
    around.density += (double)wall.r;
    around.gradient = sqrt(gx * gx + gy * gy);
    return around;
}

/* Neighbours and volume need lists of the present positions; without memory for them they are 0
 * and 1. */
static void measure_packing(const skv_world *world, skv_stats *stats)
{
    const skv_state *s = &world->state;
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    skv_neighbours lists;
    stats->volume_ratio = 1;
    skv_result result =
        skv_neighbours_create(&lists, 0, 0, width, height, world->h, &world->boundary, NULL);
    if (result == SKV_OK)
        result = skv_neighbours_reserve(&lists, s->count, NULL);
    if (result == SKV_OK) {
        skv_neighbours_build(&lists, s->x, s->y, s->count, world->h, NULL);
        result = skv_neighbours_reserve(&lists, s->count, NULL);
    }
    if (result == SKV_OK) {
        skv_neighbours_build(&lists, s->x, s->y, s->count, world->h, NULL);
        double eta = (double)world->fluid.radius_ratio;
        skv_kernel kernel = skv_law_kernel(world->fluid.law);
        double rest = skv_lattice_sums(kernel, eta).density;
        double bulk_below = BULK_GRADIENT * skv_surface_gradient(&world->fluid);
        skv_constants constants = skv_make_constants(&world->fluid, 1.0f / 60);
        double pairs = 0, volume = 0, bulk = 0;
        for (int i = 0; i < s->count; i++) {
            surroundings around = look_around(world, &lists, &constants, i);
            pairs += around.neighbours;
            if (around.gradient < bulk_below && around.density > 0.5 * rest) {
                volume += (1 + rest) / (1 + around.density);
                bulk += 1;
            }
        }
        stats->neighbours = pairs / s->count;
        if (bulk > 0)
            stats->volume_ratio = volume / bulk;
    }
    skv_neighbours_destroy(&lists);
}

skv_stats skv_world_stats(const skv_world *world)
{
    skv_stats stats = {.volume_ratio = 1};
    SKV_ASSERT_OR(world, stats);
    const skv_state *s = &world->state;
    double mass =
        (double)world->fluid.density * (double)world->fluid.spacing * (double)world->fluid.spacing;
    double speeds_squared = 0;
    stats.particles = s->count;
    for (int i = 0; i < s->count; i++) {
        if (!finite_particle(s, i)) {
            stats.not_finite++;
            continue;
        }
        double vx = (double)s->vx[i], vy = (double)s->vy[i];
        double x = (double)s->x[i], y = (double)s->y[i];
        double speed_squared = vx * vx + vy * vy;
        speeds_squared += speed_squared;
        stats.max_speed = skv_max(sqrt(speed_squared), stats.max_speed);
        stats.momentum_x += mass * vx;
        stats.momentum_y += mass * vy;
        stats.potential_energy -=
            mass * ((double)world->gravity_x * x + (double)world->gravity_y * y);
        stats.centre_x += x;
        stats.centre_y += y;
        stats.escaped += has_escaped(world, s->x[i], s->y[i]);
    }
    stats.kinetic_energy = mass * speeds_squared / 2;
    int finite = s->count - stats.not_finite;
    if (finite > 0) {
        stats.rms_speed = sqrt(speeds_squared / finite);
        stats.centre_x /= finite;
        stats.centre_y /= finite;
    }
    if (s->count > 0 && stats.not_finite == 0)
        measure_packing(world, &stats);
    return stats;
}

static uint64_t hash_float(uint64_t hash, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 4; byte++) {
        hash ^= (bits >> (8 * byte)) & 0xff;
        hash *= 1099511628211u;
    }
    return hash;
}

uint64_t skv_world_hash(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    const skv_state *s = &world->state;
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < s->count; i++) {
        hash = hash_float(hash, s->x[i]);
        hash = hash_float(hash, s->y[i]);
        hash = hash_float(hash, s->vx[i]);
        hash = hash_float(hash, s->vy[i]);
    }
    return hash;
}

const char *skv_instruction_set(void)
{
    return skv_rows_isa();
}

size_t skv_world_solver_bytes(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->solver->type->bytes(world->solver);
}
