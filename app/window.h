/* The window: header bar, canvas with its tools, transport, properties, gallery, messages. */
#ifndef SKVALP_PLAY_WINDOW_H
#define SKVALP_PLAY_WINDOW_H

#include <adwaita.h>

#include "view.h"

G_BEGIN_DECLS

#define PLAY_TYPE_WINDOW (play_window_get_type())
G_DECLARE_FINAL_TYPE(PlayWindow, play_window, PLAY, WINDOW, AdwApplicationWindow)

/* Opens a window on a scene: a built-in name, a path or a link. If it cannot be opened, the window
 * says why and shows the default scene. Null: the default scene. */
PlayWindow *play_window_new(GtkApplication *application, const char *scene);

PlayView *play_window_view(PlayWindow *window);

/* The picture with what lies over it; one or two of them, side by side. */
GtkWidget *play_window_stage(PlayWindow *window);
GtkBox *play_window_worlds(PlayWindow *window);
GtkBox *play_window_properties(PlayWindow *window);
GtkWidget *play_window_ball(PlayWindow *window);

/* The main menu's section of recent files. */
GMenu *play_window_recent(PlayWindow *window);
/* The submenu of numbers of particles. */
GMenu *play_window_amounts(PlayWindow *window);

/* Adds an instrument of a kind (skv_instrument_kind) to the picture. */
void play_window_measure(PlayWindow *window, int kind);

/* Opens a scene, a state, a replay or a link, and lets it play; or says why not, while what runs
 * goes on. */
void play_window_open(PlayWindow *window, const char *name);
void play_window_open_file(PlayWindow *window, GFile *file);

/* The pages: "play", "scenes", and "experiment" once a card was shown. */
void play_window_show_page(PlayWindow *window, const char *name);
const char *play_window_page(PlayWindow *window);

void play_window_show_experiment(PlayWindow *window, int number);

void play_window_show_properties(PlayWindow *window, gboolean shown);

/* Shows one line until it is closed or something is opened. Dismissing returns false if there was
 * none. */
void play_window_complain(PlayWindow *window, const char *text);
gboolean play_window_dismiss(PlayWindow *window);

/* What is said of the scene when it is opened is gone before its time. */
void play_window_hide_description(PlayWindow *window);

/* Says something for some seconds; not twice while it still stands there. */
void play_window_toast(PlayWindow *window, const char *text);
void play_window_add_toast(PlayWindow *window, AdwToast *toast); /* takes it over */

/* Shows that a replay plays, and what can be done then. */
void play_window_set_watching(PlayWindow *window, gboolean watching);
/* How far a video is, 0..1; negative: none is made. */
void play_window_set_progress(PlayWindow *window, double share);

G_END_DECLS

#endif
