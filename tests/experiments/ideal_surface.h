/* The moving surface of an ideal liquid: without friction, tension or air. Lengths are in a unit
 * that its liquid has, times in sqrt(unit / gravity). */
#ifndef SKV_TESTS_IDEAL_SURFACE_H
#define SKV_TESTS_IDEAL_SURFACE_H

#include <stdbool.h>

enum { SURFACE_VERTICES = 1000 };

typedef struct ideal_surface ideal_surface;

/* What one liquid has and another has not. */
typedef struct ideal_liquid {
    bool ends_on_wall; /* where the last vertex stays at its x; else it stays on the floor y = 0 */
    /* The flow that has this potential, as those of mirrored_flow.h. */
    bool (*flow)(int count, const double *x, const double *y, const double *potential,
                 double *through);
    /* How long an element may be at a height above the floor, at fineness 1. */
    double (*wanted_length)(double height);
    void (*cut)(ideal_surface *surface); /* what is too thin; null: nothing */
} ideal_liquid;

/* The surface from the wall x = 0 on, the liquid on its right: where it is, and its potential. */
struct ideal_surface {
    const ideal_liquid *liquid;
    double fineness; /* of the elements: 2 makes them half as long, and all errors smaller */
    double time;
    int count, steps;
    double x[SURFACE_VERTICES], y[SURFACE_VERTICES], potential[SURFACE_VERTICES];
};

/* Spreads the vertices along the surface as densely as is wanted; false if they are too many. */
bool ideal_surface_spread(ideal_surface *surface);
/* Goes on by a step, but not beyond `until`; false without memory or if the surface breaks. */
bool ideal_surface_step(ideal_surface *surface, double until);
/* Goes on until `time`; false likewise. */
bool ideal_surface_run(ideal_surface *surface, double time);

/* The velocity of each vertex; false without memory. */
bool ideal_surface_velocity(const ideal_surface *surface, double *u, double *v);
double ideal_surface_area(const ideal_surface *surface);
/* Kinetic and potential energy, for gravity and density 1; NaN without memory. */
double ideal_surface_energy(const ideal_surface *surface);

#endif
