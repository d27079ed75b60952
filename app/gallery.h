/* The gallery: every built-in scene with its picture and description. */
#ifndef SKVALP_PLAY_GALLERY_H
#define SKVALP_PLAY_GALLERY_H

#include <adwaita.h>
#include <skvalp/render.h>

/* Makes the page. Its cards activate "win.open-scene". The pictures are made in this style when it
 * is shown for the first time. */
GtkWidget *play_gallery_new(const skv_render_style *style);

#endif
