/* The gravity ball: where down is, to be dragged. */
#ifndef SKVALP_PLAY_BALL_H
#define SKVALP_PLAY_BALL_H

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_BALL (play_ball_get_type())
G_DECLARE_FINAL_TYPE(PlayBall, play_ball, PLAY, BALL, GtkWidget)

/* Lets a ball show the gravity of a view, and set it. */
void play_ball_attach(PlayBall *ball, PlayView *view);

G_END_DECLS

#endif
