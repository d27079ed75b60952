/* The window: header bar, view, status line, message and toasts. */
#ifndef SKVALP_PLAY_WINDOW_H
#define SKVALP_PLAY_WINDOW_H

#include <adwaita.h>

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_WINDOW (play_window_get_type())
G_DECLARE_FINAL_TYPE(PlayWindow, play_window, PLAY, WINDOW, AdwApplicationWindow)

/* Opens a window on a scene: a built-in name or a path. If it cannot be opened, the window says
 * why and shows the default scene. Null: the default scene. */
PlayWindow *play_window_new(GtkApplication *application, const char *scene);

PlayView *play_window_view(PlayWindow *window);

/* Opens a scene, or says why not while the running one goes on. */
void play_window_open(PlayWindow *window, const char *name_or_path);
void play_window_open_file(PlayWindow *window, GFile *file);

/* Shows one line until it is closed or something is opened. */
void play_window_complain(PlayWindow *window, const char *text);
void play_window_dismiss(PlayWindow *window);

void play_window_toast(PlayWindow *window, const char *text);

G_END_DECLS

#endif
