/* The events of a step: from the end of the step before to its own end. Invariant: what can happen
 * without memory being asked for first, particles leaving within a step, has had room reserved. */
#include "world/events.h"

#include "base/assert.h"
#include "base/memory.h"
#include "world/world_internal.h"

#include <string.h>

static int pending(const skv_events *events)
{
    return events->over ? 0 : events->count;
}

skv_result skv_events_reserve(skv_events *events, int more, skv_error *error)
{
    int room = SKV_MAX_EVENTS - pending(events);
    int wanted = more < room ? pending(events) + more : SKV_MAX_EVENTS;
    if (wanted <= events->capacity)
        return SKV_OK;
    int twice = events->capacity < SKV_MAX_EVENTS / 2 ? 2 * events->capacity : SKV_MAX_EVENTS;
    int capacity = wanted > twice ? wanted : twice;
    skv_event *list = skv_calloc((size_t)capacity, sizeof *list);
    if (!list)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d events", wanted);
    if (events->count)
        memcpy(list, events->list, (size_t)events->count * sizeof *list);
    skv_free(events->list);
    events->list = list;
    events->capacity = capacity;
    return SKV_OK;
}

void skv_events_begin(skv_events *events)
{
    if (events->over) {
        events->count = 0;
        events->dropped = 0;
    }
    events->over = false;
}

void skv_events_end(skv_events *events)
{
    events->over = true;
}

void skv_events_add(skv_events *events, skv_event_kind kind, skv_particle_id particle,
                    skv_acting_id source)
{
    skv_events_begin(events);
    if (events->count < SKV_MAX_EVENTS)
        events->list[events->count++] = (skv_event){kind, particle, source};
    else
        events->dropped++;
}

const skv_event *skv_world_events(const skv_world *world, int *count)
{
    SKV_ASSERT_OR(world && count, NULL);
    *count = world->events.count;
    return world->events.list;
}

int64_t skv_world_dropped_events(const skv_world *world)
{
    SKV_ASSERT_OR(world, 0);
    return world->events.dropped;
}
