/* Fingers: hands, or a gesture. Invariant: list[0..count) are down and finite; what they are is
 * decided once, and holds until none is down; of a gesture no session hears. */
#include "skvalp/fingers.h"

#include <math.h>

#include "base/assert.h"

#define TOGETHER 0.15 /* s from the first finger to the second of a gesture */
#define TAP      0.5  /* s from the first one down to the last one up */
#define TREMBLE  12.0
#define TO_UNDO  3

/* OPEN: none is down, or one that waits. */
enum { OPEN, HANDS, GESTURE };

static int find(const skv_fingers *f, uint64_t pointer)
{
    for (int i = 0; i < f->count; i++)
        if (f->list[i].last.pointer == pointer)
            return i;
    return -1;
}

static void drop(skv_fingers *f, int i)
{
    f->list[i] = f->list[--f->count];
}

/* Whether a finger that is at this event now has left the place where it came down. */
static bool has_left(const skv_fingers *f, int i, const skv_pointer_event *event)
{
    double way = hypot(event->px - f->list[i].start_x, event->py - f->list[i].start_y);
    return way > (f->tremble > 0 ? f->tremble : TREMBLE);
}

static void pass(skv_gesture *g, const skv_pointer_event *event)
{
    g->events[g->event_count++] = *event;
}

/* The one that waits is a hand. */
static void let_go_on(skv_fingers *f, skv_gesture *g)
{
    f->mode = HANDS;
    f->list[0].last.phase = SKV_PHASE_DOWN;
    pass(g, &f->list[0].last);
}

/* ---- A gesture ------------------------------------------------------------------------------- */

/* The fingers' middle, and how far from it they are in the mean. */
static void measure(const skv_fingers *f, double *x, double *y, double *spread)
{
    *x = *y = *spread = 0;
    for (int i = 0; i < f->count; i++) {
        *x += f->list[i].last.px / f->count;
        *y += f->list[i].last.py / f->count;
    }
    for (int i = 0; i < f->count; i++)
        *spread += hypot(f->list[i].last.px - *x, f->list[i].last.py - *y) / f->count;
}

/* The picture goes with the fingers: what was under their middle stays there. */
static void follow(skv_fingers *f, int i, const skv_pointer_event *event, skv_gesture *g)
{
    double x, y, before, after;
    measure(f, &x, &y, &before);
    f->moved = f->moved || has_left(f, i, event);
    f->list[i].last = *event;
    if (!f->moved)
        return;
    measure(f, &g->px, &g->py, &after);
    g->dx = g->px - x;
    g->dy = g->py - y;
    if (before > 1 && after > 1) /* pixel: one finger has no spread */
        g->factor = after / before;
}

/* ---- Events ---------------------------------------------------------------------------------- */

static void go_down(skv_fingers *f, const skv_pointer_event *event, skv_gesture *g)
{
    int i = find(f, event->pointer);
    if (i < 0 && f->count == SKV_MAX_HANDS)
        return;
    if (i < 0)
        i = f->count++;
    f->list[i].last = *event;
    f->list[i].start_x = event->px;
    f->list[i].start_y = event->py;
    if (f->count == 1 && f->mode == OPEN) {
        f->since = event->time;
        f->most = 0;
        f->moved = false;
    } else if (f->mode == OPEN) {
        f->mode = GESTURE;
    }
    f->most = f->count > f->most ? f->count : f->most;
    if (f->mode == HANDS)
        pass(g, event);
}

static void move(skv_fingers *f, int i, const skv_pointer_event *event, skv_gesture *g)
{
    if (f->mode == GESTURE) {
        follow(f, i, event, g);
        return;
    }
    if (f->mode == OPEN && has_left(f, i, event))
        let_go_on(f, g);
    f->list[i].last = *event;
    if (f->mode == HANDS)
        pass(g, event);
}

static void go_up(skv_fingers *f, int i, const skv_pointer_event *event, skv_gesture *g)
{
    bool lifted = event->phase == SKV_PHASE_UP;
    if (f->mode == OPEN && lifted)
        let_go_on(f, g);
    if (f->mode == HANDS)
        pass(g, event);
    f->moved = f->moved || !lifted;
    drop(f, i);
    if (f->count > 0)
        return;
    g->undo =
        f->mode == GESTURE && f->most == TO_UNDO && !f->moved && event->time - f->since <= TAP;
    f->mode = OPEN;
}

static bool waits(const skv_fingers *f)
{
    return f->mode == OPEN && f->count > 0;
}

static void take(skv_fingers *f, const skv_pointer_event *event, skv_gesture *g)
{
    int i = find(f, event->pointer);
    if (event->phase == SKV_PHASE_DOWN)
        go_down(f, event, g);
    else if (i >= 0 && event->phase == SKV_PHASE_MOVE)
        move(f, i, event, g);
    else if (i >= 0)
        go_up(f, i, event, g);
}

skv_gesture skv_fingers_event(skv_fingers *fingers, const skv_pointer_event *event)
{
    skv_gesture gesture = {.factor = 1};
    SKV_ASSERT_OR(fingers && event, gesture);
    if (!isfinite(event->px) || !isfinite(event->py) || !isfinite(event->time))
        return gesture;
    if (waits(fingers) && event->time - fingers->since > TOGETHER)
        let_go_on(fingers, &gesture);
    if (event->device == SKV_DEVICE_FINGER)
        take(fingers, event, &gesture);
    else
        pass(&gesture, event);
    if (waits(fingers))
        gesture.wait = fmin(fmax(fingers->since + TOGETHER - event->time, 0.001), TOGETHER);
    return gesture;
}

skv_gesture skv_fingers_wait(skv_fingers *fingers)
{
    skv_gesture gesture = {.factor = 1};
    SKV_ASSERT_OR(fingers, gesture);
    if (waits(fingers))
        let_go_on(fingers, &gesture);
    return gesture;
}
