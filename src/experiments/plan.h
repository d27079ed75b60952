/* The plan of a set-up: solids, water and bodies as polygons, and the scene that they make. */
#ifndef SKV_EXPERIMENTS_PLAN_H
#define SKV_EXPERIMENTS_PLAN_H

#include "skvalp/experiments.h"

enum { MAX_CORNERS = 64, MAX_SHAPES = 8, MAX_PLAN_FLUIDS = 2, MAX_PLAN_BODIES = 3 };

/* A polygon in metres, and the speed at which water in it starts. */
typedef struct shape {
    int corners;
    double x[MAX_CORNERS], y[MAX_CORNERS];
    double vx, vy; /* m/s */
} shape;

shape skv_shape_box(double x0, double y0, double x1, double y1);
/* A polygon of 64 corners with the area of the ellipse with half axes a and b. */
shape skv_shape_ellipse(double x, double y, double a, double b);

/* A fluid beside the first: kg/m^2, and Pa, 0 without springs. */
typedef struct plan_fluid {
    const char *name;
    double density, shear_modulus;
} plan_fluid;

/* A rigid body, kg/m^2. */
typedef struct plan_body {
    shape outline;
    double density;
} plan_body;

/* What a rig is to look like. */
typedef struct rig_plan {
    double width, height; /* of the closed world, m */
    int solids, waters;
    shape solid[MAX_SHAPES], water[MAX_SHAPES];
    bool open_right, open_bottom;
    double depth; /* deepest water to expect, m */
    double gravity_x, gravity_y;
    double share; /* of the wanted number of particles; 0: 1 */
    /* Of experiments beside alone (experiment.h). */
    int fluids, bodies;
    plan_fluid fluid[MAX_PLAN_FLUIDS];
    int fluid_of[MAX_SHAPES]; /* of the waters: 0 is the first fluid, 1 that of fluid[0] */
    plan_body body[MAX_PLAN_BODIES];
    double air; /* pressure of the atmosphere, Pa m; 0: there is none */
} rig_plan;

/* Loads the plan as a scene called `name`. The settings say what the fluid is, and `particles` or
 * `fluid.spacing`, which is about `spacing` metres and tells how fine the walls are to be drawn. */
skv_result skv_plan_scene(const rig_plan *plan, const char *name, double spacing,
                          const skv_setting *settings, int setting_count, skv_scene **scene,
                          skv_error *error);

/* Writes the plan of an experiment as a scene to play with: with `particles` of them, where
 * measuring is forgotten and still water may sleep. */
skv_result skv_plan_write(const rig_plan *plan, const skv_experiment *of, double particles,
                          const skv_setting *settings, int setting_count, skv_write *write,
                          void *user, skv_error *error);

/* The area of the plan's water, m^2; what lies in a solid counts, too. */
double skv_plan_area(const rig_plan *plan);

#endif
