/* The force of the fluid on walls, measured without touching the world. */
#ifndef SKV_MEASURE_WALL_FORCE_H
#define SKV_MEASURE_WALL_FORCE_H

#include "skvalp/measure.h"
#include "solver/solver.h"
#include "world/springs/springs.h"

/* On the walls inside a box. */
typedef struct skv_wall_force {
    double fx, fy; /* N */
    double torque; /* N m, counterclockwise about the box's centre */
} skv_wall_force;

/* Memory between measurements; all zero at the start. */
typedef struct skv_force_meter {
    skv_solver *solver;
    skv_solver_def made_for;
    /* The copy of the fluid. */
    float *x, *y, *vx, *vy, *clearance, *pressure, *warm_lambda, *mass;
    uint32_t *id;
    int capacity;
    void *block;
    skv_spring_pushes pushes; /* of the world's particles */
} skv_force_meter;

/* Takes the world's next substep on a copy of the fluid near the box and adds up what the walls in
 * the box do to it. Allocates only when more fluid is there than ever before. */
skv_result skv_force_measure(skv_force_meter *meter, const skv_world *world, double x0, double y0,
                             double x1, double y1, skv_wall_force *force, skv_error *error);
/* Adds what air does to the walls in the box of a reaction, and takes out what lifts all pressures.
 */
void skv_force_add_air(const skv_world *world, const skv_reaction *box, skv_wall_force *force);
void skv_force_free(skv_force_meter *meter);

#endif
