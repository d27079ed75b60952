/* Probes: instruments that lie on the picture, to be dragged, and the tray of chips with their
 * readings. */
#ifndef SKVALP_PLAY_PROBES_H
#define SKVALP_PLAY_PROBES_H

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_PROBES (play_probes_get_type())
G_DECLARE_FINAL_TYPE(PlayProbes, play_probes, PLAY, PROBES, GtkWidget)

/* Lets them lie over a view; the box holds the chips, and shows while there are any. Null: other
 * chips show them. */
void play_probes_attach(PlayProbes *probes, PlayView *view, GtkBox *tray);

/* Adds one of a kind (skv_instrument_kind) in the middle of what is seen. */
void play_probes_add(PlayProbes *probes, int kind);

/* The kinds to choose from, as a menu of "win.measure". */
GMenuModel *play_probes_menu(void);

G_END_DECLS

#endif
