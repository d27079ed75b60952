/* Thumbnails: pictures of the built-in scenes, rendered by the program itself on a thread. */
#ifndef SKVALP_PLAY_THUMBNAILS_H
#define SKVALP_PLAY_THUMBNAILS_H

#include <gtk/gtk.h>
#include <skvalp/render.h>

/* Makes a thumbnail of each of the names (null ends them) and hands it to `show` on the main loop,
 * as it is ready; one that cannot be made is left out. Stops when `stop` is cancelled: `show` is
 * not called any more then. */
typedef void PlayShowThumbnail(const char *name, GdkTexture *texture, gpointer user);
void play_thumbnails_make(const char *const *names, const skv_render_style *style,
                          GCancellable *stop, PlayShowThumbnail *show, gpointer user);

#endif
