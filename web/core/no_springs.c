/* What stands for springs in the page's first modules, as no_bodies.c does for bodies and in the
 * same words: who asks for some gets the modules that have them. Invariant: no fluid here has a
 * shear modulus, so no world here gets springs, and what one with springs asks is never asked.
 */
#include "base/more.h"
#include "world/bodies/bodies.h"
#include "world/springs/springs.h"

bool skv_world_is_springy(const skv_world *world)
{
    (void)world;
    return false;
}

int skv_springs_rule(const skv_world *world)
{
    (void)world;
    return 0;
}

skv_result skv_springs_prepare(skv_world *world, skv_error *error)
{
    (void)world, (void)error;
    return SKV_OK;
}

void skv_springs_push(skv_world *world, float dt, bool partial)
{
    (void)world, (void)dt, (void)partial;
}

void skv_springs_hold(const skv_world *world, float dt)
{
    (void)world, (void)dt;
}

skv_result skv_springs_ask(skv_spring_pushes *pushes, const skv_world *world, float dt,
                           const skv_pushed **pushed, skv_error *error)
{
    (void)pushes, (void)world, (void)dt, (void)error;
    *pushed = NULL;
    return SKV_OK;
}

void skv_springs_forget(skv_world *world)
{
    (void)world;
}

void skv_springs_renew(skv_world *world, int particle)
{
    (void)world, (void)particle;
}

void skv_springs_part(skv_world *world)
{
    (void)world;
}

uint64_t skv_springs_hash(uint64_t hash, const skv_springs *springs)
{
    (void)springs;
    return hash;
}

void skv_springs_destroy(skv_springs *springs)
{
    (void)springs;
}

size_t skv_springs_bytes(const skv_springs *springs)
{
    (void)springs;
    return 0;
}

void skv_springs_save(skv_writer *writer, const skv_springs *springs)
{
    (void)writer, (void)springs;
}

skv_result skv_springs_check(skv_reader *reader, float most_length, int *particles,
                             skv_error *error)
{
    (void)most_length, (void)particles;
    return skv_bodies_check(reader, 0, false, error);
}

skv_result skv_springs_load(skv_reader reader, skv_springs **springs, skv_error *error)
{
    int particles;
    *springs = NULL;
    return skv_springs_check(&reader, 0, &particles, error);
}

void skv_springs_take_over(skv_world *world, skv_springs *springs)
{
    (void)world, (void)springs;
}
