/* The fluids of a scene. Invariant: the fluids that come out may be a world's, and a number that is
 * found is that of one of them. */
#include "scene/fluids.h"

#include <string.h>

#include "base/exact.h"
#include "scene/notes.h"
#include "world/liquids.h"

/* The name of what is painted yellow, and of its material. */
#define OIL "oil"

/* Of the heaviest fluid's density, the least with which the clavet law shoots off none of a fluid:
 * dams of 20 to 30 kg/m^2 beside 1000 are at up to 6 times the speed of their fall, of 40 at up
 * to 2.8 times, those of 50 below it (docs/notebook/2026-11-28-light-fluids-by-clavets-law.md). */
#define LEAST_CLAVET_DENSITY 0.05

/* Fails for a member of a fluid, where it was given, or else for the fluid. */
static skv_result fail(const skv_draft *draft, int index, const char *member, const char *message,
                       skv_error *error)
{
    const skv_shape_values *values = &draft->values.list[SKV_LIST_FLUIDS].shapes[index];
    char path[SKV_PATH_SIZE];
    skv_format(path, sizeof path, "fluids[].%s", member);
    int field = skv_scene_find_field(path) - SKV_F_FLUIDS;
    skv_format(path, sizeof path, "fluids[%d].%s", index, member);
    skv_origin given = values->value[field].origin;
    return skv_draft_fail(draft, given.source != SKV_FROM_DEFAULT ? given : values->origin, path,
                          error, SKV_ERROR_VALUE, "%s", message);
}

static int digit_of(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/* "#rrggbb"; false if it is none. */
static bool read_color(const char *text, int *color)
{
    if (text[0] != '#' || strlen(text) != 7)
        return false;
    *color = 0;
    for (int i = 1; i < 7; i++) {
        if (digit_of(text[i]) < 0)
            return false;
        *color = 16 * *color + digit_of(text[i]);
    }
    return true;
}

static skv_liquid liquid_of(const skv_material *material)
{
    skv_liquid liquid = skv_default_liquid();
    liquid.density = material->density;
    liquid.viscosity = material->viscosity;
    return liquid;
}

static void take(const skv_value *value, float *number)
{
    if (value->origin.source != SKV_FROM_DEFAULT)
        *number = (float)value->number;
}

static skv_result build_fluid(const skv_draft *draft, int index, skv_scene *scene, skv_error *error)
{
    const skv_value *value = draft->values.list[SKV_LIST_FLUIDS].shapes[index].value;
    const skv_material *material = skv_material_info((int)value[SKV_LIQUID_MATERIAL].number);
    const char *name = value[SKV_LIQUID_NAME].text, *color = value[SKV_LIQUID_COLOR].text;
    skv_liquid *liquid = &scene->def.liquids[index];
    *liquid = liquid_of(material);
#define LIQUID_NUMBER(id, member, ...) take(&value[SKV_LIQUID_##id], &liquid->member);
#include "world/liquid_rows.h"
    if (name == NULL)
        return fail(draft, index, "name", "is missing; water and emitters need it", error);
    skv_format(liquid->name, sizeof liquid->name, "%s", name);
    if (color != NULL && !read_color(color, &liquid->color))
        return fail(draft, index, "color", "is no color; allowed is \"#rrggbb\"", error);
    scene->def.liquid_count = index + 1;
    char complaint[160];
    const char *wrong = skv_liquid_complain(&scene->def, index, complaint, sizeof complaint);
    return wrong ? fail(draft, index, wrong, complaint, error) : SKV_OK;
}

/* Says which of the listed fluids is too light for the clavet law beside the heaviest. The first is
 * none, for others have 20 times its density at most. */
static void note_lightest(skv_scene *scene)
{
    const skv_world_def *def = &scene->def;
    double first = (double)def->fluid.density, heaviest = first;
    int lightest = 0;
    for (int i = 0; i < def->liquid_count; i++) {
        heaviest = skv_max(heaviest, (double)def->liquids[i].density);
        if (def->liquids[i].density < def->liquids[lightest].density)
            lightest = i;
    }
    double density = (double)def->liquids[lightest].density,
           least = LEAST_CLAVET_DENSITY * heaviest;
    if (def->fluid.law != SKV_LAW_CLAVET || density >= least)
        return;
    char text[3][32];
    skv_format_float(density, text[0]);
    skv_format_float(least, text[1]);
    skv_format_float(first / LEAST_CLAVET_DENSITY, text[2]);
    skv_scene_note(scene, "with fluids[%d].density %s the clavet fluid bursts; %s to %s can be had",
                   lightest, text[0], text[1], text[2]);
}

skv_result skv_scene_build_fluids(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    skv_result result = SKV_OK;
    int count = draft->values.list[SKV_LIST_FLUIDS].count;
    for (int i = 0; i < count && result == SKV_OK; i++)
        result = build_fluid(draft, i, scene, error);
    if (result == SKV_OK && count > 0)
        note_lightest(scene);
    return result;
}

skv_result skv_scene_paint_oil(skv_scene *scene, const char *label, skv_error *error)
{
    skv_world_def *def = &scene->def;
    int place = 0;
    if (scene->marked[SKV_PAINT_OIL] == 0)
        return SKV_OK;
    while (place < def->liquid_count && strcmp(def->liquids[place].name, OIL) != 0)
        place++;
    scene->oil = place + 1;
    if (place < def->liquid_count)
        return SKV_OK;
    if (place == SKV_MAX_FLUIDS - 1)
        return skv_fail(
            error, SKV_ERROR_LIMIT,
            "%s: its yellow pixels are oil, one fluid too many; name one of the scene's "
            "%d fluids \"" OIL "\"",
            label, place);
    const skv_material *material = skv_material_info(0);
    for (int i = 1; strcmp(material->name, OIL) != 0 && skv_material_info(i); i++)
        material = skv_material_info(i);
    skv_liquid *oil = &def->liquids[def->liquid_count++];
    *oil = liquid_of(material);
    memcpy(oil->name, OIL, sizeof OIL);
    skv_error cause;
    skv_result result = skv_check_liquids(def, &cause);
    return result == SKV_OK ? result : skv_fail(error, result, "%s: %s", label, cause.text);
}

skv_result skv_scene_find_fluid(const skv_draft *draft, const skv_value *value, const char *path,
                                int *number, skv_error *error)
{
    const skv_shape_list *list = &draft->values.list[SKV_LIST_FLUIDS];
    *number = 0;
    if (value->text == NULL || strcmp(value->text, SKV_FIRST_FLUID) == 0)
        return SKV_OK;
    char names[320];
    size_t used = skv_format(names, sizeof names, "%s", SKV_FIRST_FLUID);
    for (int i = 0; i < list->count; i++) {
        const char *name = list->shapes[i].value[SKV_LIQUID_NAME].text;
        if (name == NULL)
            continue;
        if (strcmp(name, value->text) == 0) {
            *number = i + 1;
            return SKV_OK;
        }
        if (used < sizeof names)
            used += skv_format(names + used, sizeof names - used, ", %s", name);
    }
    return skv_draft_fail(draft, value->origin, path, error, SKV_ERROR_VALUE,
                          "\"%s\" is no fluid of this scene; allowed is one of %s", value->text,
                          names);
}
