/* Sums over the rest lattice: the densities that a particle of a fluid at rest sees. */
#ifndef SKV_SOLVER_LATTICE_H
#define SKV_SOLVER_LATTICE_H

/* Sums over the hexagonal lattice with one point per spacing^2, the point itself left out, for a
 * radius of `eta` spacings; q = 1 - r/h. */
typedef struct skv_lattice {
    double density;      /* sum q^2 */
    double near_density; /* sum q^3 */
    double virial;       /* sum (r/h) q: how strongly the pressure acts */
    double near_virial;  /* sum (r/h) q^2: how strongly the near pressure acts */
} skv_lattice;

skv_lattice skv_lattice_sums(double eta);

#endif
