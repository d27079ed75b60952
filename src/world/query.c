/* Reading a world: statistics, hash. Invariant: nothing here changes the world, and
 * every sum runs in creation order, so the same world gives the same bits. */
#include "base/assert.h"
#include "base/exact.h"
#include "solver/rows/rows.h"
#include "world/world_internal.h"

#include <math.h>
#include <string.h>

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

skv_stats skv_world_stats(const skv_world *world)
{
    skv_stats stats = {0};
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
    return stats;
}

static uint64_t hash_byte(uint64_t hash, unsigned byte)
{
    return (hash ^ byte) * 1099511628211u;
}

static uint64_t hash_float(uint64_t hash, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 4; byte++)
        hash = hash_byte(hash, (bits >> (8 * byte)) & 0xff);
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
        if (s->dye[i])
            hash = hash_byte(hash, s->dye[i]);
    }
    return hash;
}

skv_wall_impulse skv_world_wall_impulse(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_wall_impulse){0});
    return world->wall_impulse;
}

skv_memory skv_world_memory(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_memory){0});
    skv_solver_memory solver = world->solver->type->memory(world->solver);
    return (skv_memory){
        .particles = skv_state_bytes(&world->state) + solver.particles,
        .kept = solver.kept,
        .grid = solver.grid,
        .histograms = solver.histograms,
    };
}
