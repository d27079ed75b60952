/* Input: what mouse, fingers and arrow keys do to a view. */
#ifndef SKVALP_PLAY_INPUT_H
#define SKVALP_PLAY_INPUT_H

#include "view.h"

/* Adds the event controllers; they live as long as the view. */
void play_input_attach(PlayView *view);

#endif
