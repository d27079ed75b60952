/* Preferences: what is chosen once, and remembered. */
#ifndef SKVALP_PLAY_PREFERENCES_H
#define SKVALP_PLAY_PREFERENCES_H

#include "view.h"

/* Takes up what was chosen the last time. */
void play_preferences_apply(PlayView *view, GtkWidget *ball);

void play_preferences_show(GtkWindow *parent, PlayView *view, GtkWidget *ball);

#endif
