/* The particles of a world, structure of arrays: the one list of what a particle has.
 *
 * Whoever adds an attribute adds a line here, and gives a new particle its value in
 * skv_world_append; room, removal, copies and snapshots follow from the list.
 */
#ifndef SKV_WORLD_STATE_H
#define SKV_WORLD_STATE_H

#include "skvalp/base.h"

/* X(type, name, saved): one element per particle, SI units. `saved`: a snapshot holds it; what it
 * does not is found again, from 0. */
#define SKV_STATE_ARRAYS(X)                                                                        \
    X(float, x, true) /* position, m */                                                            \
    X(float, y, true)                                                                              \
    X(float, vx, true) /* velocity, m/s */                                                         \
    X(float, vy, true)                                                                             \
    X(float, pressure, true)   /* gauge, of the last substep, Pa m */                              \
    X(float, clearance, false) /* lower bound of the distance to the nearest wall, m */            \
    X(float, anchor_x, true)   /* where it was at sleep's last look round, m */                    \
    X(float, anchor_y, true)                                                                       \
    X(uint32_t, id, true)    /* number at creation; ascending */                                   \
    X(uint8_t, unrest, true) /* skv_unrest, of sleep.h */                                          \
    X(uint8_t, part, false)  /* skv_part, of solver.h; what sleep has planned */                   \
    X(uint8_t, dye, true)    /* its colour; 0: none */

typedef struct skv_state {
    int count, capacity;
    void *block; /* the one allocation behind all of the arrays */
#define SKV_DECLARE_ARRAY(type, name, saved) type *name;
    SKV_STATE_ARRAYS(SKV_DECLARE_ARRAY)
#undef SKV_DECLARE_ARRAY
} skv_state;

/* Makes room for `count` particles in all; nothing changes on failure. */
skv_result skv_state_reserve(skv_state *state, int count, skv_error *error);

/* Bytes held. */
size_t skv_state_bytes(const skv_state *state);

/* Puts particle `from` into the place `to`. */
void skv_state_move(skv_state *state, int from, int to);

void skv_state_free(skv_state *state);

#endif
