/* What the library says, in the language of the reader. */
#ifndef SKVALP_PLAY_SAID_H
#define SKVALP_PLAY_SAID_H

#include <glib.h>

G_BEGIN_DECLS

/* The library's messages are in English and made of parts: "a.png: damaged PNG: a checksum is
 * wrong; save it again, or fetch another copy". Each part that is translated is; the rest stays. To
 * be freed. */
char *play_said(const char *english);

G_END_DECLS

#endif
