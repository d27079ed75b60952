/* Sharing: games as links, copied and opened, and whether what was recorded goes as it went. */
#ifndef SKVALP_PLAY_SHARE_H
#define SKVALP_PLAY_SHARE_H

#include "window.h"

/* Adds the actions "share" and "paste", and looks at recorded games that are played. */
void play_share_add(PlayWindow *window);

#endif
