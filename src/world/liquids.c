/* The fluids of a world as data. Invariant: names in a list that has been let through differ, and
 * every number of it is finite and in its range. */
#include "world/liquids.h"

#include "base/defs.h"
#include "base/exact.h"
#include "base/fields.h"
#include "base/plain.h"
#include "world/springs/springs.h"
#include "world/world_internal.h"

#include <string.h>

enum { LIQUID_COOKIE = 0x4c51, MOST_COLOR = 0xffffff };

const uint32_t skv_liquid_cookie = SKV_COOKIE(LIQUID_COOKIE, skv_liquid);

/* m^2/s, as the field of fluid.viscosity allows. */
#define MOST_VISCOSITY 0.05f

/* m/s^2: layers are calm with so much, and drops gain nothing from more than 100. */
#define MOST_INTERFACE 400.0

/* m/s^2, as the field of fluid.cohesion allows. */
#define MOST_COHESION 500.0

/* Of the greatest cohesion, of who has none: less than rounding, but a gradient that has been
 * multiplied by it can be had back. */
#define LEAST_COHESION 0x1p-24f

/* Densities over the first fluid's. A layer of 0.01 lies calm on water, 0.002 flies apart; 20 is
 * more than mercury has. */
#define LEAST_RATIO 0.01
#define MOST_RATIO  20.0

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

skv_liquid_member skv_liquid_complain(const skv_world_def *def, int index, char *text, size_t size)
{
    const skv_liquid *liquid = &def->liquids[index];
    skv_liquid_member wrong = SKV_LIQUID_WRONG_NAME;
    const char *complaint = complain_of_name(def, index);
    if (!complaint && complain_of_density(liquid->density, def->fluid.density, text, size))
        return SKV_LIQUID_WRONG_DENSITY;
    if (!complaint && !skv_within((double)liquid->viscosity, 0, (double)MOST_VISCOSITY)) {
        complaint = "is out of range; allowed is 0..0.05 m^2/s";
        wrong = SKV_LIQUID_WRONG_VISCOSITY;
    }
    if (!complaint && (liquid->color < SKV_NO_COLOR || liquid->color > MOST_COLOR)) {
        complaint = "is out of range; allowed is 0..0xffffff, and -1 for none";
        wrong = SKV_LIQUID_WRONG_COLOR;
    }
    if (!complaint && !skv_within((double)liquid->interface_push, 0, MOST_INTERFACE)) {
        complaint = "is out of range; allowed is 0..400 m/s^2";
        wrong = SKV_LIQUID_WRONG_INTERFACE;
    }
    if (!complaint && liquid->cohesion != SKV_AS_FIRST &&
        !skv_within((double)liquid->cohesion, 0, MOST_COHESION)) {
        complaint = "is out of range; allowed is 0..500 m/s^2, and -1 for that of the first fluid";
        wrong = SKV_LIQUID_WRONG_COHESION;
    }
    if (!complaint)
        complaint = skv_springs_complain(liquid, &wrong);
    if (!complaint)
        return SKV_LIQUID_SANE;
    skv_format(text, size, "%s", complaint);
    return wrong;
}

skv_result skv_check_liquids(const skv_world_def *def, skv_error *error)
{
    static const char *const members[] = {
        "",      "name",       "density",        "viscosity", "color", "shear_modulus",
        "yield", "plasticity", "interface_push", "cohesion"};
    if (def->liquid_count < 0 || def->liquid_count >= SKV_MAX_FLUIDS)
        return skv_fail(error, SKV_ERROR_LIMIT, "fluids: %d beside the first; allowed is 0..%d",
                        def->liquid_count, SKV_MAX_FLUIDS - 1);
    for (int i = 0; i < def->liquid_count; i++) {
        char text[160];
        skv_liquid_member wrong = skv_liquid_complain(def, i, text, sizeof text);
        if (wrong != SKV_LIQUID_SANE)
            return skv_fail(error, SKV_ERROR_VALUE, "fluid %d: its %s %s", i + 1, members[wrong],
                            text);
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
    for (int i = 1; i < world->fluid_count; i++) {
        extras |= world->liquids[i].interface_push > 0 ? SKV_WITH_INTERFACES : 0u;
        extras |= world->liquids[i].cohesion != SKV_AS_FIRST ? SKV_WITH_COHESIONS : 0u;
    }
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
        skv_exchange_float(port, &liquid->density);
        skv_exchange_float(port, &liquid->viscosity);
        skv_exchange(port, &color, 4);
        liquid->color = color <= MOST_COLOR + 1 ? (int)color - 1 : MOST_COLOR + 1;
        if (extras & SKV_WITH_SPRINGS) {
            skv_exchange_float(port, &liquid->shear_modulus);
            skv_exchange_float(port, &liquid->yield);
            skv_exchange_float(port, &liquid->plasticity);
        }
        if (extras & SKV_WITH_INTERFACES)
            skv_exchange_float(port, &liquid->interface_push);
        if (extras & SKV_WITH_COHESIONS)
            skv_exchange_float(port, &liquid->cohesion);
        else if (port->from)
            liquid->cohesion = SKV_AS_FIRST;
    }
    return sane && skv_check_liquids(def, NULL) == SKV_OK;
}
