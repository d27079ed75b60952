/* Bodies of water whose every answer is known: worlds that are written to instead of stepped. */
#ifndef SKV_TESTS_MEASURE_REST_H
#define SKV_TESTS_MEASURE_REST_H

#include "skvalp/measure.h"

/* A tank of 1.6 x 0.9 m with the rest lattice from the floor up to `depth`. */
skv_world *rest_pool(float spacing, float depth);

/* p = at_origin + slope_x x + slope_y y */
void rest_set_pressure(skv_world *world, double at_origin, double slope_x, double slope_y);

/* Solid rotation (spin, 1/s) and stretching along x (1/s) about a centre. */
void rest_set_velocity(skv_world *world, double centre_x, double centre_y, double spin,
                       double stretch);

/* Heaves the water above the floor so that its surface is depth + amplitude sin(k x - phase);
 * `still` are the particles' heights at rest. */
void rest_set_wave(skv_world *world, const float *still, double depth, double amplitude, double k,
                   double phase);

/* Moves every particle, and the clock. */
void rest_shift(skv_world *world, float dx, float dy, double seconds);

void rest_remove(skv_world *world, int index);

#endif
