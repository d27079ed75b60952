/* The dam break of an ideal liquid: without friction, tension or air, released at once. */
#ifndef SKV_TESTS_IDEAL_DAM_H
#define SKV_TESTS_IDEAL_DAM_H

#include <stdbool.h>

enum { DAM_VERTICES = 1000 };

/* The liquid's surface from the wall x = 0 to the floor y = 0: where it is, and its potential.
 * Lengths are in widths of the column, times in sqrt(width / gravity). */
typedef struct ideal_dam {
    double fineness; /* 1: 36 elements at the start; 2: twice as many, and all errors smaller */
    double time;
    int count, steps;
    double x[DAM_VERTICES], y[DAM_VERTICES], potential[DAM_VERTICES];
} ideal_dam;

/* A column 1 wide and `height` high at rest. */
void ideal_dam_begin(ideal_dam *dam, double height, double fineness);
/* Goes on until `time`; false without memory or if the surface breaks. */
bool ideal_dam_run(ideal_dam *dam, double time);

/* The velocity of each vertex; false without memory. */
bool ideal_dam_velocity(const ideal_dam *dam, double *u, double *v);
/* The farthest that liquid is at a height above the floor. */
double ideal_dam_front(const ideal_dam *dam, double height);
double ideal_dam_area(const ideal_dam *dam);
/* Kinetic and potential energy, for gravity and density 1; NaN without memory. */
double ideal_dam_energy(const ideal_dam *dam);

#endif
