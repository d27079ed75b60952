/* A solver: what carries a fluid through substeps.
 *
 * There are two, of one model: reference/ is the list of passes, one after the other, in double
 * precision, for reading and for measuring against; rows/ is the production solver. A solver takes
 * arrays, a boundary and constants, and never knows a world. All of them come in SI units and in
 * the world's axes; each solver converts to its own.
 *
 * Invariant: the state of the fluid lies in the caller's arrays. Whatever a solver keeps from call
 * to call is memory.
 */
#ifndef SKV_SOLVER_SOLVER_H
#define SKV_SOLVER_SOLVER_H

#include "base/pool.h"
#include "model/constants.h"
#include "skvalp/base.h"
#include "solver/external_force.h"
#include "solver/impulse.h"
#include "terrain/boundary.h"

#include <limits.h>

/* What a solver is made for. */
typedef struct skv_solver_def {
    float x0, y0, x1, y1;                /* where fluid is to be expected, m; it may leave */
    float h;                             /* smoothing radius, m */
    skv_instruction_set instruction_set; /* one that this machine has; not all solvers care */
    float per_square;                    /* particles in a square of side h at rest */
    const skv_boundary *boundary;        /* has to outlive the solver */
} skv_solver_def;

/* What a particle does in a step: nothing; lie there, as low as what moves does on average, so that
 * it counts in the sums but stays, and nothing of it is written; or move. */
typedef enum skv_part { SKV_ABSENT, SKV_HELD, SKV_MOVES } skv_part;

/* The particles, in the caller's arrays: SI units. */
typedef struct skv_solver_particles {
    int count;
    float *x, *y;
    float *vx, *vy;
    float *clearance; /* lower bound of the distance to the nearest wall */
    float *pressure;  /* gauge pressure, Pa m; written only */
    /* What the pressure term, without cohesion, crowding and tension, has pushed in the last
     * substep: the sum of its P over dt^2, m/s^2. The next one starts from there. Not written with
     * the clavet law, which does not know it. */
    float *warm_lambda;
    /* Over that of the first fluid's, whose density and spacing the constants have: above 0. Null:
     * all 1. */
    const float *mass;
    /* sigma of its linear viscosity times `mass`, 1/s; where there is `mass`. Null: the constants'
     * times `mass`. */
    const float *drag;
    /* Numbers of their fluids, if one of the following is there. By number: */
    const uint8_t *fluid;
    const skv_liquid
        *liquids;          /* of which `interface_push` counts alone; null: none pushes others */
    const float *cohesion; /* over the constants' cohesion, above 0; null: all 1 */
    const uint32_t *id;
    const uint8_t *part; /* skv_part; null: all move */
} skv_solver_particles;

/* What walls have done to the fluid, of which the nearest point lies in a box. */
typedef struct skv_reaction {
    double x0, y0, x1, y1; /* the box, m */
    double dx, dy;         /* sums of the walls' displacements of particles times mass, m ... */
    double moment;         /* ... and of their moments about the box's centre, m^2 */
} skv_reaction;

/* Some substeps to take. */
typedef struct skv_solver_step {
    skv_solver_particles particles;
    const skv_constants *constants;
    float gravity_x, gravity_y; /* m/s^2 */
    const skv_external_force *forces;
    int force_count;
    int substeps;
    bool ungauged;          /* nobody wants the pressures: they need not be written */
    skv_pool *pool;         /* null: the calling thread */
    skv_reaction *reaction; /* is added to. Null: not wanted */
    /* What each of the boundary's solids gives the particles in these substeps, as `advance`
     * returns it of all walls, but the moment about the solid's middle. Written if there are
     * particles; null: not wanted. While solids move a step is one substep. */
    skv_impulse *solid_given;
} skv_solver_step;

/* Bytes that a solver holds. */
typedef struct skv_solver_memory {
    size_t particles;  /* its own arrays of particles */
    size_t kept;       /* what it keeps of pairs */
    size_t grid;       /* where it finds particles */
    size_t histograms; /* for filling the grid, once for each thread */
} skv_solver_memory;

typedef struct skv_solver skv_solver;

enum { SKV_SOLVER_MOST_PASSES = 16, SKV_SOLVER_MOST_FORCES = 48 };

/* A kind of solver. */
typedef struct skv_solver_type {
    bool holds;        /* knows `part` */
    int most_substeps; /* that it can take after one `reserve` */
    int pass_count;
    const char *pass_names[SKV_SOLVER_MOST_PASSES];

    skv_result (*create)(const skv_solver_def *def, skv_solver **solver, skv_error *error);
    void (*destroy)(skv_solver *solver);
    /* Makes room for a step; allocates only when it has to. On failure nothing has changed. */
    skv_result (*reserve)(skv_solver *solver, const skv_solver_step *step, skv_error *error);
    /* Takes the substeps, for which there is room. Returns what walls have given the particles that
     * are not held, as displacements times mass, in m, and the moment about the origin in m^2. */
    skv_impulse (*advance)(skv_solver *solver, const skv_solver_step *step);
    /* Wall seconds of each pass since the last call with `reset`. */
    void (*profile)(skv_solver *solver, bool reset, double *seconds);
    skv_solver_memory (*memory)(const skv_solver *solver);
} skv_solver_type;

/* What every solver begins with. */
struct skv_solver {
    const skv_solver_type *type;
};

extern const skv_solver_type skv_reference_solver, skv_rows_solver;

/* What the rows call an instruction set, or the best one; null if this machine lacks it. */
const char *skv_rows_instruction_set(skv_instruction_set set);

#endif
