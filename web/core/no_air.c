/* What stands for air in the page's first modules, as no_bodies.c does for bodies: who asks for
 * some gets the modules that have it. Invariant: no field of a scene here is of air, so no world
 * here has any, and what one with air asks is never asked.
 */
#include "base/more.h"
#include "measure/wall_force.h"
#include "world/air/air.h"

skv_result skv_world_set_air(skv_world *world, float pressure, skv_error *error)
{
    (void)world, (void)pressure, (void)error;
    return SKV_OK;
}

void skv_air_push(skv_world *world, float dt, bool partial)
{
    (void)world, (void)dt, (void)partial;
}

void skv_air_push_one(const skv_world *world, int particle, float dt, float *vx, float *vy)
{
    (void)world, (void)particle, (void)dt, (void)vx, (void)vy;
}

void skv_force_add_air(const skv_world *world, const skv_reaction *box, skv_wall_force *force)
{
    (void)world, (void)box, (void)force;
}

void skv_air_hold(skv_world *world, float dt)
{
    (void)world, (void)dt;
}

void skv_air_gauge(skv_world *world, bool partial)
{
    (void)world, (void)partial;
}

bool skv_air_stirs(const skv_world *world, int particle)
{
    (void)world, (void)particle;
    return false;
}

void skv_air_destroy(skv_air *air)
{
    (void)air;
}

uint64_t skv_air_hash(uint64_t hash, const skv_air *air)
{
    (void)air;
    return hash;
}

void skv_air_save(skv_writer *writer, const skv_air *air)
{
    (void)writer, (void)air;
}

skv_result skv_air_check(skv_reader *reader, skv_error *error)
{
    (void)reader;
    return skv_want_more(error);
}

skv_result skv_air_load(const skv_world *world, skv_reader reader, skv_air **air, skv_error *error)
{
    (void)world, (void)reader;
    *air = NULL;
    return skv_want_more(error);
}

void skv_air_take_over(skv_world *world, skv_air *air)
{
    (void)world, (void)air;
}
