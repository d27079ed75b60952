/* The parameters of a world and its fluid, one row each: the one place that knows what a parameter
 * is called, its unit, range, default and meaning. A new scalar is a member of skv_fluid_def or
 * skv_world_def, a row here, and its use.
 *
 * Whoever includes this defines what becomes of a row:
 *   NUMBER(id, path, member, unit, least, most, standard, live, help)
 *   WHOLE(...)   the same for whole numbers
 *   FLAG(id, path, member, standard, live, help)
 *   CHOICE(id, path, member, choices, standard, help)
 *   PRESET(id, path, choices, standard, live, help)   sets other parameters, is none itself
 * and, where it matters, of
 *   NUMBER_BY_LAW, WHOLE_BY_LAW(..., standard, clavet, live, help)   two defaults
 *   FOUND_NUMBER(...)   a scene finds it from the rest if it is not given
 *   HOST_WHOLE, HOST_CHOICE(...)   the host's affair, not a scene's
 * `member` is that of skv_world_def, `standard` the default, `clavet` that of the clavet law;
 * `live`: it can be changed while a world runs. All macros are undefined at the end.
 */
#ifndef NUMBER_BY_LAW
#define NUMBER_BY_LAW(id, path, member, unit, least, most, standard, clavet, live, help)           \
    NUMBER(id, path, member, unit, least, most, standard, live, help " (clavet: " #clavet ")")
#define WHOLE_BY_LAW(id, path, member, unit, least, most, standard, clavet, live, help)            \
    WHOLE(id, path, member, unit, least, most, standard, live, help " (clavet: " #clavet ")")
#endif
#ifndef FOUND_NUMBER
#define FOUND_NUMBER NUMBER
#endif
#ifndef HOST_WHOLE
#define HOST_WHOLE  WHOLE
#define HOST_CHOICE CHOICE
#endif

/* clang-format off */
WHOLE(SUBSTEPS, "substeps", substeps, "", 0, 1000, 0, false,
      "substeps in 1/60 s; 0: by depth and gravity")
FLAG(SLEEP, "sleep", sleep, true, false,
     "fluid at rest is not stepped until something disturbs it")
NUMBER(DEPTH, "depth", depth, "m", 0, 16, 0, false,
       "deepest fluid to expect, for the substeps; 0: from the start")
NUMBER(GRAVITY_X, "gravity.x", gravity_x, "m/s^2", -1000, 1000, 0, true,
       "gravity to the right")
NUMBER(GRAVITY_Y, "gravity.y", gravity_y, "m/s^2", -1000, 1000, -9.81, true,
       "gravity upwards")

WHOLE(EMISSION_LIMIT, "emission.limit", emission_limit, "", 0, SKV_MAX_PARTICLES, 20000, true,
      "emitters stop when the world holds so many particles")
FLAG(EMISSION_REPLACES, "emission.replaces", emission_replaces, false, true,
     "instead of stopping there the oldest particles go")

CHOICE(FLUID_LAW, "fluid.law", fluid.law, "calibrated|clavet", calibrated,
       "pressure law: like a real liquid, or as in the thesis")
PRESET(FLUID_MATERIAL, "fluid.material", "water|oil|honey|mercury", water, true,
       "sets density and viscosity as of that liquid at 20 °C")
FOUND_NUMBER(FLUID_SPACING, "fluid.spacing", fluid.spacing, "m", 0.0005, 0.1, 0.0155, false,
             "one particle per spacing^2; instead of particles")
NUMBER_BY_LAW(FLUID_RADIUS_RATIO, "fluid.radius_ratio", fluid.radius_ratio, "", 2, 4, 3,
              2.85, false, "smoothing radius in spacings")
NUMBER(FLUID_DENSITY, "fluid.density", fluid.density, "kg/m^2", 1, 20000, 1000, true,
       "mass of a square metre of the sheet")
NUMBER(FLUID_VISCOSITY, "fluid.viscosity", fluid.viscosity, "m^2/s", 0, 0.05, 0.000001,
       true, "kinematic viscosity; else the material's (oil 0.000092, honey 0.007)")
NUMBER(FLUID_VISCOSITY_LINEAR, "fluid.viscosity_linear", fluid.viscosity_linear, "1/s", 0, 1000,
       0, true, "removes a pair's approach speed")
NUMBER(FLUID_VISCOSITY_QUADRATIC, "fluid.viscosity_quadratic", fluid.viscosity_quadratic, "1/m",
       0, 1000, 0, true, "the same, growing with the speed")
NUMBER(FLUID_NEAR_STIFFNESS, "fluid.near_stiffness", fluid.near_stiffness, "m/s^2", 0, 200,
       107.9, true, "calibrated law: keeps particles apart")
NUMBER(FLUID_COHESION, "fluid.cohesion", fluid.cohesion, "m/s^2", 0, 500, 78.48, true,
       "calibrated law: 39 splashes, 235 clings")
NUMBER(FLUID_RELAXATION, "fluid.relaxation", fluid.relaxation, "", 0.05, 0.4, 0.35, true,
       "calibrated law: share of the correction applied in a round, 4/radius_ratio^2 at most")
WHOLE_BY_LAW(FLUID_ITERATIONS, "fluid.iterations", fluid.iterations, "", 1, 8, 2, 1, true,
             "relaxation rounds a substep")
NUMBER(FLUID_CLAVET_STIFFNESS, "fluid.clavet_stiffness", fluid.clavet_stiffness, "", 0, 0.02,
       0.004, true, "clavet law: k, with h = dt = 1")
NUMBER(FLUID_CLAVET_NEAR_STIFFNESS, "fluid.clavet_near_stiffness", fluid.clavet_near_stiffness,
       "", 0, 0.2, 0.04, true, "clavet law: k_near, with h = dt = 1")
NUMBER(FLUID_CLAVET_REST_DENSITY, "fluid.clavet_rest_density", fluid.clavet_rest_density, "",
       1, 40, 10, true, "clavet law: rho0, a sum over neighbours")
NUMBER(FLUID_WALL_FRICTION, "fluid.wall_friction", fluid.wall_friction, "", 0, 1, 0.05,
       true, "share of the speed along a wall lost in 1/60 s")
NUMBER(FLUID_WALL_SOFTNESS, "fluid.wall_softness", fluid.wall_softness, "", 0.1, 1, 1, true,
       "share of a penetration corrected in 1/60 s")
NUMBER_BY_LAW(FLUID_CONTACT_DISTANCE, "fluid.contact_distance", fluid.contact_distance, "", 0, 1,
              0.2, 0.3, true, "contact with a wall that drags begins so many spacings away")
FLAG(FLUID_WALL_IMAGES, "fluid.wall_images", fluid.wall_images, true, false,
     "calibrated law: walls that do not drag, by images")
NUMBER(FLUID_ADHESION, "fluid.adhesion", fluid.adhesion, "", 0, 1, 0, true,
       "walls by images: share of their pull that holds fluid up against gravity")

HOST_WHOLE(THREADS, "threads", threads, "", 0, SKV_MAX_THREADS, 0, false,
           "threads to compute on; 0: one per physical core")
HOST_WHOLE(CAPACITY, "capacity", capacity, "", 0, SKV_MAX_PARTICLES, 0, false,
           "particles to make room for at creation")
HOST_CHOICE(SOLVER, "solver", solver, "fast|reference", fast,
            "the production solver, or the one that is written for reading")
HOST_CHOICE(INSTRUCTION_SET, "instruction_set", instruction_set,
            "best|scalar|sse2|avx2|avx512|neon|wasm", best,
            "instruction set to compute with; the results are the same")
/* clang-format on */
#undef NUMBER
#undef NUMBER_BY_LAW
#undef WHOLE
#undef WHOLE_BY_LAW
#undef FOUND_NUMBER
#undef FLAG
#undef CHOICE
#undef PRESET
#undef HOST_WHOLE
#undef HOST_CHOICE
