/* Dye, the colour that particles carry. Invariant: nothing here touches what moves, so a dyed world
 * goes the same way as a clear one, and who sleeps sleeps on. */
#include "world/dye.h"

#include "base/assert.h"
#include "world/area.h"
#include "world/world_internal.h"

#include <string.h>

#define FIRST(name) name
#define NEXT(name)  , name
static const char *const names[] = {SKV_DYE_NAMES(FIRST, NEXT)};
#undef FIRST
#undef NEXT

_Static_assert(sizeof names / sizeof *names == SKV_DYES + 1, "every dye has a name");

const char *skv_dye_name(int dye)
{
    return dye >= 0 && dye <= SKV_DYES ? names[dye] : NULL;
}

skv_result skv_check_dye(int dye, skv_error *error)
{
    if (skv_dye_name(dye))
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE, "there is no dye %d; allowed is 0..%d", dye, SKV_DYES);
}

skv_result skv_world_set_dyes(skv_world *world, int first, int count, const uint8_t *dyes,
                              skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (dyes || count <= 0), SKV_ERROR_VALUE);
    skv_result result = skv_state_check_range(&world->state, "dye", first, count, error);
    for (int i = 0; i < count && result == SKV_OK; i++)
        result = skv_check_dye(dyes[i], error);
    if (result != SKV_OK)
        return result;
    if (count)
        memcpy(world->state.dye + first, dyes, (size_t)count);
    return SKV_OK;
}

skv_result skv_world_dye_area(skv_world *world, const skv_area *area, int dye, int *dyed,
                              skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && area, SKV_ERROR_VALUE);
    skv_result result = skv_check_dye(dye, error);
    if (result != SKV_OK)
        return result;
    skv_state *s = &world->state;
    skv_region region = skv_area_region(area);
    int changed = 0;
    for (int i = skv_next_in_region(s, &region, 0); i < s->count;
         i = skv_next_in_region(s, &region, i + 1)) {
        changed += s->dye[i] != dye;
        s->dye[i] = (uint8_t)dye;
    }
    if (dyed)
        *dyed = changed;
    return SKV_OK;
}
