/* The production solver: particles sorted into rows, pairs found by ranges, eight at a time.
 *
 * rows.c is the list of passes; layout.h says where everything lies.
 *
 * Scheme. Space is cut into rows one smoothing radius high, each row into cells of h/4. Particles
 * are kept sorted by row and cell, so the partners of a particle with a higher place are two
 * contiguous ranges: the rest of its own row up to h ahead, and the stretch of the next row within
 * h on either side. Each pair is visited once. Tiles of four consecutive particles share the loads
 * of their partners; eight partners are handled at a time. A row's task adds what it finds for its
 * own particles to `own` and for the next row's to `next`; these are added up later. So no two
 * tasks write the same place, and the result does not depend on threads, instruction set or
 * compiler.
 *
 * Within a substep the rows run through a pipeline: walls of row R+1, density of row R, pressure
 * of row R, displacement of row R-1, update of row R-1; so a row's data is still in the cache, and
 * its pairs' q are kept for the displacement. Rows lie across the longer side of the world, to have
 * many of them.
 *
 * Units: lengths in h, times in substeps. Coordinates: `x` runs along the rows, `y` across them.
 */
#ifndef SKV_SOLVER_ROWS_H
#define SKV_SOLVER_ROWS_H

#include "solver/solver.h"

/* What acts on the fluid from outside, in h and substeps. */
typedef struct skv_row_acting {
    float gravity_x, gravity_y;
    float turn_sense; /* -1 where the axes are mirrored, which makes right of left */
    const skv_external_force *forces;
    int force_count;
    float wall_margin; /* how close a move may come to a wall */
    float contact_distance;
} skv_row_acting;

typedef struct skv_rows skv_rows;

/* Makes the grid for a world of the given size (in h, in the solver's axes), in which a square of
 * side h holds `per_square` particles at rest. SKV_ERROR_VALUE if the machine lacks the instruction
 * set. */
skv_result skv_rows_create(float width, float height, float per_square, skv_instruction_set set,
                           skv_rows **rows, skv_error *error);
void skv_rows_destroy(skv_rows *rows);

/* Makes room for `count` particles, with masses or without, and these viscous or not, and for
 * `threads` threads; allocates only when it has to. */
skv_result skv_rows_reserve(skv_rows *rows, int count, int threads, bool masses, bool drags,
                            skv_error *error);

/* The particles outside, in units of the caller's. */
typedef struct skv_row_frame {
    int count;
    const uint8_t *part; /* skv_part; null: all move */
    float *x, *y, *vx, *vy;
    float *clearance;     /* lower bound of the distance to the nearest wall */
    float *pressure;      /* written only; null: nobody wants it */
    float *warm_lambda;   /* solver.h */
    const float *mass;    /* solver.h */
    const float *drag;    /* solver.h */
    bool viscous;         /* masses are */
    float dt;             /* s */
    float length, speed;  /* factors from the caller's units to h, h a substep, ... */
    float lambda;         /* ... and h a substep squared */
    float sunk_x, sunk_y; /* how far below their places held ones lie, h */
    const skv_solver_particles *particles; /* as they came: of which fluids they are */
} skv_row_frame;

/* Takes in the frame's particles, takes `substeps` substeps, and writes the particles back. The
 * state lies in the frame's arrays alone: nothing is kept from call to call but memory. The
 * constants are those of h = dt = 1. Returns what walls have given the particles that are not held,
 * adds to a reaction what it asks for, and writes what each solid has given, in m and the world's
 * axes; null: nobody wants it.
 */
skv_impulse skv_rows_step(skv_rows *rows, const skv_row_frame *frame, int substeps,
                          const skv_constants *constants, const skv_row_acting *acting,
                          const skv_boundary *boundary, skv_pool *pool, skv_reaction *reaction,
                          skv_impulse *solid_given);

/* Wall seconds since the last call with `reset`: advance, sort, relaxation, transfer in and out. */
void skv_rows_profile(skv_rows *rows, bool reset, double seconds[4]);

skv_solver_memory skv_rows_memory(const skv_rows *rows);

#endif
