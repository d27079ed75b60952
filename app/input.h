/* Input: what mouse, pen, fingers and keys do to a view. */
#ifndef SKVALP_PLAY_INPUT_H
#define SKVALP_PLAY_INPUT_H

#include "view.h"

/* Adds the event controllers for pointers; they live as long as the view. */
void play_input_attach(PlayView *view);

/* Adds those for keys without an action of their own, to the window around it: arrows work wherever
 * the focus is, except where arrows mean something. */
void play_input_attach_keys(GtkWidget *window, PlayView *view);

/* Whether arrow keys move a hand, which Return closes and opens, instead of gravity. */
void play_input_set_keyboard_hand(GtkWidget *window, gboolean shown);

#endif
