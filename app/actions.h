/* Actions: what the header bar, the menus and the keys do. */
#ifndef SKVALP_PLAY_ACTIONS_H
#define SKVALP_PLAY_ACTIONS_H

#include "window.h"

/* Adds the "win." actions to a window. */
void play_actions_add(PlayWindow *window);

/* Gives the application the keys of the shortcuts window (arrows are the view's own). */
void play_actions_set_keys(GtkApplication *application);

/* Brings the actions' states in line with the session. */
void play_actions_update(PlayWindow *window);

#endif
