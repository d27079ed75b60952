/* Keys as a pointer. Invariant: it stays within the view. */
#include "session/keyboard.h"

#include <math.h>

/* Shares of the view's longer side a second: at first, and after the arrows were held for long. */
#define SLOW  0.08
#define FAST  0.6
#define WHILE 0.8 /* s from the one to the other */

static skv_pointer_event event_of(const skv_keyboard *keyboard, skv_phase phase)
{
    return (skv_pointer_event){.phase = phase,
                               .device = SKV_DEVICE_KEYBOARD,
                               .px = keyboard->px,
                               .py = keyboard->py,
                               .time = keyboard->time};
}

bool skv_keyboard_moves(const skv_keyboard *keyboard)
{
    return keyboard->right != 0 || keyboard->up != 0;
}

bool skv_keyboard_press(skv_keyboard *keyboard, int right, int up, bool down, int width, int height,
                        skv_pointer_event *event)
{
    if (!keyboard->shown) {
        keyboard->px = 0.5 * width;
        keyboard->py = 0.5 * height;
    }
    bool first = !keyboard->shown, changed = down != keyboard->down;
    bool turned = right != keyboard->right || up != keyboard->up;
    keyboard->shown = true;
    keyboard->width = width;
    keyboard->height = height;
    keyboard->right = (right > 0) - (right < 0);
    keyboard->up = (up > 0) - (up < 0);
    keyboard->down = down;
    if (turned && !skv_keyboard_moves(keyboard))
        keyboard->held = 0;
    skv_phase phase = SKV_PHASE_MOVE;
    if (changed)
        phase = down ? SKV_PHASE_DOWN : SKV_PHASE_UP;
    *event = event_of(keyboard, phase);
    return first || changed;
}

bool skv_keyboard_pass(skv_keyboard *keyboard, double seconds, skv_pointer_event *event)
{
    keyboard->time += seconds;
    if (!skv_keyboard_moves(keyboard))
        return false;
    keyboard->held += seconds;
    double share = fmin(keyboard->held / WHILE, 1);
    double speed = (SLOW + (FAST - SLOW) * share) * fmax(keyboard->width, keyboard->height);
    double way = speed * seconds / hypot(keyboard->right, keyboard->up);
    keyboard->px = fmin(fmax(keyboard->px + way * keyboard->right, 0), keyboard->width);
    keyboard->py = fmin(fmax(keyboard->py - way * keyboard->up, 0), keyboard->height);
    *event = event_of(keyboard, SKV_PHASE_MOVE);
    return true;
}
