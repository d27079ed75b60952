/* Fluids: the row of chips that chooses what is poured. */
#ifndef SKVALP_PLAY_FLUIDS_H
#define SKVALP_PLAY_FLUIDS_H

#include "view.h"

/* Fills a box with a chip for every fluid of the view's world, and shows it while there are
 * several. The chips activate "win.fluid" and follow its state. */
void play_fluids_attach(GtkBox *box, PlayView *view);

#endif
