/* What the renderer and its style share. */
#ifndef SKV_RENDER_STYLE_H
#define SKV_RENDER_STYLE_H

#define SKV_STYLE_COOKIE 0x5253

#endif
