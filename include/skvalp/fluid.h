/** @file
 * Fluid: what a liquid is like, as plain data.
 */
#ifndef SKVALP_FLUID_H
#define SKVALP_FLUID_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How density becomes displacement. Both go through the same passes. */
typedef enum skv_law {
    SKV_LAW_CALIBRATED, /**< density constraint: pressures and periods of a real liquid (default) */
    SKV_LAW_CLAVET      /**< the thesis' double density relaxation (Algorithm 6, symmetric) */
} skv_law;

/** "calibrated" or "clavet". */
SKV_API const char *skv_law_name(skv_law law);

/** A fluid's parameters. Initialise with skv_default_fluid_def, which depends on the law. Ranges
 * and defaults are those of skv_world_field. */
typedef struct skv_fluid_def {
    uint32_t cookie;
    skv_law law;
    float spacing;               /**< s: one particle per s*s square metres at rest, m */
    float radius_ratio;          /**< h/s: smoothing radius in spacings */
    float density;               /**< kg/m^2 of the sheet */
    float viscosity;             /**< kinematic, m^2/s, on top of the method's own */
    float viscosity_linear;      /**< sigma, 1/s: removes a pair's approach speed */
    float viscosity_quadratic;   /**< beta, 1/m: the same, growing with the speed */
    float near_stiffness;        /**< k_near, m/s^2, calibrated law */
    float cohesion;              /**< k_coh, m/s^2, calibrated law */
    float relaxation;            /**< omega, share of the correction applied, calibrated law;
                                      more than 4 / radius_ratio^2 acts as that */
    int iterations;              /**< relaxation rounds a substep */
    float clavet_stiffness;      /**< k h^-1 dt^2, dimensionless */
    float clavet_near_stiffness; /**< k_near h^-1 dt^2, dimensionless */
    float clavet_rest_density;   /**< rho0, dimensionless */
    float wall_friction;         /**< share of the tangential speed lost at a wall in 1/60 s */
    float wall_softness;         /**< share of the penetration corrected in 1/60 s */
    float contact_distance;      /**< in spacings: closer to a wall that drags is contact */
    bool wall_images;            /**< walls by images, which do not drag; calibrated law */
    float adhesion;              /**< share of their pull that holds fluid up against gravity */
} skv_fluid_def;

/** The default fluid, water, for a law. */
SKV_API skv_fluid_def skv_default_fluid_def(skv_law law);
SKV_API void skv_fluid_def_init(skv_fluid_def *def, size_t size, skv_law law);

/** Fluids that a world may have, the first included. */
#define SKV_MAX_FLUIDS 8
/** Bytes of a fluid's name, its end included. */
#define SKV_FLUID_NAME 32

/** What one fluid of a world has for itself beside others; all else is as skv_fluid_def says.
 * Initialise with skv_default_liquid. */
typedef struct skv_liquid {
    uint32_t cookie;
    char name[SKV_FLUID_NAME]; /**< UTF-8 without control characters, another for each fluid of a
                                    world; "water" is the first */
    float density;             /**< kg/m^2 of the sheet, 0.01..20 times that of the first */
    float viscosity;           /**< kinematic, m^2/s, as in skv_fluid_def: 0..0.05 */
    int color; /**< 0xrrggbb, as it looks in deep layers; -1: by material and number */
    /** Pa, 0..20000: springs between its particles resist a change of shape, as in jelly; 0: none,
     * a liquid. */
    float shear_modulus;
    float yield; /**< strain of a spring from which on it gives way for good, 0..1; default 0.1 */
    float plasticity; /**< share of what is beyond that which it gives way by in a second, 1/s,
                           0..100, 0 without a shear modulus; 0: it stays elastic, and what
                           touches later does not join */
    /** m/s^2, 0..400: how strongly its particles and those of other fluids push each other apart;
     * between two such fluids the stronger counts. 20 makes the line between oil and water short,
     * 100 holds drops of oil together; 0, the default: nothing but weight parts them. */
    float interface_push;
    /** m/s^2, 0..500, as in skv_fluid_def, calibrated law: how strongly its own surface draws
     * together; -1, the default: as the first fluid's. */
    float cohesion;
} skv_liquid;

/** A liquid like the default fluid, which still needs a name of its own; and the same for binders
 * ("Definitions" in skvalp/base.h). */
SKV_API skv_liquid skv_default_liquid(void);
SKV_API void skv_liquid_init(skv_liquid *def, size_t size);

/** Liquids by name: density in kg/m^3 and kinematic viscosity in m^2/s at 20 degrees Celsius. */
typedef struct skv_material {
    const char *name;
    float density, viscosity;
} skv_material;

/** The materials; null past the last. Static. The first is water, the default fluid. */
SKV_API const skv_material *skv_material_info(int i);

#ifdef __cplusplus
}
#endif
#endif
