/* The legend: the scale of what is shown, with its figures. */
#ifndef SKVALP_PLAY_LEGEND_H
#define SKVALP_PLAY_LEGEND_H

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_LEGEND (play_legend_get_type())
G_DECLARE_FINAL_TYPE(PlayLegend, play_legend, PLAY, LEGEND, GtkWidget)

/* Lets it show the scale of a view; it hides where there is none. A tap fixes its range, and lets
 * it follow the water again. */
void play_legend_attach(PlayLegend *legend, PlayView *view);

G_END_DECLS

#endif
