/* Quitting: by a key that every window and menu of the app hears, or by a signal. */
#ifndef SKVALP_PLAY_QUIT_H
#define SKVALP_PLAY_QUIT_H

#include <adwaita.h>

/* Adds key and signals; to be called before any window is made. */
void play_quit_add(void);

#endif
