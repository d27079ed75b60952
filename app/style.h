/* Style: how pictures are drawn, by the theme and by what was chosen. */
#ifndef SKVALP_PLAY_STYLE_H
#define SKVALP_PLAY_STYLE_H

#include <adwaita.h>
#include <skvalp/render.h>

/* Light, dark or high contrast, as the desktop or the preferences have it. */
void play_style_follow_theme(skv_render_style *style);

#endif
