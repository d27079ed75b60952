/* The particles of a world, structure of arrays: the one list of what a particle has.
 *
 * Whoever adds an attribute adds a line here, and gives a new particle its value in
 * skv_world_append; room, removal, copies and snapshots follow from the list.
 */
#ifndef SKV_WORLD_STATE_H
#define SKV_WORLD_STATE_H

#include "skvalp/base.h"

/* m/s, each way: a metre in the shortest substep is a third of it. Pushes from outside end there,
 * and a snapshot with more is none. */
#define SKV_MOST_SPEED 1e6

/* In which snapshots an attribute is; one that does not hold it is read as 0. */
typedef enum skv_saved {
    SKV_SAVED_NOWHERE,        /* found again, from 0 */
    SKV_SAVED = 1,            /* in all */
    SKV_SAVED_WITH_WARM = 2,  /* in those with warm starts, docs/snapshot.md */
    SKV_SAVED_WITH_FLUIDS = 4 /* in those of worlds with several fluids */
} skv_saved;

/* X(type, name, saved): one element per particle, SI units. First those of every world. */
#define SKV_COMMON_ARRAYS(X)                                                                       \
    X(float, x, SKV_SAVED) /* position, m */                                                       \
    X(float, y, SKV_SAVED)                                                                         \
    X(float, vx, SKV_SAVED) /* velocity, m/s */                                                    \
    X(float, vy, SKV_SAVED)                                                                        \
    X(float, pressure, SKV_SAVED)              /* gauge, of the last substep, Pa m */              \
    X(float, warm_lambda, SKV_SAVED_WITH_WARM) /* what the next substep starts from, solver.h */   \
    X(float, clearance,                                                                            \
      SKV_SAVED_NOWHERE)          /* lower bound of the distance to the nearest wall, m */         \
    X(float, anchor_x, SKV_SAVED) /* where it was at sleep's last look round, m */                 \
    X(float, anchor_y, SKV_SAVED)                                                                  \
    X(uint32_t, id, SKV_SAVED)          /* number at creation; ascending */                        \
    X(uint8_t, unrest, SKV_SAVED)       /* skv_unrest, of sleep.h */                               \
    X(uint8_t, part, SKV_SAVED_NOWHERE) /* skv_part, of solver.h; what sleep has planned */        \
    X(uint8_t, dye, SKV_SAVED)          /* its colour; 0: none */

/* Those of worlds with several fluids; null in others, so that one fluid takes no memory more. */
#define SKV_FLUID_ARRAYS(X)                                                                        \
    X(uint8_t, fluid, SKV_SAVED_WITH_FLUIDS) /* number of its fluid */                             \
    X(float, mass, SKV_SAVED_NOWHERE)        /* over that of the first fluid's; from the list */   \
    X(float, drag, SKV_SAVED_NOWHERE)        /* as in solver.h; from the list */

#define SKV_STATE_ARRAYS(X) SKV_COMMON_ARRAYS(X) SKV_FLUID_ARRAYS(X)

typedef struct skv_state {
    int count, capacity;
    bool several; /* fluids: it has their arrays */
    void *block;  /* the one allocation behind all of the arrays */
#define SKV_DECLARE_ARRAY(type, name, saved) type *name;
    SKV_STATE_ARRAYS(SKV_DECLARE_ARRAY)
#undef SKV_DECLARE_ARRAY
} skv_state;

/* Gives it the arrays of several fluids, in which all particles are of the first; nothing changes
 * on failure. */
skv_result skv_state_admit_fluids(skv_state *state, skv_error *error);

/* The number of a particle's fluid. */
static inline int skv_fluid_of(const skv_state *state, int particle)
{
    return state->several ? state->fluid[particle] : 0;
}

/* Makes room for `count` particles in all; nothing changes on failure. */
skv_result skv_state_reserve(skv_state *state, int count, skv_error *error);

/* Fails unless there are so many particles from the first on; `what` is to be set of them. */
skv_result skv_state_check_range(const skv_state *state, const char *what, int first, int count,
                                 skv_error *error);

/* Bytes held. */
size_t skv_state_bytes(const skv_state *state);

/* Puts particle `from` into the place `to`. */
void skv_state_move(skv_state *state, int from, int to);

void skv_state_free(skv_state *state);

#endif
