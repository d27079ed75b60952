/* Hands, forces, emitters and drains one by one, by their names.
 *
 * Invariant: a list's members, their names and how far each of them is keep the same places;
 * nothing changes on failure.
 */
#include "base/assert.h"
#include "world/emitters.h"
#include "world/forces.h"
#include "world/hands.h"
#include "world/names.h"
#include "world/world_internal.h"

#include <string.h>

/* Whether it may act, of whatever kind it is. */
static skv_result check(const skv_world *world, skv_acting_kind kind, const void *item,
                        skv_error *error)
{
    switch (kind) {
    case SKV_ACTING_HAND:
        return skv_check_hands(item, 1, error);
    case SKV_ACTING_FORCE:
        return skv_check_forces(item, 1, error);
    case SKV_ACTING_EMITTER:
        return skv_world_check_emitters(world, item, 1, error);
    case SKV_ACTING_DRAIN:
        break;
    }
    return skv_check_drains(item, 1, error);
}

/* What follows when a list has changed, as for all of it at once. */
static void follow(skv_world *world, skv_acting_kind kind)
{
    if (kind == SKV_ACTING_FORCE)
        skv_sleep_wake_all(world);
    if (kind == SKV_ACTING_FORCE || kind == SKV_ACTING_EMITTER)
        skv_world_adapt_substeps(world);
}

static void put(skv_world *world, skv_acting_kind kind, int i, const void *item)
{
    skv_acting_list l = skv_acting_list_of(&world->acting, kind);
    skv_emitter *emitters = world->acting.emitters;
    if (kind == SKV_ACTING_EMITTER && (i == *l.count || !skv_emitter_goes_on(&emitters[i], item)))
        world->acting.streams[i] = skv_new_stream(world->next_id);
    memmove((char *)l.items + (size_t)i * l.size, item, l.size);
    if (kind == SKV_ACTING_DRAIN && i == *l.count)
        world->acting.drainable[i] = 0;
}

static skv_result add(skv_world *world, skv_acting_kind kind, const void *item, skv_acting_id *id,
                      skv_error *error)
{
    skv_acting_list l = skv_acting_list_of(&world->acting, kind);
    if (id)
        *id = 0;
    skv_result result = check(world, kind, item, error);
    if (result == SKV_OK && *l.count == l.most)
        result = skv_fail(error, SKV_ERROR_LIMIT, "%s: there are %d; that is all there may be",
                          l.name, l.most);
    if (result == SKV_OK)
        result = skv_acting_name(&world->acting, kind, *l.count + 1, error);
    if (result != SKV_OK)
        return result;
    put(world, kind, *l.count, item);
    if (id)
        *id = l.ids[*l.count];
    ++*l.count;
    follow(world, kind);
    return SKV_OK;
}

static skv_result change(skv_world *world, skv_acting_kind kind, skv_acting_id id, const void *item,
                         skv_error *error)
{
    skv_acting_list l = skv_acting_list_of(&world->acting, kind);
    int i = skv_acting_find(&l, id);
    if (i < 0)
        return skv_fail(error, SKV_ERROR_VALUE, "%s: there is none named %u (any more)", l.name,
                        (unsigned)id);
    skv_result result = check(world, kind, item, error);
    if (result != SKV_OK)
        return result;
    put(world, kind, i, item);
    follow(world, kind);
    return SKV_OK;
}

/* Closes the gap at `i` in an array of `count`. */
static void close_up(void *array, size_t size, int i, int count)
{
    char *at = (char *)array + (size_t)i * size;
    memmove(at, at + size, (size_t)(count - i - 1) * size);
}

bool skv_world_remove_acting(skv_world *world, skv_acting_id id)
{
    SKV_ASSERT_OR(skv_may_change(world), false);
    skv_acting *a = &world->acting;
    skv_acting_kind kind = skv_acting_kind_of(id);
    skv_acting_list l = skv_acting_list_of(a, kind);
    int i = skv_acting_find(&l, id);
    if (i < 0)
        return false;
    close_up(l.items, l.size, i, *l.count);
    close_up(l.ids, sizeof *l.ids, i, *l.count);
    if (kind == SKV_ACTING_EMITTER)
        close_up(a->streams, sizeof *a->streams, i, *l.count);
    if (kind == SKV_ACTING_DRAIN)
        close_up(a->drainable, sizeof *a->drainable, i, *l.count);
    --*l.count;
    follow(world, kind);
    return true;
}

int skv_world_acting_index(const skv_world *world, skv_acting_id id, skv_acting_kind *kind)
{
    SKV_ASSERT_OR(world, -1);
    skv_acting *acting = (skv_acting *)&world->acting; /* only read */
    skv_acting_list l = skv_acting_list_of(acting, skv_acting_kind_of(id));
    int i = skv_acting_find(&l, id);
    if (i >= 0 && kind)
        *kind = skv_acting_kind_of(id);
    return i;
}

skv_acting_id skv_world_acting_id(const skv_world *world, skv_acting_kind kind, int index)
{
    SKV_ASSERT_OR(world && kind >= 0 && (int)kind < SKV_ACTING_KINDS, 0);
    skv_acting *acting = (skv_acting *)&world->acting; /* only read */
    skv_acting_list l = skv_acting_list_of(acting, kind);
    return index >= 0 && index < *l.count ? l.ids[index] : 0;
}

#define DEFINE(what, KIND)                                                                         \
    skv_result skv_world_add_##what(skv_world *world, const skv_##what *what, skv_acting_id *id,   \
                                    skv_error *error)                                              \
    {                                                                                              \
        SKV_ASSERT_OR(skv_may_change(world) && (what), SKV_ERROR_VALUE);                           \
        return add(world, KIND, what, id, error);                                                  \
    }                                                                                              \
                                                                                                   \
    skv_result skv_world_change_##what(skv_world *world, skv_acting_id id, const skv_##what *what, \
                                       skv_error *error)                                           \
    {                                                                                              \
        SKV_ASSERT_OR(skv_may_change(world) && (what), SKV_ERROR_VALUE);                           \
        return change(world, KIND, id, what, error);                                               \
    }
DEFINE(hand, SKV_ACTING_HAND)
DEFINE(force, SKV_ACTING_FORCE)
DEFINE(emitter, SKV_ACTING_EMITTER)
DEFINE(drain, SKV_ACTING_DRAIN)
