/* The dam break of an ideal liquid, released at once. */
#ifndef SKV_TESTS_IDEAL_DAM_H
#define SKV_TESTS_IDEAL_DAM_H

#include "ideal_surface.h"

/* A column 1 wide and `height` high at rest, its right side free. Fineness 1: 36 elements at the
 * start. */
void ideal_dam_begin(ideal_surface *dam, double height, double fineness);
/* The farthest that liquid is at a height above the floor. */
double ideal_dam_front(const ideal_surface *dam, double height);

#endif
