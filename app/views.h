/* Views: what the fluid shows and what is drawn over it, as actions and a menu. */
#ifndef SKVALP_PLAY_VIEWS_H
#define SKVALP_PLAY_VIEWS_H

#include "view.h"

/* Adds "win.view", "win.next-view" and an action "win.overlay-NAME" for every overlay to a window,
 * and takes up what was chosen the last time. */
void play_views_add(GActionMap *window, PlayView *view);

/* The menu of all these, and of zooming. */
GMenuModel *play_views_menu(void);

#endif
