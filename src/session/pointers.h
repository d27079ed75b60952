/* Pointers: which fingers and mouse buttons are down, where, and how fast they move. In view
 * pixels, so that a pointer stays under its finger when the view changes its size. */
#ifndef SKV_SESSION_POINTERS_H
#define SKV_SESSION_POINTERS_H

#include "skvalp/world.h"

typedef struct skv_pointer {
    uint64_t id;
    double px, py;                            /* where it is, view pixels */
    double vx, vy;                            /* smoothed velocity, view pixels a second */
    double sample_px, sample_py, sample_time; /* the last move that had a time of its own */
    double quiet;                             /* real seconds since the last move */
} skv_pointer;

typedef struct skv_pointers {
    int count;
    skv_pointer list[SKV_MAX_HANDS]; /* in the order in which they went down */
} skv_pointers;

/* Down again with an id that is down already starts that pointer afresh. A pointer beyond
 * SKV_MAX_HANDS and events that are not finite are ignored, as are moves of unknown ids. */
void skv_pointers_down(skv_pointers *pointers, uint64_t id, double px, double py, double time);
void skv_pointers_move(skv_pointers *pointers, uint64_t id, double px, double py, double time);
void skv_pointers_up(skv_pointers *pointers, uint64_t id);

/* Lets real time pass: a pointer that rests sends no events, so its velocity fades here. */
void skv_pointers_pass(skv_pointers *pointers, double seconds);

#endif
