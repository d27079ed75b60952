/* The names of hands, forces, emitters and drains, and their lists as one kind of list.
 *
 * Invariant: in each list names ascend, as its members were added in that order; none is given
 * twice. A name's lowest bits are its kind, so a name of one kind is none of another.
 */
#include "world/names.h"

enum { KIND_BITS = 2, MOST_NAMES = 1 << (32 - KIND_BITS) };

_Static_assert(SKV_ACTING_KINDS == 1 << KIND_BITS, "a name holds its kind");

skv_acting_list skv_acting_list_of(skv_acting *a, skv_acting_kind kind)
{
    switch (kind) {
    case SKV_ACTING_HAND:
        return (skv_acting_list){a->hands,      sizeof *a->hands, &a->hand_count,
                                 SKV_MAX_HANDS, a->hand_ids,      "hand"};
    case SKV_ACTING_FORCE:
        return (skv_acting_list){a->forces,      sizeof *a->forces, &a->force_count,
                                 SKV_MAX_FORCES, a->force_ids,      "force"};
    case SKV_ACTING_EMITTER:
        return (skv_acting_list){a->emitters,      sizeof *a->emitters, &a->emitter_count,
                                 SKV_MAX_EMITTERS, a->emitter_ids,      "emitter"};
    case SKV_ACTING_DRAIN:
        break;
    }
    return (skv_acting_list){a->drains,      sizeof *a->drains, &a->drain_count,
                             SKV_MAX_DRAINS, a->drain_ids,      "drain"};
}

skv_acting_kind skv_acting_kind_of(skv_acting_id id)
{
    return (skv_acting_kind)(id % SKV_ACTING_KINDS);
}

int skv_acting_find(const skv_acting_list *l, skv_acting_id id)
{
    for (int i = 0; id && i < *l->count; i++)
        if (l->ids[i] == id)
            return i;
    return -1;
}

skv_result skv_acting_name(skv_acting *acting, skv_acting_kind kind, int count, skv_error *error)
{
    skv_acting_list l = skv_acting_list_of(acting, kind);
    if (count - *l.count >= (int)(MOST_NAMES - acting->named))
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "%ss: this world has named %d and has no name left; make another", l.name,
                        MOST_NAMES - 1);
    for (int i = *l.count; i < count; i++)
        l.ids[i] = ++acting->named << KIND_BITS | (skv_acting_id)kind;
    return SKV_OK;
}

void skv_acting_rename(skv_acting *acting)
{
    acting->named = 0;
    for (int kind = 0; kind < SKV_ACTING_KINDS; kind++) {
        skv_acting_list l = skv_acting_list_of(acting, (skv_acting_kind)kind);
        for (int i = 0; i < *l.count; i++)
            l.ids[i] = ++acting->named << KIND_BITS | (skv_acting_id)kind;
    }
}

skv_result skv_exchange_names(skv_port *port, skv_acting *acting, skv_error *error)
{
    uint64_t named = acting->named;
    skv_exchange(port, &named, 4);
    bool sane = named < MOST_NAMES;
    acting->named = (uint32_t)named;
    for (int kind = 0; kind < SKV_ACTING_KINDS; kind++) {
        skv_acting_list l = skv_acting_list_of(acting, (skv_acting_kind)kind);
        skv_acting_id last = 0;
        for (int i = 0; i < *l.count; i++) {
            uint64_t id = l.ids[i];
            skv_exchange(port, &id, 4);
            l.ids[i] = (skv_acting_id)id;
            sane = sane && l.ids[i] > last && (int)skv_acting_kind_of(l.ids[i]) == kind &&
                   l.ids[i] >> KIND_BITS <= acting->named && l.ids[i] >> KIND_BITS > 0;
            last = l.ids[i];
        }
    }
    return sane ? SKV_OK
                : skv_fail(error, SKV_ERROR_VALUE,
                           "snapshot: it holds names of hands, forces or taps that no world has");
}
