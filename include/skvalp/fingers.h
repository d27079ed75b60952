/** @file
 * Fingers: what several of them on a touch screen mean together. A front end hands every pointer
 * event through here, and does what comes out of it. Plain values: a view has its own, on the
 * thread of its front end.
 *
 * The rule: a finger is a pointer, and so are all that come down beside it, as many hands as there
 * are fingers. But where a second one comes down within 0.15 s of the first, and neither has moved
 * by then, they belong together, with all that come down until none is left: they move the picture
 * and zoom it as they part. Three of them that go up again within half a second, none having moved,
 * undo. So a finger that comes down alone waits, and is a pointer once it moves, once it is lifted,
 * or when its 0.15 s are over.
 */
#ifndef SKVALP_FINGERS_H
#define SKVALP_FINGERS_H

#include "skvalp/stage.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The fingers that are down on a view. All 0 at first, and again where its pointers are cancelled;
 * all but `tremble` is for skv_fingers_event alone. */
typedef struct skv_fingers {
    double tremble; /**< view pixels within which a finger has not moved; 0: 12 */
    int mode, count, most;
    bool moved;
    double since; /**< s, when the first came down */
    struct {
        skv_pointer_event last;
        double start_x, start_y;
    } list[SKV_MAX_HANDS];
} skv_fingers;

/** What is to be done now: in this order. */
typedef struct skv_gesture {
    skv_pointer_event events[2]; /**< for skv_stage_pointer */
    int event_count;
    double dx, dy;         /**< by which skv_camera_pan moves the picture */
    double factor, px, py; /**< by which skv_camera_zoom zooms it; 1: not */
    bool undo;             /**< skv_stage_undo */
    double wait; /**< s after which skv_fingers_wait is due if no event comes before; 0: never */
} skv_gesture;

/** A pointer did something. What is no finger's goes through unchanged. Beyond SKV_MAX_HANDS
 * fingers more are ignored, as is what is not finite. */
SKV_API skv_gesture skv_fingers_event(skv_fingers *fingers, const skv_pointer_event *event);

/** The time is over that the last gesture told to wait. */
SKV_API skv_gesture skv_fingers_wait(skv_fingers *fingers);

#ifdef __cplusplus
}
#endif
#endif
