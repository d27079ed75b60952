/* Potential flow of a liquid between mirrors, that is, walls and a floor, by boundary elements. */
#ifndef SKV_TESTS_MIRRORED_FLOW_H
#define SKV_TESTS_MIRRORED_FLOW_H

#include <stdbool.h>

/* In the corner of a wall and a floor. The surface goes from the wall x = 0 through `count`
 * vertices to the floor y = 0, the liquid on its right. Writes the speed through the middle of each
 * of the count - 1 elements, outwards, of the flow that has this potential at the vertices. False
 * without memory, or if there is no one solution. */
bool quarter_flow(int count, const double *x, const double *y, const double *potential,
                  double *through);

/* The same in a tank: its floor is y = 0, and the surface ends on a second wall x = 1. */
bool tank_flow(int count, const double *x, const double *y, const double *potential,
               double *through);

#endif
