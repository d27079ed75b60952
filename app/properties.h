/* Properties: a panel of all that can be changed while a world runs, made from its registry. */
#ifndef SKVALP_PLAY_PROPERTIES_H
#define SKVALP_PLAY_PROPERTIES_H

#include "view.h"

/* Fills a box with groups of rows. They show what the scene began with until they are changed, and
 * again when something else is opened. */
void play_properties_fill(GtkBox *box, PlayView *view);

/* Shows those of another view's world in a box that was filled. */
void play_properties_show(GtkBox *box, PlayView *view);

#endif
