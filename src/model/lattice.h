/* Sums over the hexagonal lattice with one particle per spacing^2: the fluid at rest. */
#ifndef SKV_MODEL_LATTICE_H
#define SKV_MODEL_LATTICE_H

#include "model/kernel.h"

typedef struct skv_lattice {
    double density;      /* sum W */
    double response;     /* sum F^2: how much the density answers to a push of 1, by the gain */
    double near_density; /* sum q^3 */
    double virial;       /* sum r F, r in h */
    double near_virial;  /* sum r q^2 */
} skv_lattice;

/* For eta = h/s, 2..4. */
skv_lattice skv_lattice_sums(skv_kernel kernel, double eta);

#endif
