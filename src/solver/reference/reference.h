/* The fluid as the reference solver sees it, and the passes of a substep in their order.
 *
 * The reference is the text from which to learn the method, and what tests hold the rows against:
 * one particle after the other, one thread, double precision, SI units. A pass is a function of the
 * fluid and stands in one line of take_substep, in reference.c. "Algorithm" is the thesis' number.
 *
 * Invariant: a pass that goes over pairs writes a particle's own elements only, and none that the
 * same pass reads of others. So the order of the particles does not matter, and what two particles
 * of a pair give each other is opposite.
 */
#ifndef SKV_SOLVER_REFERENCE_H
#define SKV_SOLVER_REFERENCE_H

#include "solver/reference/neighbours.h"
#include "solver/solver.h"
#include "terrain/solids.h"

typedef struct skv_reference {
    skv_solver solver;
    const skv_boundary *boundary;
    skv_neighbours neighbours; /* lists of pairs, as of the substep's advance */

    /* The step under way: what it is asked for. */
    const skv_constants *constants;
    double gravity_x, gravity_y; /* m/s^2 */
    const skv_external_force *forces;
    int force_count;
    bool first, last;         /* which iteration it is */
    bool various;             /* particles have viscosities of their own */
    bool massive;             /* and masses */
    bool advances;            /* the move under way is the advance, while solids move, too */
    skv_impulse given;        /* by walls, m and m^2 */
    skv_impulse *solid_given; /* null: not wanted */
    skv_reaction *reaction;   /* null: not wanted */

    /* The particles, one element each. */
    int count;
    const uint32_t *id;
    const uint8_t *fluid;      /* solver.h */
    const skv_liquid *liquids; /* solver.h; null: no fluid pushes others */
    const float *cohesion;     /* solver.h; null: all have the constants' */
    double *x, *y;             /* position, m */
    double *vx, *vy;           /* velocity before and after the substep, m/s */
    double *clearance;         /* lower bound of the distance to the nearest wall, m */
    double *pressure;          /* gauge, Pa m */
    double *mass;              /* over the first fluid's */
    double *drag;              /* sigma dt of its linear viscosity times the mass */
    double *warm_lambda; /* what the pressure term pushes: of the last substep, then of this, m */

    double *moved_x, *moved_y;   /* displacement in this substep so far, m */
    double *behind_x, *behind_y; /* how far behind the position pairs are taken, m */
    double *dx, *dy; /* the displacement that passes collect until it is carried out; from pairs
                        and walls times the mass, until it is divided by it */

    double *density, *near_density; /* sum W, sum q^3, walls included; dimensionless */
    double *mean_mass;              /* of what is around: skv_pass_density */
    double *gradient_x,
        *gradient_y;              /* sum F r^, walls included, less what the bulk has; times ... */
    double *hanging;              /* share of a wall's pull that one is let fall from */
    double *lambda, *near_lambda; /* ... as P and N of the pressure law, m: the mean mass */

    /* What walls add to these sums: the solid, or the images before it. */
    double *wall_density, *wall_near; /* R, Rn of the wall maps; dimensionless */
    double *f1x, *f1y, *f2x, *f2y;    /* F1, F2 of the wall maps; dimensionless */
    double *image;                    /* D of images, in h: wall_image.h */
    double *facing_x, *facing_y;      /* its slope: about the unit vector out of the wall */

    float *listed_x, *listed_y; /* where pairs were taken when they were listed, m */

    int capacity;
    void *block; /* the one allocation behind all of the arrays */
    size_t bytes;
    double seconds[SKV_SOLVER_MOST_PASSES]; /* of each pass, for the profile */
} skv_reference;

typedef void skv_pass(skv_reference *fluid);

/* velocity.c */

/* Algorithm 2: gravity, the hands and the force fields change the velocity. */
skv_pass skv_pass_external_forces;

/* Algorithm 4: clamps the speed and puts the wanted move into dx, dy; the displacement so far and
 * the gauge start at 0. */
skv_pass skv_pass_predict;

/* How far behind the particles pairs are taken: a share of the way that they have gone in the
 * substep, for the slopes that push them are those of the middle of it; less for what hardly moves,
 * which a late push calms. */
skv_pass skv_pass_lag;

/* Algorithm 3: pairs that approach each other exchange impulses. Of pairs of different fluids the
 * linear part is the harmonic mean of both, as a shear stress goes through one fluid and then the
 * other; the quadratic one and the bound of both are of the lighter one's mass. In dx, dy. */
skv_pass skv_pass_viscosity;

/* Unlike pairs of which the heavier particle lies above turn about each other: solver/turn.h. In
 * dx, dy. */
skv_pass skv_pass_turn;
/* Unlike pairs push each other apart by the stronger of their fluids' pushes. In dx, dy. */
skv_pass skv_pass_push;

/* Algorithm 8: the velocity is the displacement of the substep over its time. */
skv_pass skv_pass_velocity;

/* What external forces do in a substep to the velocity of a particle in a place, gravity apart. */
void skv_apply_forces(const skv_reference *fluid, double x, double y, double *vx, double *vy);

/* relaxation.c */

/* Algorithm 6, lines 3-9: densities from neighbours and walls, and in the first iteration their
 * gradient, which the tension needs. And the mean mass, which says how far a particle and what is
 * around it give way: the reciprocal of the mean of reciprocals, each weighted with its near
 * density. What a wall adds is of the particle's own kind. */
skv_pass skv_pass_density;

/* Algorithm 6, lines 10-11: P and N of a particle from its densities, by the fluid's law. */
skv_pass skv_pass_pressure;

/* Algorithm 6, lines 13-19: collects the displacement in dx, dy, and adds the virial to the gauge
 * pressure. */
skv_pass skv_pass_displacement;

/* The calibrated law's surface tension (docs/model.md): adds to dx, dy and the gauge pressure what
 * evens out the gradients. */
skv_pass skv_pass_tension;

/* Divides dx, dy by the mass: so far they are what pairs and walls give. */
skv_pass skv_pass_divide;

/* walls.c */

/* What walls add to the sums: the wall maps, or the images of the particles beside them. */
skv_pass skv_pass_walls;

/* Takes from dx, dy what friction and viscosity hold of the slip beside a wall by images. */
skv_pass skv_pass_slip;

/* Carries out dx, dy as far as walls allow. */
skv_pass skv_pass_move;

/* Algorithm 7 for particles closer to a wall than the contact distance: friction along it and a
 * push out of it, carried out at once. */
skv_pass skv_pass_contact;

/* Books (dx, dy) times its mass, in m, which the walls' part of the displacement has given particle
 * i: `out` times D's slope, P F1 + N F2, and what holds it there. */
void skv_book_push(skv_reference *fluid, int i, double out, double lambda, double near_lambda,
                   double dx, double dy);

/* Books what the tension of particle i turns the walls beside it by: its energy knows which way
 * they face, since what they add to the gradient is part of it. */
void skv_book_turn(skv_reference *fluid, int i);

#endif
