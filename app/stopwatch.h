/* The stopwatch: a button that starts and stops it, and once it was pressed, the world's time since
 * and, while it runs, a button for laps. */
#ifndef SKVALP_PLAY_STOPWATCH_H
#define SKVALP_PLAY_STOPWATCH_H

#include "view.h"

G_BEGIN_DECLS

/* Fills two boxes for a view's time. Buttons activate "win.stopwatch". */
void play_stopwatch_fill(GtkWidget *buttons, GtkWidget *readings, PlayView *view);

/* Starts or stops it, or takes a lap, at the moment that the view shows. */
void play_stopwatch_press(PlayView *view, gboolean lap);

G_END_DECLS

#endif
