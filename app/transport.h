/* The transport: play and pause, a step, back to the start, undo and redo, the rewind bar, and how
 * fast it goes. */
#ifndef SKVALP_PLAY_TRANSPORT_H
#define SKVALP_PLAY_TRANSPORT_H

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_TRANSPORT (play_transport_get_type())
G_DECLARE_FINAL_TYPE(PlayTransport, play_transport, PLAY, TRANSPORT, GtkBox)

/* Lets it show a view's time, and move in it. Buttons activate "win." actions. */
void play_transport_attach(PlayTransport *transport, PlayView *view);

/* Two rows instead of one. */
void play_transport_set_narrow(PlayTransport *transport, gboolean narrow);

G_END_DECLS

#endif
