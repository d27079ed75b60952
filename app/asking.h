/* Asking: what is asked of a view's world, and of the one beside it where both are meant: time
 * always, tools too, hands and gravity while they are linked, instruments always. */
#ifndef SKVALP_PLAY_ASKING_H
#define SKVALP_PLAY_ASKING_H

#include "view.h"

void play_ask_pause(PlayView *view, gboolean paused);
void play_ask_step(PlayView *view);
void play_ask_speed(PlayView *view, double speed);
void play_ask_seek(PlayView *view, gint64 frame);
void play_ask_undo(PlayView *view);
void play_ask_redo(PlayView *view);
gboolean play_can_undo(PlayView *view);
gboolean play_can_redo(PlayView *view);

void play_ask_tool(PlayView *view, int tool);
void play_ask_dye(PlayView *view, int dye);
void play_ask_brush(PlayView *view, double radius);
void play_ask_gravity(PlayView *view, double x, double y);
void play_ask_push(PlayView *view, double x, double y);
void play_ask_keyboard(PlayView *view, int right, int up, gboolean down);

/* Instruments of both worlds are the same, in the same order. */
void play_ask_probe(PlayView *view, const skv_instrument_def *def);
void play_ask_move(PlayView *view, guint32 probe, double x0, double y0, double x1, double y1);
void play_ask_watch(PlayView *view, guint32 probe, gboolean watched);
void play_ask_remove(PlayView *view, guint32 probe);

/* The same instrument of the world beside; null if there is none. */
const skv_probe *play_probe_beside(PlayView *view, guint32 probe);

#endif
