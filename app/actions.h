/* Actions: what the header bar, the menus and the keys do. */
#ifndef SKVALP_PLAY_ACTIONS_H
#define SKVALP_PLAY_ACTIONS_H

#include "window.h"

/* Adds the "win." actions to a window, whose states follow the session from then on. */
void play_actions_add(PlayWindow *window, gboolean offers);

#endif
