/* What stands for several fluids in the page's first modules, as no_bodies.c does for bodies: who
 * asks for a second one gets the modules that have them. Invariant: no world here has more fluids
 * than one, so no particle has a mass of its own.
 */
#include "base/more.h"
#include "scene/fluids.h"
#include "solver/rows/rows_internal.h"
#include "world/liquids.h"
#include "world/world_internal.h"

#include <string.h>

const uint32_t skv_liquid_cookie = 1;

static skv_result check_count(int64_t fluids, skv_error *error)
{
    return fluids == 0 ? SKV_OK : skv_want_more(error);
}

skv_result skv_check_liquids(const skv_world_def *def, skv_error *error)
{
    return check_count(def->liquid_count, error);
}

skv_result skv_check_fluid(int fluid, int fluids, skv_error *error)
{
    (void)fluids;
    return check_count(fluid, error);
}

void skv_exchange_contents(skv_port *port, int *dye, int *fluid)
{
    uint64_t byte = (uint64_t)*dye;
    skv_exchange(port, &byte, 1);
    *dye = (int)(byte & 15);
    *fluid = (int)(byte >> 4);
}

bool skv_exchange_liquids(skv_port *port, skv_world_def *def, unsigned extras)
{
    (void)port, (void)def, (void)extras;
    return skv_want_more(NULL) == SKV_OK;
}

unsigned skv_world_liquid_extras(const skv_world *world)
{
    (void)world;
    return 0;
}

float skv_world_most_cohesion(const skv_world *world)
{
    return world->fluid.cohesion;
}

void skv_world_share_cohesion(skv_world *world)
{
    (void)world;
}

void skv_world_tell_fluids(const skv_world *world, skv_solver_particles *particles)
{
    (void)world, (void)particles;
}

skv_result skv_scene_build_fluids(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    (void)scene;
    return check_count(draft->values.list[SKV_LIST_FLUIDS].count, error);
}

skv_result skv_scene_paint_oil(skv_scene *scene, const char *label, skv_error *error)
{
    (void)label;
    return check_count(scene->marked[SKV_PAINT_OIL] + scene->marked[SKV_PAINT_BODY], error);
}

/* "water" is the first of them, as it is elsewhere. */
skv_result skv_scene_find_fluid(const skv_draft *draft, const skv_value *value, const char *path,
                                int *number, skv_error *error)
{
    (void)draft, (void)path;
    *number = 0;
    return check_count(value->text && strcmp(value->text, SKV_FIRST_FLUID) != 0, error);
}

void skv_rows_push_unlike(const skv_rows *rows, int row, const skv_boundary *boundary)
{
    (void)rows, (void)row, (void)boundary;
}

void skv_rows_turn_unlike(const skv_rows *rows, int row, const skv_constants *constants,
                          const skv_boundary *boundary)
{
    (void)rows, (void)row, (void)constants, (void)boundary;
}
