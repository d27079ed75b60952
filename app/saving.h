/* Saving: what becomes of every file that a window writes is said in it. */
#ifndef SKVALP_PLAY_SAVING_H
#define SKVALP_PLAY_SAVING_H

#include "window.h"

G_BEGIN_DECLS

void play_saving_add(PlayWindow *window);

/* Says that a file was saved, or that it was not, and the cause; null: it was. */
void play_saving_tell(PlayWindow *window, const char *path, const char *cause);

/* Writes a file, which appears when it is complete. Returns null, or the cause. */
const char *play_saving_write(const char *path, const void *bytes, gsize size);

/* Opens a state that was kept in a file. False if the file cannot be read, which is said. */
gboolean play_saving_open(PlayWindow *window, const char *path, const char *title);

/* Has the stage save to a file, and calls `done` with the cause, or null, and `data`; not if the
 * window is gone by then: who wants it holds the window. */
typedef void PlaySaved(PlayWindow *window, const char *path, const char *cause, gpointer data);
void play_saving_ask(PlayWindow *window, const char *path, PlaySaved *done, gpointer data);

/* While files are written, a window that is closed is hidden, and goes with the last of them. */
void play_saving_hold(PlayWindow *window);
void play_saving_release(PlayWindow *window);

G_END_DECLS

#endif
