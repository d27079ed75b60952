/* Going on where one was: the world is kept now and then, and offered at the next start. */
#ifndef SKVALP_PLAY_RESUME_H
#define SKVALP_PLAY_RESUME_H

#include "window.h"

G_BEGIN_DECLS

/* To be called before play_saving_add. `offers`: nobody has asked for anything else. */
void play_resume_add(PlayWindow *window, gboolean offers);

G_END_DECLS

#endif
