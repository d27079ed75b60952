/* The field registry: one table of everything a scene file may say.
 *
 * Invariant: the table is the only place that knows a field's type, range, choices and default.
 * Readers, messages, --set, panels and docs/scenes.md all derive from it.
 */
#include "scene/fields.h"

#include <assert.h>

#include "skvalp/terrain.h"

#define NUMBER SKV_FIELD_NUMBER
#define WHOLE  SKV_FIELD_INTEGER
#define TEXT   SKV_FIELD_TEXT
#define CHOICE SKV_FIELD_CHOICE
#define FLAG   SKV_FIELD_BOOLEAN

/* The fields that every shape has. `list` is "solid[]" or "water[]". */
#define SHAPE_FIELDS(base, list)                                                                   \
    [base +                                                                                        \
        SKV_SHAPE_KIND] =                                                                          \
        {list ".shape", CHOICE, "", 0, 0, "box|circle|polygon|line", "", "kind of shape; needed"}, \
        [base + SKV_SHAPE_X0] = {list ".x0", NUMBER, "m", -100, 100, NULL, "0", "box: left side"}, \
        [base +                                                                                    \
            SKV_SHAPE_Y0] = {list ".y0", NUMBER, "m", -100, 100, NULL, "0", "box: lower side"},    \
        [base +                                                                                    \
            SKV_SHAPE_X1] = {list ".x1", NUMBER, "m", -100,                                        \
                             100,        NULL,   "",  "box: right side; else the world's width"},  \
        [base +                                                                                    \
            SKV_SHAPE_Y1] = {list ".y1", NUMBER, "m", -100,                                        \
                             100,        NULL,   "",  "box: upper side; else the world's height"}, \
        [base + SKV_SHAPE_X] = {list ".x", NUMBER, "m", -100,                                      \
                                100,       NULL,   "",  "circle: centre; needed"},                 \
        [base + SKV_SHAPE_Y] = {list ".y", NUMBER, "m", -100,                                      \
                                100,       NULL,   "",  "circle: centre; needed"},                 \
        [base + SKV_SHAPE_RADIUS] = {list ".radius",          NUMBER, "m", 0.0001, 100, NULL, "",  \
                                     "circle: radius; needed"},                                    \
        [base + SKV_SHAPE_POINTS] = {list ".points[][]",                                           \
                                     NUMBER,                                                       \
                                     "m",                                                          \
                                     -100,                                                         \
                                     100,                                                          \
                                     NULL,                                                         \
                                     "",                                                           \
                                     "polygon, line: corners [[x, y], ...]; needed"},              \
        [base + SKV_SHAPE_THICKNESS] = {list ".thickness",                                         \
                                        NUMBER,                                                    \
                                        "m",                                                       \
                                        0.0001,                                                    \
                                        10,                                                        \
                                        NULL,                                                      \
                                        "0.02",                                                    \
                                        "line: its width; ends and bends are round"}

static const skv_field fields[SKV_F_COUNT] = {
    [SKV_F_NAME] = {"name", TEXT, "", 0, 64, NULL, "", "short name; else the file's name"},
    [SKV_F_TITLE] = {"title", TEXT, "", 0, 100, NULL, "", "heading; else the name"},
    [SKV_F_DESCRIPTION] = {"description", TEXT, "", 0, 1000, NULL, "",
                           "one or two sentences about what there is to see"},
    [SKV_F_SECONDS] = {"seconds", NUMBER, "s", 0.1, 3600, NULL, "10",
                       "a fitting length of a recording"},
    [SKV_F_PARTICLES] = {"particles", WHOLE, "", 1, SKV_MAX_PARTICLES, NULL, "3000",
                         "number of particles; the spacing follows from it"},
    [SKV_F_SUBSTEPS] = {"substeps", WHOLE, "", 0, 1000, NULL, "0",
                        "substeps in 1/60 s; 0: by depth and gravity"},
    [SKV_F_SLEEP] = {"sleep", FLAG, "", 0, 1, NULL, "true",
                     "fluid at rest is not stepped until something disturbs it"},
    [SKV_F_DEPTH] = {"depth", NUMBER, "m", 0, 100, NULL, "0",
                     "deepest fluid to expect, for the substeps; 0: from the start"},

    [SKV_F_WORLD_WIDTH] = {"world.width", NUMBER, "m", 0.01, 16, NULL, "1.6", "width of the world"},
    [SKV_F_WORLD_HEIGHT] = {"world.height", NUMBER, "m", 0.01, 16, NULL, "0.9",
                            "height of the world; not beside a picture, which has its own"},
    [SKV_F_WORLD_PIXEL] = {"world.pixel", NUMBER, "m", 0.0001, 0.1, NULL, "0.0025",
                           "grain of the walls; not beside a picture"},
    [SKV_F_WORLD_PICTURE] = {"world.picture", TEXT, "", 0, 255, NULL, "",
                             "painted PNG, in the scene file's folder or below it"},
    [SKV_F_OPEN_LEFT] = {"world.open.left", FLAG, "", 0, 1, NULL, "false",
                         "fluid leaves through the left side"},
    [SKV_F_OPEN_RIGHT] = {"world.open.right", FLAG, "", 0, 1, NULL, "false",
                          "fluid leaves through the right side"},
    [SKV_F_OPEN_BOTTOM] = {"world.open.bottom", FLAG, "", 0, 1, NULL, "false",
                           "fluid leaves through the bottom"},
    [SKV_F_OPEN_TOP] = {"world.open.top", FLAG, "", 0, 1, NULL, "false",
                        "fluid leaves through the top"},
    [SKV_F_GRAVITY_X] = {"gravity.x", NUMBER, "m/s^2", -1000, 1000, NULL, "0",
                         "gravity to the right"},
    [SKV_F_GRAVITY_Y] = {"gravity.y", NUMBER, "m/s^2", -1000, 1000, NULL, "-9.81",
                         "gravity upwards"},

    [SKV_F_FLUID_LAW] = {"fluid.law", CHOICE, "", 0, 0, "calibrated|clavet", "calibrated",
                         "pressure law: like a real liquid, or the thesis' own"},
    [SKV_F_FLUID_MATERIAL] = {"fluid.material", CHOICE, "", 0, 0, "water|oil|honey|mercury",
                              "water", "sets density and viscosity as of that liquid at 20 C"},
    [SKV_F_FLUID_SPACING] = {"fluid.spacing", NUMBER, "m", 0.0005, 0.1, NULL, "",
                             "one particle per spacing^2; instead of particles"},
    [SKV_F_FLUID_RADIUS_RATIO] = {"fluid.radius_ratio", NUMBER, "", 2, 4, NULL, "3",
                                  "smoothing radius in spacings (clavet: 2.85)"},
    [SKV_F_FLUID_DENSITY] = {"fluid.density", NUMBER, "kg/m^2", 1, 20000, NULL, "1000",
                             "mass of a square metre of the sheet"},
    [SKV_F_FLUID_VISCOSITY] =
        {"fluid.viscosity", NUMBER, "m^2/s", 0, 0.05, NULL, "0.000001",
         "kinematic viscosity; else the material's (oil 0.000092, honey 0.007)"},
    [SKV_F_FLUID_VISCOSITY_LINEAR] = {"fluid.viscosity_linear", NUMBER, "1/s", 0, 1000, NULL, "0",
                                      "removes a pair's approach speed"},
    [SKV_F_FLUID_VISCOSITY_QUADRATIC] = {"fluid.viscosity_quadratic", NUMBER, "1/m", 0, 1000, NULL,
                                         "0", "the same, growing with the speed"},
    [SKV_F_FLUID_NEAR_STIFFNESS] = {"fluid.near_stiffness", NUMBER, "m/s^2", 0, 200, NULL, "98.1",
                                    "calibrated law: keeps particles apart"},
    [SKV_F_FLUID_COHESION] = {"fluid.cohesion", NUMBER, "m/s^2", 0, 500, NULL, "78.48",
                              "calibrated law: 39 splashes, 235 clings"},
    [SKV_F_FLUID_RELAXATION] = {"fluid.relaxation", NUMBER, "", 0.05, 0.4, NULL, "0.35",
                                "calibrated law: share of the correction applied in a round"},
    [SKV_F_FLUID_ITERATIONS] = {"fluid.iterations", WHOLE, "", 1, 8, NULL, "2",
                                "relaxation rounds a substep (clavet: 1)"},
    [SKV_F_FLUID_CLAVET_STIFFNESS] = {"fluid.clavet_stiffness", NUMBER, "", 0, 0.02, NULL, "0.004",
                                      "clavet law: k, with h = dt = 1"},
    [SKV_F_FLUID_CLAVET_NEAR_STIFFNESS] = {"fluid.clavet_near_stiffness", NUMBER, "", 0, 0.2, NULL,
                                           "0.04", "clavet law: k_near, with h = dt = 1"},
    [SKV_F_FLUID_CLAVET_REST_DENSITY] = {"fluid.clavet_rest_density", NUMBER, "", 1, 40, NULL, "10",
                                         "clavet law: rho0, a sum over neighbours"},
    [SKV_F_FLUID_WALL_FRICTION] = {"fluid.wall_friction", NUMBER, "", 0, 1, NULL, "0.05",
                                   "share of the speed along a wall lost in 1/60 s"},
    [SKV_F_FLUID_WALL_SOFTNESS] = {"fluid.wall_softness", NUMBER, "", 0.1, 1, NULL, "1",
                                   "share of a penetration corrected in 1/60 s"},
    [SKV_F_FLUID_CONTACT_DISTANCE] =
        {"fluid.contact_distance", NUMBER, "", 0, 1, NULL, "0.2",
         "contact with a wall begins so many spacings away (clavet: 0.3)"},

    SHAPE_FIELDS(SKV_F_SOLID, "solid[]"),
    [SKV_F_SOLID + SKV_SHAPE_CARVE] = {"solid[].carve", FLAG, "", 0, 1, NULL, "false",
                                       "cut the shape out of the solid before it in the list"},
    SHAPE_FIELDS(SKV_F_WATER, "water[]"),
    [SKV_F_WATER + SKV_SHAPE_VX] = {"water[].vx", NUMBER, "m/s", -20, 20, NULL, "0",
                                    "speed to the right at the start"},
    [SKV_F_WATER + SKV_SHAPE_VY] = {"water[].vy", NUMBER, "m/s", -20, 20, NULL, "0",
                                    "speed upwards at the start"},
};

const skv_field *skv_scene_fields(int *count)
{
    if (count != NULL)
        *count = SKV_F_COUNT;
    return fields;
}
