/* An ideal liquid that sloshes in a tank with walls 1 apart, released from a straight slope. */
#ifndef SKV_TESTS_IDEAL_TANK_H
#define SKV_TESTS_IDEAL_TANK_H

#include "ideal_surface.h"

/* At rest, `depth` deep in the middle, and rising by `slope` to the right. Fineness 1: 40 elements,
 * more in shallow water. */
void ideal_tank_begin(ideal_surface *tank, double depth, double slope, double fineness);
/* Where the centre of all liquid is. */
double ideal_tank_centre(const ideal_surface *tank);

#endif
