/* Pointers: which fingers, pens and buttons are down, where, and how fast they move; in metres. */
#ifndef SKV_SESSION_POINTERS_H
#define SKV_SESSION_POINTERS_H

#include "skvalp/stage.h"

/* The mouse's number may be a finger's, too. */
typedef struct skv_pointer_id {
    skv_device device;
    uint64_t number;
} skv_pointer_id;

/* A hand's way between two pictures has so many corners at most. */
enum { SKV_MOST_WAY = 16 };

typedef struct skv_pointer {
    skv_pointer_id id;
    double x, y;                            /* where it is, m */
    double vx, vy;                          /* smoothed velocity, m a real second */
    double sample_x, sample_y, sample_time; /* the last move that had a time of its own */
    double quiet;                           /* real seconds since the last move */

    /* What its tool knows of it. */
    int tool;
    bool straight;
    double pressure;
    double start_x, start_y;     /* where it went down */
    double held_x, held_y;       /* where a hand holds, which follows the pointer */
    skv_hand hold;               /* what it holds */
    double done_x, done_y;       /* up to where a brush has drawn */
    double way[SKV_MOST_WAY][2]; /* points on the way from there to (x, y), for brushes */
    int way_count;
    bool begun; /* a brush has drawn, a hand has closed */
} skv_pointer;

typedef struct skv_pointers {
    int count;
    skv_pointer list[SKV_MAX_HANDS]; /* in the order in which they went down */
} skv_pointers;

/* Null for one that is not down. */
skv_pointer *skv_pointers_find(skv_pointers *pointers, skv_pointer_id id);

/* Down again with an id that is down already starts that pointer afresh. A pointer beyond
 * SKV_MAX_HANDS and events that are not finite are ignored, as are moves of unknown ids: null. */
skv_pointer *skv_pointers_down(skv_pointers *pointers, skv_pointer_id id, double x, double y,
                               double time);
skv_pointer *skv_pointers_move(skv_pointers *pointers, skv_pointer_id id, double x, double y,
                               double time);
void skv_pointers_up(skv_pointers *pointers, skv_pointer_id id);

/* Lets real time pass: a pointer that rests sends no events, so its velocity fades here. */
void skv_pointers_pass(skv_pointers *pointers, double seconds);

#endif
