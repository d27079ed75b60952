/* The springs of a world: what gives fluids with a shear modulus their shape; see springs.c. */
#ifndef SKV_WORLD_SPRINGS_H
#define SKV_WORLD_SPRINGS_H

#include "base/bytes.h"
#include "solver/reference/neighbours.h"
#include "world/liquids.h"
#include "world/world_internal.h"

/* A particle's springs to such with higher numbers, at most: twice what the closest lattice that a
 * definition allows has. More are passed over. */
enum { SKV_MOST_SPRINGS = 48 };

/* By particle: where it will be in a substep, m, and what its springs change its velocity by, m/s.
 */
typedef struct skv_pushed {
    float *x, *y, *dvx, *dvy;
} skv_pushed;

/* A particle's springs to those with higher numbers follow each other, by rising numbers. */
typedef struct skv_springs {
    int count;
    int particles;   /* that may have some; those added since have none yet */
    int *first;      /* one more than these: where each one's springs begin */
    uint8_t *bonded; /* whether each one has been given springs to what was around it */
    int *to;         /* of a spring, its end with the higher number */
    float *length;   /* at rest, m */

    /* Room for work. */
    skv_pushed pushed; /* while pairs are found, where those are among whom they are */
    int *number;       /* of those among whom pairs are found, or of those that stay */
    int *mark, *many;  /* who has a spring to the particle at hand; how many of each one are due */
    skv_neighbours near;
    bool can_find; /* `near` is made */

    int particle_room, room; /* particles and springs to have memory for */
    void *particle_block, *block;
} skv_springs;

/* Whether a fluid has springs, and whether one of a world's has. */
static inline bool skv_liquid_is_springy(const skv_liquid *liquid)
{
    return liquid->shear_modulus > 0;
}
bool skv_world_is_springy(const skv_world *world);

/* How many substeps a frame the stiffest springs of the world's fluids need; 0 without any. */
int skv_springs_rule(const skv_world *world);

/* springs/pairs.c. Before a substep: makes the springs that are due, if a fluid has some, and all
 * the room that it takes. On failure no spring has changed. */
skv_result skv_springs_prepare(skv_world *world, skv_error *error);

/* Lets the springs change the velocities of particles that move, for a substep of `dt`; those that
 * are longer than they bear break, and plastic ones give way. */
void skv_springs_push(skv_world *world, float dt, bool partial);

/* The same of all particles, while no spring breaks or gives way: no time passes. */
void skv_springs_hold(const skv_world *world, float dt);

/* Room for what springs change velocities by; all zero at the start, and `block` to be freed. */
typedef struct skv_spring_pushes {
    skv_pushed pushed;
    int room; /* particles */
    void *block;
} skv_spring_pushes;

/* Tells what they would change all particles' velocities by, while nothing changes; null where
 * there are none. */
skv_result skv_springs_ask(skv_spring_pushes *pushes, const skv_world *world, float dt,
                           const skv_pushed **pushed, skv_error *error);

/* Follows the particles: those marked as leaving go, the rest closes ranks. */
void skv_springs_forget(skv_world *world);
/* A particle is of another fluid now: it gets springs anew. */
void skv_springs_renew(skv_world *world, int particle);
/* Drops springs that walls part since they were changed, or whose ends are of two fluids. */
void skv_springs_part(skv_world *world);

/* Makes room for springs of so many particles, and for so many springs; nothing changes on failure.
 */
skv_result skv_springs_reserve(skv_springs *springs, int particles, int count, skv_error *error);

/* Adds what decides their future to a hash. */
uint64_t skv_springs_hash(uint64_t hash, const skv_springs *springs);
void skv_springs_destroy(skv_springs *springs);
size_t skv_springs_bytes(const skv_springs *springs);

/* In a snapshot (docs/snapshot.md). Reading checks all of it, and writes how many particles there
 * have to be; loading makes what has been read. */
void skv_springs_save(skv_writer *writer, const skv_springs *springs);
skv_result skv_springs_check(skv_reader *reader, float most_length, int *particles,
                             skv_error *error);
skv_result skv_springs_load(skv_reader reader, skv_springs **springs, skv_error *error);
/* Gives a world others, or none, and frees its own. */
void skv_springs_take_over(skv_world *world, skv_springs *springs);

#endif
