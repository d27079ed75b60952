/* Placing: where a new instrument begins. */
#ifndef SKV_SESSION_PLACING_H
#define SKV_SESSION_PLACING_H

#include "skvalp/stage.h"

/* Under the pointer, if it is over a view, and else in the water nearest to the middle of what the
 * first side shows. `in_water`: in the water nearest to the pointer, too, and below the surface. */
void skv_place(const skv_stage *stage, bool in_water, double *x, double *y);

#endif
