/* The oracle: the thesis' Algorithms 2-8 with the errata of docs/model.md, in scalar double
 * precision, all pairs, straight from the formulas. It shares no code with the solver. */
#ifndef SKV_TEST_ORACLE_H
#define SKV_TEST_ORACLE_H

#include <stdbool.h>

enum { ORACLE_MAX = 600 };

/* One finger. */
typedef struct oracle_hand {
    double x, y, vx, vy, radius, attraction, friction, follow;
} oracle_hand;

typedef struct oracle {
    int n;
    double x[ORACLE_MAX], y[ORACLE_MAX], vx[ORACLE_MAX], vy[ORACLE_MAX];
    double wx[ORACLE_MAX], wy[ORACLE_MAX], dx[ORACLE_MAX], dy[ORACLE_MAX];
    double px[ORACLE_MAX], py[ORACLE_MAX]; /* where pairs are taken */
    double density[ORACLE_MAX], near_density[ORACLE_MAX], gx[ORACLE_MAX], gy[ORACLE_MAX];
    double lambda[ORACLE_MAX], near_lambda[ORACLE_MAX], pressure[ORACLE_MAX];
    double warm[ORACLE_MAX]; /* of the pressure term in the last substep, m/s^2 */
    double warm_start;       /* share of it with which the next one starts */
    double wall_density[ORACLE_MAX], wall_near[ORACLE_MAX];
    double f1x[ORACLE_MAX], f1y[ORACLE_MAX], f2x[ORACLE_MAX], f2y[ORACLE_MAX];
    /* Of walls by images: D in h, 1 or more where there are none, and its slope. */
    double image[ORACLE_MAX], facing_x[ORACLE_MAX], facing_y[ORACLE_MAX];
    double depth[ORACLE_MAX], normal_x[ORACLE_MAX], normal_y[ORACLE_MAX];

    /* Parameters, SI. */
    double s, eta, fluid_density, dt, g_x, g_y, sigma, beta, friction_a_frame, softness_a_frame;
    double omega, k_near, k_coh; /* calibrated law */
    bool images;                 /* walls by images */
    double adhesion;
    int iterations;
    bool clavet;
    double k, k_near_clavet, rest_density_clavet; /* clavet law, in units of h and dt */
    const oracle_hand *hand;
    /* An upright wall so thin that only pairs feel it: those that it parts do not exist. */
    bool walled;
    double wall_x;
} oracle;

/* The hand acts on what walls let go of, too, from now on; null: none. */
void oracle_external_forces(oracle *o, const oracle_hand *hand);
void oracle_viscosity(oracle *o);
void oracle_advance(oracle *o, double max_speed);
/* From now on pairs are taken so much of the substep's way behind where the particles are,
 * less of it where they hardly move; and how much that is by the calibrated law. */
#define ORACLE_LAG 0.7
void oracle_take_pairs(oracle *o, double lag);
void oracle_density(oracle *o, bool gradient);
/* `first`: iteration, which starts warm. */
void oracle_pressure(oracle *o, bool first);
/* `last`: iteration, which tells the gauge how dense it is beside images. */
void oracle_displacement(oracle *o, bool last);
void oracle_tension(oracle *o);
void oracle_contact(oracle *o);
void oracle_correct(oracle *o);
void oracle_velocity(oracle *o);

/* Density of the rest lattice and the rest density rho0 of the law. */
double oracle_lattice_density(bool clavet, double eta);
double oracle_rest_density(const oracle *o);

#endif
