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

/* Martin and Moyce 1952, Phil. Trans. R. Soc. A 244, 312-324, series n^2 = 2, a = 2.25 in: when the
 * front of a collapsing column, width a and height n^2 a, reaches Z = x/a, in T = n t sqrt(g/a). */
enum { DAM_POINTS = 15 };
typedef struct dam_point {
    double time, front; /* T, Z */
} dam_point;
extern const dam_point skv_theory_dam[DAM_POINTS];

/* Speed of a jet under a head of water: sqrt(2 g h) (Torricelli). */
double skv_theory_jet_speed(double gravity, double head);

/* Contraction of a jet from a sharp-edged slot in a plane wall: pi/(pi + 2) (Kirchhoff 1869). */
double skv_theory_contraction(void);

/* Buoyancy of a submerged body, N: rho g V (Archimedes). */
double skv_theory_buoyancy(double density, double gravity, double area);

#endif
