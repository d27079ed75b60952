/* Keys: the shortcuts of the library's table. */
#ifndef SKVALP_PLAY_KEYS_H
#define SKVALP_PLAY_KEYS_H

#include <gtk/gtk.h>

/* Lets them activate a window's actions, and makes the window that lists them. */
void play_keys_add(GtkApplicationWindow *window);

#endif
