/* What is the same for all particles of a substep: the fluid's constants. The world makes them in
 * SI units. The rows convert them once, at their door, to those in which h and dt are 1. */
#ifndef SKV_MODEL_CONSTANTS_H
#define SKV_MODEL_CONSTANTS_H

#include "model/kernel.h"
#include "skvalp/fluid.h"

#include <stdbool.h>

/* What viscosity takes of a pair's approach in a substep, at most, at q = 1. Half of a particle's
 * pairs approach, and take half of the rest each: all of them together would reverse it with 1. */
#define SKV_MOST_VISCOUS 0.5f

/* What a particle itself weighs in the mean mass of what is around it: q^3 at no distance, a third
 * of the whole in the lattice at rest. What is light among heavy ones is moved itself by what
 * pushes it out from one side; without it, it would be shot off. */
#define SKV_OWN_WEIGHT 1.0f

/* Constants of a substep. Lengths in m, times in s. */
typedef struct skv_constants {
    float h, inv_h;
    float dt;
    float max_speed; /* clamp at the advance, m/s */
    /* How far pairs lie behind the particles, per way of the substep, at most, and how much of that
     * per square of the speed, s^2/m^2: skv_pass_lag. */
    float pair_lag, lag_rise;

    float viscosity_linear, viscosity_quadratic; /* sigma 1/s, beta 1/m */

    /* Pressure laws. Densities are dimensionless. */
    bool clavet;             /* the clavet law, else the calibrated one */
    bool images;             /* walls by images: wall_image.h; calibrated law alone */
    int iterations;          /* relaxation rounds */
    skv_kernel kernel;       /* of the density; the near density has its own */
    float rest_density;      /* rho0 */
    float lambda_scale;      /* calibrated: omega h/gain; clavet: dt^2 k/2; m */
    float near_lambda_scale; /* the same for the near density; m */
    float lambda_limit;      /* clavet: bound of rho N, m */
    float wall_virial;       /* virial of a smooth solid, per h R P: 2/gain */
    float loose_lambda;      /* P of a particle that no wall holds up, at most; m */
    /* Calibrated law alone. */
    float warm_start; /* share of the last substep's P with which the next one starts; 0: cold */
    float warm_limit; /* the most of that P that counts, m */
    float warm_most;  /* ... and the most of it, per P that the excess of density finds */
    float response_slope; /* how strongly the density answers to P, per density, ... */
    float response_floor; /* ... and at least */
    float near_share;     /* near density per density in the lattice at rest: more is a crowd */
    float cohesion_scale; /* cohesion per missing density, m */
    float cohesion_below; /* density from which on none is missing */
    float cohesion_from;  /* density up to which there is no cohesion ... */
    float cohesion_slope; /* ... and how steeply its share grows to 1 from there */
    float tension_scale;  /* of the surface tension, m */
    float tension_from;   /* gradient up to which there is none */
    float tension_until;  /* P of the last substep from which on there is none, m */
    /* Walls by images alone. */
    float adhesion;       /* share of a wall's pull that holds against gravity */
    float residual_share; /* near density per density of the residual volume */
    float image_gradient; /* F1 beside a flat wall, per slope of the solid's share */
    float image_virial, image_near_virial; /* of fluid and images as one body, per h P and h N */
    float slip_friction; /* share of the slip along a wall that friction takes a substep */
    float wall_drag;     /* strength of viscosity's pairs with the solid */
    /* Both for fluids of their own viscosity: of those without, and per sigma dt of the others. */
    float bare_slip, wall_stick;

    float turn_reach; /* how far unlike pairs turn, in h: solver/turn.h */

    float pressure_scale; /* gauge: Pa m per m^2 of virial (sum of distance times displacement) */

    float design_pressure; /* that cold substeps of this length are made for, Pa m */

    float softness; /* share of the penetration corrected a substep */
    float friction; /* share of the tangential displacement removed a substep */
} skv_constants;

/* True if the pair viscosity has anything to do. */
static inline bool skv_is_viscous(const skv_constants *constants)
{
    return constants->viscosity_linear > 0 || constants->viscosity_quadratic > 0;
}

/* True if walls hold anything of what slips along them, out of contact too. */
static inline bool skv_resists_slip(const skv_constants *constants)
{
    return constants->slip_friction > 0 || constants->wall_drag > 0;
}

/* sigma of all of a fluid's linear viscosity, 1/s. */
double skv_linear_viscosity(const skv_fluid_def *fluid);

/* Those of a fluid as stiff as dt allows. */
skv_constants skv_make_constants(const skv_fluid_def *fluid, float compression, float dt);

/* k dt^2 of the springs of a fluid with a shear modulus, Pa, and a density, kg/m^2, as stiff as dt
 * allows: two of their particles push each other by half of it times q(L) and what their spring is
 * shortened by, L being its length at rest. */
double skv_spring_stiffness(const skv_fluid_def *fluid, double shear_modulus, double density,
                            double dt);
/* How many substeps a frame bear such springs. */
int skv_spring_rule(const skv_fluid_def *fluid, double shear_modulus, double density);

/* The rule: how many substeps a frame bear a load. */
int skv_substep_rule(const skv_fluid_def *fluid, double load);
/* How many substeps are as stiff as that many of the rule's, which start cold, if they start warm
 * (docs/model.md); with the clavet law so many. */
int skv_warm_substeps(const skv_fluid_def *fluid, int cold);
/* Makes a substep's pressure as stiff as that of so many substeps that start cold: weaker if they
 * are less than one, warm if they are more. Not with the clavet law, which is as stiff as it is. */
void skv_set_stiffness(skv_constants *constants, float cold);
/* The kernel of a law's pressure. */
skv_kernel skv_law_kernel(skv_law law);

/* Whether walls act by images. */
bool skv_has_images(const skv_fluid_def *fluid);

/* Closer to a wall than this is contact, m. */
float skv_contact_distance(const skv_fluid_def *fluid);

/* |g| at a flat surface: n0 times the integral of F x/r over a half disc. */
double skv_surface_gradient(const skv_fluid_def *fluid);

/* The areas, in that of the start, that a clavet fluid may take at rest: one that takes more bursts
 * as soon as it can, and of one that takes less its particles meet in points. From 1.5 on a dam's
 * drops fly faster than it falls. Down to 0.44 none of 121 dams burst, from there to 0.4 up to
 * three of 80 did. */
#define SKV_CLAVET_WIDEST    1.45
#define SKV_CLAVET_NARROWEST 0.45

/* 1 if it takes more at rest, -1 if it takes less; else, and by another law, 0. */
int skv_clavet_swells(const skv_fluid_def *fluid);

/* m/s, with substeps of dt; 0 for a law that has none. */
double skv_speed_of_sound(const skv_fluid_def *fluid, double dt);

#endif
