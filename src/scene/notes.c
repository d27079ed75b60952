/* What is worth saying about a scene that can be built.
 *
 * Invariant: notes follow from the scene alone and change nothing of it.
 */
#include "scene/notes.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "base/memory.h"
#include "calm/load.h"
#include "model/constants.h"
#include "scene/channels.h"
#include "world/parameters.h"
#include "world/world_internal.h"

void skv_scene_note(skv_scene *scene, const char *format, ...)
{
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    size_t length = skv_format_list(text, sizeof text, format, arguments);
    va_end(arguments);
    length = length < sizeof text ? length : sizeof text - 1;
    int free = 0;
    while (free < SKV_MAX_NOTICES && scene->notices[free] != NULL)
        free++;
    if (free == SKV_MAX_NOTICES)
        return;
    scene->notices[free] = skv_calloc(length + 1, 1);
    if (scene->notices[free] != NULL)
        memcpy(scene->notices[free], text, length);
}

/* ---- The clavet law's numbers ---------------------------------------------------------------- */

/* Of the law's own numbers, each alone can be what lets the fluid burst. */
static const skv_parameter clavet_numbers[] = {
    SKV_P_FLUID_CLAVET_NEAR_STIFFNESS, SKV_P_FLUID_CLAVET_STIFFNESS,
    SKV_P_FLUID_CLAVET_REST_DENSITY, SKV_P_FLUID_RADIUS_RATIO};

/* The least and the greatest value of a parameter, the others being as they are, with which the
 * fluid keeps its area; false if there is none. */
static bool find_calm(const skv_world_def *def, skv_parameter parameter, double *least,
                      double *most)
{
    enum { PLACES = 200 };
    const skv_field *field = skv_world_field((int)parameter);
    skv_world_def other = *def;
    bool found = false;
    for (int i = 0; i <= PLACES; i++) {
        double value = field->minimum + (field->maximum - field->minimum) * i / PLACES;
        skv_parameter_store(&other, (int)parameter, value);
        if (skv_clavet_swells(&other.fluid) != 0)
            continue;
        *least = found ? *least : value;
        *most = value;
        found = true;
    }
    return found;
}

/* Says of all numbers that are not the law's own what they do together, for none of them alone can
 * mend it. */
static void note_together(skv_scene *scene, const skv_world_def *standard, const char *what)
{
    char given[160] = "", own[64] = "", text[2][32];
    size_t given_used = 0, own_used = 0;
    for (size_t i = 0; i < sizeof clavet_numbers / sizeof *clavet_numbers; i++) {
        int parameter = (int)clavet_numbers[i];
        double value = skv_parameter_load(&scene->def, parameter);
        double usual = skv_parameter_load(standard, parameter);
        if (value == usual)
            continue;
        const char *comma = given_used > 0 ? ", " : "";
        skv_format_float(value, text[0]);
        skv_format_float(usual, text[1]);
        given_used += skv_format(given + given_used, sizeof given - given_used, "%s%s %s", comma,
                                 skv_world_field(parameter)->path, text[0]);
        own_used += skv_format(own + own_used, sizeof own - own_used, "%s%s", comma, text[1]);
    }
    skv_scene_note(scene, "with %s the clavet fluid %s; the defaults %s can be had", given, what,
                   own);
}

static void note_clavet(skv_scene *scene)
{
    int swells = skv_clavet_swells(&scene->def.fluid);
    if (swells == 0)
        return;
    skv_world_def standard = skv_default_world_def();
    standard.fluid = skv_default_fluid_def(SKV_LAW_CLAVET);
    const char *what = swells > 0 ? "swells and bursts" : "collapses";
    for (size_t i = 0; i < sizeof clavet_numbers / sizeof *clavet_numbers; i++) {
        int parameter = (int)clavet_numbers[i];
        double value = skv_parameter_load(&scene->def, parameter), least, most;
        if (value == skv_parameter_load(&standard, parameter) ||
            !find_calm(&scene->def, clavet_numbers[i], &least, &most))
            continue;
        char text[3][32];
        skv_format_float(value, text[0]);
        skv_format_number(least, text[1]);
        skv_format_number(most, text[2]);
        skv_scene_note(scene, "with %s %s the clavet fluid %s; %s to %s can be had",
                       skv_world_field(parameter)->path, text[0], what, text[1], text[2]);
        return;
    }
    note_together(scene, &standard, what);
}

/* ---- Channels -------------------------------------------------------------------------------- */

/* Three digits, rounded up, and a fiftieth more: fewer would do if walls lay between pixels. */
static int enough_particles(double wanted)
{
    double unit = 1;
    while (wanted >= 1000 * unit)
        unit *= 10;
    double rounded = ceil(1.02 * wanted / unit) * unit;
    return rounded <= SKV_MAX_PARTICLES ? (int)rounded : 0;
}

static void note_channel(skv_scene *scene)
{
    double width = skv_scene_narrow_channel(scene);
    if (!(width > 0) || scene->def.fluid.law == SKV_LAW_CLAVET)
        return; /* whose levels do not meet in wide channels, either */
    double times = SKV_CHANNEL_WIDE * (double)scene->def.fluid.spacing / width;
    int enough = enough_particles(scene->amount * times * times);
    char text[32];
    skv_format_number(floor(1e4 * width + 0.5) * 1e-4, text);
    if (enough > 0)
        skv_scene_note(scene,
                       "a channel is %s m wide, so levels beside it may stay apart; %d particles "
                       "make it %g spacings wide",
                       text, enough, SKV_CHANNEL_WIDE);
    else
        skv_scene_note(scene,
                       "a channel is %s m wide, so levels beside it may stay apart; no number of "
                       "particles that is allowed makes it %g spacings wide",
                       text, SKV_CHANNEL_WIDE);
}

/* ---- Substeps -------------------------------------------------------------------------------- */

/* Of those that the rule takes for the water at the start: calibrated dams and pools of 500 to
 * 10 000 particles burst with a third and less, at g and at ten times that, and none did with 0.38.
 * What the clavet law pushes does not go by the substep, and is bounded with fewer, too. */
#define FEWEST_SUBSTEPS 0.4

static void note_substeps(skv_scene *scene)
{
    const skv_world_def *def = &scene->def;
    float gravity = sqrtf(def->gravity_x * def->gravity_x + def->gravity_y * def->gravity_y);
    double load = skv_load_of_depth(gravity, def->depth, 0);
    int fewest = (int)ceil(FEWEST_SUBSTEPS * skv_substep_rule(&def->fluid, load));
    if (def->substeps == 0 || def->substeps >= fewest || def->fluid.law == SKV_LAW_CLAVET)
        return;
    skv_scene_note(scene, "with substeps %d the fluid may burst; 0, or %d and more can be had",
                   def->substeps, fewest);
}

void skv_scene_add_notes(skv_scene *scene)
{
    note_substeps(scene);
    note_channel(scene);
    note_clavet(scene);
}
