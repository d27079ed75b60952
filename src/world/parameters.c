/* The registry of a world's parameters: defaults, ranges, and access by path.
 *
 * Invariant: nothing here knows a single parameter but the two that set others (law, material);
 * everything comes from the rows.
 */
#include "world/parameters.h"

#include "base/assert.h"
#include "base/defs.h"
#include "base/fields.h"
#include "world/liquids.h"
#include "world/world_internal.h"

#include <string.h>

enum { FLUID_COOKIE = 0x464c, WORLD_COOKIE = 0x574f };

#define NO_MEMBER SIZE_MAX

/* What a row adds to its field: where the value lies, its default by law, and whether it can be
 * changed while a world runs. */
typedef struct place {
    size_t offset;
    float standard[2]; /* gcc 12 may compare a double that is narrowed without narrowing it */
    bool live;
} place;

#define NUMBER(id, path, member, unit, least, most, standard, live, help)                          \
    {path, SKV_FIELD_NUMBER, unit, least, most, NULL, #standard, help},
#define WHOLE(id, path, member, unit, least, most, standard, live, help)                           \
    {path, SKV_FIELD_INTEGER, unit, least, most, NULL, #standard, help},
#define FLAG(id, path, member, standard, live, help)                                               \
    {path, SKV_FIELD_BOOLEAN, "", 0, 1, NULL, #standard, help},
#define CHOICE(id, path, member, choices, standard, help)                                          \
    {path, SKV_FIELD_CHOICE, "", 0, 0, choices, #standard, help},
#define PRESET(id, path, choices, standard, live, help)                                            \
    {path, SKV_FIELD_CHOICE, "", 0, 0, choices, #standard, help},
static const skv_field fields[SKV_P_COUNT] = {
#include "world/parameter_rows.h"
};

#define AT(member) offsetof(skv_world_def, member)
#define NUMBER(id, path, member, unit, least, most, standard, live, help)                          \
    {AT(member), {(float)(standard), (float)(standard)}, live},
#define WHOLE(id, path, member, unit, least, most, standard, live, help)                           \
    {AT(member), {standard, standard}, live},
#define NUMBER_BY_LAW(id, path, member, unit, least, most, standard, clavet, live, help)           \
    {AT(member), {(float)(standard), (float)(clavet)}, live},
#define WHOLE_BY_LAW(id, path, member, unit, least, most, standard, clavet, live, help)            \
    {AT(member), {standard, clavet}, live},
#define FLAG(id, path, member, standard, live, help)      {AT(member), {standard, standard}, live},
#define CHOICE(id, path, member, choices, standard, help) {AT(member), {0, 0}, false},
#define PRESET(id, path, choices, standard, live, help)   {NO_MEMBER, {0, 0}, live},
static const place places[SKV_P_COUNT] = {
#include "world/parameter_rows.h"
};

static bool is_fluids(int parameter)
{
    size_t offset = places[parameter].offset;
    return offset >= AT(fluid) && offset < AT(fluid) + sizeof(skv_fluid_def);
}

const skv_field *skv_world_field(int i)
{
    return i >= 0 && i < SKV_P_COUNT ? &fields[i] : NULL;
}

bool skv_world_can_change(const char *path)
{
    SKV_ASSERT_OR(path, false);
    int parameter = skv_field_find(fields, SKV_P_COUNT, path);
    return parameter >= 0 && places[parameter].live;
}

const skv_material *skv_material_info(int i)
{
    static const skv_material materials[] = {
        {"water", 1000, 1.0e-6f},
        {"oil", 911, 9.2e-5f},
        {"honey", 1420, 7.0e-3f},
        {"mercury", 13546, 1.15e-7f},
    };
    return i >= 0 && i < (int)(sizeof materials / sizeof *materials) ? &materials[i] : NULL;
}

const char *skv_law_name(skv_law law)
{
    return law == SKV_LAW_CLAVET ? "clavet" : "calibrated";
}

/* ---- Members --------------------------------------------------------------------------------- */

_Static_assert(sizeof(skv_law) == sizeof(int) && sizeof(skv_solver_kind) == sizeof(int),
               "choices are stored as int");

static void store(skv_world_def *def, int parameter, double number)
{
    char *member = (char *)def + places[parameter].offset;
    float value = (float)number;
    int whole = (int)number;
    bool flag = number != 0;
    switch (fields[parameter].type) {
    case SKV_FIELD_NUMBER:
        memcpy(member, &value, sizeof value);
        break;
    case SKV_FIELD_INTEGER:
    case SKV_FIELD_CHOICE:
        memcpy(member, &whole, sizeof whole);
        break;
    case SKV_FIELD_BOOLEAN:
        memcpy(member, &flag, sizeof flag);
        break;
    case SKV_FIELD_TEXT: /* there is none */
        break;
    }
}

static double load(const skv_world_def *def, int parameter)
{
    const char *member = (const char *)def + places[parameter].offset;
    float value;
    int whole;
    bool flag;
    switch (fields[parameter].type) {
    case SKV_FIELD_NUMBER:
        memcpy(&value, member, sizeof value);
        return (double)value;
    case SKV_FIELD_INTEGER:
    case SKV_FIELD_CHOICE:
        memcpy(&whole, member, sizeof whole);
        return whole;
    case SKV_FIELD_BOOLEAN:
        memcpy(&flag, member, sizeof flag);
        return flag;
    case SKV_FIELD_TEXT:
        break;
    }
    return 0;
}

/* What has the old law's default gets the new law's. */
static void change_law(skv_world_def *def, int law)
{
    int old = def->fluid.law == SKV_LAW_CLAVET;
    for (int i = 0; i < SKV_P_COUNT; i++) {
        const float *standard = places[i].standard;
        if (is_fluids(i) && load(def, i) == (double)standard[old])
            store(def, i, (double)standard[law]);
    }
    def->fluid.law = (skv_law)law;
}

void skv_parameter_store(skv_world_def *def, int parameter, double number)
{
    if (parameter == SKV_P_FLUID_LAW) {
        change_law(def, (int)number);
    } else if (parameter == SKV_P_FLUID_MATERIAL) {
        const skv_material *material = skv_material_info((int)number);
        def->fluid.density = material->density;
        def->fluid.viscosity = material->viscosity;
    } else {
        store(def, parameter, number);
    }
}

double skv_parameter_load(const skv_world_def *def, int parameter)
{
    const skv_material *material;
    if (parameter != SKV_P_FLUID_MATERIAL)
        return load(def, parameter);
    for (int i = 0; (material = skv_material_info(i)); i++) {
        if (material->density == def->fluid.density && material->viscosity == def->fluid.viscosity)
            return i;
    }
    return -1;
}

/* ---- Definitions ----------------------------------------------------------------------------- */

skv_world_def skv_default_world_def(void)
{
    skv_world_def def = {.cookie = SKV_COOKIE(WORLD_COOKIE, skv_world_def)};
    def.fluid.cookie = SKV_COOKIE(FLUID_COOKIE, skv_fluid_def);
    for (int i = 0; i < SKV_P_COUNT; i++) {
        if (places[i].offset != NO_MEMBER)
            store(&def, i, (double)places[i].standard[0]);
    }
    for (int i = 0; i < SKV_MAX_FLUIDS - 1; i++)
        def.liquids[i] = (skv_liquid){
            .cookie = skv_liquid_cookie,
            .color = SKV_NO_COLOR,
#define LIQUID_OF_MATERIAL(id, member, ...)                         .member = def.fluid.member,
#define LIQUID_NUMBER(id, member, unit, least, most, standard, ...) .member = (float)(standard),
#include "world/liquid_rows.h"
        };
    return def;
}

skv_fluid_def skv_default_fluid_def(skv_law law)
{
    skv_world_def def = skv_default_world_def();
    if (law == SKV_LAW_CLAVET)
        change_law(&def, law);
    return def.fluid;
}

skv_liquid skv_default_liquid(void)
{
    return skv_default_world_def().liquids[0];
}

void skv_liquid_init(skv_liquid *def, size_t size)
{
    const skv_liquid standard = skv_default_liquid();
    skv_def_init(def, size, &standard, sizeof standard);
}

void skv_world_def_init(skv_world_def *def, size_t size)
{
    const skv_world_def standard = skv_default_world_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

void skv_fluid_def_init(skv_fluid_def *def, size_t size, skv_law law)
{
    const skv_fluid_def standard = skv_default_fluid_def(law);
    skv_def_init(def, size, &standard, sizeof standard);
}

const skv_world_def *skv_open_world_def(const skv_world_def *def, skv_world_def *own)
{
    *own = skv_default_world_def();
    const uint32_t fluid = own->fluid.cookie;
    def = skv_def_open(def, own, sizeof *own);
    bool whole = def && def->fluid.cookie == fluid;
    for (int i = 0; whole && i < def->liquid_count && i < SKV_MAX_FLUIDS - 1; i++)
        whole = def->liquids[i].cookie == skv_liquid_cookie;
    return whole ? def : NULL;
}

/* Whether a field allows a number. */
static skv_result check_number(int parameter, double number, skv_error *error)
{
    const skv_field *field = &fields[parameter];
    const char *wrong = NULL;
    if (field->type == SKV_FIELD_BOOLEAN)
        wrong = number == 0 || number == 1 ? NULL : "is not 0 or 1";
    else if (field->type != SKV_FIELD_CHOICE)
        wrong = skv_field_complaint(field, number);
    else if (!(number >= 0 && number < skv_field_choices(field->choices)) ||
             number != (double)(int)number)
        wrong = "is not known";
    if (!wrong)
        return SKV_OK;
    char what[32];
    skv_format_number(number, what);
    return skv_field_refuse(field, what, wrong, error);
}

skv_result skv_check_world_def(const skv_world_def *def, skv_error *error)
{
    for (int i = 0; i < SKV_P_COUNT; i++) {
        skv_result result = SKV_OK;
        if (places[i].offset != NO_MEMBER)
            result = check_number(i, load(def, i), error);
        if (result != SKV_OK)
            return result;
    }
    return skv_check_liquids(def, error);
}

/* ---- Access by path -------------------------------------------------------------------------- */

static skv_result find(const char *path, int *found, skv_error *error)
{
    *found = skv_field_find(fields, SKV_P_COUNT, path);
    if (*found >= 0)
        return SKV_OK;
    char hint[200];
    skv_field_suggest(fields, SKV_P_COUNT, path, hint, sizeof hint);
    return skv_fail(error, SKV_ERROR_VALUE, "%.60s: unknown field%s", path, hint);
}

/* Stores a value that its field allows, unless the program that has the def knows no such member.
 */
static skv_result put(skv_world_def *def, int parameter, double number, skv_error *error)
{
    size_t size = skv_def_size(def), offset = places[parameter].offset;
    if (offset != NO_MEMBER && offset >= size)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: this program was compiled before there was such a field",
                        fields[parameter].path);
    skv_world_def own = skv_default_world_def();
    memcpy(&own, def, size);
    skv_parameter_store(&own, parameter, number);
    memcpy(def, &own, size);
    return SKV_OK;
}

skv_result skv_world_def_set(skv_world_def *def, const char *path, const char *text,
                             skv_error *error)
{
    SKV_ASSERT_OR(def && path && text, SKV_ERROR_VALUE);
    skv_world_def own;
    const skv_world_def *whole = def;
    SKV_ASSERT_INITIALISED(whole, skv_open_world_def(def, &own), SKV_ERROR_VALUE);
    int parameter;
    double number;
    skv_result result = find(path, &parameter, error);
    if (result != SKV_OK)
        return result;
    const char *wrong = skv_field_read(&fields[parameter], text, &number);
    if (wrong)
        return skv_field_refuse(&fields[parameter], text, wrong, error);
    return put(def, parameter, number, error);
}

skv_result skv_world_def_get(const skv_world_def *def, const char *path, char *text, size_t size,
                             skv_error *error)
{
    SKV_ASSERT_OR(def && path && text && size > 0, SKV_ERROR_VALUE);
    skv_world_def own;
    SKV_ASSERT_INITIALISED(def, skv_open_world_def(def, &own), SKV_ERROR_VALUE);
    int parameter;
    skv_result result = find(path, &parameter, error);
    if (result != SKV_OK)
        return result;
    double number = skv_parameter_load(def, parameter);
    text[0] = '\0'; /* no material */
    if (number >= 0 || fields[parameter].type != SKV_FIELD_CHOICE)
        skv_field_write(&fields[parameter], number, text, size);
    return SKV_OK;
}

skv_world_def skv_world_describe(const skv_world *world)
{
    skv_world_def def = skv_default_world_def();
    def.fluid = world->fluid;
    def.liquid_count = world->fluid_count - 1;
    for (int i = 0; i < def.liquid_count; i++)
        def.liquids[i] = world->liquids[i + 1];
    def.gravity_x = world->gravity_x;
    def.gravity_y = world->gravity_y;
    def.substeps = world->substeps;
    def.depth = world->depth;
    def.sleep = world->sleep.allowed;
    def.emission_limit = world->emission_limit;
    def.emission_replaces = world->emission_replaces;
    def.threads = skv_pool_threads(world->pool);
    def.capacity = world->state.capacity;
    def.solver =
        world->solver->type == &skv_reference_solver ? SKV_SOLVER_REFERENCE : SKV_SOLVER_FAST;
    return def;
}

/* Lets a world go on with a definition in which one parameter has been set. */
static skv_result follow(skv_world *world, int parameter, const skv_world_def *def,
                         skv_error *error)
{
    if (is_fluids(parameter) || parameter == SKV_P_FLUID_MATERIAL) {
        skv_result result = skv_check_liquids(def, error);
        if (result == SKV_OK)
            skv_world_change_fluid(world, &def->fluid);
        return result;
    }
    if (parameter == SKV_P_EMISSION_LIMIT || parameter == SKV_P_EMISSION_REPLACES)
        skv_world_put_emission(world, def);
    else
        return skv_world_set_gravity(world, def->gravity_x, def->gravity_y, error);
    return SKV_OK;
}

static skv_result check_live(int parameter, skv_error *error)
{
    if (places[parameter].live)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE,
                    "%s: cannot change while a world runs; set it in the definition of a new one",
                    fields[parameter].path);
}

skv_result skv_world_set(skv_world *world, const char *path, const char *text, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && path && text, SKV_ERROR_VALUE);
    int parameter;
    skv_result result = find(path, &parameter, error);
    if (result == SKV_OK)
        result = check_live(parameter, error);
    if (result != SKV_OK)
        return result;
    skv_world_def def = skv_world_describe(world);
    result = skv_world_def_set(&def, path, text, error);
    return result == SKV_OK ? follow(world, parameter, &def, error) : result;
}

skv_result skv_world_get(const skv_world *world, const char *path, char *text, size_t size,
                         skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    skv_world_def def = skv_world_describe(world);
    return skv_world_def_get(&def, path, text, size, error);
}

/* ---- Access by number ------------------------------------------------------------------------ */

int skv_world_parameter(const char *path)
{
    SKV_ASSERT_OR(path, -1);
    return skv_field_find(fields, SKV_P_COUNT, path);
}

/* Whether there is a parameter of a number. */
static skv_result check_parameter(int parameter, skv_error *error)
{
    if (parameter >= 0 && parameter < SKV_P_COUNT)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE, "parameter %d: there is none; allowed is 0..%d",
                    parameter, SKV_P_COUNT - 1);
}

skv_result skv_world_def_set_number(skv_world_def *def, int parameter, double value,
                                    skv_error *error)
{
    skv_world_def own;
    const skv_world_def *whole = def;
    SKV_ASSERT_INITIALISED(whole, skv_open_world_def(def, &own), SKV_ERROR_VALUE);
    skv_result result = check_parameter(parameter, error);
    if (result == SKV_OK)
        result = check_number(parameter, value, error);
    return result == SKV_OK ? put(def, parameter, value, error) : result;
}

double skv_world_def_number(const skv_world_def *def, int parameter)
{
    skv_world_def own;
    SKV_ASSERT_INITIALISED(def, skv_open_world_def(def, &own), 0);
    SKV_ASSERT_OR(parameter >= 0 && parameter < SKV_P_COUNT, 0);
    return skv_parameter_load(def, parameter);
}

skv_result skv_world_set_number(skv_world *world, int parameter, double value, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    skv_result result = check_parameter(parameter, error);
    if (result == SKV_OK)
        result = check_live(parameter, error);
    if (result != SKV_OK)
        return result;
    skv_world_def def = skv_world_describe(world);
    result = skv_world_def_set_number(&def, parameter, value, error);
    return result == SKV_OK ? follow(world, parameter, &def, error) : result;
}

double skv_world_number(const skv_world *world, int parameter)
{
    SKV_ASSERT_OR(world, 0);
    skv_world_def def = skv_world_describe(world);
    return skv_world_def_number(&def, parameter);
}
