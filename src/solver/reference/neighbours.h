/* Neighbour lists (thesis, Algorithm 5 and section 3.2): a grid of cells of the smoothing radius,
 * filled by a counting sort, and for each particle the list of those within the radius.
 *
 * Lists hold ascending cells and, within a cell, ascending particle indices: the order, and so
 * every floating-point sum over a list, depends on the state alone.
 */
#ifndef SKV_SOLVER_REFERENCE_NEIGHBOURS_H
#define SKV_SOLVER_REFERENCE_NEIGHBOURS_H

#include "skvalp/base.h"
#include "terrain/boundary.h"

typedef struct skv_neighbours {
    float origin_x, origin_y, inv_cell; /* of the grid, m and 1/m */
    int columns, rows;
    int *cell_start; /* columns*rows + 1: where a cell's particles begin in `sorted` */
    int *sorted;     /* particle indices by cell */
    int *cell;       /* each particle's cell */
    int *start;      /* count + 1: where a particle's list begins in `list` */
    int *list;
    void *particle_block, *list_block;
    int particle_capacity, list_capacity;
    int wanted;                   /* elements the last build would have liked in `list` */
    const skv_boundary *boundary; /* pairs that its thin walls part are left out; null: none are */
} skv_neighbours;

/* Sets up the grid over [x0, x1] x [y0, y1]; particles outside count for the nearest cell.
 * `boundary` has to outlive the lists. */
skv_result skv_neighbours_create(skv_neighbours *neighbours, float x0, float y0, float x1, float y1,
                                 float h, const skv_boundary *boundary, skv_error *error);
void skv_neighbours_destroy(skv_neighbours *neighbours);

/* Makes room for `count` particles and for one and a half times the list of the last build. Only
 * here is memory allocated: a warm step finds enough. On failure nothing changes. */
skv_result skv_neighbours_reserve(skv_neighbours *neighbours, int count, skv_error *error);

/* Builds the lists of pairs with r < h. A list that does not fit, which takes a fluid squeezed to
 * two thirds of its volume within one substep, is cut; the next reserve makes room. */
void skv_neighbours_build(skv_neighbours *neighbours, const float *x, const float *y, int count,
                          float h);

#endif
