/* The view: a GL area that shows a side of a stage live.
 *
 * Emits "changed" when what the window says about the view may have changed, a few times a second
 * while something moves. The first side's view emits, too: "opened" when something was opened;
 * "saved" when a file was, "shared" when what a link holds is ready, and "compared" when a second
 * world is there, with a line of text if it is not, or null; and "failed" with such a line when
 * something else was not done. Who has something saved asks play_saving_ask.
 */
#ifndef SKVALP_PLAY_VIEW_H
#define SKVALP_PLAY_VIEW_H

#include <adwaita.h>
#include <skvalp/render.h>
#include <skvalp/stage.h>

G_BEGIN_DECLS

#define PLAY_TYPE_VIEW (play_view_get_type())
G_DECLARE_FINAL_TYPE(PlayView, play_view, PLAY, VIEW, GtkGLArea)

/* What it does is asked of the stage itself; the view sees to it that it shows. */
skv_stage *play_view_stage(PlayView *view);
int play_view_side(PlayView *view);

/* The picture that is shown; valid until the main loop goes on. */
const skv_picture *play_view_picture(PlayView *view);

/* How it is drawn; a change shows at once. */
const skv_render_style *play_view_style(PlayView *view);
void play_view_set_style(PlayView *view, const skv_render_style *style);

/* What part of the world is seen, in device pixels. */
skv_camera play_view_camera(PlayView *view);

/* Makes a stage for a new view, or makes it that of the second side, beside the first's. */
void play_view_begin(PlayView *view, PlayView *first);
PlayView *play_view_twin(PlayView *view); /* that of the other side; null: none */
/* The second side's view is gone. */
void play_view_end_twin(PlayView *view);

/* Pictures a second, measured; 0 while nothing moves. */
double play_view_frame_rate(PlayView *view);

G_END_DECLS

#endif
