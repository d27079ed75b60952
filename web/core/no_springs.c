/* What stands in the page's module for springs, as no_bodies.c does for bodies. Invariant: no fluid
 * there has a shear modulus, so no world there gets springs, and what one with springs asks is
 * never asked.
 */
#include "world/springs.h"

const char *skv_springs_complain(const skv_liquid *liquid, skv_liquid_member *wrong)
{
    *wrong = SKV_LIQUID_WRONG_MODULUS;
    return liquid->shear_modulus == 0 ? NULL : "is none that the page knows; use the program";
}

bool skv_world_is_springy(const skv_world *world)
{
    (void)world;
    return false;
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

void skv_springs_tell(const skv_world *world, float dt, const skv_pushed *pushed)
{
    (void)world, (void)dt, (void)pushed;
}

void skv_springs_forget(skv_world *world)
{
    (void)world;
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
    (void)reader, (void)most_length, (void)particles;
    return skv_fail(error, SKV_ERROR_VALUE, "the page knows no springs; use the program");
}

skv_result skv_springs_load(skv_reader reader, int particles, skv_springs **springs,
                            skv_error *error)
{
    *springs = NULL;
    return skv_springs_check(&reader, 0, &particles, error);
}

void skv_springs_take_over(skv_world *world, skv_springs *springs)
{
    (void)world, (void)springs;
}
