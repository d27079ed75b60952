/* Squares of a picture, as a set: which of its parts have changed, and what lies near them. */
#ifndef SKV_TERRAIN_SQUARES_H
#define SKV_TERRAIN_SQUARES_H

#include "skvalp/base.h"

enum { SKV_SQUARE = 8 }; /* pixels a side */

typedef struct skv_squares {
    int columns, rows; /* squares */
    uint8_t *marks;    /* columns * rows: 1 where a square belongs to the set */
} skv_squares;

/* The empty set, for a picture of so many pixels. Needs skv_squares_destroy. */
skv_result skv_squares_create(int pixels_x, int pixels_y, skv_squares *squares, skv_error *error);
void skv_squares_destroy(skv_squares *squares);

/* Adds the square of a pixel. */
void skv_squares_add(skv_squares *squares, int x, int y);

/* Adds the squares in which two pictures of so many pixels differ; false if they do not. */
bool skv_squares_add_differences(skv_squares *squares, const uint8_t *a, const uint8_t *b,
                                 int pixels_x, int pixels_y);

/* Makes another set: all squares within so many pixels of one. Needs skv_squares_destroy. */
skv_result skv_squares_spread(const skv_squares *squares, double pixels, skv_squares *all,
                              skv_error *error);

/* The box around the set, in pixels; its last ones lie before x1 and y1. All 0 if it is empty. */
typedef struct skv_square_bounds {
    int x0, y0, x1, y1;
} skv_square_bounds;
skv_square_bounds skv_squares_bounds(const skv_squares *squares);

/* True if the set has a square that holds a point of the box, in pixels; the box may reach beyond
 * the picture. */
bool skv_squares_meet(const skv_squares *squares, double x0, double y0, double x1, double y1);

#endif
