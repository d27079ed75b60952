/* The number of particles that people choose. */
#ifndef SKVALP_PLAY_AMOUNT_H
#define SKVALP_PLAY_AMOUNT_H

#include "window.h"

G_BEGIN_DECLS

void play_amount_add(PlayWindow *window);

G_END_DECLS

#endif
