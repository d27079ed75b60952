/* The registry of a scene's fields, and paths into it.
 *
 * Invariant: the table, with the world's rows in it, is the only place that knows a field's type,
 * range, choices and default. Readers, messages, --set, panels and docs/scenes.md derive from it.
 */
#include "scene/fields.h"

#include <string.h>

#include "base/more.h"
#include "skvalp/acting.h"
#include "world/dye.h"

/* Without bodies there are no fields of theirs and of air, which are the last. Who asks for one
 * tells the host, which brings more: web/core/no_bodies.c. */
#ifdef SKV_WITHOUT_BODIES
enum { FIELDS = SKV_F_BODIES };
#else
enum { FIELDS = SKV_F_COUNT };
#endif

/* Rows of the scene's own. Nobody reads in the page's first modules what texts and fields of lists
 * are for: there they do not say so. */
#define HELP(text) text
#ifdef SKV_WITHOUT_BODIES
#define TEXT_HELP(text) ""
#else
#define TEXT_HELP(text) text
#endif
#define OWN_TEXT(id, path, most, help)                                                             \
    [id] = {path, SKV_FIELD_TEXT, "", 0, most, NULL, "", TEXT_HELP(help)},
#define OWN_NUMBER(id, path, unit, least, most, standard, help)                                    \
    [id] = {path, SKV_FIELD_NUMBER, unit, least, most, NULL, standard, HELP(help)},
#define OWN_WHOLE(id, path, least, most, standard, help)                                           \
    [id] = {path, SKV_FIELD_INTEGER, "", least, most, NULL, standard, HELP(help)},
#define OWN_FLAG(id, path, standard, help)                                                         \
    [id] = {path, SKV_FIELD_BOOLEAN, "", 0, 1, NULL, standard, HELP(help)},
#define OWN_CHOICE(id, path, choices, standard, help)                                              \
    [id] = {path, SKV_FIELD_CHOICE, "", 0, 0, choices, standard, HELP(help)},

/* Rows of the world's; the host's parameters are no scene's. */
#define NUMBER(id, path, member, unit, least, most, standard, live, help)                          \
    OWN_NUMBER(SKV_F_##id, path, unit, least, most, #standard, help)
#define FOUND_NUMBER(id, path, member, unit, least, most, standard, live, help)                    \
    OWN_NUMBER(SKV_F_##id, path, unit, least, most, "", help)
#define WHOLE(id, path, member, unit, least, most, standard, live, help)                           \
    OWN_WHOLE(SKV_F_##id, path, least, most, #standard, help)
#define FLAG(id, path, member, standard, live, help) OWN_FLAG(SKV_F_##id, path, #standard, help)
#define CHOICE(id, path, member, choices, standard, help)                                          \
    OWN_CHOICE(SKV_F_##id, path, choices, #standard, help)
#define PRESET(id, path, choices, standard, live, help)                                            \
    OWN_CHOICE(SKV_F_##id, path, choices, #standard, help)
#define HOST_WHOLE(...)
#define HOST_CHOICE(...)

#define FIRST_DYE(name) name
#define NEXT_DYE(name)  "|" name
#define DYES            SKV_DYE_NAMES(FIRST_DYE, NEXT_DYE)

/* clang-format off */
/* The fields that every shape has. `list` is "solid[]" or the like. */
#define SHAPE_FIELDS(base, list, kinds, kind_help, cornered)                                       \
    OWN_CHOICE(base + SKV_SHAPE_KIND, list ".shape", kinds, "", kind_help)                         \
    OWN_NUMBER(base + SKV_SHAPE_X0, list ".x0", "m", -100, 100, "0", "box: left side")             \
    OWN_NUMBER(base + SKV_SHAPE_Y0, list ".y0", "m", -100, 100, "0", "box: lower side")            \
    OWN_NUMBER(base + SKV_SHAPE_X1, list ".x1", "m", -100, 100, "",                                \
               "box: right side; else the world's width")                                          \
    OWN_NUMBER(base + SKV_SHAPE_Y1, list ".y1", "m", -100, 100, "",                                \
               "box: upper side; else the world's height")                                         \
    OWN_NUMBER(base + SKV_SHAPE_X, list ".x", "m", -100, 100, "", "circle: centre; needed")        \
    OWN_NUMBER(base + SKV_SHAPE_Y, list ".y", "m", -100, 100, "", "circle: centre; needed")        \
    OWN_NUMBER(base + SKV_SHAPE_RADIUS, list ".radius", "m", 0.0001, 100, "",                      \
               "circle: radius; needed")                                                           \
    OWN_NUMBER(base + SKV_SHAPE_POINTS, list ".points[][]", "m", -100, 100, "",                    \
               cornered ": corners [[x, y], ...]; needed")

/* Those of areas in which something is done, and of shapes that can be lines, too. */
#define AREA_FIELDS(base, list, kind_help)                                                         \
    SHAPE_FIELDS(base, list, "box|circle|polygon", kind_help, "polygon, at most 64")

#define LINE_FIELDS(base, list)                                                                    \
    SHAPE_FIELDS(base, list, "box|circle|polygon|line", "kind of shape; needed", "polygon, line")  \
    OWN_NUMBER(base + SKV_SHAPE_THICKNESS, list ".thickness", "m", 0.0001, 10, "0.02",             \
               "line: its width; ends and bends are round")

static const skv_field fields[FIELDS] = {
    OWN_TEXT(SKV_F_NAME, "name", 64, "short name; else the file's name")
    OWN_TEXT(SKV_F_TITLE, "title", 100, "heading; else the name")
    OWN_TEXT(SKV_F_DESCRIPTION, "description", 1000,
             "one or two sentences about what there is to see")
    OWN_NUMBER(SKV_F_SECONDS, "seconds", "s", 0.1, 3600, "10", "a fitting length of a recording")
    OWN_NUMBER(SKV_F_WORLD_WIDTH, "world.width", "m", 0.01, 16, "1.6", "width of the world")
    OWN_NUMBER(SKV_F_WORLD_HEIGHT, "world.height", "m", 0.01, 16, "0.9",
               "height of the world; not beside a picture, which has its own")
    OWN_NUMBER(SKV_F_WORLD_PIXEL, "world.pixel", "m", 0.0001, 0.1, "0.0025",
               "grain of the walls; not beside a picture")
    OWN_TEXT(SKV_F_WORLD_PICTURE, "world.picture", 255,
             "painted PNG, in the scene file's folder or below it")
    OWN_FLAG(SKV_F_OPEN_LEFT, "world.open.left", "false", "fluid leaves through the left side")
    OWN_FLAG(SKV_F_OPEN_RIGHT, "world.open.right", "false", "fluid leaves through the right side")
    OWN_FLAG(SKV_F_OPEN_BOTTOM, "world.open.bottom", "false", "fluid leaves through the bottom")
    OWN_FLAG(SKV_F_OPEN_TOP, "world.open.top", "false", "fluid leaves through the top")
    OWN_FLAG(SKV_F_SETTLE, "settle", "true", "what can rest where it is begins at rest")
    OWN_WHOLE(SKV_F_PARTICLES, "particles", 1, SKV_MAX_PARTICLES, "3000",
              "number of particles; the spacing follows from it")
#include "world/parameter_rows.h"
#ifdef SKV_WITHOUT_BODIES
#undef HELP
#define HELP(text) ""
#endif
    OWN_TEXT(SKV_F_FLUIDS + SKV_LIQUID_NAME, "fluids[].name", SKV_FLUID_NAME - 1,
             "by which water and emitters name it; needed; \"water\" is the fluid above")
    OWN_CHOICE(SKV_F_FLUIDS + SKV_LIQUID_MATERIAL, "fluids[].material", "water|oil|honey|mercury",
               "water", "its density and viscosity are as of that liquid at 20 °C")
    OWN_TEXT(SKV_F_FLUIDS + SKV_LIQUID_COLOR, "fluids[].color", 7,
             "as it looks where it is deep, \"#rrggbb\"; else by material and place in the list")
#define LIQUID_NUMBER(id, member, unit, least, most, standard, extra, help)                        \
    LIQUID_FIELD(id, member, unit, least, most, #standard, help)
#define LIQUID_OF_MATERIAL(id, member, unit, least, most, help)                                    \
    LIQUID_FIELD(id, member, unit, least, most, "", help)
#define LIQUID_OF_FIRST(id, member, unit, least, most, extra, help)                                \
    LIQUID_FIELD(id, member, unit, least, most, "", help)
#define LIQUID_FIELD(id, member, unit, least, most, standard, help)                                \
    OWN_NUMBER(SKV_F_FLUIDS + SKV_LIQUID_##id, "fluids[]." #member, unit, least, most, standard, help)
#include "world/liquid_rows.h"
    LINE_FIELDS(SKV_F_SOLID, "solid[]")
    OWN_FLAG(SKV_F_SOLID + SKV_SOLID_CARVE, "solid[].carve", "false",
             "cut the shape out of the solid before it in the list")
    LINE_FIELDS(SKV_F_WATER, "water[]")
    OWN_NUMBER(SKV_F_WATER + SKV_WATER_VX, "water[].vx", "m/s", -20, 20, "0",
               "speed to the right at the start")
    OWN_NUMBER(SKV_F_WATER + SKV_WATER_VY, "water[].vy", "m/s", -20, 20, "0",
               "speed upwards at the start")
    OWN_CHOICE(SKV_F_WATER + SKV_WATER_DYE, "water[].dye", DYES, "none", "its colour")
    OWN_TEXT(SKV_F_WATER + SKV_WATER_FLUID, "water[].fluid", SKV_FLUID_NAME - 1,
             "name of its fluid; else the first, water")
    AREA_FIELDS(SKV_F_FORCES, "forces[]", "kind of area; else a box, by itself all of the world")
#define FORCE_NUMBER(id, member, unit, least, most, help)                                          \
    OWN_NUMBER(SKV_F_FORCES + SKV_FORCE_##id, "forces[]." #member, unit, least, most, "0", help)
#include "world/force_rows.h"
    OWN_NUMBER(SKV_F_EMITTERS + SKV_EMITTER_X, "emitters[].x", "m", -100, 100, "",
               "middle of the line from which fluid flows; needed")
    OWN_NUMBER(SKV_F_EMITTERS + SKV_EMITTER_Y, "emitters[].y", "m", -100, 100, "",
               "middle of that line; needed")
    OWN_NUMBER(SKV_F_EMITTERS + SKV_EMITTER_VX, "emitters[].vx", "m/s", -20, 20, "0",
               "speed to the right; the line lies across")
    OWN_NUMBER(SKV_F_EMITTERS + SKV_EMITTER_VY, "emitters[].vy", "m/s", -20, 20, "0",
               "speed upwards")
    OWN_NUMBER(SKV_F_EMITTERS + SKV_EMITTER_WIDTH, "emitters[].width", "m", 0.0001, 100, "0.05",
               "length of the line; width times speed is the rate")
    OWN_CHOICE(SKV_F_EMITTERS + SKV_EMITTER_DYE, "emitters[].dye", DYES, "none",
               "colour of what flows from it")
    OWN_TEXT(SKV_F_EMITTERS + SKV_EMITTER_FLUID, "emitters[].fluid", SKV_FLUID_NAME - 1,
             "name of the fluid that flows from it; else the first, water")
    AREA_FIELDS(SKV_F_DRAINS, "drains[]", "kind of area; needed")
    OWN_NUMBER(SKV_F_DRAINS + SKV_DRAIN_RATE, "drains[].rate", "m^2/s", 0, 10000, "0",
               "takes at most so much; 0: all that comes")
#ifndef SKV_WITHOUT_BODIES
    LINE_FIELDS(SKV_F_BODIES, "bodies[]")
    OWN_TEXT(SKV_F_BODIES + SKV_BODY_NAME, "bodies[].name", SKV_BODY_NAME_SIZE - 1,
             "by which reports name it; else its place in the list")
    OWN_CHOICE(SKV_F_BODIES + SKV_BODY_MATERIAL, "bodies[].material", "cork|wood|ice|brick|steel",
               "wood", "its density is that of the material")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_DENSITY, "bodies[].density", "kg/m^2", 10, 50000, "",
               "mass of a square metre of the sheet; else the material's")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_ANGLE, "bodies[].angle", "rad", -100, 100, "0",
               "turned so far about its pin, or else its middle, counter-clockwise")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_VX, "bodies[].vx", "m/s", -100, 100, "0",
               "speed to the right at the start")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_VY, "bodies[].vy", "m/s", -100, 100, "0",
               "speed upwards at the start")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_SPIN, "bodies[].spin", "rad/s", -1000, 1000, "0",
               "how fast it turns at the start")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_FRICTION, "bodies[].friction", "", 0, 10, "0.3",
               "Coulomb's number against walls and other bodies")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_RESTITUTION, "bodies[].restitution", "", 0, 1, "0.2",
               "share of its speed with which it bounces")
    OWN_FLAG(SKV_F_BODIES + SKV_BODY_FIXED, "bodies[].fixed", "false",
             "nothing moves it but its own speed, which stays")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_PIN, "bodies[].pin[]", "m", -100, 100, "",
               "[x, y] of the world: a place about which it turns, held there")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_MOTOR_SPEED, "bodies[].motor.speed", "rad/s", -1000, 1000, "0",
               "a motor at its pin drives it at this speed, counter-clockwise; 0: it brakes")
    OWN_NUMBER(SKV_F_BODIES + SKV_BODY_MOTOR_TORQUE, "bodies[].motor.torque", "N", 0, 1000000, "0",
               "the most that the motor gives, N m in a metre of depth; 0: there is none")
    OWN_NUMBER(SKV_F_AIR_PRESSURE, "air.pressure", "kPa m", 0, 100, "0",
               "closed pockets of air push, from this pressure on; 10 lifts water by a metre; 0: none do")
#endif
};
/* clang-format on */

const skv_list_fields *skv_scene_list(skv_list list)
{
    static const skv_list_fields lists[SKV_LISTS] = {
        [SKV_LIST_FLUIDS] = {"fluids", SKV_F_FLUIDS, SKV_LIQUID_FIELDS, 0, SKV_MAX_FLUIDS - 1},
        [SKV_LIST_SOLID] = {"solid", SKV_F_SOLID, SKV_SOLID_FIELDS, SKV_SHAPE_THICKNESS + 1, 256},
        [SKV_LIST_WATER] = {"water", SKV_F_WATER, SKV_WATER_FIELDS, SKV_SHAPE_THICKNESS + 1, 256},
        [SKV_LIST_FORCES] = {"forces", SKV_F_FORCES, SKV_FORCE_FIELDS, SKV_SHAPE_SHARED,
                             SKV_MAX_FORCES},
        [SKV_LIST_EMITTERS] = {"emitters", SKV_F_EMITTERS, SKV_EMITTER_FIELDS, 0, SKV_MAX_EMITTERS},
        [SKV_LIST_DRAINS] = {"drains", SKV_F_DRAINS, SKV_DRAIN_FIELDS, SKV_SHAPE_SHARED,
                             SKV_MAX_DRAINS},
        [SKV_LIST_BODIES] = {"bodies", SKV_F_BODIES, SKV_BODY_FIELDS, SKV_SHAPE_THICKNESS + 1,
                             SKV_MAX_BODIES},
    };
    return &lists[list];
}

const skv_field *skv_scene_field(int i)
{
    return i >= 0 && i < FIELDS ? &fields[i] : NULL;
}

const skv_field *skv_scene_fields(int *count)
{
    if (count != NULL)
        *count = FIELDS;
    return fields;
}

int skv_scene_find_field(const char *pattern)
{
    return skv_field_find(fields, FIELDS, pattern);
}

void skv_scene_suggest(const char *pattern, char *text, size_t size)
{
#ifdef SKV_WITHOUT_BODIES
    if (strncmp(pattern, "bodies", 6) == 0 || strncmp(pattern, "air", 3) == 0)
        skv_want_more(NULL);
#endif
    skv_field_suggest(fields, FIELDS, pattern, text, size);
}

/* ---- Paths ----------------------------------------------------------------------------------- */

#define MAX_INDEX 1000000

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Reads "[12]" at `text`; returns what follows it, or null. */
static const char *parse_index(const char *text, int *index)
{
    if (*text != '[' || !is_digit(text[1]))
        return NULL;
    long value = 0;
    for (text++; is_digit(*text); text++) {
        value = value * 10 + (*text - '0');
        if (value > MAX_INDEX)
            return NULL;
    }
    *index = (int)value;
    return *text == ']' ? text + 1 : NULL;
}

bool skv_field_parse_path(const char *text, skv_field_path *path)
{
    size_t length = 0;
    path->index_count = 0;
    while (*text != '\0') {
        if (length + 3 > sizeof path->pattern)
            return false;
        if (*text == '[') {
            if (path->index_count == 3)
                return false;
            text = parse_index(text, &path->index[path->index_count++]);
            if (text == NULL)
                return false;
            path->pattern[length++] = '[';
            path->pattern[length++] = ']';
        } else {
            path->pattern[length++] = *text++;
        }
    }
    path->pattern[length] = '\0';
    return true;
}

/* Whether some field's path is `pattern`, then `next`, then more. */
static bool has_below(const char *pattern, const char *next)
{
    size_t length = strlen(pattern), next_length = strlen(next);
    for (int i = 0; i < FIELDS; i++) {
        if (strncmp(fields[i].path, pattern, length) == 0 &&
            strncmp(fields[i].path + length, next, next_length) == 0)
            return true;
    }
    return false;
}

bool skv_field_is_object(const char *pattern)
{
    return pattern[0] == '\0' || has_below(pattern, ".");
}

bool skv_field_is_list(const char *pattern)
{
    return pattern[0] != '\0' && has_below(pattern, "[]");
}
