/* What the textbook says, in SI units: plain functions of plain numbers, with their sources. */
#ifndef SKV_EXPERIMENTS_THEORY_H
#define SKV_EXPERIMENTS_THEORY_H

/* Pressure at a depth in water at rest, Pa m: rho g z (Stevin, Pascal). */
double skv_theory_pressure(double density, double gravity, double depth);

/* Period of a liquid column of inertial length L between two equal arms: 2 pi sqrt(L / 2g) (Newton,
 * Principia II, prop. 44; L instead of the centre line's length for arms of finite width). */
double skv_theory_u_tube_period(double gravity, double length);

/* Inertial length of a U of two arms and a bend, all of width `arm`, their centre lines `gap`
 * apart, filled to `level` above the floor: the length with which rho L w v^2 / 2 is the kinetic
 * energy of potential flow with speed v in arms of width w. Laplace's equation on a grid,
 * extrapolated. */
double skv_theory_inertial_length(double arm, double gap, double level);

/* Period of the first standing wave in a tank: omega^2 = g k tanh(k d), k = pi / width (Airy, Lamb
 * Hydrodynamics section 228). For small amplitudes. */
double skv_theory_slosh_period(double gravity, double width, double depth);

/* A collapsing column, width a and height n^2 a, n^2 = 2: when, in T = n t sqrt(g/a), the front
 * reaches Z = x/a. Measured by Martin and Moyce 1952, Phil. Trans. R. Soc. A 244, 312-324, a = 2.25
 * in; for an ideal liquid, released at once, by boundary elements (tests/experiments/ideal_dam.h):
 * the farthest liquid at each of the heights, to 0.003. */
enum { DAM_POINTS = 15, DAM_HEIGHTS = 6 };
typedef struct dam_point {
    double time, measured, ideal[DAM_HEIGHTS]; /* T, Z, Z */
} dam_point;
extern const dam_point skv_theory_dam[DAM_POINTS];
extern const double skv_theory_dam_heights[DAM_HEIGHTS]; /* above the floor, in widths */

/* How much later than the ideal liquid's front at a height of 0.02 the measured one is, in T: the
 * shift that leaves the least rms deviation (0.04 in Z, without it 0.33). */
#define DAM_LATE 0.26

/* The ideal liquid's Z at the i-th time and a height above the floor, in widths; below and above
 * the table's heights it is that at the first and the last of them. */
double skv_theory_dam_front(int point, double height);

/* Speed of a jet under a head of water: sqrt(2 g h) (Torricelli). */
double skv_theory_jet_speed(double gravity, double head);

/* Contraction of a jet from a sharp-edged slot in a plane wall: pi/(pi + 2) (Kirchhoff 1869). */
double skv_theory_contraction(void);

/* Buoyancy of a submerged body, N: rho g V (Archimedes). */
double skv_theory_buoyancy(double density, double gravity, double area);

#endif
