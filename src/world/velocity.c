/* Changing particles' velocities from outside. Invariant: whoever is given another velocity is
 * awake from the next substep on. */
#include "base/assert.h"
#include "world/world_internal.h"

skv_result skv_world_add_velocity(skv_world *world, int first, int count, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(world, SKV_ERROR_VALUE);
    if (!skv_within((double)vx, -1000, 1000) || !skv_within((double)vy, -1000, 1000))
        return skv_fail(error, SKV_ERROR_VALUE, "velocity: not finite or beyond 1000 m/s");
    if (first < 0 || count < 0 || first > world->state.count - count)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "velocity: particles %d.. do not exist; there are %d", first,
                        world->state.count);
    for (int i = first; i < first + count; i++) {
        world->state.vx[i] += vx;
        world->state.vy[i] += vy;
        skv_sleep_wake(world, i);
    }
    return SKV_OK;
}
