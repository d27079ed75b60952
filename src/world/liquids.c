/* The fluids of a world as data. Invariant: names in a list that has been let through differ, and
 * every number of it is finite and in its range. */
#include "world/liquids.h"

#include "base/defs.h"
#include "base/exact.h"
#include "base/fields.h"
#include "base/plain.h"

#include <string.h>

enum { LIQUID_COOKIE = 0x4c51, MOST_COLOR = 0xffffff };

const uint32_t skv_liquid_cookie = SKV_COOKIE(LIQUID_COOKIE, skv_liquid);

/* m^2/s, as the field of fluid.viscosity allows. */
#define MOST_VISCOSITY 0.05

/* ---- What fluids may be ---------------------------------------------------------------------- */

const char *skv_liquid_complaint(const skv_liquid *liquid, const char **member)
{
    const char *wrong = NULL;
    *member = "name";
    if (!memchr(liquid->name, '\0', sizeof liquid->name))
        wrong = "is too long; allowed are 31 bytes";
    else if (liquid->name[0] == '\0')
        wrong = "is empty; each fluid needs a name of its own";
    else if (strcmp(liquid->name, SKV_FIRST_FLUID) == 0)
        wrong = "is that of the first fluid; choose another";
    else
        wrong = skv_plain_complaint(liquid->name);
    if (wrong)
        return wrong;
    *member = "viscosity";
    if (!skv_within((double)liquid->viscosity, 0, MOST_VISCOSITY))
        return "is out of range; allowed is 0..0.05 m^2/s";
    *member = "color";
    if (liquid->color < SKV_NO_COLOR || liquid->color > MOST_COLOR)
        return "is none; allowed is 0..0xffffff, and -1 for none";
    return NULL;
}

/* A fluid's density beside that of the first. */
static skv_result check_density(const skv_liquid *liquid, float first, skv_error *error)
{
    if (liquid->density == first)
        return SKV_OK;
    char own[32], other[32];
    skv_format_float((double)liquid->density, own);
    skv_format_float((double)first, other);
    return skv_fail(error, SKV_ERROR_VALUE,
                    "fluid %s: its density, %s kg/m^2, differs from that of the first fluid, %s, "
                    "and the solvers know one density; give it the same",
                    liquid->name, own, other);
}

skv_result skv_check_liquids(const skv_world_def *def, skv_error *error)
{
    if (def->liquid_count < 0 || def->liquid_count >= SKV_MAX_FLUIDS)
        return skv_fail(error, SKV_ERROR_LIMIT, "fluids: %d beside the first; allowed is 0..%d",
                        def->liquid_count, SKV_MAX_FLUIDS - 1);
    for (int i = 0; i < def->liquid_count; i++) {
        const skv_liquid *liquid = &def->liquids[i];
        const char *member, *wrong = skv_liquid_complaint(liquid, &member);
        for (int k = 0; k < i && !wrong; k++)
            if (strcmp(def->liquids[k].name, liquid->name) == 0)
                wrong = "is another fluid's, too; choose another", member = "name";
        if (wrong)
            return skv_fail(error, SKV_ERROR_VALUE, "fluid %d: its %s %s", i + 1, member, wrong);
        skv_result result = check_density(liquid, def->fluid.density, error);
        if (result != SKV_OK)
            return result;
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

bool skv_exchange_liquids(skv_port *port, skv_world_def *def)
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
        uint64_t color = (uint64_t)(liquid->color + 1);
        liquid->cookie = skv_liquid_cookie;
        sane = exchange_name(port, liquid->name) && sane;
        skv_exchange_float(port, &liquid->density);
        skv_exchange_float(port, &liquid->viscosity);
        skv_exchange(port, &color, 4);
        liquid->color = color <= MOST_COLOR + 1 ? (int)color - 1 : MOST_COLOR + 1;
    }
    return sane && skv_check_liquids(def, NULL) == SKV_OK;
}
