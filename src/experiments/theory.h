/* What the textbook says, in SI units: plain functions of plain numbers, with their sources. */
#ifndef SKV_EXPERIMENTS_THEORY_H
#define SKV_EXPERIMENTS_THEORY_H

/* Pressure at a depth in water at rest, Pa m: rho g z (Stevin, Pascal). */
double skv_theory_pressure(double density, double gravity, double depth);

/* The same where another liquid begins below `interface`, a depth: the weights of both add up. */
double skv_theory_layered_pressure(double upper, double lower, double gravity, double interface,
                                   double depth);

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

/* How high a wave of the first kind is: its rise at a wall, slope width / 2, in the depth that it
 * feels, tanh(k d) / k. That is the rise over the depth in shallow water and k rise in deep water;
 * at some 0.5 waves break at any depth. */
double skv_theory_slosh_height(double width, double depth, double slope);

/* What an ideal liquid keeps of the amplitude of its centre after one period, released at rest from
 * a straight slope: it loses height, because the wave steepens. For skv_theory_slosh_depths, in
 * widths, and skv_theory_slosh_heights; by boundary elements (tests/experiments/ideal_tank.h), to
 * 0.001. */
enum { SLOSH_DEPTHS = 12, SLOSH_HEIGHTS = 6 };
extern const double skv_theory_slosh_depths[SLOSH_DEPTHS];
extern const double skv_theory_slosh_heights[SLOSH_HEIGHTS];
extern const double skv_theory_slosh_kept[SLOSH_DEPTHS][SLOSH_HEIGHTS];

/* The same for any tank: between the table's entries to 0.003. Beyond them it is that of the
 * nearest depth, which is as good in deeper water and 0.011 too much in half the shallowest, and of
 * the nearest height, which is too much. */
double skv_theory_slosh_amplitude(double width, double depth, double slope);

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

/* How far a jet reaches that leaves horizontally under such a head, until it has fallen by a
 * height: 2 sqrt(head height). */
double skv_theory_jet_range(double head, double height);

/* How many times as deep a stream is behind a jump or bore as before it: (sqrt(1 + 8 F^2) - 1)/2 at
 * a Froude number F, which is the speed at which it runs into the jump over sqrt(g depth) (Belanger
 * 1828, of mass and momentum). */
double skv_theory_conjugate(double froude);

/* The same of a bore that a stream makes before a wall. Froude's number there counts the speed of
 * stream and bore together, and the bore has u/(r - 1), for water behind it stands still. So the
 * stream's own is F^2 = (r - 1)^2 (r + 1)/2r, of which this is the root r. */
double skv_theory_bore(double stream_froude);

/* Contraction of a jet from a sharp-edged slot in a plane wall: pi/(pi + 2) (Kirchhoff 1869). */
double skv_theory_contraction(void);

/* Buoyancy of a submerged body, N: rho g V (Archimedes). */
double skv_theory_buoyancy(double density, double gravity, double area);

/* The volume of air that had `volume` at a pressure, at another one: their product stays (Boyle).
 */
double skv_theory_boyle(double pressure, double volume, double other_pressure);

/* How deep a block floats: what it displaces weighs as much as it does (Archimedes). */
double skv_theory_draught(double density, double body, double height);

/* How much a block loses of its height by its own weight, if it can spread: rho g H^2/8G, for what
 * is squeezed in a sheet and keeps its area has the plane modulus 4 G. */
double skv_theory_sag(double density, double gravity, double height, double modulus);

/* Atwood's number of two densities, and the rate at which a small wave grows between the heavier
 * one above and the other below, each so deep: n^2 = A g k tanh(k d), k = 2 pi / length (Rayleigh,
 * Taylor). */
double skv_theory_atwood(double heavy, double light);
double skv_theory_growth(double atwood, double gravity, double length, double depth);

#endif
