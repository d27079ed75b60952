/* Taking particles out: those that have left through an open side, and those that the host names.
 *
 * Invariant: the order of the rest is kept, so ids ascend; every particle taken out is one event;
 * and what lay beside it is awake.
 */
#include "world/remove.h"

#include "base/assert.h"
#include "world/area.h"

/* True for a particle that has left through an open side: by more than h, or round the corner,
 * where it would meet a closed side from behind. */
static bool has_left(const skv_world *world, float x, float y)
{
    unsigned open = skv_terrain_open_sides(world->terrain);
    float width = skv_terrain_width(world->terrain), height = skv_terrain_height(world->terrain);
    float h = world->h;
    bool beside = ((open & SKV_SIDE_LEFT) && x < 0) || ((open & SKV_SIDE_RIGHT) && x > width);
    bool above_or_below =
        ((open & SKV_SIDE_BOTTOM) && y < 0) || ((open & SKV_SIDE_TOP) && y > height);
    return (beside && (x < -h || x > width + h || y < 0 || y > height)) ||
           (above_or_below && (y < -h || y > height + h || x < 0 || x > width));
}

/* Marks a particle that is to go; there is room for its event. */
static void take_out(skv_world *world, int i, skv_event_kind kind)
{
    skv_events_add(&world->events, kind, world->state.id[i]);
    skv_sleep_leave(world, i);
}

/* Closes the gaps that those marked leave. */
static void close_ranks(skv_world *world)
{
    skv_state *s = &world->state;
    int kept = 0;
    for (int i = 0; i < s->count; i++) {
        if (s->unrest[i] == SKV_LEAVING)
            continue;
        if (kept < i)
            skv_state_move(s, i, kept);
        kept++;
    }
    s->count = kept;
    skv_world_regroup(world);
}

void skv_world_remove_leavers(skv_world *world)
{
    const skv_state *s = &world->state;
    int left = 0;
    for (int i = 0; i < s->count; i++) {
        if (has_left(world, s->x[i], s->y[i])) {
            take_out(world, i, SKV_EVENT_LEFT);
            left++;
        }
    }
    if (left)
        close_ranks(world);
}

/* Begins and ends a removal by the host; fluid that sleeps beside what goes begins to move. */
static skv_result begin(skv_world *world, int most, skv_error *error)
{
    int count = world->state.count;
    skv_result result = skv_events_reserve(&world->events, most < count ? most : count, error);
    if (result == SKV_OK)
        skv_sleep_begin_disturbance(&world->sleep);
    return result;
}

static void remove_one(skv_world *world, int i)
{
    skv_sleep_disturb(world, i);
    take_out(world, i, SKV_EVENT_REMOVED);
}

static void end(skv_world *world, int count, int *removed)
{
    if (count) {
        close_ranks(world);
        skv_sleep_end_disturbance(world);
    }
    if (removed)
        *removed = count;
}

skv_result skv_world_remove(skv_world *world, const skv_particle_id *ids, int count, int *removed,
                            skv_error *error)
{
    SKV_ASSERT_OR(world && count >= 0 && (ids || count == 0), SKV_ERROR_VALUE);
    skv_result result = begin(world, count, error);
    if (result != SKV_OK)
        return result;
    int gone = 0;
    for (int k = 0; k < count; k++) {
        int i = skv_world_index(world, ids[k]);
        if (i < 0 || world->state.unrest[i] == SKV_LEAVING)
            continue;
        remove_one(world, i);
        gone++;
    }
    end(world, gone, removed);
    return SKV_OK;
}

skv_result skv_world_remove_area(skv_world *world, const skv_area *area, int *removed,
                                 skv_error *error)
{
    SKV_ASSERT_OR(world && area, SKV_ERROR_VALUE);
    skv_result result = begin(world, world->state.count, error);
    if (result != SKV_OK)
        return result;
    const skv_state *s = &world->state;
    skv_bounds bounds = skv_area_bounds(area);
    int gone = 0;
    for (int i = 0; i < s->count; i++) {
        if (skv_is_within(&bounds, s->x[i], s->y[i])) {
            remove_one(world, i);
            gone++;
        }
    }
    end(world, gone, removed);
    return SKV_OK;
}
