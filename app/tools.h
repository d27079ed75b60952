/* Tools: the pill of buttons that chooses what a finger or the mouse does. */
#ifndef SKVALP_PLAY_TOOLS_H
#define SKVALP_PLAY_TOOLS_H

#include "view.h"

/* Fills a box with a button for every tool of the session's table, and one for the brush's size.
 * The buttons activate "win.tool" and follow its state. */
void play_tools_fill(GtkBox *box, PlayView *view);

/* A button of that kind which opens a menu or a popover, to be given to it. */
GtkWidget *play_tools_menu_button(const char *icon, const char *name, const char *tip);

#endif
