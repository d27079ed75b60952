/* Contours inside one cell of a grid, shared by fields and the surface. */
#ifndef SKV_MEASURE_CONTOUR_H
#define SKV_MEASURE_CONTOUR_H

#include "skvalp/measure.h"

/* A cell of the grid, its values counterclockwise from the lower left. Edges are counted alike: 0
 * is the lower one, 1 the right, 2 the upper, 3 the left. */
typedef struct skv_contour_cell {
    double x, y, step;
    double value[4];
    double level;
} skv_contour_cell;

skv_contour_cell skv_contour_cell_at(const skv_grid *grid, const float *values, double level,
                                     int column, int row);

/* The pieces of the contour in a cell, 0 to 2: the edges on which each begins and ends, the higher
 * values on its left. None if a value is NaN. */
typedef struct skv_contour_piece {
    int from, to;
} skv_contour_piece;
int skv_contour_pieces(const skv_contour_cell *cell, skv_contour_piece pieces[2]);

/* Where the contour crosses an edge, the same for both cells that share it. */
skv_point skv_contour_crossing(const skv_contour_cell *cell, int edge);

#endif
