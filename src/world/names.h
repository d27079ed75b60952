/* Names of what acts: giving them, finding them, and in snapshots. */
#ifndef SKV_WORLD_NAMES_H
#define SKV_WORLD_NAMES_H

#include "world/acting.h"

enum { SKV_ACTING_KINDS = SKV_ACTING_DRAIN + 1 };

/* One of the lists. */
typedef struct skv_acting_list {
    void *items;
    size_t size; /* of an item */
    int *count;
    int most;
    skv_acting_id *ids;
    const char *name;
} skv_acting_list;
skv_acting_list skv_acting_list_of(skv_acting *acting, skv_acting_kind kind);

/* The kind that a name is of, and its place in that kind's list, or -1. */
skv_acting_kind skv_acting_kind_of(skv_acting_id id);
int skv_acting_find(const skv_acting_list *list, skv_acting_id id);

/* Names for the members that a list of so many has more than before; its count is still the old
 * one. Nothing changes on failure. */
skv_result skv_acting_name(skv_acting *acting, skv_acting_kind kind, int count, skv_error *error);

/* Writes or reads all names; what has been read is checked. */
skv_result skv_exchange_names(skv_port *port, skv_acting *acting, skv_error *error);
/* Names for those of a snapshot that has none. */
void skv_acting_rename(skv_acting *acting);

#endif
