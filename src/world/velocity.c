/* Changing particles' velocities and positions from outside. Invariant: whoever is given another
 * one is awake from the next substep on, and lies where particles may be added. */
#include "base/assert.h"
#include "world/add.h"

static bool is_sane(float vx, float vy)
{
    return skv_within((double)vx, -1000, 1000) && skv_within((double)vy, -1000, 1000);
}

/* Pushes may add up for as long as nothing steps. */
static float bounded(float speed)
{
    const float most = (float)SKV_MOST_SPEED;
    return skv_maxf(-most, skv_minf(speed, most));
}

skv_result skv_world_add_velocity(skv_world *world, int first, int count, float vx, float vy,
                                  skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world), SKV_ERROR_VALUE);
    if (!is_sane(vx, vy))
        return skv_fail(error, SKV_ERROR_VALUE, "velocity: not finite or beyond 1000 m/s");
    skv_result result = skv_state_check_range(&world->state, "velocity", first, count, error);
    if (result != SKV_OK)
        return result;
    for (int i = first; i < first + count; i++) {
        world->state.vx[i] = bounded(world->state.vx[i] + vx);
        world->state.vy[i] = bounded(world->state.vy[i] + vy);
        skv_sleep_wake(world, i);
    }
    return SKV_OK;
}

skv_result skv_world_set_velocities(skv_world *world, int first, int count, const float *vx,
                                    const float *vy, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && ((vx && vy) || count <= 0), SKV_ERROR_VALUE);
    skv_result result = skv_state_check_range(&world->state, "velocity", first, count, error);
    if (result != SKV_OK)
        return result;
    for (int i = 0; i < count; i++)
        if (!is_sane(vx[i], vy[i]))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "velocity of particle %d: not finite or beyond 1000 m/s", first + i);
    skv_state *s = &world->state;
    for (int i = first, k = 0; k < count; i++, k++) {
        if (s->vx[i] == vx[k] && s->vy[i] == vy[k])
            continue;
        s->vx[i] = vx[k];
        s->vy[i] = vy[k];
        skv_sleep_wake(world, i);
    }
    return SKV_OK;
}

skv_result skv_world_set_positions(skv_world *world, const skv_particle_id *ids, int count,
                                   const float *x, const float *y, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && count >= 0 && ((ids && x && y) || count == 0),
                  SKV_ERROR_VALUE);
    for (int k = 0; k < count; k++) {
        if (skv_world_index(world, ids[k]) < 0)
            continue;
        if (!skv_within((double)x[k], -100, 100) || !skv_within((double)y[k], -100, 100))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "position of particle %u: not finite or beyond 100 m",
                            (unsigned)ids[k]);
        if (skv_world_is_blocked(world, x[k], y[k]))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "position of particle %u: (%g, %g) is in solid or outside the world; "
                            "choose a free place",
                            (unsigned)ids[k], (double)x[k], (double)y[k]);
    }
    skv_state *s = &world->state;
    skv_sleep_begin_disturbance(world);
    for (int k = 0; k < count; k++) {
        int i = skv_world_index(world, ids[k]);
        if (i < 0)
            continue;
        skv_sleep_disturb(world, i);
        skv_sleep_wake(world, i);
        s->x[i] = s->anchor_x[i] = x[k];
        s->y[i] = s->anchor_y[i] = y[k];
        s->pressure[i] = s->warm_lambda[i] = s->clearance[i] = 0;
    }
    skv_sleep_end_disturbance(world);
    if (count)
        skv_world_revise(world);
    return SKV_OK;
}
