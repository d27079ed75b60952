/* What has happened to particles, for the host to read after a step. */
#ifndef SKV_WORLD_EVENTS_H
#define SKV_WORLD_EVENTS_H

#include "skvalp/query.h"

typedef struct skv_events {
    skv_event *list;
    int count, capacity;
    bool over;       /* a step has ended since: the next event begins a new list */
    int64_t dropped; /* events that found the list full */
} skv_events;

/* Makes room for `more` events, as far as SKV_MAX_EVENTS goes. On failure nothing has changed. */
skv_result skv_events_reserve(skv_events *events, int more, skv_error *error);

/* Adds an event, for which there is room, or drops it. */
void skv_events_add(skv_events *events, skv_event_kind kind, skv_particle_id particle,
                    skv_acting_id source);

/* A step begins; a step has ended. */
void skv_events_begin(skv_events *events);
void skv_events_end(skv_events *events);

#endif
