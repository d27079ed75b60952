/* What the rows do where there are solids beside the terrain; see solids.c. */
#ifndef SKV_ROWS_SOLIDS_H
#define SKV_ROWS_SOLIDS_H

#include "solver/rows/rows_internal.h"
#include "solver/wall_image.h"
#include "terrain/solids.h"

/* Lowers the bounds of a row's distances from walls to those from the circles around all solids,
 * while these move. */
void skv_rows_expect_solids(const skv_rows *rows, int row, const skv_boundary *boundary);

/* Samples the walls at (x, y), each of several after their sum; returns the distance. */
float skv_rows_sample_solids(const skv_boundary *boundary, bool images, float x, float y,
                             skv_near_wall *to);

/* How far the walls move in the substep that a particle has been sampled beside. */
void skv_rows_way_of_walls(const skv_rows *rows, const skv_near_wall *wall, const skv_constants *c,
                           const skv_boundary *boundary, float *dx, float *dy);

/* What makes up a push: the factors of D's slope, of F1 and of F2. */
typedef struct skv_push_made {
    float by_slope, by_rest, by_near;
} skv_push_made;

/* Books for each solid what it gives a particle at (x, y): displacement times mass; by the walls
 * that it has been sampled beside, ... */
void skv_rows_book_push(const skv_rows *rows, const skv_near_wall *wall, bool images,
                        const skv_boundary *boundary, float x, float y, float dx, float dy,
                        skv_push_made made, skv_row_given *walls);
/* ... what they have taken from its way, to all of them, too, ... */
void skv_rows_book_cuts(const skv_rows *rows, const skv_boundary *boundary, int i, float x, float y,
                        const skv_cuts *cuts, skv_row_given *walls);
/* ... and what the tension of a row's particles turns them by: its energy knows which way they
 * face, since what they add to the gradient is part of it. While the gradients are still there. */
void skv_rows_book_turns(const skv_rows *rows, int row, const skv_constants *c,
                         const skv_boundary *boundary, const skv_row_samples *samples,
                         skv_row_given *walls);
/* Writes what each has given in a call, of all threads, in m and the world's axes. */
void skv_rows_tell_solids(const skv_rows *rows, const skv_boundary *boundary, skv_impulse *given);

/* Contact, Algorithm 7, with whatever particle i is deepest in. */
void skv_rows_touch_solids(const skv_rows *rows, int i, const skv_constants *c,
                           const skv_boundary *boundary, skv_row_given *walls);

#endif
