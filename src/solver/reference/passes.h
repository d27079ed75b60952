/* The passes of a substep, in the order in which reference.c runs them. Each mirrors an algorithm
 * of the thesis with the errata of docs/model.md; each handles particles [begin, end). */
#ifndef SKV_SOLVER_REFERENCE_PASSES_H
#define SKV_SOLVER_REFERENCE_PASSES_H

#include "solver/reference/neighbours.h"
#include "solver/reference/pass_data.h"
#include "solver/solver.h"

#include <stdatomic.h>

/* An skv_impulse_sum that several threads add to. */
typedef struct skv_shared_impulse {
    atomic_uint_fast64_t x, y, moment;
} skv_shared_impulse;

/* What the passes of one substep share. */
typedef struct skv_substep {
    skv_pass_data data;
    const skv_constants *constants;
    float gravity_x, gravity_y; /* m/s^2 */
    const skv_external_force *forces;
    int force_count;
    const skv_neighbours *neighbours;
    const skv_boundary *boundary;
    bool first;                /* iteration: with gradient and tension, and the warm start */
    bool last;                 /* iteration: what the gauge adds up is whole */
    skv_shared_impulse *given; /* by walls, in this step */
    skv_reaction *reaction;    /* null: not wanted. Wanted: all on one thread */
} skv_substep;

typedef void skv_pass(const skv_substep *substep, int begin, int end);

/* Algorithm 2: gravity and the hands change the velocity. */
skv_pass skv_pass_external_forces;

/* Algorithm 3: collects the pair viscosity's change of velocity in dx, dy ... */
skv_pass skv_pass_viscosity;
/* ... and adds it once every particle has been read. */
skv_pass skv_pass_apply_viscosity;

/* Algorithm 4: clamps the speed and puts the wanted move into dx, dy; the corrections start at 0.
 */
skv_pass skv_pass_predict;
/* Carries the move out as far as walls allow. What they stop of it is a correction: it leaves the
 * velocity. */
skv_pass skv_pass_advance;

/* Before each iteration: how far behind the particles pairs are taken. Half of the way that they
 * have gone in the substep, for the slopes that push them are those of the middle of it; less for
 * what hardly moves, which a late push calms. */
skv_pass skv_pass_lag;

/* What the solid adds to the sums, the wall density maps; and the images of the particles beside
 * it. */
skv_pass skv_pass_walls;

/* Algorithm 6, lines 3-9: densities from neighbours and walls, and their gradient, if the tension
 * is to follow. */
skv_pass skv_pass_density;

/* Algorithm 6, lines 10-11: P and N of a particle from its densities. Two laws behind one
 * signature; the calibrated one starts warm. */
skv_pass skv_pass_pressure_calibrated, skv_pass_pressure_clavet;

/* Algorithm 6, lines 13-19: collects the displacement in dx, dy, and adds the virial to the gauge
 * pressure. */
skv_pass skv_pass_displacement;

/* The calibrated law's surface tension (docs/model.md): adds to dx, dy and the gauge pressure what
 * evens out the gradients. Once a substep, after the first displacement pass. */
skv_pass skv_pass_tension;

/* Carries out dx, dy as far as walls allow, and keeps in the corrections what was carried out. */
skv_pass skv_pass_correct;

/* With walls by images, in the last iteration: takes from dx, dy what friction and viscosity
 * hold of the slip beside a wall. */
skv_pass skv_pass_slip;

/* Algorithm 7 for particles closer to a wall than the contact distance: friction and push, in
 * dx, dy; zero for all others. First how deep they are, and which way is out. */
skv_pass skv_pass_find_contacts;
skv_pass skv_pass_contact;

/* Books (dx, dy), in m, which a wall has done to particle i. */
void skv_book_reaction(const skv_substep *substep, int i, double dx, double dy);

/* Algorithm 8: the corrections of the substep become velocity. */
skv_pass skv_pass_update_velocity;

#endif
