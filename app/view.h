/* The view: a GL area that lets a session's world play and shows it live.
 *
 * Emits "changed" when what the window says about the view may have changed: a few times a second
 * while it plays, and after every call below. Emits "failed" with a line of text when a step
 * failed; the view is paused then.
 */
#ifndef SKVALP_PLAY_VIEW_H
#define SKVALP_PLAY_VIEW_H

#include <adwaita.h>
#include <skvalp/session.h>

G_BEGIN_DECLS

#define PLAY_TYPE_VIEW (play_view_get_type())
G_DECLARE_FINAL_TYPE(PlayView, play_view, PLAY, VIEW, GtkGLArea)

/* For reading; changes go through the functions below, so that they are drawn. */
skv_session *play_view_session(PlayView *view);

/* Opens a scene and lets it play. On failure the running scene goes on. */
bool play_view_open(PlayView *view, const char *name_or_path, skv_error *error);

void play_view_set_paused(PlayView *view, bool paused);
void play_view_step(PlayView *view);
bool play_view_reset(PlayView *view, skv_error *error);
void play_view_set_speed(PlayView *view, double speed);
void play_view_set_tracers(PlayView *view, bool tracers);
void play_view_set_dark(PlayView *view, bool dark);
void play_view_set_gravity(PlayView *view, double x, double y);

/* Pictures a second, measured; 0 while nothing moves. */
double play_view_frame_rate(PlayView *view);

G_END_DECLS

#endif
