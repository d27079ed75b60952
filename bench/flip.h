/* Another method, to measure beside ours: FLIP, particles that carry what a grid has made free of
 * divergence (Brackbill and Ruppel 1986; for liquids Zhu and Bridson 2005). Written anew after the
 * papers, in plain C with single precision and on one thread, as simple as it gets. */
#ifndef BENCH_FLIP_H
#define BENCH_FLIP_H

#include <stdbool.h>

/* Steps a frame of 1/60 s, and sweeps of the pressure in each. */
enum { FLIP_STEPS = 2, FLIP_SWEEPS = 30 };

typedef struct flip flip;

/* A closed tank, m, with a box of water in its lower left corner; null without memory. */
flip *flip_create(double width, double height, double water_width, double depth, int particles);
void flip_destroy(flip *f);

int flip_particles(const flip *f);
/* A step of so many seconds. */
void flip_step(flip *f, float dt);
/* The rms speed, m/s, and the mean height of the particles, m. */
void flip_measure(const flip *f, double *speed, double *height);

#endif
