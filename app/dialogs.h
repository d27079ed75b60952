/* Dialogs of files: what was chosen in one. */
#ifndef SKVALP_PLAY_DIALOGS_H
#define SKVALP_PLAY_DIALOGS_H

#include <gtk/gtk.h>

/* The path chosen, null if it is nowhere on this computer. To be freed. */
char *play_chosen_path(GtkNativeDialog *dialog);

#endif
