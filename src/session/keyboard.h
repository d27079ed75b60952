/* A pointer moved by keys, in view pixels. */
#ifndef SKV_SESSION_KEYBOARD_H
#define SKV_SESSION_KEYBOARD_H

#include "skvalp/stage.h"

typedef struct skv_keyboard {
    bool shown; /* it has been used */
    bool down;
    int right, up; /* the arrows held, each -1..1 */
    double held;   /* s, since they are */
    double time;   /* s, its own clock */
    double px, py;
    int width, height; /* of the view */
} skv_keyboard;

/* Keys have changed. Writes the event that follows; false if there is none. */
bool skv_keyboard_press(skv_keyboard *keyboard, int right, int up, bool down, int width, int height,
                        skv_pointer_event *event);

/* Lets time pass: the pointer moves. */
bool skv_keyboard_pass(skv_keyboard *keyboard, double seconds, skv_pointer_event *event);

/* Whether it does. */
bool skv_keyboard_moves(const skv_keyboard *keyboard);

#endif
