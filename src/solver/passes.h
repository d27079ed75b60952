/* The passes of a substep in the order in which src/world/step.c runs them. Each mirrors an
 * algorithm of the thesis with the errata of docs/model.md; each handles particles [begin, end). */
#ifndef SKV_SOLVER_PASSES_H
#define SKV_SOLVER_PASSES_H

#include "solver/neighbours.h"
#include "solver/state.h"

/* A finger's pull (thesis, section 3.5), lengths in m. */
typedef struct skv_pull {
    float x, y, vx, vy;
    float inv_radius;
    float attraction;       /* m/s^2 at half the radius */
    float friction, follow; /* shares of the velocity a substep at the centre, 0..1 */
} skv_pull;

/* Algorithm 2: gravity and the hands change the velocity. */
void skv_pass_external_forces(skv_state *state, const skv_constants *constants, float gx, float gy,
                              const skv_pull *pulls, int pull_count, int begin, int end);

/* Algorithm 3: collects the pair viscosity's change of velocity in dx, dy ... */
void skv_pass_viscosity(skv_state *state, const skv_constants *constants,
                        const skv_neighbours *neighbours, int begin, int end);
/* ... and adds it once every particle has been read. */
void skv_pass_apply_viscosity(skv_state *state, int begin, int end);

/* Algorithm 4: clamps the speed and puts the wanted move into dx, dy; the corrections start at 0.
 * The mover, which knows the walls, then carries it out. */
void skv_pass_advance(skv_state *state, const skv_constants *constants, int begin, int end);

/* Algorithm 6, lines 3-9: densities from neighbours and walls, and their gradient, if the tension
 * is to follow. */
void skv_pass_density(skv_state *state, const skv_constants *constants,
                      const skv_neighbours *neighbours, bool gradient, int begin, int end);

/* Algorithm 6, lines 10-11: P and N of a particle from its densities. Two laws behind one
 * signature. */
typedef void skv_pressure_law(skv_state *state, const skv_constants *constants, int begin, int end);
skv_pressure_law skv_pass_pressure_calibrated;
skv_pressure_law skv_pass_pressure_clavet;

/* Algorithm 6, lines 13-19: collects the displacement in dx, dy, and adds the virial to the gauge
 * pressure. */
void skv_pass_displacement(skv_state *state, const skv_constants *constants,
                           const skv_neighbours *neighbours, int begin, int end);

/* The calibrated law's surface tension (docs/model.md): adds to dx, dy and the gauge pressure what
 * evens out the gradients. Once a substep, after the first displacement pass. */
void skv_pass_tension(skv_state *state, const skv_constants *constants,
                      const skv_neighbours *neighbours, int begin, int end);

/* Algorithm 7 for particles closer to a wall than the contact distance: friction and push, in
 * dx, dy; zero for all others. Reads depth and normal. */
void skv_pass_contact(skv_state *state, const skv_constants *constants, int begin, int end);

/* Algorithm 8: the corrections of the substep become velocity. */
void skv_pass_update_velocity(skv_state *state, const skv_constants *constants, int begin, int end);

#endif
