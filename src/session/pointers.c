/* Pointers: tracks up to SKV_MAX_HANDS of them. Invariant: list[0..count) are down, have different
 * ids, and hold finite numbers only. */
#include "session/pointers.h"

#include <math.h>

#include "base/exact.h"

/* Over how many seconds a velocity is averaged: long enough to hide the jitter of touch panels,
 * short enough that a flick throws the fluid in the direction of its end. */
#define SMOOTHING 0.04
/* A resting pointer sends nothing, and so does one between two events of a slow device: the
 * velocity fades only after this many seconds without a move. */
#define PATIENCE 0.03

skv_pointer *skv_pointers_find(skv_pointers *pointers, skv_pointer_id id)
{
    for (int i = 0; i < pointers->count; i++)
        if (pointers->list[i].id.device == id.device && pointers->list[i].id.number == id.number)
            return &pointers->list[i];
    return NULL;
}

skv_pointer *skv_pointers_down(skv_pointers *pointers, skv_pointer_id id, double x, double y,
                               double time)
{
    if (!isfinite(x) || !isfinite(y) || !isfinite(time))
        return NULL;
    skv_pointer *pointer = skv_pointers_find(pointers, id);
    if (!pointer) {
        if (pointers->count == SKV_MAX_HANDS)
            return NULL;
        pointer = &pointers->list[pointers->count++];
    }
    *pointer =
        (skv_pointer){.id = id, .x = x, .y = y, .sample_x = x, .sample_y = y, .sample_time = time};
    return pointer;
}

skv_pointer *skv_pointers_move(skv_pointers *pointers, skv_pointer_id id, double x, double y,
                               double time)
{
    skv_pointer *pointer = skv_pointers_find(pointers, id);
    if (!pointer || !isfinite(x) || !isfinite(y) || !isfinite(time))
        return NULL;
    pointer->x = x;
    pointer->y = y;
    pointer->quiet = 0;

    /* Several events may share one time stamp; their way adds up until the clock moves on. The
     * weight of a sample grows with its duration, so that a tiny interval cannot shoot up the
     * velocity: its share is at most the way over SMOOTHING. */
    double seconds = time - pointer->sample_time;
    if (seconds > 0) {
        double share = 1 - skv_exp(-fmin(seconds / SMOOTHING, 50));
        pointer->vx += share * ((x - pointer->sample_x) / seconds - pointer->vx);
        pointer->vy += share * ((y - pointer->sample_y) / seconds - pointer->vy);
    }
    if (seconds != 0) {
        pointer->sample_x = x;
        pointer->sample_y = y;
        pointer->sample_time = time;
    }
    return pointer;
}

void skv_pointers_up(skv_pointers *pointers, skv_pointer_id id)
{
    skv_pointer *pointer = skv_pointers_find(pointers, id);
    if (!pointer)
        return;
    skv_pointer *last = &pointers->list[--pointers->count];
    for (; pointer < last; pointer++)
        *pointer = pointer[1];
}

void skv_pointers_pass(skv_pointers *pointers, double seconds)
{
    double keep = skv_exp(-fmin(seconds / SMOOTHING, 50));
    for (int i = 0; i < pointers->count; i++) {
        skv_pointer *pointer = &pointers->list[i];
        pointer->quiet += seconds;
        if (pointer->quiet > PATIENCE) {
            pointer->vx *= keep;
            pointer->vy *= keep;
        }
    }
}
