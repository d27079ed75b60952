/* The fluids of a world as data. Invariant: names in a list that has been let through differ, and
 * every number of it is finite and in its range. */
#include "world/liquids.h"

#include "base/defs.h"
#include "base/exact.h"
#include "base/fields.h"
#include "base/plain.h"
#include "world/springs/springs.h"
#include "world/world_internal.h"

#include <stddef.h>
#include <string.h>

enum { LIQUID_COOKIE = 0x4c51, MOST_COLOR = 0xffffff };

const uint32_t skv_liquid_cookie = SKV_COOKIE(LIQUID_COOKIE, skv_liquid);

/* Of the greatest cohesion, of who has none: less than rounding, but a gradient that has been
 * multiplied by it can be had back. */
#define LEAST_COHESION 0x1p-24f

/* Densities over the first fluid's. A layer of 0.01 lies calm on water, 0.002 flies apart; 20 is
 * more than mercury has. */
#define LEAST_RATIO 0.01
#define MOST_RATIO  20.0

/* What each fluid has for itself, and the flag of snapshots that have it. */
static const struct {
    const char *name, *unit;
    size_t offset;
    float least, most, standard;
    unsigned extra;
} liquid_numbers[] = {
#define LIQUID_NUMBER(id, member, unit, least, most, standard, extra, help)                        \
    {#member,           unit, offsetof(skv_liquid, member), (float)(least), (float)(most),         \
     (float)(standard), extra},
#include "world/liquid_rows.h"
};
enum { LIQUID_NUMBERS = sizeof liquid_numbers / sizeof *liquid_numbers };

static float number_of(const skv_liquid *liquid, int k)
{
    float number;
    memcpy(&number, (const char *)liquid + liquid_numbers[k].offset, sizeof number);
    return number;
}

/* ---- What fluids may be ---------------------------------------------------------------------- */

/* What is wrong with the name of a fluid in a list; null: nothing. */
static const char *complain_of_name(const skv_world_def *def, int index)
{
    const skv_liquid *liquid = &def->liquids[index];
    if (!memchr(liquid->name, '\0', sizeof liquid->name))
        return "is too long; allowed are 31 bytes";
    if (liquid->name[0] == '\0')
        return "is empty; each fluid needs a name of its own";
    if (strcmp(liquid->name, SKV_FIRST_FLUID) == 0)
        return "is that of the first fluid; choose another";
    for (int i = 0; i < index; i++)
        if (strcmp(def->liquids[i].name, liquid->name) == 0)
            return "is another fluid's, too; choose another";
    return skv_plain_complaint(liquid->name);
}

/* Whether a density cannot stand beside that of the first fluid, and in `text` why. */
static bool complain_of_density(float own, float first, char *text, size_t size)
{
    float least = (float)(LEAST_RATIO * (double)first), most = (float)(MOST_RATIO * (double)first);
    if (skv_within((double)own, (double)least, (double)most))
        return false;
    char given[32], from[32], to[32];
    skv_format_float((double)own, given);
    skv_format_float((double)least, from);
    skv_format_float((double)most, to);
    skv_format(text, size,
               "is %s kg/m^2; allowed is %g to %g times that of the first fluid, %s..%s kg/m^2",
               given, LEAST_RATIO, MOST_RATIO, from, to);
    return true;
}

/* Whether a number is neither in its range nor a default beside that, and in `text` why. */
static bool complain_of_number(float own, int k, char *text, size_t size)
{
    const bool may_follow = liquid_numbers[k].standard == SKV_AS_FIRST;
    const double least = (double)liquid_numbers[k].least, most = (double)liquid_numbers[k].most;
    if (skv_within((double)own, least, most) || (may_follow && own == SKV_AS_FIRST))
        return false;
    const char *unit = liquid_numbers[k].unit, *space = unit[0] == '\0' ? "" : " ";
    if (may_follow)
        skv_format(text, size,
                   "is out of range; allowed is %g..%g%s%s, and -1 for that of the first fluid",
                   least, most, space, unit);
    else
        skv_format(text, size, "is out of range; allowed is %g..%g%s%s", least, most, space, unit);
    return true;
}

const char *skv_liquid_complain(const skv_world_def *def, int index, char *text, size_t size)
{
    const skv_liquid *liquid = &def->liquids[index];
    const char *complaint = complain_of_name(def, index), *wrong = "name";
    if (!complaint && complain_of_density(liquid->density, def->fluid.density, text, size))
        return "density";
    if (!complaint && (liquid->color < SKV_NO_COLOR || liquid->color > MOST_COLOR)) {
        complaint = "is out of range; allowed is 0..0xffffff, and -1 for none";
        wrong = "color";
    }
    for (int k = 0; !complaint && k < LIQUID_NUMBERS; k++)
        if (complain_of_number(number_of(liquid, k), k, text, size))
            return liquid_numbers[k].name;
    if (!complaint && liquid->plasticity > 0 && !skv_liquid_is_springy(liquid)) {
        complaint = "needs springs that give way; add a shear_modulus, Pa";
        wrong = "plasticity";
    }
    if (!complaint)
        return NULL;
    skv_format(text, size, "%s", complaint);
    return wrong;
}

skv_result skv_check_liquids(const skv_world_def *def, skv_error *error)
{
    if (def->liquid_count < 0 || def->liquid_count >= SKV_MAX_FLUIDS)
        return skv_fail(error, SKV_ERROR_LIMIT, "fluids: %d beside the first; allowed is 0..%d",
                        def->liquid_count, SKV_MAX_FLUIDS - 1);
    for (int i = 0; i < def->liquid_count; i++) {
        char text[160];
        const char *wrong = skv_liquid_complain(def, i, text, sizeof text);
        if (wrong)
            return skv_fail(error, SKV_ERROR_VALUE, "fluids[%d].%s: %s", i, wrong, text);
    }
    return SKV_OK;
}

skv_result skv_check_fluid(int fluid, int fluids, skv_error *error)
{
    if (fluid >= 0 && fluid < fluids)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE, "there is no fluid %d; allowed is 0..%d", fluid,
                    fluids - 1);
}

unsigned skv_world_liquid_extras(const skv_world *world)
{
    unsigned extras = skv_world_is_springy(world) ? SKV_WITH_SPRINGS : 0;
    for (int i = 1; i < world->fluid_count; i++)
        for (int k = 0; k < LIQUID_NUMBERS;
             k++) /* without springs nothing counts what they are like */
            if (liquid_numbers[k].extra != SKV_WITH_SPRINGS &&
                number_of(&world->liquids[i], k) != liquid_numbers[k].standard)
                extras |= liquid_numbers[k].extra;
    return extras;
}

static float cohesion_of(const skv_world *world, int fluid)
{
    float own = world->liquids[fluid].cohesion;
    return own == SKV_AS_FIRST ? world->fluid.cohesion : own;
}

float skv_world_most_cohesion(const skv_world *world)
{
    float most = world->fluid.cohesion;
    for (int i = 1; i < world->fluid_count; i++)
        most = skv_maxf(most, cohesion_of(world, i));
    return most;
}

void skv_world_share_cohesion(skv_world *world)
{
    const float most = skv_world_most_cohesion(world);
    world->cohesions_differ = false;
    for (int i = 0; i < world->fluid_count; i++) {
        float own = cohesion_of(world, i);
        world->cohesions[i] = own < most ? skv_maxf(own / most, LEAST_COHESION) : 1;
        world->cohesions_differ |= own < most;
    }
}

void skv_world_tell_fluids(const skv_world *world, skv_solver_particles *particles)
{
    if (!world->state.several)
        return;
    if (skv_world_liquid_extras(world) & SKV_WITH_INTERFACES)
        particles->liquids = world->liquids;
    if (world->cohesions_differ)
        particles->cohesion = world->cohesions;
    if (particles->liquids || particles->cohesion)
        particles->fluid = world->state.fluid;
}

/* ---- Snapshots ------------------------------------------------------------------------------- */

void skv_exchange_contents(skv_port *port, int *dye, int *fluid)
{
    uint64_t byte = (uint64_t)*dye | (uint64_t)*fluid << 4;
    skv_exchange(port, &byte, 1);
    *dye = (int)(byte & 15);
    *fluid = (int)(byte >> 4);
}

static bool exchange_name(skv_port *port, char name[SKV_FLUID_NAME])
{
    char text[256];
    if (port->to) {
        skv_put_text(port->to, name);
        return true;
    }
    skv_get_text(port->from, text);
    size_t length = strlen(text);
    memset(name, 0, SKV_FLUID_NAME);
    if (length >= SKV_FLUID_NAME)
        return false;
    memcpy(name, text, length);
    return true;
}

/* The numbers that every snapshot has, or those that one has besides; others have their default. */
static void exchange_numbers(skv_port *port, skv_liquid *liquid, bool besides, unsigned extras)
{
    for (int k = 0; k < LIQUID_NUMBERS; k++) {
        float *number = (float *)(void *)((char *)liquid + liquid_numbers[k].offset);
        if ((liquid_numbers[k].extra != 0) != besides)
            continue;
        if (!besides || liquid_numbers[k].extra & extras)
            skv_exchange_float(port, number);
        else if (port->from)
            *number = liquid_numbers[k].standard;
    }
}

bool skv_exchange_liquids(skv_port *port, skv_world_def *def, unsigned extras)
{
    uint64_t count = (uint64_t)def->liquid_count;
    skv_exchange(port, &count, 1);
    def->liquid_count = (int)count;
    if (count < 1 || count >= SKV_MAX_FLUIDS) {
        def->liquid_count = 0;
        return false;
    }
    bool sane = true;
    for (int i = 0; i < def->liquid_count; i++) {
        skv_liquid *liquid = &def->liquids[i];
        uint64_t color = (uint64_t)liquid->color + 1;
        liquid->cookie = skv_liquid_cookie;
        sane = exchange_name(port, liquid->name) && sane;
        exchange_numbers(port, liquid, false, extras);
        skv_exchange(port, &color, 4);
        liquid->color = color <= MOST_COLOR + 1 ? (int)color - 1 : MOST_COLOR + 1;
        exchange_numbers(port, liquid, true, extras);
    }
    return sane && skv_check_liquids(def, NULL) == SKV_OK;
}
