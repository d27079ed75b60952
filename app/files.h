/* Files: opening, saving, pictures and videos, by dialogs. */
#ifndef SKVALP_PLAY_FILES_H
#define SKVALP_PLAY_FILES_H

#include "window.h"

/* Adds "win.open", "win.open-scene", "win.open-uri", "win.save", "win.screenshot", "win.record"
 * and "win.stop-recording" to a window. */
void play_files_add(PlayWindow *window);

/* Fills the menu's section of files that were opened lately, and keeps it so. */
void play_files_show_recent(PlayWindow *window, GMenu *section);

#endif
