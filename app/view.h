/* The view: a GL area that shows a session live.
 *
 * Emits "changed" when what the window says about the view may have changed, a few times a second
 * while something moves; "opened" when something was opened; "saved" when a file was, and "shared"
 * when what a link holds is ready, with a line of text if it is not, or null; and "failed" with
 * such a line when something else was not done.
 */
#ifndef SKVALP_PLAY_VIEW_H
#define SKVALP_PLAY_VIEW_H

#include <adwaita.h>
#include <skvalp/pair.h>
#include <skvalp/render.h>
#include <skvalp/session.h>

G_BEGIN_DECLS

#define PLAY_TYPE_VIEW (play_view_get_type())
G_DECLARE_FINAL_TYPE(PlayView, play_view, PLAY, VIEW, GtkGLArea)

/* What it does is asked of the session itself; the view sees to it that it shows. */
skv_session *play_view_session(PlayView *view);

/* The picture that is shown; valid until the main loop goes on. */
const skv_picture *play_view_picture(PlayView *view);

/* How it is drawn; a change shows at once. */
const skv_render_style *play_view_style(PlayView *view);
void play_view_set_style(PlayView *view, const skv_render_style *style);

/* What part of the world is seen, in device pixels. */
skv_camera play_view_camera(PlayView *view);
/* Zooms about a place of the view, moves the picture, shows all of it again; device pixels. */
void play_view_zoom(PlayView *view, double factor, double px, double py);
void play_view_pan(PlayView *view, double dx, double dy);
void play_view_show_all(PlayView *view);

/* A pointer's event goes to the session; its place is in device pixels of the view. */
void play_view_send(PlayView *view, const skv_pointer_event *event);
/* All its pointers are gone. */
void play_view_cancel(PlayView *view);

/* Lays a second view beside one, whose worlds are a pair now: its time passes by the first, both
 * show the same part of their worlds, and fingers on one are on both unless that is switched off.
 * With null they part. */
void play_view_join(PlayView *view, PlayView *twin, skv_pair *pair);
PlayView *play_view_twin(PlayView *view); /* null: none */
/* Whether it is the second of two. */
gboolean play_view_follows(PlayView *view);
skv_pair *play_view_pair(PlayView *view);
void play_view_set_linked(PlayView *view, gboolean linked);
gboolean play_view_is_linked(PlayView *view);

/* Pictures a second, measured; 0 while nothing moves. */
double play_view_frame_rate(PlayView *view);

G_END_DECLS

#endif
