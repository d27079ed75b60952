/* Reading a world: statistics, hash. Invariant: nothing here changes the world, and
 * every sum runs in creation order, so the same world gives the same bits. */
#include "base/assert.h"
#include "base/exact.h"
#include "solver/rows/rows.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/springs/springs.h"

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

/* Of the particles of one fluid, or of all for a negative number. A weight is a particle's mass
 * over that of the first fluid's. */
static skv_stats gather(const skv_world *world, int fluid)
{
    skv_stats stats = {0};
    const skv_state *s = &world->state;
    double first = (double)world->fluid.density, weights[SKV_MAX_FLUIDS] = {0};
    double mass_of_first = first * (double)world->fluid.spacing * (double)world->fluid.spacing;
    double speeds_squared = 0, energies = 0, weight_of_all = 0;
    for (int i = 0; i < world->fluid_count; i++)
        weights[i] = (double)world->liquids[i].density / first;
    for (int i = 0; i < s->count; i++) {
        if (fluid >= 0 && skv_fluid_of(s, i) != fluid)
            continue;
        stats.particles++;
        if (!finite_particle(s, i)) {
            stats.not_finite++;
            continue;
        }
        double weight = weights[skv_fluid_of(s, i)], mass = weight * mass_of_first;
        double vx = (double)s->vx[i], vy = (double)s->vy[i];
        double x = (double)s->x[i], y = (double)s->y[i];
        double speed_squared = vx * vx + vy * vy;
        speeds_squared += speed_squared;
        energies += weight * speed_squared;
        weight_of_all += weight;
        stats.max_speed = skv_max(sqrt(speed_squared), stats.max_speed);
        stats.momentum_x += mass * vx;
        stats.momentum_y += mass * vy;
        stats.potential_energy -=
            mass * ((double)world->gravity_x * x + (double)world->gravity_y * y);
        stats.centre_x += weight * x;
        stats.centre_y += weight * y;
        stats.escaped += has_escaped(world, s->x[i], s->y[i]);
    }
    stats.kinetic_energy = mass_of_first * energies / 2;
    int finite = stats.particles - stats.not_finite;
    if (finite > 0) {
        stats.rms_speed = sqrt(speeds_squared / finite);
        stats.centre_x /= weight_of_all;
        stats.centre_y /= weight_of_all;
    }
    return stats;
}

skv_stats skv_world_stats(const skv_world *world)
{
    SKV_ASSERT_OR(world, (skv_stats){0});
    return gather(world, -1);
}

skv_stats skv_world_fluid_stats(const skv_world *world, int fluid)
{
    SKV_ASSERT_OR(world && fluid >= 0, (skv_stats){0});
    return gather(world, fluid);
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
        if (skv_fluid_of(s, i))
            hash = hash_byte(hash, 16u * (unsigned)skv_fluid_of(s, i));
    }
    if (world->air)
        hash = skv_air_hash(hash, world->air);
    if (world->springs)
        hash = skv_springs_hash(hash, world->springs);
    return world->bodies ? skv_bodies_hash(hash, world->bodies) : hash;
}

int skv_world_spring_count(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->springs ? world->springs->count : 0;
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
        .kept = solver.kept + skv_springs_bytes(world->springs),
        .grid = solver.grid,
        .histograms = solver.histograms,
    };
}
