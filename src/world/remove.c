/* Taking particles out: those that have left through an open side or a drain, the oldest, and those
 * that the host names.
 *
 * Invariant: the order of the rest is kept, so ids ascend; every particle taken out is one event;
 * and what lay beside it is awake.
 */
#include "world/remove.h"

#include "base/assert.h"
#include "world/area.h"
#include "world/springs/springs.h"

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
static void take_out(skv_world *world, int i, skv_event_kind kind, skv_acting_id source)
{
    skv_events_add(&world->events, kind, world->state.id[i], source);
    skv_sleep_leave(world, i);
}

/* Closes the gaps that those marked leave. */
static void close_ranks(skv_world *world)
{
    skv_state *s = &world->state;
    int kept = 0;
    skv_springs_forget(world);
    for (int i = 0; i < s->count; i++) {
        if (s->unrest[i] == SKV_LEAVING)
            continue;
        if (kept < i)
            skv_state_move(s, i, kept);
        kept++;
    }
    s->count = kept;
    skv_world_revise(world);
}

void skv_world_remove_leavers(skv_world *world)
{
    const skv_state *s = &world->state;
    int left = 0;
    for (int i = 0; i < s->count; i++) {
        if (has_left(world, s->x[i], s->y[i])) {
            take_out(world, i, SKV_EVENT_LEFT, 0);
            left++;
        }
    }
    world->acting.flow.left += left;
    if (left)
        close_ranks(world);
}

skv_result skv_world_begin_removal(skv_world *world, int most, skv_error *error)
{
    int count = world->state.count;
    skv_result result = skv_events_reserve(&world->events, most < count ? most : count, error);
    if (result == SKV_OK)
        skv_sleep_begin_disturbance(world);
    return result;
}

static void remove_one(skv_world *world, int i, skv_event_kind kind, skv_acting_id source)
{
    skv_sleep_disturb(world, i);
    take_out(world, i, kind, source);
}

void skv_world_remove_one(skv_world *world, int i)
{
    remove_one(world, i, SKV_EVENT_REMOVED, 0);
}

void skv_world_end_removal(skv_world *world, int count)
{
    if (count == 0)
        return;
    close_ranks(world);
    skv_sleep_end_disturbance(world);
}

skv_result skv_world_remove(skv_world *world, const skv_particle_id *ids, int count, int *removed,
                            skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && count >= 0 && (ids || count == 0), SKV_ERROR_VALUE);
    skv_result result = skv_world_begin_removal(world, count, error);
    if (result != SKV_OK)
        return result;
    int gone = 0;
    for (int k = 0; k < count; k++) {
        int i = skv_world_index(world, ids[k]);
        if (i < 0 || world->state.unrest[i] == SKV_LEAVING)
            continue;
        skv_world_remove_one(world, i);
        gone++;
    }
    skv_world_end_removal(world, gone);
    if (removed)
        *removed = gone;
    return SKV_OK;
}

skv_result skv_world_remove_area(skv_world *world, const skv_area *area, int *removed,
                                 skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && area, SKV_ERROR_VALUE);
    skv_result result = skv_world_begin_removal(world, world->state.count, error);
    if (result != SKV_OK)
        return result;
    const skv_state *s = &world->state;
    skv_region region = skv_area_region(area);
    int gone = 0;
    for (int i = skv_next_in_region(s, &region, 0); i < s->count;
         i = skv_next_in_region(s, &region, i + 1)) {
        skv_world_remove_one(world, i);
        gone++;
    }
    skv_world_end_removal(world, gone);
    if (removed)
        *removed = gone;
    return SKV_OK;
}

/* Takes what a drain may have; returns how many. */
static int drain(skv_world *world, int number, float dt)
{
    const skv_drain *d = &world->acting.drains[number];
    const skv_state *s = &world->state;
    skv_region region = skv_area_region(&d->area);
    double *may = &world->acting.drainable[number];
    double area = (double)world->fluid.spacing * (double)world->fluid.spacing;
    /* What does not come in time is not made up for. */
    *may = (*may < 1 ? *may : 1) + (double)d->rate * (double)dt / area;
    int gone = 0;
    int next = 0;
    while (d->rate <= 0 || *may >= 1) {
        int i = skv_next_in_region(s, &region, next);
        if (i == s->count)
            break;
        next = i + 1;
        if (s->unrest[i] == SKV_LEAVING)
            continue;
        remove_one(world, i, SKV_EVENT_DRAINED, world->acting.drain_ids[number]);
        *may -= d->rate > 0;
        gone++;
    }
    return gone;
}

void skv_world_remove_drained(skv_world *world, float dt)
{
    if (world->acting.drain_count == 0)
        return;
    skv_sleep_begin_disturbance(world);
    int gone = 0;
    for (int k = 0; k < world->acting.drain_count; k++)
        gone += drain(world, k, dt);
    world->acting.flow.drained += gone;
    skv_world_end_removal(world, gone);
}

int skv_world_remove_oldest(skv_world *world, int count, int emitter)
{
    int gone = count < world->state.count ? count : world->state.count;
    skv_sleep_begin_disturbance(world);
    for (int i = 0; i < gone; i++)
        remove_one(world, i, SKV_EVENT_REPLACED, world->acting.emitter_ids[emitter]);
    skv_world_end_removal(world, gone);
    return gone;
}
