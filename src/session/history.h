/* The key frames of a player: states of its world, from which it is stepped again. */
#ifndef SKV_SESSION_HISTORY_H
#define SKV_SESSION_HISTORY_H

#include "session/log.h"

typedef struct skv_key {
    skv_position position;
    uint64_t terrain; /* its hash: what was painted is in the log */
    uint8_t *bytes;   /* a snapshot without terrain */
    size_t size;
} skv_key;

typedef struct skv_history {
    skv_key *list; /* by position, no two at one */
    int count, capacity;
    size_t bytes;
} skv_history;

void skv_history_free(skv_history *history);

/* Adds the world's state; nothing if there is one at that position. */
skv_result skv_history_add(skv_history *history, const skv_world *world, skv_position position,
                           skv_error *error);

/* Adds one, whose bytes it takes over; there is none at its position. */
skv_result skv_history_insert(skv_history *history, const skv_key *key, skv_error *error);
/* Writes one as it lies in memory, for the same program. */
void skv_key_write(const skv_key *key, skv_write *write, void *user);
/* Adds a copy of the one that was written, unless there is one at its position, and moves on to
 * what comes behind it. */
skv_result skv_history_take(skv_history *history, const uint8_t **written, skv_error *error);
bool skv_history_has(const skv_history *history, skv_position position);

/* The last one at or before a position; null if there is none. */
const skv_key *skv_history_find(const skv_history *history, skv_position position);

/* Moves those after a position into another history, which is empty. */
skv_result skv_history_split(skv_history *history, skv_position position, skv_history *later,
                             skv_error *error);
/* The reverse: appends all of the later ones. Nothing changes on failure. */
skv_result skv_history_join(skv_history *history, skv_history *later, skv_error *error);

/* Drops those after a position. */
void skv_history_drop_after(skv_history *history, skv_position position);

/* Drops one that is missed least, never the first and the last: the older, the wider apart they
 * may be. False if there is none. */
bool skv_history_thin(skv_history *history);

#endif
