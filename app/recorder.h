/* Recorder: the last seconds as a video, rendered again from the session's log. */
#ifndef SKVALP_PLAY_RECORDER_H
#define SKVALP_PLAY_RECORDER_H

#include <gtk/gtk.h>
#include <skvalp/render.h>

/* Told on the main loop: how far it is (0..1), and at the end 1 and null, or why it failed. */
typedef void PlayRecorded(double share, bool ended, const char *error, gpointer user);

/* Renders the last `seconds` up to frame `moment` of a replay file to a video at `path`, on a
 * thread. `stop` ends it; nothing is left at `path` then. The replay file has to stay until the
 * end. */
void play_record(const char *replay, const char *path, gint64 moment, double seconds,
                 const skv_render_style *style, GCancellable *stop, PlayRecorded *told,
                 gpointer user);

#endif
